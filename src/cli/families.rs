//! The command `families`: families of splines as data, what they are, and which classical properties they have.

use std::ffi::OsString;
use std::fmt;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Serialize;

use crate::judge::{Cases, Verdict, judge};
use crate::language::{
    Adjective, Claim, Family, Form, Name, Paper, Parameter, Real, classical, families, paper, source,
};
use crate::meaning::{MemberError, Values, Weighting, has};
use crate::scalar::{integer, rational};
use crate::settle::SettleError;
use crate::spline::KnotVector;
use crate::typed::TypedError;

use super::error::CliError;
use super::exit::Exit;
use super::family::find;
use super::output::Output;
use super::progress::Progress;
use super::table::plain;

/// Lists the families of splines, shows one, finds one by its weights, or judges the classical properties of all.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    /// Shows this family: a name, or a file of your own.
    #[arg(value_name = "NAME|FILE")]
    family: Option<OsString>,
    /// Finds families with these weights "RISE : FALL", by x, a, b, i, d, s, k, t[i] and names of your own for parameters.
    #[arg(long, value_name = "RATIO", conflicts_with = "family", allow_hyphen_values = true)]
    like: Option<String>,
    /// Judges the classical properties of all families, or of the one that is named, on small cases: a page in Markdown. It takes
    /// minutes.
    #[arg(long, conflicts_with = "like")]
    table: bool,
}

const EXAMPLE: &str = r#"Examples:
  knotproof families
  knotproof families lupas
  knotproof families --like "q^(d-1)*(x-a) : b-x"
  knotproof families polya --table"#;

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Families {
    /// What this object is: `knotproof.families/1`.
    #[schemars(extend("const" = "knotproof.families/1"))]
    schema: &'static str,
    /// The families: all, the one that is named, or those with the weights that were asked for.
    families: Vec<Shown>,
    /// Under `--like`, of linear weights: the slope ratio of the Möbius map on every interval.
    #[serde(skip_serializing_if = "Option::is_none")]
    slope_ratio: Option<String>,
    #[serde(skip)]
    layout: Layout,
}

/// How it is told in a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Layout {
    List,
    One,
    Like,
}

/// A family.
#[derive(Debug, Serialize, JsonSchema)]
struct Shown {
    /// Its name.
    name: String,
    /// What it is.
    title: String,
    /// Where it comes from.
    source: String,
    /// The knots that it is for; nothing, if for any.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    knots: Vec<String>,
    /// Its parameters with their bounds.
    parameters: Vec<Bounded>,
    /// rise : fall.
    weight: String,
    /// What reads a member otherwise, by parameters; and back.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    reads: Vec<String>,
    /// The parameters of the polynomial B-splines; nothing, if they are no member, or the only one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    classical: Vec<String>,
    /// The parameters that the reflection of the knots leads to, of those that change; `null`, if they are not known.
    dual: Option<Vec<String>>,
    /// Under `--like`: the parameters of the family by those of the weights that were asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    with: Vec<String>,
}

/// A parameter.
#[derive(Debug, Serialize, JsonSchema)]
struct Bounded {
    /// As written: `omega[i]`.
    parameter: String,
    /// What its numbers satisfy; nothing, if they may be any.
    bound: String,
}

impl Shown {
    fn of(family: &Family) -> Self {
        let bounded =
            |parameter: &Parameter| Bounded { parameter: parameter.head(), bound: parameter.says.clone() };
        let head = |name: &Name| {
            let own = family.parameters.iter().find(|own| own.name == *name);
            own.map_or_else(|| name.to_string(), Parameter::head)
        };
        let equations = |all: &[(Name, Real)]| -> Vec<String> {
            all.iter().map(|(name, term)| format!("{} = {}", head(name), source(term))).collect()
        };
        let reads = family.reads.iter().flat_map(|(_, all)| equations(all));
        Self {
            reads: reads.chain(equations(&family.writes)).collect(),
            classical: family.classical.as_deref().map(equations).unwrap_or_default(),
            dual: family.dual.as_deref().map(equations),
            name: family.name.clone(),
            title: family.title.clone(),
            source: family.source.clone(),
            knots: family.knots.iter().map(|adjective| adjective.name().to_owned()).collect(),
            parameters: family.parameters.iter().map(bounded).collect(),
            weight: family.ratio(true),
            with: Vec::new(),
        }
    }
}

/// Lists, shows, finds or judges.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let (mut slope_ratio, mut layout) = (None, Layout::List);
    let shown = match (&args.family, &args.like) {
        _ if args.table => return table(args, output),
        (Some(name), _) => {
            layout = Layout::One;
            vec![Shown::of(&*find(name)?)]
        }
        (None, Some(ratio)) => {
            layout = Layout::Like;
            let complain = |complaints| CliError::Claim { argument: "--like", complaints };
            let asked = Arc::new(Family::of_ratio(ratio).map_err(complain)?);
            slope_ratio = linear_ratio(&asked);
            like(&asked)?
        }
        (None, None) => families().iter().map(|family| Shown::of(family)).collect(),
    };
    let found = !shown.is_empty() || slope_ratio.is_some();
    output.result(&Families { schema: "knotproof.families/1", families: shown, slope_ratio, layout })?;
    Ok(if found { Exit::Holds } else { Exit::Undecided })
}

impl fmt::Display for Families {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.layout {
            Layout::List => {
                let mut table = plain(["family", "weights, rise : fall", "parameters"]);
                for Shown { name, weight, parameters, .. } in &self.families {
                    let bounds: Vec<_> = parameters.iter().map(|own| own.bound.clone()).collect();
                    table.add_row([name.clone(), weight.clone(), bounds.join(", ")]);
                }
                write!(f, "{}", table.trim_fmt())
            }
            Layout::One => self.families.iter().try_for_each(|own| write!(f, "{own}")),
            Layout::Like => {
                if let Some(ratio) = &self.slope_ratio {
                    writeln!(f, "On every interval a Möbius map with the slope ratio {ratio}.")?;
                }
                for Shown { name, with, .. } in &self.families {
                    let with =
                        if with.is_empty() { String::new() } else { format!(" with {}", with.join(", ")) };
                    writeln!(f, "The weights of {name}{with}, on all knots and numbers that were tried.")?;
                }
                if self.families.is_empty() {
                    write!(f, "No family that comes with the program has these weights.")?;
                }
                Ok(())
            }
        }
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.name, self.title)?;
        writeln!(f, "source: {}", self.source)?;
        writeln!(f, "weight: {}", self.weight)?;
        if !self.knots.is_empty() {
            writeln!(f, "knots: {}", self.knots.join(", "))?;
        }
        for Bounded { parameter, bound } in &self.parameters {
            writeln!(f, "parameter: {parameter}, {}", if bound.is_empty() { "any number" } else { bound })?;
        }
        for read in &self.reads {
            writeln!(f, "read by: {read}")?;
        }
        if !self.classical.is_empty() {
            writeln!(f, "polynomial B-splines: {}", self.classical.join(", "))?;
        }
        match self.dual.as_deref() {
            None => writeln!(f, "reflected knots: no member is known"),
            Some([]) => writeln!(f, "reflected knots: the same member"),
            Some(dual) => writeln!(f, "reflected knots: {}", dual.join(", ")),
        }
    }
}

/// Knots and degrees on which weights are compared.
fn samples() -> Vec<(usize, KnotVector)> {
    const SAMPLES: [(usize, &[i64]); 3] =
        [(3, &[0, 1, 3, 4, 7, 9, 12]), (2, &[0, 0, 0, 1, 3, 3, 3]), (3, &[1, 1, 1, 1, 3, 3, 3, 3])];
    let knots = |(degree, knots): &(usize, &[i64])| {
        let knots = KnotVector::new(knots.iter().map(|t| integer(*t)).collect());
        Some((*degree, knots.ok()?))
    };
    SAMPLES.iter().filter_map(knots).collect()
}

/// Numbers of a shape, all different.
fn sample(parameter: &Parameter, seed: i64, inverse: bool) -> Values {
    const ENOUGH: i64 = 13;
    let number = |at: i64| {
        let (p, q) = (2 + seed + at * (at + 1), 3 + 2 * seed + at);
        if inverse { rational(q, p) } else { rational(p, q) }
    };
    match parameter.indices.len() {
        0 => Values::One(number(0)),
        1 => Values::List((0..ENOUGH).map(number).collect()),
        _ => {
            Values::Rows((0..4).map(|row| (0..ENOUGH).map(|i| number(ENOUGH * row + i)).collect()).collect())
        }
    }
}

/// The families that have these weights, with what their parameters are.
fn like(asked: &Arc<Family>) -> Result<Vec<Shown>, CliError> {
    let mut found = Vec::new();
    for family in families() {
        for matching in matchings(asked, family) {
            if same(asked, family, &matching)
                .map_err(|error| TypedError::Member { argument: "--like", error })?
            {
                let told = |(own, (place, inverse)): (&Parameter, &(usize, bool))| {
                    let other = asked.parameters[*place].head();
                    format!("{} = {}{other}", own.head(), if *inverse { "1/" } else { "" })
                };
                let with = family.parameters.iter().zip(&matching).map(told).collect();
                found.push(Shown { with, ..Shown::of(family) });
                break;
            }
        }
    }
    Ok(found)
}

/// For each parameter of the family one of those asked for, of as many indices, or its inverse.
fn matchings(asked: &Family, family: &Family) -> Vec<Vec<(usize, bool)>> {
    let mut all: Vec<Vec<(usize, bool)>> = vec![Vec::new()];
    for own in &family.parameters {
        let fits = |place: &usize| asked.parameters[*place].indices.len() == own.indices.len();
        let longer = |known: &Vec<(usize, bool)>| {
            let free = (0..asked.parameters.len()).filter(fits);
            let free = free.filter(|place| known.iter().all(|(other, _)| other != place));
            let next = |place: usize| {
                [(place, false), (place, true)].map(|choice| [known.as_slice(), &[choice]].concat())
            };
            free.flat_map(next).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all.retain(|matching| matching.len() == asked.parameters.len());
    all
}

fn same(asked: &Arc<Family>, family: &Arc<Family>, matching: &[(usize, bool)]) -> Result<bool, MemberError> {
    let mut compared = 0;
    for seed in 0..2 {
        let of_asked: Vec<_> =
            asked.parameters.iter().map(|own| (own.name.to_string(), sample(own, seed, false))).collect();
        let of_family = family.parameters.iter().zip(matching).map(|(own, (place, inverse))| {
            (own.name.to_string(), sample(&asked.parameters[*place], seed, *inverse))
        });
        let one = Weighting::of(asked, &of_asked)?;
        let Ok(other) = Weighting::of(family, &of_family.collect::<Vec<_>>()) else { return Ok(false) };
        for (degree, knots) in samples() {
            if family.knots.iter().any(|adjective| !has(*adjective, &knots, degree)) {
                continue;
            }
            let Ok(other) = other.table(&knots, degree) else { continue };
            let one = one.table(&knots, degree)?;
            compared += 1;
            if !one.iter().zip(other.iter()).all(|((_, one), (_, other))| one.is_proportional(other)) {
                return Ok(false);
            }
        }
    }
    Ok(compared > 0)
}

/// The slope ratio, as it is written, of weights that are linear on all samples.
fn linear_ratio(asked: &Arc<Family>) -> Option<String> {
    let given: Vec<_> =
        asked.parameters.iter().map(|own| (own.name.to_string(), sample(own, 0, false))).collect();
    let weights = Weighting::of(asked, &given).ok()?;
    for (degree, knots) in samples() {
        let table = weights.table(&knots, degree).ok()?;
        let mut all = table.iter();
        if all.any(|(_, forms)| forms.slope_ratio().is_none()) {
            return None;
        }
    }
    asked.slope_ratio()
}

/// A cell of the table.
struct Judged {
    cell: String,
    /// Why not, or why it is open.
    because: Option<String>,
}

fn judged(family: &Family, id: &str, verdict: &Verdict) -> Judged {
    let cell = |cell: &str, because: Option<String>| Judged { cell: cell.to_owned(), because };
    match verdict {
        Verdict::Proved { reach, .. } => {
            let highest = reach.degrees.iter().max().map(|k| format!(", k ≤ {k}")).unwrap_or_default();
            cell(&format!("yes: {}{highest}", reach.small_cases + reach.instances), None)
        }
        Verdict::Refuted(witness) => {
            let k = witness.k.map(|k| format!(": k = {k}")).unwrap_or_default();
            let given = witness.given().into_iter().map(|(name, value)| format!("{name} = {value}"));
            let because = format!(
                "no `{id}` at {}: not {}; {}. `{}`",
                given.collect::<Vec<_>>().join(", "),
                witness.claimed,
                witness.found(),
                witness.again(id, Form::Printed, paper())
            );
            cell(&format!("**no**{k}"), Some(because))
        }
        Verdict::Undecided(_) if family.dual.is_none() && id == "reflection" => {
            cell("–", Some(format!("nothing to say of `{id}`: the file has no `[dual]`")))
        }
        Verdict::Undecided(why) => cell("open", Some(format!("open `{id}`: {why}"))),
        Verdict::NotApplicable(_) | Verdict::NotFormal(_) => cell("–", None),
    }
}

/// The page of families × properties.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Page {
    /// What this object is: `knotproof.families-table/1`.
    #[schemars(extend("const" = "knotproof.families-table/1"))]
    schema: &'static str,
    /// It, in Markdown.
    markdown: String,
}

impl fmt::Display for Page {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.markdown.trim_end())
    }
}

fn table(args: &Args, output: &Output) -> Result<Exit, CliError> {
    /// Beyond cubic splines the cases are few, and slow.
    const HIGHEST: usize = 4;
    let chosen: Vec<Arc<Family>> = match &args.family {
        Some(name) => vec![find(name)?],
        None => families().to_vec(),
    };
    let properties = Paper { files: vec![classical().clone()], ..paper().clone() };
    let claims: Vec<Claim<'_>> = Claim::of(&properties).collect();
    let on = |family: &Arc<Family>| {
        let cases = Cases::of_family(family, &[]);
        let error = |error| TypedError::Member { argument: "--family", error };
        Ok((Arc::clone(family), cases.map_err(error)?.up_to(HIGHEST)))
    };
    let on = chosen.iter().map(on).collect::<Result<Vec<_>, CliError>>()?;
    let said: Vec<_> =
        claims.iter().filter_map(|claim| Some((*claim, claim.sentence(Form::Printed)?))).collect();
    let each: Vec<_> = on.iter().flat_map(|on| said.iter().map(move |said| (on, said))).collect();
    let progress = Progress::new(each.len());
    let name = |((family, _), (claim, _)): &(&(Arc<Family>, _), &(Claim<'_>, _))| {
        format!("{}, {}", family.name, claim.id())
    };
    let found = progress.each(&each, name, |((family, cases), (claim, sentence))| {
        let verdict =
            judge(sentence, (*claim).into(), &cases.of(sentence, None)).map_err(SettleError::Fault)?;
        Ok(judged(family, claim.id(), &verdict))
    });
    let mut found = found.into_iter().collect::<Result<Vec<_>, CliError>>()?.into_iter();
    let rows: Vec<_> =
        chosen.iter().map(|family| (family, found.by_ref().take(said.len()).collect())).collect();
    drop(progress);
    output.result(&Page { schema: "knotproof.families-table/1", markdown: markdown(&rows, &claims) })?;
    Ok(Exit::Holds)
}

fn markdown(rows: &[(&Arc<Family>, Vec<Judged>)], claims: &[Claim<'_>]) -> String {
    let mut page = String::from(HEAD);
    let names: Vec<_> = rows.iter().map(|(family, _)| family.name.as_str()).collect();
    page.push_str(&format!("| property | {} |\n|---|{}\n", names.join(" | "), "---|".repeat(names.len())));
    for (at, claim) in claims.iter().enumerate() {
        let cells: Vec<_> = rows.iter().filter_map(|(_, row)| Some(row.get(at)?.cell.as_str())).collect();
        page.push_str(&format!("| `{}` | {} |\n", claim.id(), cells.join(" | ")));
    }
    page.push_str("\n## The properties\n\n");
    for claim in claims {
        page.push_str(&format!(
            "- `{}`: {}. {}.\n",
            claim.id(),
            claim.stanza.title,
            claim.text(Form::Printed).trim_end_matches('.')
        ));
    }
    page.push_str("\n## The families, and why not\n");
    for (family, row) in rows {
        page.push_str(&format!("\n### {}\n\n{}. Source: {}.\n\n", family.name, family.title, family.source));
        page.push_str(&format!("- weight: `{}`\n", family.ratio(true)));
        for own in &family.parameters {
            page.push_str(&format!(
                "- parameter: `{}`\n",
                if own.says.is_empty() { own.head() } else { own.says.clone() }
            ));
        }
        let adjectives: Vec<_> = family.knots.iter().map(|adjective: &Adjective| adjective.name()).collect();
        if !adjectives.is_empty() {
            page.push_str(&format!("- knots: {}\n", adjectives.join(", ")));
        }
        for because in row.iter().filter_map(|judged| judged.because.as_ref()) {
            page.push_str(&format!("- {because}\n"));
        }
    }
    page
}

const HEAD: &str = "\
# Families of splines, and the classical properties

Which properties of polynomial B-splines does a family keep? A *yes* is decided for every x, exactly, on as many small cases as it says,
of the degrees up to k: knots and parameters in order of size. A *no* has a smallest witness, below, with the command that shows
it. *Open* is what these cases do not decide, with the reason: control values that are only tried refute, and prove nothing. A
dash: the cases of the family have nothing to do with it. This page is written by `knotproof families --table`, and a test compares
it.

";

#[cfg(test)]
mod tests {
    use super::*;

    fn found(ratio: &str) -> Vec<String> {
        let asked = Arc::new(Family::of_ratio(ratio).expect(ratio));
        let told = |shown: Shown| format!("{} {}", shown.name, shown.with.join(", ")).trim().to_owned();
        like(&asked).expect(ratio).into_iter().map(told).collect()
    }

    #[test]
    fn weights_are_found_up_to_a_common_factor() {
        assert_eq!(found("q^(d-1)*(x-a) : b-x"), ["lupas q = q"]);
        assert_eq!(found("x-a : p^(d-1)*(b-x)"), ["lupas q = 1/p"]);
        assert_eq!(found("2*(x-a)*(x-a+b) : 2*(b-x)*(x-a+b)"), ["classical"]);
        assert_eq!(found("z[i+d]*(x-a) : z[i]*(b-x)"), ["knot-weights omega[i] = z[i]"]);
        assert_eq!(found("s*(x-a) : b-x"), Vec::<String>::new());
        let ratio = |text: &str| linear_ratio(&Arc::new(Family::of_ratio(text).expect(text)));
        assert_eq!(ratio("q^(d-1)*(x-a) : b-x").as_deref(), Some("q^(d-1)"));
        assert_eq!(ratio("(x-a)^2 : (b-x)^2"), None);
    }
}
