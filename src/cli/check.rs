//! The command `check`: the paper's claims on one instance, for every x.

use std::fmt;

use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser as _;
use serde::Serialize;

use crate::certificate::{Form as Of, certify_for_degree};
use crate::claims::{
    BasisCase, Claim, Fault, Form, Origin, Scope, Source, Statement, Verdict, WeightCase, claims, judge,
};
use crate::report::Finding;
use crate::spline::Basis;

use super::error::CliError;
use super::exit::Exit;
use super::instance::InstanceArgs;
use super::output::Output;
use super::progress::Progress;
use super::verdict::{Tally, styled};

/// Decides the paper's claims on one instance: for every x, exactly.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub(super) struct Args {
    #[command(flatten)]
    instance: InstanceArgs,
    /// Only this claim, such as T3.5.3; may be repeated. Without it, every claim of the paper that is about a
    /// weight, a basis or a curve in general; the questions X.… are judged where they are named.
    #[arg(long, value_name = "CLAIM")]
    property: Vec<String>,
    /// The least scope that counts: a claim that is proved for less is called undecided.
    #[arg(long, value_name = "S", default_value = "instance", value_parser = scope_parser())]
    scope: Scope,
}

const EXAMPLE: &str = r#"Examples:
  knotproof check --degree 2 --knots "0 0 0 1 1 1 2 2 2" --alpha -1
  knotproof check --instance U4 --property T3.5.4 --property X.G1 --format json
Exit code 1 means that some claim is refuted as printed; the witness says where."#;

fn scope_parser() -> impl clap::builder::TypedValueParser<Value = Scope> {
    PossibleValuesParser::new(Scope::ALL.map(Scope::name))
        .map(|name| Scope::ALL.into_iter().find(|scope| scope.name() == name).unwrap_or(Scope::Instance))
}

/// The result: its fields are the JSON.
#[derive(Debug, Serialize)]
struct Check {
    schema: &'static str,
    degree: usize,
    knots: Vec<String>,
    properties: Vec<Property>,
    #[serde(skip)]
    label: Option<String>,
}

/// One claim on the instance with one index.
#[derive(Debug, Serialize)]
struct Property {
    id: &'static str,
    alpha: String,
    statement: &'static str,
    #[serde(flatten)]
    finding: Finding,
    /// The amended statement, where the printed one is refuted.
    #[serde(skip_serializing_if = "Option::is_none")]
    amended: Option<Amended>,
}

#[derive(Debug, Serialize)]
struct Amended {
    statement: &'static str,
    #[serde(flatten)]
    finding: Finding,
}

/// Judges and prints.
pub(super) fn run(args: &Args, output: &Output) -> Result<Exit, CliError> {
    let subject = args.instance.resolve()?;
    let chosen = choose(claims(), &args.property)?;
    let progress = Progress::new(chosen.len() * subject.cases.len());
    let mut properties = Vec::new();
    for case in &subject.cases {
        let cases = UserCases::new(&case.basis);
        for claim in &chosen {
            progress.step(claim.id);
            properties.push(cases.property(claim, args.scope)?);
        }
    }
    drop(progress);
    let tally: Tally = properties.iter().map(|property| &property.finding).collect();
    let first = &subject.cases[0].basis;
    let check = Check {
        schema: "knotproof.check/1",
        degree: first.degree(),
        knots: first.knots().knots().iter().map(ToString::to_string).collect(),
        properties,
        label: subject.label,
    };
    output.result(&check)?;
    Ok(tally.exit())
}

/// The claims asked for, or all that are about instances in general.
fn choose(all: Vec<Claim>, names: &[String]) -> Result<Vec<Claim>, CliError> {
    let ids: Vec<_> = all.iter().map(|claim| claim.id).collect();
    for name in names {
        match all.iter().find(|claim| claim.id == name) {
            None => return Err(CliError::unknown_claim("--property", name, &ids)),
            Some(claim) if !claim.printed.is_general() => {
                return Err(CliError::NotGeneral { claim: name.clone() });
            }
            Some(_) => {}
        }
    }
    let wanted = |claim: &Claim| match names {
        [] => claim.source() == Source::Paper && claim.printed.is_general(),
        names => names.iter().any(|name| name == claim.id),
    };
    Ok(all.into_iter().filter(wanted).collect())
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

    fn property(&self, claim: &Claim, scope: Scope) -> Result<Property, CliError> {
        let nothing = || (&Verdict::NotApplicable("there is nothing to judge".into())).into();
        let finding = self.verdict(claim, Of::Printed, scope)?.unwrap_or_else(nothing);
        let amended = match &claim.amended {
            Some(form) if finding.witness.is_some() => self
                .verdict(claim, Of::Amended, scope)?
                .map(|finding| Amended { statement: form.text(), finding }),
            _ => None,
        };
        let alpha = self.bases[0].basis().index().to_string();
        Ok(Property { id: claim.id, alpha, statement: claim.printed.text(), finding, amended })
    }
}

/// One paragraph a claim.
impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(label) = &self.label {
            writeln!(f, "{label}")?;
        }
        writeln!(f, "k = {}, U = ({})", self.degree, self.knots.join(", "))?;
        let mut alpha = None;
        for property in &self.properties {
            if alpha != Some(&property.alpha) {
                writeln!(f, "\nα = {}, for every x:", property.alpha)?;
                alpha = Some(&property.alpha);
            }
            write!(f, "  {:26} {}", property.id, styled(&property.finding))?;
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
