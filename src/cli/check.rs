//! The command `check`: the paper's claims on one instance, for every x.

use std::fmt;

use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser as _;
use schemars::JsonSchema;
use serde::Serialize;

use crate::certificate::{Form as Of, certify_for_degree};
use crate::claims::{
    BasisCase, Claim, Fault, Form, Origin, Scope, Source, Statement, Verdict, WeightCase, claims, judge,
};
use crate::report::{Baseline, Finding};
use crate::spline::Basis;

use super::error::CliError;
use super::exit::Exit;
use super::instance::InstanceArgs;
use super::offered::claim_name;
use super::output::Output;
use super::progress::Progress;
use super::verdict::{Tally, styled};

/// Decides the paper's claims on one instance: for every x, exactly.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// Only this claim, such as T3.5.3; may be repeated. Without it, every claim of the paper about bases and curves
    /// in general: what depends on the instance.
    #[arg(long, value_name = "CLAIM", value_parser = claim_name(), hide_possible_values = true)]
    property: Vec<String>,
    /// Every statement that can be judged on an instance: also those about the weight alone, which are the same on any
    /// instance, and the questions X.….
    #[arg(long, conflicts_with = "property")]
    all: bool,
    /// Judges the amended statement in place of the printed one, where there is one.
    #[arg(long)]
    amended: bool,
    /// Exit code 1 only where something is refuted that is recorded as proved.
    #[arg(long)]
    baseline: bool,
    /// The least scope that counts: a claim that is proved for less is called undecided.
    #[arg(long, value_name = "S", default_value = "instance", value_parser = scope_parser())]
    scope: Scope,
}

const EXAMPLE: &str = r#"Examples:
  knotproof check --degree 2 --knots "0 0 0 1 1 1 2 2 2" --alpha -1
  knotproof check --instance U4 --property T3.5.4 --property X.G1 --format json
  knotproof check --instance U4 --alpha -1 --amended
  knotproof check --instance U4 --alpha -1 --all --baseline
Exit code 1 means that some claim is refuted, the first two and many others as printed; the witness says where. The
last two end with 0: what is known to be true holds here too."#;

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
    /// k.
    degree: usize,
    /// t_0, …, t_m, as fractions in lowest terms.
    knots: Vec<String>,
    /// The claims, for one α after the other.
    properties: Vec<Property>,
    #[serde(skip)]
    label: Option<String>,
}

/// One claim on the instance with one index.
#[derive(Debug, Serialize, JsonSchema)]
struct Property {
    /// The claim.
    id: &'static str,
    /// α: `inf`, or an exact number.
    alpha: String,
    /// Is it the printed statement, or the amended one?
    #[serde(serialize_with = "named")]
    #[schemars(with = "String", extend("enum" = ["printed", "amended"]))]
    form: Of,
    /// It, in words and formulas.
    statement: &'static str,
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
    statement: &'static str,
    #[serde(flatten)]
    finding: Finding,
}

fn named<S: serde::Serializer>(form: &Of, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(form)
}

/// Judges and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let subject = args.instance.resolve()?;
    let chosen = choose(claims(), args)?;
    let recorded = args.baseline.then(Baseline::recorded).transpose().map_err(CliError::Recorded)?;
    let progress = Progress::new(chosen.len() * subject.cases.len());
    let mut properties = Vec::new();
    for case in &subject.cases {
        let cases = UserCases::new(&case.basis);
        for claim in &chosen {
            progress.step(claim.id);
            properties.push(cases.property(claim, args, recorded.as_ref())?);
        }
    }
    drop(progress);
    let unexpected = properties.iter().filter(|property| property.as_recorded != Some(true));
    let counted: Tally = unexpected.map(|property| &property.finding).collect();
    let first = &subject.cases[0].basis;
    let check = Check {
        schema: "knotproof.check/1",
        degree: first.degree(),
        knots: first.knots().knots().iter().map(ToString::to_string).collect(),
        properties,
        label: subject.label,
    };
    output.result_of_paper(&check)?;
    Ok(counted.exit())
}

/// The claims asked for: by name, all that can be judged on an instance, or those that depend on it.
fn choose(all: Vec<Claim>, args: &Args) -> Result<Vec<Claim>, CliError> {
    let ids: Vec<_> = all.iter().map(|claim| claim.id).collect();
    for name in &args.property {
        match all.iter().find(|claim| claim.id == name) {
            None => return Err(CliError::unknown_claim("--property", name, &ids)),
            Some(claim) if !claim.printed.is_general() => {
                return Err(CliError::NotGeneral { claim: name.clone() });
            }
            Some(_) => {}
        }
    }
    let wanted = |claim: &Claim| match args.property.as_slice() {
        [] if args.all => claim.printed.is_general(),
        [] => claim.source() == Source::Paper && matches!(claim.printed, Form::Basis(_)),
        names => names.iter().any(|name| name == claim.id),
    };
    Ok(all.into_iter().filter(wanted).collect())
}

/// Does the recorded verdict on the statement, in that degree, let one expect what was found? Only what is refuted
/// and was proved is news: proofs are about all instances, refutations about some.
fn as_recorded(baseline: &Baseline, id: &str, form: Of, degree: usize, found: &Finding) -> bool {
    let entry = baseline.claims.iter().find(|entry| entry.id == id);
    let recorded = entry.and_then(|entry| match form {
        Of::Amended => entry.amended.as_ref(),
        _ => {
            let of_degree = entry.by_degree.iter().find(|of| of.degree == degree).map(|of| &of.finding);
            of_degree.or(Some(&entry.as_printed))
        }
    });
    found.witness.is_none() || recorded.is_some_and(|recorded| recorded.witness.is_some())
}

/// What the claims are judged on: the basis, and the intervals of its weights.
struct UserCases {
    bases: [BasisCase; 1],
    weights: Vec<WeightCase>,
}

impl UserCases {
    fn new(basis: &Basis) -> Self {
        let (knots, index) = (basis.knots(), basis.index());
        let mut intervals = vec![(knots.first(), knots.last())];
        for d in 1..=basis.degree() {
            intervals.extend((0..=knots.m() - d).map(|i| (knots.t(i), knots.t(i + d))));
        }
        intervals.retain(|(a, b)| a < b);
        intervals.sort();
        intervals.dedup();
        let weight =
            |(a, b): (&_, &_)| WeightCase::new(Clone::clone(a), Clone::clone(b), index.clone(), Origin::User);
        let weights = intervals.into_iter().map(weight).collect();
        Self { bases: [BasisCase::new(basis.clone(), Origin::User)], weights }
    }

    fn verdict(&self, claim: &Claim, of: Of, scope: Scope) -> Result<Option<Finding>, CliError> {
        let form = match of {
            Of::Printed => &claim.printed,
            _ => match &claim.amended {
                Some(form) => form,
                None => return Ok(None),
            },
        };
        let verdict = match form {
            Form::Weight(statement) => judge(statement, &self.weights)?,
            Form::Basis(statement) => self.on_basis(statement)?,
            Form::Illustration(..) => {
                Verdict::NotApplicable("the claim is about examples of the paper".into())
            }
            Form::Vague { reason, .. } => Verdict::NotFormal((*reason).to_owned()),
        };
        // What is proved for every knot vector is proved for this one, and further.
        let certificate = match verdict {
            Verdict::Proved { .. } | Verdict::Undecided(_) => {
                certify_for_degree(claim, of, self.bases[0].basis().degree())?
            }
            _ => None,
        };
        if let Some(certificate) = &certificate {
            certificate.check()?;
        }
        let mut finding = Finding::from(&verdict).certified(certificate.as_ref());
        let reached = Scope::ALL.into_iter().find(|reached| finding.scope.as_deref() == Some(reached.name()));
        if let Some(reached) = reached.filter(|reached| *reached < scope) {
            let reason = format!("proved at scope {reached} only, and {scope} was asked for");
            finding = (&Verdict::Undecided(reason)).into();
        }
        Ok(Some(finding))
    }

    fn on_basis(&self, statement: &Statement<BasisCase>) -> Result<Verdict, Fault> {
        judge(statement, &self.bases)
    }

    fn property(
        &self,
        claim: &Claim,
        args: &Args,
        recorded: Option<&Baseline>,
    ) -> Result<Property, CliError> {
        let (form, stated) = match &claim.amended {
            Some(amended) if args.amended => (Of::Amended, amended),
            _ => (Of::Printed, &claim.printed),
        };
        let nothing = || (&Verdict::NotApplicable("there is nothing to judge".into())).into();
        let finding = self.verdict(claim, form, args.scope)?.unwrap_or_else(nothing);
        let amended = match &claim.amended {
            Some(amended) if finding.witness.is_some() && form == Of::Printed => self
                .verdict(claim, Of::Amended, args.scope)?
                .map(|finding| Amended { statement: amended.text(), finding }),
            _ => None,
        };
        let basis = self.bases[0].basis();
        let as_recorded =
            recorded.map(|recorded| as_recorded(recorded, claim.id, form, basis.degree(), &finding));
        let alpha = basis.index().to_string();
        Ok(Property { id: claim.id, alpha, form, statement: stated.text(), finding, as_recorded, amended })
    }
}

/// One paragraph a claim.
impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(label) = &self.label {
            writeln!(f, "{label}")?;
        }
        writeln!(f, "k = {}, U = ({})", self.degree, self.knots.join(", "))?;
        let width = if self.properties.iter().any(|property| property.form == Of::Amended) { 35 } else { 26 };
        let mut alpha = None;
        for property in &self.properties {
            if alpha != Some(&property.alpha) {
                writeln!(f, "\nα = {}, for every x:", property.alpha)?;
                alpha = Some(&property.alpha);
            }
            let form = if property.form == Of::Amended { ", amended" } else { "" };
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
                let at = witness.given.iter().filter(|(name, _)| !["k", "U", "α"].contains(&name.as_str()));
                let at: Vec<_> = at.map(|(name, value)| format!("{name} = {value}")).collect();
                let at = if at.is_empty() { String::new() } else { format!("at {}: ", at.join(", ")) };
                writeln!(f, "      {at}it says {}; but {}", witness.claimed, witness.found)?;
            }
            if let Some(amended) = &property.amended {
                writeln!(f, "      amended: {} {}", styled(&amended.finding), amended.statement)?;
            }
        }
        let tally: Tally = self.properties.iter().map(|property| &property.finding).collect();
        write!(f, "\n{tally}")
    }
}
