//! Families of splines as data: which weights the recursion has, by which parameters.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, LazyLock};

use include_dir::{Dir, include_dir};
use num_rational::BigRational;
use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;

use super::complaint::{Complaint, Fault, ensure, fault};
use super::definitions::definitions;
use super::file::{File, Reading, Text, stanzas};
use super::known::{Kind, Known, Subjects, Vocabulary, nearest};
use super::print::{source, text};
use super::raw::{Node, Parser, Raw, whole};
use super::resolve::{Named, Resolved, Scope, not_reserved};
use super::syntax::{Adjective, Argument, Definition, Formula, Function, Int, Name, Real, Relation};

/// A family of splines: the recursion G_i^d = w_i^d G_i^{d−1} + v_{i+1}^d G_{i+1}^{d−1} with w = rise/over and v = fall/over on
/// the interval [a, b] = [t_i, t_{i+d}], and 0 outside of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Family {
    /// Its name.
    pub name: String,
    /// What names it on a command line: its name, or its file.
    pub given: String,
    /// What stands in its file.
    pub text: String,
    /// What it is.
    pub title: String,
    /// Where it comes from.
    pub source: String,
    /// The knots that it is for; any, if there is no adjective.
    pub knots: Vec<Adjective>,
    /// Its parameters, in order.
    pub parameters: Vec<Parameter>,
    /// Other names for members: from such a number, the parameters.
    pub reads: Vec<(Name, Vec<(Name, Real)>)>,
    /// And back: the number, from the parameters.
    pub writes: Vec<(Name, Real)>,
    /// The parameters that give the classical B-splines, where there are such.
    pub classical: Option<Vec<(Name, Real)>>,
    /// rise.
    pub rise: Real,
    /// fall.
    pub fall: Real,
    /// What both are divided by; rise + fall, if nothing is said.
    pub over: Option<Real>,
    /// The parameters of the member that reflection leads to: those that are not named stay. `None` if it is not known.
    pub dual: Option<Vec<(Name, Real)>>,
    /// What the weights name.
    pub definitions: Vec<Definition>,
}

/// A parameter of a family, by its indices: none, the i of a knot, the degree d, or both.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parameter {
    /// Its name.
    pub name: Name,
    /// `i`, `d`, in this order.
    pub indices: Vec<Name>,
    /// How its numbers compare with others: all of these hold.
    pub bounds: Vec<(Relation, BigRational)>,
    /// The bounds as written.
    pub says: String,
}

impl Parameter {
    /// As written: `omega[i]`.
    #[must_use]
    pub fn head(&self) -> String {
        Vocabulary::head(&self.name, &self.indices)
    }

    /// May it be this number?
    #[must_use]
    pub fn admits(&self, value: &BigRational) -> bool {
        self.bounds.iter().all(|(relation, bound)| match relation {
            Relation::Equal => value == bound,
            Relation::Unequal => value != bound,
            Relation::Less => value < bound,
            Relation::AtMost => value <= bound,
            Relation::Greater => value > bound,
            Relation::AtLeast => value >= bound,
        })
    }
}

/// A family of splines.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Families of splines")]
struct RawFamily {
    /// The format of the file; 1 if nothing is said.
    #[serde(rename = "format")]
    #[schemars(extend("const" = 1))]
    _format: Option<u8>,
    /// Its name: letters, digits and `-`.
    #[schemars(with = "String")]
    name: Text,
    /// What it is, in a few words.
    title: String,
    /// Where it comes from.
    source: String,
    /// The knots that it is for, by adjectives: "bernstein"; left out, if it is for any.
    #[schemars(with = "Option<String>")]
    knots: Option<Text>,
    /// Its parameters with their bounds: r = "r > 0", "omega[i]" = "omega[i] > 0", "rho[i,d]" = "rho[i,d] > 0".
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, String>")]
    parameters: BTreeMap<Text, Text>,
    /// Other numbers that name a member: alpha = { r = "alpha/(alpha-1)" }.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, BTreeMap<String, String>>")]
    reads: BTreeMap<Text, BTreeMap<Text, Text>>,
    /// Such a number from the parameters: alpha = "r/(r-1)".
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, String>")]
    writes: BTreeMap<Text, Text>,
    /// The parameters of the classical B-splines: r = "1".
    #[schemars(with = "Option<BTreeMap<String, String>>")]
    classical: Option<BTreeMap<Text, Text>>,
    /// The weight on [a, b].
    weight: RawWeight,
    /// The parameters after a reflection: r = "1/r", "omega[i]" = "omega[m-i]"; empty, if they stay.
    #[schemars(with = "Option<BTreeMap<String, String>>")]
    dual: Option<BTreeMap<Text, Text>>,
    /// Names for terms, with indices and x where they depend on them: "c[i]" = "omega[i]^2".
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, String>")]
    define: BTreeMap<Text, Text>,
}

/// w = rise/over and 1 − w = fall/over on [a, b] = [t_i, t_{i+d}].
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RawWeight {
    /// By x, a, b, i, d, k, s = the place of the function among those over the span, t[…], parameters, definitions.
    #[schemars(with = "String")]
    rise: Text,
    /// Likewise.
    #[schemars(with = "String")]
    fall: Text,
    /// What both are divided by; rise + fall, if it is left out.
    #[schemars(with = "Option<String>")]
    over: Option<Text>,
}

/// The JSON Schema of files of families, for editors.
#[must_use]
pub fn family_schema() -> Schema {
    schema_for!(RawFamily)
}

/// The families that come with the program, by name.
///
/// # Panics
/// If the program was built with a damaged folder, which a test rules out: with all that is wrong in it.
#[must_use]
pub fn families() -> &'static [Arc<Family>] {
    static FOLDER: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/families");
    static FAMILIES: LazyLock<Vec<Arc<Family>>> = LazyLock::new(|| {
        let read = |file: &include_dir::File<'_>| {
            let name = file.path().to_string_lossy().into_owned();
            match Family::read(&name, file.contents_utf8().unwrap_or_default()) {
                Ok(family) => Arc::new(Family { given: family.name.clone(), ..family }),
                Err(complaints) => {
                    let complaints: Vec<_> = complaints.iter().map(Complaint::message).collect();
                    unreachable!("the folder of the families is damaged:\n{}", complaints.join("\n"))
                }
            }
        };
        let mut all: Vec<_> = FOLDER.files().map(read).collect();
        all.sort_by(|a, b| a.name.cmp(&b.name));
        all
    });
    &FAMILIES
}

/// The classical properties of B-splines, which can be asked of any family.
///
/// # Panics
/// If the program was built with a damaged file, which a test rules out: with all that is wrong in it.
#[must_use]
pub fn classical() -> &'static File {
    static FILE: LazyLock<File> = LazyLock::new(|| {
        let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/std/classical.toml"));
        match stanzas("std/classical.toml", text) {
            Ok(file) => file,
            Err(complaints) => {
                let complaints: Vec<_> = complaints.iter().map(ToString::to_string).collect();
                unreachable!("the classical properties are damaged:\n{}", complaints.join("\n"))
            }
        }
    });
    &FILE
}

/// Names that mean something in a weight.
const OF_WEIGHTS: [&str; 6] = ["x", "a", "b", "i", "d", "s"];

fn in_order(map: &BTreeMap<Text, Text>) -> Vec<(&Text, &Text)> {
    let mut all: Vec<_> = map.iter().collect();
    all.sort_by_key(|(head, _)| head.span().start);
    all
}

/// The one with an index α.
impl Default for Family {
    fn default() -> Self {
        Self::clone(Self::of_index())
    }
}

impl Known {
    /// The same, about a family.
    #[must_use]
    pub fn about(self, family: &Family) -> Self {
        Self { family: family.known().family, ..self }
    }
}

impl Family {
    /// The one with an index α, as it comes with the program.
    ///
    /// # Panics
    /// If the program was built without it, which a test rules out.
    #[must_use]
    pub fn of_index() -> &'static Arc<Self> {
        match families().iter().find(|family| matches!(family.moebius(), Some(Some(_)))) {
            Some(family) => family,
            None => unreachable!("the family of an index comes with the program"),
        }
    }

    /// Reads the file of a family.
    ///
    /// # Errors
    /// Everything that is wrong, each with its place.
    pub fn read(file_name: &str, text: &str) -> Result<Self, Vec<Complaint>> {
        let mut reading = Reading::new(file_name, text);
        let found = reading.toml::<RawFamily>().and_then(|raw| Self::of(&mut reading, &raw));
        match found {
            Some(family) if reading.complaints.is_empty() => Ok(Self { text: text.to_owned(), ..family }),
            _ => Err(reading.complaints),
        }
    }

    /// A weight without a name, `rise : fall`; names that mean nothing else are its parameters.
    ///
    /// # Errors
    /// The first thing that is wrong, with its place.
    pub fn of_ratio(text: &str) -> Result<Self, Vec<Complaint>> {
        let quoted = |text: &str| text.trim().replace('\\', "\\\\").replace('"', "\\\"");
        let (rise, fall) = text.split_once(':').unwrap_or((text, ""));
        let mut parameters = String::new();
        let mut known = BTreeSet::new();
        let words = |text: &str| -> Vec<(String, bool)> {
            let mut found = Vec::new();
            for (start, word) in text
                .split(|c: char| !c.is_ascii_alphanumeric())
                .filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()))
                .map(|word| (word.as_ptr() as usize - text.as_ptr() as usize, word))
            {
                found.push((word.to_owned(), text[start + word.len()..].trim_start().starts_with('[')));
            }
            found
        };
        for (word, indexed) in words(rise).into_iter().chain(words(fall)) {
            let taken = OF_WEIGHTS.contains(&word.as_str())
                || matches!(word.as_str(), "k" | "n" | "m" | "t" | "sum" | "prod" | "in" | "binomial");
            if !taken && known.insert(word.clone()) {
                let head = if indexed { format!("{word}[i]") } else { word };
                parameters.push_str(&format!("\"{head}\" = \"{head} > 0\"\n"));
            }
        }
        let file = format!(
            "name = \"ratio\"\ntitle = \"\"\nsource = \"\"\n[parameters]\n{parameters}[weight]\nrise = \"{}\"\nfall = \"{}\"\n",
            quoted(rise),
            quoted(fall)
        );
        Self::read("rise : fall", &file)
    }

    fn of(reading: &mut Reading, raw: &RawFamily) -> Option<Self> {
        let name = raw.name.get_ref();
        let strange = |c: char| !(c.is_ascii_alphanumeric() || c == '-');
        if name.is_empty() || name.contains(strange) {
            let rule = "the name of a family is made of letters, digits and `-`";
            reading.complain(raw.name.span(), rule, "write it like `knot-weights`");
        }
        let knots = raw.knots.as_ref().map(|text| reading.read(text, adjectives(text.get_ref())));
        let knots = knots.flatten().unwrap_or_default();
        let mut vocabulary =
            Vocabulary { name: name.clone(), parameters: Vec::new(), by_ends: false, in_file: true };
        let mut parameters: Vec<Parameter> = Vec::new();
        for (head, bound) in in_order(&raw.parameters) {
            let Some((own, indices)) = reading.read(head, parameter(head.get_ref())) else { continue };
            if parameters.iter().any(|other| other.name == own) {
                reading.complain(
                    head.span(),
                    format!("`{own}` is a parameter twice"),
                    "give one another name",
                );
                continue;
            }
            vocabulary.parameters.push((Arc::clone(&own), indices.clone()));
            let known = Known { family: Some(vocabulary.clone()), ..Known::default() };
            let bounds = bounds(&known, &own, &indices, bound.get_ref());
            if let Some(bounds) = reading.read(bound, bounds) {
                let says = bound.get_ref().trim().to_owned();
                parameters.push(Parameter { name: own, indices, bounds, says });
            }
        }
        if !reading.complaints.is_empty() {
            return None;
        }
        let heads = in_order(&raw.define);
        for (head, _) in &heads {
            let name = head.get_ref().split(['[', '(']).next().unwrap_or_default().trim();
            if OF_WEIGHTS.contains(&name) {
                let rule = format!("`{name}` has a meaning already");
                reading.complain(head.span(), rule, "take another name for what is defined");
            }
        }
        let texts: Vec<_> =
            heads.iter().map(|(head, body)| (head.get_ref().clone(), body.get_ref().clone())).collect();
        let seed = Known { family: Some(vocabulary.clone()), ..Known::default() };
        let known = match definitions(&texts, seed) {
            Ok(known) => known,
            Err(faults) => {
                for (at, in_head, fault) in faults {
                    reading.fault(if in_head { heads[at].0 } else { heads[at].1 }, fault);
                }
                return None;
            }
        };
        let mut used = BTreeSet::new();
        let mut term = |reading: &mut Reading, text: &Text, own: &[(&str, Kind)]| {
            let mut scope = scope(&known, own);
            let read = whole(text.get_ref(), Parser::expression).and_then(|node| scope.real(&node));
            used.extend(std::mem::take(&mut scope.named).definitions.into_iter().map(|(name, ..)| name));
            reading.read(text, read)
        };
        let of_weights = OF_WEIGHTS.map(|name| match name {
            "x" | "a" | "b" => (name, Kind::Real),
            _ => (name, Kind::Int),
        });
        let rise = term(reading, &raw.weight.rise, &of_weights);
        let fall = term(reading, &raw.weight.fall, &of_weights);
        let over = raw.weight.over.as_ref().map(|text| term(reading, text, &of_weights));
        let named = |reading: &mut Reading, head: &Text| {
            let known =
                parameters.iter().find(|parameter| parameter.head() == head.get_ref().replace(' ', ""));
            if known.is_none() {
                let advice = format!("it has {}", vocabulary.has());
                reading.complain(head.span(), format!("`{head}` is no parameter of this family"), advice);
            }
            known
        };
        type Term<'t> = &'t mut dyn FnMut(&mut Reading, &Text, &[(&str, Kind)]) -> Option<Real>;
        let numbers = |reading: &mut Reading, map: &BTreeMap<Text, Text>, term: Term<'_>| {
            let mut all = Vec::new();
            for (head, text) in in_order(map) {
                let Some(parameter) = named(reading, head) else { continue };
                let own: Vec<_> = parameter.indices.iter().map(|of| (&**of, Kind::Int)).collect();
                all.extend(term(reading, text, &own).map(|term| (Arc::clone(&parameter.name), term)));
            }
            all
        };
        let mut reads = Vec::new();
        for (head, map) in &raw.reads {
            let other = head.get_ref().as_str();
            let free = other == "alpha" || not_reserved(other, &(0..other.len())).is_ok();
            if !free || parameters.iter().any(|own| *own.name == *other) || OF_WEIGHTS.contains(&other) {
                let rule = format!("`{other}` has a meaning already");
                reading.complain(head.span(), rule, "take another name for what is read");
                continue;
            }
            // It takes the place of a parameter: all its entries are read alike.
            let mut all = Vec::new();
            for (own, text) in in_order(map) {
                let name = own.get_ref();
                match parameters.iter().find(|parameter| *parameter.name == **name) {
                    Some(parameter) => all.extend(
                        term(reading, text, &[(other, Kind::Real)])
                            .map(|term| (Arc::clone(&parameter.name), term)),
                    ),
                    None => {
                        let rule = format!("`{name}` is no parameter of this family");
                        reading.complain(own.span(), rule, format!("it has {}", vocabulary.has()));
                    }
                }
            }
            reads.push((Name::from(other), all));
        }
        let writes = in_order(&raw.writes)
            .into_iter()
            .filter_map(|(head, text)| Some((Name::from(head.get_ref().as_str()), term(reading, text, &[])?)))
            .collect();
        let classical = raw.classical.as_ref().map(|map| numbers(reading, map, &mut term));
        let dual = raw.dual.as_ref().map(|map| numbers(reading, map, &mut term));
        let (rise, fall, over) = (rise?, fall?, over.map_or(Some(None), |over| over.map(Some))?);
        let family = Self {
            name: name.clone(),
            given: reading.name().to_owned(),
            text: String::new(),
            title: raw.title.clone(),
            source: raw.source.clone(),
            knots,
            parameters,
            reads,
            writes,
            classical,
            rise,
            fall,
            over,
            dual,
            definitions: known.definitions.clone(),
        };
        for (head, _) in &heads {
            let own = head.get_ref().split(['[', '(']).next().unwrap_or_default().trim();
            if !known.is_used(own, &used) {
                reading.complain(head.span(), format!("nothing uses `{own}`"), "delete it");
            }
        }
        for head in raw.parameters.keys() {
            let own = head.get_ref().split('[').next().unwrap_or_default().trim();
            if !family.mentions(|part| matches!(part, Part::Real(Real::Parameter(name, _)) if **name == *own))
            {
                reading.complain(head.span(), format!("no weight uses `{own}`"), "delete it, or use it");
            }
        }
        let divides = |text: &Text, term: &Real, reading: &mut Reading| {
            if family.divides_by_x(term) {
                let advice = "multiply `rise`, `fall` and `over` by it";
                reading.complain(text.span(), "a weight divides by what depends on x", advice);
            }
        };
        divides(&raw.weight.rise, &family.rise, reading);
        divides(&raw.weight.fall, &family.fall, reading);
        if let (Some(text), Some(over)) = (&raw.weight.over, &family.over) {
            divides(text, over, reading);
        }
        for ((_, body), definition) in heads.iter().zip(&family.definitions) {
            divides(body, &definition.body, reading);
        }
        Some(family)
    }

    /// Does a part of the weights, or of what they are defined by, have a property?
    fn mentions(&self, has: impl Fn(Part<'_>) -> bool) -> bool {
        let bodies = self.definitions.iter().map(|definition| &definition.body);
        let terms = [&self.rise, &self.fall].into_iter().chain(&self.over).chain(bodies);
        terms.into_iter().any(|term| term.any(&has))
    }

    fn divides_by_x(&self, term: &Real) -> bool {
        let moves = |part: Part<'_>| match part {
            Part::Real(Real::Bound(name)) => **name == *"x",
            Part::Real(Real::Value(..)) => true,
            _ => false,
        };
        let by = |part: Part<'_>| match part {
            Part::Real(Real::Over(_, b)) => b.any(&moves),
            Part::Real(Real::Power(a, e)) => a.any(&moves) && matches!(e, Int::Number(e) if *e < 0),
            _ => false,
        };
        term.any(&by)
    }

    /// Are its weights given by the ends of the interval and by numbers without an index?
    #[must_use]
    pub fn is_by_ends(&self) -> bool {
        !self.mentions(|part| match part {
            Part::Real(Real::Knot(_)) | Part::Int(Int::Degree | Int::Last | Int::M) => true,
            Part::Real(Real::Parameter(_, of)) => !of.is_empty(),
            Part::Int(Int::Bound(name)) => ["i", "d", "s"].contains(&&**name),
            _ => false,
        })
    }

    /// ρ and σ of weights ρ·(x − a) : σ·(b − x) that are written so.
    fn slopes(&self) -> Option<(Real, Real)> {
        let (x, a, b) = (Real::Bound("x".into()), Real::Bound("a".into()), Real::Bound("b".into()));
        let slope = |term: &Real, linear: &Real| match term {
            term if term == linear => Some(Real::Whole(Int::Number(1))),
            Real::Times(scale, other) if **other == *linear => Some((**scale).clone()),
            Real::Times(other, scale) if **other == *linear => Some((**scale).clone()),
            _ => None,
        };
        let slopes = (slope(&self.rise, &x.clone().minus(a))?, slope(&self.fall, &b.minus(x))?);
        self.over.is_none().then_some(slopes)
    }

    /// Are its members those of an index, with slopes r and 1 for r > 0? With the parameter that is r; `Some(None)`, if r = 1.
    #[must_use]
    pub fn moebius(&self) -> Option<Option<&Name>> {
        let one = Real::Whole(Int::Number(1));
        let (rho, sigma) = self.slopes()?;
        if sigma != one || !self.knots.is_empty() {
            return None;
        }
        match self.parameters.as_slice() {
            [] => (rho == one).then_some(None),
            // Sentences speak of r where there is an index.
            [own] if &*own.name == "r" => {
                let positive = own.bounds == [(Relation::Greater, BigRational::from_integer(0.into()))];
                let is_it = rho == Real::Parameter(Arc::clone(&own.name), Vec::new());
                (is_it && positive).then_some(Some(&own.name))
            }
            _ => None,
        }
    }

    /// Is the member of this index one of it? `None` is ∞.
    #[must_use]
    pub fn has_index(&self, alpha: Option<&BigRational>) -> bool {
        match self.moebius() {
            Some(Some(_)) => true,
            Some(None) => alpha.is_none(),
            None => false,
        }
    }

    /// ρ/σ as it is written, of weights ρ·(x − a) : σ·(b − x) that are written so.
    #[must_use]
    pub fn slope_ratio(&self) -> Option<String> {
        let (rho, sigma) = self.slopes()?;
        let plain = sigma == Real::Whole(Int::Number(1));
        Some(source(&if plain { rho } else { rho.over(sigma) }))
    }

    /// What texts may say of it.
    #[must_use]
    pub fn known(&self) -> Known {
        let parameters =
            self.parameters.iter().map(|own| (Arc::clone(&own.name), own.indices.clone())).collect();
        let vocabulary =
            Vocabulary { name: self.name.clone(), parameters, by_ends: self.is_by_ends(), in_file: false };
        // Of Möbius weights there is the index to speak of.
        let family = self.moebius().is_none().then_some(vocabulary);
        Known { family, ..Known::default() }
    }

    /// rise : fall, as written; in notation for people, or as source.
    #[must_use]
    pub fn ratio(&self, as_source: bool) -> String {
        let show = |term: &Real| if as_source { source(term) } else { text(term) };
        let over = self.over.as_ref().map(|over| format!(", over {}", show(over))).unwrap_or_default();
        format!("{} : {}{over}", show(&self.rise), show(&self.fall))
    }
}

fn scope<'a>(known: &'a Known, own: &[(&str, Kind)]) -> Scope<'a> {
    let has = Subjects { degree: true, knots: true, ..Subjects::default() };
    let own = own.iter().map(|(name, kind)| (Name::from(*name), *kind)).collect();
    Scope { known, has, defining: false, own, named: Named::default() }
}

fn adjectives(text: &str) -> Result<Vec<Adjective>, Fault> {
    let mut all = Vec::new();
    for word in text.split_whitespace() {
        let at = text.find(word).unwrap_or_default();
        let at = at..at + word.len();
        let names = || Adjective::ALL.into_iter().map(Adjective::name);
        match Adjective::ALL.into_iter().find(|adjective| adjective.name() == word) {
            Some(adjective) => all.push(adjective),
            None => {
                let advice = match nearest(word, names()) {
                    Some(close) => format!("did you mean `{close}`?"),
                    None => format!("knots are {}", names().collect::<Vec<_>>().join(", ")),
                };
                return fault(&at, format!("knots are not `{word}`"), advice);
            }
        }
    }
    Ok(all)
}

/// The name and the indices of a parameter.
fn parameter(text: &str) -> Resolved<(Name, Vec<Name>)> {
    let head = whole(text, Parser::head)?;
    let free = head.name == "r" || not_reserved(&head.name, &head.at).is_ok();
    let free = free && !OF_WEIGHTS.contains(&head.name.as_str());
    ensure(free, &head.at, format!("`{}` has a meaning already", head.name), "take another name")?;
    if let Some((_, at)) = &head.variable {
        return fault(at, "a parameter is a number", "a function of x is written in `define`");
    }
    let index = |node: &Node| match &node.raw {
        Raw::Name { name, primes: 0 } if name == "i" || name == "d" => Ok(Name::from(name.as_str())),
        _ => fault(&node.at, "a parameter has the index i, d, or i,d", "write `omega[i]` or `rho[i,d]`"),
    };
    let indices = head.indices.iter().map(index).collect::<Result<Vec<_>, _>>()?;
    let right = matches!(
        indices.iter().map(|of| &**of).collect::<Vec<_>>().as_slice(),
        [] | ["i"] | ["d"] | ["i", "d"]
    );
    ensure(right, &head.at, "a parameter has the index i, d, or i,d", "write `omega[i]` or `rho[i,d]`")?;
    Ok((head.name.as_str().into(), indices))
}

/// `q > 0`, `0 < q < 1`: comparisons of the parameter with numbers; an empty text says nothing.
fn bounds(
    known: &Known,
    name: &Name,
    indices: &[Name],
    text: &str,
) -> Resolved<Vec<(Relation, BigRational)>> {
    if text.trim().is_empty() {
        return Ok(Vec::new());
    }
    let own: Vec<_> = indices.iter().map(|of| (&**of, Kind::Int)).collect();
    let node = whole(text, Parser::expression)?;
    let formula = scope(known, &own).formula(&node)?;
    let itself = Real::Parameter(Arc::clone(name), indices.iter().cloned().map(Int::Bound).collect());
    let head = Vocabulary::head(name, indices);
    let wrong = || {
        let advice = format!("write `{head} > 0` or `0 < {head} < 1`");
        fault(&node.at, "a bound compares the parameter with numbers", advice)
    };
    let Formula::Chain(first, rest) = formula else { return wrong() };
    let mut before = first;
    let mut all = Vec::new();
    for (relation, next) in rest {
        match (before == itself, before.literal(), next == itself, next.literal()) {
            (true, _, _, Some(bound)) => all.push((relation, bound)),
            (_, Some(bound), true, _) => all.push((relation.reversed(), bound)),
            _ => return wrong(),
        }
        before = next;
    }
    Ok(all)
}

impl Relation {
    /// The relation of b to a.
    fn reversed(self) -> Self {
        match self {
            Self::Equal | Self::Unequal => self,
            Self::Less => Self::Greater,
            Self::AtMost => Self::AtLeast,
            Self::Greater => Self::Less,
            Self::AtLeast => Self::AtMost,
        }
    }
}

/// A part of a term.
#[derive(Clone, Copy)]
enum Part<'a> {
    Real(&'a Real),
    Int(&'a Int),
}

impl Real {
    /// Has some part of it a property?
    fn any(&self, has: &dyn Fn(Part<'_>) -> bool) -> bool {
        let ints = |of: &[Int]| of.iter().any(|i| i.any(has));
        has(Part::Real(self))
            || match self {
                Self::Whole(i) | Self::Knot(i) => i.any(has),
                Self::Coefficient(_, of) | Self::Parameter(_, of) | Self::Defined(_, of) => ints(of),
                Self::Plus(a, b)
                | Self::Minus(a, b)
                | Self::Times(a, b)
                | Self::Over(a, b)
                | Self::Least(a, b)
                | Self::Greatest(a, b) => a.any(has) || b.any(has),
                Self::Negated(a) | Self::Absolute(a) | Self::Root(a) => a.any(has),
                Self::Power(a, e) => a.any(has) || e.any(has),
                Self::Fold(_, range, body) => range.from.any(has) || range.to.any(has) || body.any(has),
                Self::Value(f, argument) => {
                    let Argument { at, .. } = &**argument;
                    at.any(has) || matches!(&**f, Function::Defined(_, of) if ints(of))
                }
                Self::Number(_)
                | Self::Bound(_)
                | Self::Index(_)
                | Self::Ratio
                | Self::Infinity
                | Self::Word(_) => false,
            }
    }
}

impl Int {
    fn any(&self, has: &dyn Fn(Part<'_>) -> bool) -> bool {
        has(Part::Int(self))
            || match self {
                Self::Plus(a, b)
                | Self::Minus(a, b)
                | Self::Times(a, b)
                | Self::Least(a, b)
                | Self::Greatest(a, b)
                | Self::Binomial(a, b) => a.any(has) || b.any(has),
                Self::Number(_) | Self::Bound(_) | Self::Degree | Self::Last | Self::M | Self::Word(_) => {
                    false
                }
            }
    }
}
