//! The command `check`: claims on one instance, for every x; the paper's, or sentences of the user's own.

use std::borrow::Cow;
use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser as _;
use schemars::JsonSchema;
use serde::Serialize;

use crate::judge::{Cases, OfFamily, Scope, Verdict};
use crate::language::{Claim, Family, File, Form, Known, Paper, Said, Source, Stanza, classical, paper};
use crate::meaning::{Instance, Weighting, examples_of, setting};
use crate::report::{Baseline, Finding};
use crate::settle::{Proving, settle_form};
use crate::typed::TypedError;

use super::error::CliError;
use super::exit::Exit;
use super::file::read;
use super::instance::{InstanceArgs, MemberSubject, Resolved, Subjects};
use super::offered::claim_name;
use super::output::Output;
use super::paper::paper_of;
use super::progress::Progress;
use super::verdict::{Tally, styled};

/// Decides claims on one instance: for every x, exactly. The paper's, or sentences of your own in the language of
/// docs/language.md, which are judged on all small cases where no instance is given.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// The claims and the instances of this paper: a folder, or the name of one that comes with the program. Its family is the
    /// one that --set is about, unless --family names another.
    #[arg(long, value_name = "FOLDER|NAME", conflicts_with = "baseline")]
    paper: Option<OsString>,
    /// Only this claim, such as T3.5.3; may be repeated. Without it, every claim of the paper about bases and curves
    /// in general: what depends on the instance.
    #[arg(long, value_name = "CLAIM", value_parser = claim_name(), hide_possible_values = true)]
    property: Vec<String>,
    /// A sentence of your own: "BINDERS : FORMULA", or "BINDERS | HYPOTHESES : FORMULA". On an instance `k; U` need not
    /// be among the binders.
    #[arg(long, value_name = "SENTENCE", conflicts_with_all = ["property", "all", "amended", "baseline"])]
    claim: Option<String>,
    /// A file of claims (TOML), such as those below papers/.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["property", "claim", "all", "baseline"])]
    claims: Option<PathBuf>,
    /// The classical properties of B-splines in place of the paper's claims; with `--property` some of them.
    #[arg(long, conflicts_with_all = ["claim", "claims", "all", "amended", "baseline"])]
    classical: bool,
    /// Every statement that can be judged on an instance: also those about the weight alone, which are the same on any
    /// instance, and the questions X.….
    #[arg(long, conflicts_with = "property")]
    all: bool,
    /// Judges the amended statement in place of the printed one, where there is one.
    #[arg(long)]
    amended: bool,
    /// Exit code 1 only where something is refuted that is recorded as proved.
    #[arg(long, conflicts_with = "family")]
    baseline: bool,
    /// The least scope that counts: a claim that is proved for less is called undecided.
    #[arg(long, value_name = "S", default_value = "instance", value_parser = scope_parser())]
    scope: Scope,
}

const EXAMPLE: &str = r#"Examples:
  knotproof check --degree 2 --knots "0 0 0 1 1 1 2 2 2" --alpha -1  # exit code 1
  knotproof check --instance U4 --property T3.5.4 --property X.G1 --format json
  knotproof check --instance U4 --alpha -1 --amended
  knotproof check --instance U4 --alpha -1 --all --baseline
  knotproof check --degree 2 --knots "0 0 0 1 2 2 2" --alpha -1 \
    --claim "i in 0..n; x in [t[0], t[m]] : G[i](x) <= 1"
  knotproof check --claim "k; U open; i in 0..n : maxima(G[i]) <= 1"
  knotproof check --family lupas --classical --property unity --property C1  # exit code 1
  knotproof check --family lupas \
    --claim "k; U clamped : G'[0](t[0]) = -k*q^(k-1)/(t[k+1]-t[0])"  # exit code 1
Exit code 1 means that some claim is refuted, the first two and many others as printed, and the last three; the witness
says where. The others end with 0: what is known to be true holds here too."#;

fn scope_parser() -> impl clap::builder::TypedValueParser<Value = Scope> {
    PossibleValuesParser::new(Scope::ALL.map(Scope::name))
        .map(|name| Scope::ALL.into_iter().find(|scope| scope.name() == name).unwrap_or(Scope::Instance))
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Check {
    /// What this object is: `knotproof.check/1`.
    #[schemars(extend("const" = "knotproof.check/1"))]
    schema: &'static str,
    /// k; nothing where all small cases were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    degree: Option<usize>,
    /// The member of another family than that of an index; nothing where many members were judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    family: Option<OfFamily>,
    /// t_0, …, t_m, as fractions in lowest terms; nothing where all small cases were judged.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    knots: Vec<String>,
    /// The claims, for one α after the other.
    properties: Vec<Property>,
    #[serde(skip)]
    label: Option<String>,
    /// The family, for the head of a text.
    #[serde(skip)]
    of: Option<String>,
}

/// One claim on the instance with one index.
#[derive(Debug, Serialize, JsonSchema)]
struct Property {
    /// The claim.
    id: String,
    /// α: `inf`, or an exact number; nothing where all small cases were judged, or for another family.
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha: Option<String>,
    /// Is it the printed statement, or the amended one?
    #[serde(serialize_with = "named")]
    #[schemars(with = "String", extend("enum" = ["printed", "amended"]))]
    form: Form,
    /// It, in words and formulas.
    statement: String,
    #[serde(flatten)]
    finding: Finding,
    /// Under `--baseline`: is it what the recorded verdict lets one expect?
    #[serde(skip_serializing_if = "Option::is_none")]
    as_recorded: Option<bool>,
    /// The amended statement, where the printed one is refuted.
    #[serde(skip_serializing_if = "Option::is_none")]
    amended: Option<Amended>,
}

/// A statement that takes the place of the printed one, with its verdict.
#[derive(Debug, Serialize, JsonSchema)]
struct Amended {
    /// It, in words and formulas.
    statement: String,
    #[serde(flatten)]
    finding: Finding,
}

fn named<S: serde::Serializer>(form: &Form, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(form)
}

/// Judges and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let paper = match &args.paper {
        Some(name) => paper_of("--paper", name)?,
        None => Cow::Borrowed(paper()),
    };
    let own_family = args.paper.is_some().then_some(&paper.about.family);
    let own = args.own_claims(&paper, own_family)?;
    let count = own.as_ref().map(|own| own.claims.len());
    // What they name of the paper is there too.
    let library = own.map(|own| paper.with(own));
    let chosen = match (&library, count) {
        (Some(library), Some(count)) => Claim::of(library).take(count).collect(),
        _ => args.of_paper(&paper)?,
    };
    let recorded = args.baseline.then(Baseline::recorded).transpose().map_err(CliError::Recorded)?;
    let mut check = Check {
        schema: "knotproof.check/1",
        degree: None,
        family: None,
        knots: Vec::new(),
        properties: Vec::new(),
        label: None,
        of: None,
    };
    let mut all = Vec::new();
    let chosen_family = args.instance.family(own_family)?;
    let member = |error| TypedError::Member { argument: "--family", error };
    if let (Some(_), Some(of), true) = (&library, &chosen_family, args.instance.is_without_knots()) {
        check.of = Some(of.family.name.clone());
        all.push((None, None, Cases::of_family(&of.family, &of.given).map_err(member)?));
    } else if library.is_some() && args.instance.is_absent() {
        all.push((None, None, Cases::of_paper(&paper).map_err(member)?));
    } else {
        let examples = examples_of(&paper.examples, &paper.about.family);
        // Own sentences may be about any weights, and the claims that are there if no paper is named.
        let any = args.paper.is_none();
        let subjects = match args.instance.resolve_among(&examples, own_family)? {
            Resolved::Indices(subjects) => subjects,
            Resolved::Member(MemberSubject { label, basis, points }) => {
                native(&paper, any, basis.weights())?;
                check.degree = Some(basis.degree());
                check.family = OfFamily::of(basis.weights());
                check.of = Some(basis.weights().to_string());
                check.knots = basis.knots().knots().iter().map(ToString::to_string).collect();
                check.label = label;
                let points = points.map(|(points, _)| points);
                let on = Instance::on(basis).map_err(member)?.with_points(points);
                all.push((on.degree(), None, Cases::only(on)));
                Subjects { label: None, cases: Vec::new() }
            }
        };
        for subject in &subjects.cases {
            native(&paper, any, &Weighting::Index(subject.basis.index().clone()))?;
        }
        if let Some(first) = subjects.cases.first() {
            check.degree = Some(first.basis.degree());
            check.knots = first.basis.knots().knots().iter().map(ToString::to_string).collect();
            check.label = subjects.label;
        }
        for subject in &subjects.cases {
            let points = subject.curve.as_ref().map(|curve| curve.points().to_vec());
            let on = Instance::of(subject.basis.clone()).with_points(points);
            let (k, alpha) = (subject.basis.degree(), subject.basis.index().to_string());
            all.push((Some(k), Some(alpha), Cases::only(on)));
        }
    }
    // What is proved is about the weights of an index.
    let proves = library.is_none() && check.of.is_none();
    let each: Vec<_> = all.iter().flat_map(|on| chosen.iter().map(move |claim| (on, *claim))).collect();
    let progress = Progress::new(each.len());
    let properties = progress.each(
        &each,
        |(_, claim)| claim.id().to_owned(),
        |((degree, alpha, cases), claim)| {
            let on = On { degree: *degree, cases, proves, scope: args.scope };
            let property = on.property(*claim, args.amended, recorded.as_ref())?;
            Ok(Property { alpha: alpha.clone(), ..property })
        },
    );
    check.properties = properties.into_iter().collect::<Result<_, CliError>>()?;
    drop(progress);
    let unexpected = check.properties.iter().filter(|property| property.as_recorded != Some(true));
    let counted: Tally = unexpected.map(|property| &property.finding).collect();
    output.result_of(&paper, &check)?;
    Ok(counted.exit())
}

/// Claims about a paper's family are judged on its members; unless they may be about `any`.
///
/// # Errors
/// [`CliError::Foreign`] for other weights.
pub fn native(paper: &Paper, any: bool, weights: &Weighting) -> Result<(), CliError> {
    let family: &Family = &paper.about.family;
    let is_native = match weights {
        Weighting::Index(index) => family.has_index(index.alpha().as_ref()),
        Weighting::Family(member) => {
            let other = member.family();
            (&other.name, &other.rise, &other.fall) == (&family.name, &family.rise, &family.fall)
        }
    };
    if is_native || any {
        return Ok(());
    }
    let (argument, shown) = match weights {
        Weighting::Index(index) => ("--alpha", format!("index {index}")),
        Weighting::Family(member) => ("--family", format!("member {}", member.family().name)),
    };
    let advice = match (family.moebius(), family.parameters.first()) {
        (Some(_), _) => "write --alpha inf".to_owned(),
        (None, None) => format!("write --family {}", family.given),
        (None, Some(own)) => format!("write --family {} --set {}", family.given, setting(own)),
    };
    Err(CliError::Foreign { argument, family: family.name.clone(), weights: shown, advice })
}

impl Args {
    /// The sentence or the file of the user's own, if one is given.
    fn own_claims(&self, paper: &Paper, family: Option<&Arc<Family>>) -> Result<Option<File>, CliError> {
        if let Some(text) = &self.claim {
            let complain = |complaint| CliError::Claim { argument: "--claim", complaints: vec![complaint] };
            let known = self.known(paper.known(), family)?;
            let sentence = match self.instance.is_without_knots() {
                true => known.one_line(text),
                false => known.one_line_on_knots(text),
            };
            let printed = Said::Sentence(sentence.map_err(complain)?);
            return Ok(Some(File {
                title: None,
                definitions: Vec::new(),
                claims: vec![Stanza::own(printed)],
            }));
        }
        if self.classical {
            return self.of_classical().map(Some);
        }
        let Some(path) = &self.claims else { return Ok(None) };
        let text = read("--claims", path)?;
        let name = path.display().to_string();
        let file = paper.stanzas_about(self.known(paper.known(), family)?, &name, &text);
        file.map(Some).map_err(|complaints| CliError::Claim { argument: "--claims", complaints })
    }

    /// What sentences may say of the family that is chosen.
    fn known(&self, known: Known, family: Option<&Arc<Family>>) -> Result<Known, CliError> {
        Ok(match self.instance.family(family)? {
            Some(chosen) => known.about(&chosen.family),
            None => known,
        })
    }

    /// The classical properties that are asked for.
    fn of_classical(&self) -> Result<File, CliError> {
        let mut file = classical().clone();
        let ids: Vec<_> = classical().claims.iter().map(|stanza| &*stanza.id).collect();
        if let Some(unknown) = self.property.iter().find(|name| !ids.contains(&name.as_str())) {
            return Err(CliError::unknown_claim("--property", unknown, &ids));
        }
        let wanted = |stanza: &Stanza| {
            self.property.is_empty() || self.property.iter().any(|name| **name == *stanza.id)
        };
        file.claims.retain(wanted);
        Ok(file)
    }

    /// The paper's claims that are asked for: by name, all that can be judged on an instance, or those that depend on it.
    fn of_paper<'a>(&self, paper: &'a Paper) -> Result<Vec<Claim<'a>>, CliError> {
        let all: Vec<_> = Claim::of(paper).collect();
        let ids: Vec<_> = all.iter().map(Claim::id).collect();
        for name in &self.property {
            match all.iter().find(|claim| claim.id() == name) {
                None => return Err(CliError::unknown_claim("--property", name, &ids)),
                Some(claim) if !claim.is_general() => {
                    return Err(CliError::NotGeneral { claim: name.clone(), judges: paper.judges(name) });
                }
                Some(_) => {}
            }
        }
        let wanted = |claim: &Claim<'_>| match self.property.as_slice() {
            [] if self.all => claim.is_general(),
            [] => claim.source() == Source::Paper && claim.is_general() && claim.is_about_knots(),
            names => names.iter().any(|name| name == claim.id()),
        };
        Ok(all.into_iter().filter(wanted).collect())
    }
}

/// Does the recorded verdict on the statement, in that degree, let one expect what was found? Only what is refuted
/// and was proved is news: proofs are about all instances, refutations about some.
fn as_recorded(baseline: &Baseline, id: &str, form: Form, degree: Option<usize>, found: &Finding) -> bool {
    let entry = baseline.claims.iter().find(|entry| entry.id == id);
    let recorded = entry.and_then(|entry| match form {
        Form::Amended => entry.amended.as_ref(),
        _ => {
            let of_degree = entry.by_degree.iter().find(|of| Some(of.degree) == degree);
            of_degree.map(|of| &of.finding).or(Some(&entry.as_printed))
        }
    });
    found.witness.is_none() || recorded.is_some_and(|recorded| recorded.witness.is_some())
}

/// What claims are judged on, and how far.
struct On<'a> {
    degree: Option<usize>,
    cases: &'a Cases,
    /// Are there windows for them?
    proves: bool,
    scope: Scope,
}

impl On<'_> {
    fn finding(&self, claim: Claim<'_>, form: Form) -> Result<Option<Finding>, CliError> {
        // What is proved for every knot vector is proved for this one, and further.
        let proving = if self.proves { Proving::ForDegree(self.degree) } else { Proving::Nothing };
        let Some(settled) = settle_form(claim, form, self.cases, proving)? else { return Ok(None) };
        let finding = Finding::of(claim, &settled);
        let reached = Scope::ALL.into_iter().find(|reached| finding.scope.as_deref() == Some(reached.name()));
        Ok(Some(match reached.filter(|reached| *reached < self.scope) {
            Some(reached) => {
                let reason = format!("proved at scope {reached} only, and {} was asked for", self.scope);
                (&Verdict::Undecided(reason)).into()
            }
            None => finding,
        }))
    }

    fn property(
        &self,
        claim: Claim<'_>,
        amended: bool,
        recorded: Option<&Baseline>,
    ) -> Result<Property, CliError> {
        let form = if amended && claim.said(Form::Amended).is_some() { Form::Amended } else { Form::Printed };
        let nothing = || (&Verdict::NotApplicable("there is nothing to judge".into())).into();
        let finding = self.finding(claim, form)?.unwrap_or_else(nothing);
        let amended = match finding.witness.is_some() && form == Form::Printed {
            true => self.finding(claim, Form::Amended)?,
            false => None,
        };
        Ok(Property {
            id: claim.id().to_owned(),
            alpha: None,
            form,
            statement: claim.text(form),
            as_recorded: recorded
                .map(|recorded| as_recorded(recorded, claim.id(), form, self.degree, &finding)),
            finding,
            amended: amended.map(|finding| Amended { statement: claim.text(Form::Amended), finding }),
        })
    }
}

/// One paragraph a claim.
impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(label) = &self.label {
            writeln!(f, "{label}")?;
        }
        match self.degree {
            Some(k) => writeln!(f, "k = {k}, U = ({})", self.knots.join(", "))?,
            None if self.of.is_some() => {}
            None => writeln!(f, "On all small cases and the paper's examples, for every x:")?,
        }
        match (&self.of, self.degree) {
            (Some(of), Some(_)) => writeln!(f, "\nFamily {of}, for every x:")?,
            (Some(of), None) => writeln!(f, "On small cases of the family {of}, for every x:")?,
            (None, _) => {}
        }
        let width =
            if self.properties.iter().any(|property| property.form == Form::Amended) { 35 } else { 26 };
        let mut alpha = &None;
        for property in &self.properties {
            if alpha != &property.alpha {
                writeln!(f, "\nα = {}, for every x:", property.alpha.as_deref().unwrap_or_default())?;
                alpha = &property.alpha;
            }
            let form = if property.form == Form::Amended { ", amended" } else { "" };
            let name = format!("{}{form}", property.id);
            write!(f, "  {name:width$} {}", styled(&property.finding))?;
            match property.as_recorded {
                Some(false) => write!(f, ", not as recorded")?,
                Some(true) if property.finding.witness.is_some() => write!(f, ", as recorded")?,
                _ => {}
            }
            match &property.finding.reason {
                Some(reason) => writeln!(f, ": {reason}")?,
                None => writeln!(f)?,
            }
            for remark in &property.finding.remarks {
                writeln!(f, "      {remark}")?;
            }
            if let Some(witness) = &property.finding.witness {
                writeln!(f, "      {}", property.statement)?;
                // The case stands at the head, if there is only one.
                let known = if self.degree.is_some() { ["k", "U", "α"].as_slice() } else { &[] };
                let of = witness.family.as_ref().filter(|_| self.degree.is_some());
                let set =
                    |name: &str| of.is_some_and(|of| name == "family" || of.parameters.contains_key(name));
                let at = witness.given().into_iter();
                let at = at.filter(|(name, _)| !known.contains(&name.as_str()) && !set(name));
                let told = |(name, value): (String, String)| match name.as_str() {
                    "instance" => value,
                    _ => format!("{name} = {value}"),
                };
                let at: Vec<_> = at.map(told).collect();
                let at = if at.is_empty() { String::new() } else { format!("at {}: ", at.join(", ")) };
                writeln!(f, "      {at}it says {}; but {}", witness.claimed, witness.found())?;
            }
            if let Some(amended) = &property.amended {
                writeln!(f, "      amended: {} {}", styled(&amended.finding), amended.statement)?;
            }
        }
        let tally: Tally = self.properties.iter().map(|property| &property.finding).collect();
        write!(f, "\n{tally}")
    }
}
