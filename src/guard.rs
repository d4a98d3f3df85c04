//! The guard: every claim as the closure of `claims` and as the stanza of `papers/rational-bsplines/claims`, both on every
//! case, outcome and witness compared.
//!
//! ```sh
//! KNOTPROOF_GUARD_IDS=T3.5.3,L3.8 cargo test --lib guard -- --ignored --nocapture
//! ```
//!
//! | variable | means |
//! |---|---|
//! | `KNOTPROOF_GUARD_IDS` | identifiers; `T3.*` all that begin so; without it all |
//! | `KNOTPROOF_GUARD_DEGREE` | cases of at most this degree |
//! | `KNOTPROOF_GUARD_STEP` | every so-manyth case only |
//! | `KNOTPROOF_GUARD_SHOW` | how many differences of a kind are shown (3) |
//!
//! Where the closure is about bases, each case is compared: what differs is listed by kind (`closure holds, stanza refuted`)
//! with the first cases of it. Where it is about weights or instances, the verdicts are. `witness` is the smallest one of each
//! side. A `*` marks what has to be looked at. Times are wall-clock, of all cases in parallel; pieces are kept from one claim to
//! the next on both sides.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::claims::{self, BasisCase, Form, Statement, Stop};
use crate::judge::{self, Case, Origin, judge_case};
use crate::language::{self, Said, Sentence};
use crate::meaning::{Instance, Names, concerns};
use crate::spline::Basis;

/// What one side says of one case.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Says {
    Holds,
    Nothing,
    Refuted(String),
    Undecided(String),
    Fault(String),
}

impl Says {
    fn kind(&self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Nothing => "nothing",
            Self::Refuted(_) => "refuted",
            Self::Undecided(_) => "undecided",
            Self::Fault(_) => "FAULT",
        }
    }
}

impl std::fmt::Display for Says {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Refuted(at) => write!(f, "refuted: {at}"),
            Self::Undecided(why) | Self::Fault(why) => write!(f, "{}: {why}", self.kind()),
            Self::Holds | Self::Nothing => f.write_str(self.kind()),
        }
    }
}

fn listed(given: &[(String, String)]) -> String {
    let given: Vec<_> = given.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    given.join(", ")
}

fn of_closure(stop: &Stop) -> Says {
    match stop {
        Stop::Refuted(witness) => Says::Refuted(listed(&witness.given)),
        Stop::Undecided(why) => Says::Undecided(why.clone()),
        Stop::Fault(why) => Says::Fault(why.clone()),
    }
}

fn closure(statement: &Statement<BasisCase>, case: &BasisCase) -> Says {
    match statement.decide(case) {
        claims::Outcome::Holds(_) => Says::Holds,
        claims::Outcome::Nothing(_) => Says::Nothing,
        claims::Outcome::Stopped(stop) => of_closure(&stop),
    }
}

fn stanza(sentence: &Sentence, names: Names<'_>, case: &Case) -> Says {
    if !concerns(sentence, &case.on) {
        return Says::Nothing;
    }
    match judge_case(sentence, names, case) {
        Ok(judge::Outcome::Holds(..)) => Says::Holds,
        Ok(judge::Outcome::Nothing) => Says::Nothing,
        Ok(judge::Outcome::Refuted(witness)) => Says::Refuted(listed(&witness.given())),
        Ok(judge::Outcome::Undecided(why)) => Says::Undecided(why),
        Err(fault) => Says::Fault(fault.0),
    }
}

/// The settings of a run.
struct Settings {
    ids: Vec<String>,
    degree: usize,
    step: usize,
    show: usize,
}

impl Settings {
    fn read() -> Self {
        let text = |name: &str| std::env::var(format!("KNOTPROOF_GUARD_{name}")).ok();
        let number = |name: &str, default| text(name).map_or(default, |n| n.parse().expect("a number"));
        let ids = text("IDS").unwrap_or_default();
        Self {
            ids: ids.split(',').filter(|id| !id.is_empty()).map(|id| id.trim().to_owned()).collect(),
            degree: number("DEGREE", usize::MAX),
            step: number("STEP", 1).max(1),
            show: number("SHOW", 3),
        }
    }

    fn wants(&self, id: &str) -> bool {
        let fits = |wanted: &String| match wanted.strip_suffix('*') {
            Some(start) => id.starts_with(start),
            None => id == wanted,
        };
        self.ids.is_empty() || self.ids.iter().any(fits)
    }
}

/// The stanzas of all files; files that can't be read are told of and left out.
fn files() -> Vec<language::File> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("papers/rational-bsplines/claims");
    let mut paths: Vec<_> = match std::fs::read_dir(&folder) {
        Ok(entries) => entries.filter_map(|entry| Some(entry.ok()?.path())).collect(),
        Err(_) => Vec::new(),
    };
    paths.sort();
    let read = |path: &std::path::PathBuf| {
        let text = std::fs::read_to_string(path).ok()?;
        match language::stanzas(&path.display().to_string(), &text) {
            Ok(file) => Some(file),
            Err(complaints) => {
                complaints.iter().for_each(|complaint| println!("{complaint}"));
                None
            }
        }
    };
    paths.iter().filter(|path| path.extension().is_some_and(|end| end == "toml")).filter_map(read).collect()
}

/// The paper's instances, one for each index.
fn paper() -> impl Iterator<Item = Instance> {
    claims::instances().into_iter().flat_map(|instance| {
        let one = move |index: &crate::spline::Index| {
            let basis =
                Basis::new(instance.knots.clone(), instance.degree, index.clone()).expect("a test builds it");
            Instance::of(basis).named(instance.name, instance.points.clone())
        };
        instance.indices.clone().iter().map(one).collect::<Vec<_>>()
    })
}

/// Everything that both sides are run on.
struct Guard {
    settings: Settings,
    closures: claims::Cases,
    stanzas: judge::Cases,
    /// The same bases in the same order.
    bases: Vec<Case>,
}

impl Guard {
    fn new(settings: Settings) -> Self {
        let mut closures = claims::Cases::all();
        let mut place = 0;
        closures.bases.retain(|case| {
            place += 1;
            case.k() <= settings.degree && (place - 1) % settings.step == 0
        });
        let bases = closures.bases.iter();
        let bases = bases
            .map(|case| Case { on: Instance::of(case.basis().clone()), origin: Origin::Small })
            .collect();
        Self { settings, stanzas: judge::Cases::new(paper()), closures, bases }
    }

    fn compare(&self, head: &str, form: &Form, said: &Said, names: Names<'_>) {
        let Some(sentence) = said.sentence() else {
            println!("  {head}: said in words");
            return;
        };
        match form {
            Form::Basis(statement) if !of_paper(sentence) => {
                self.case_by_case(head, statement, sentence, names)
            }
            Form::Vague { .. } => println!("  {head}: no closure"),
            _ => self.as_a_whole(head, form, sentence, names),
        }
    }

    fn case_by_case(
        &self,
        head: &str,
        statement: &Statement<BasisCase>,
        sentence: &Sentence,
        names: Names<'_>,
    ) {
        let start = Instant::now();
        let by_closure: Vec<_> =
            self.closures.bases.par_iter().map(|case| closure(statement, case)).collect();
        let middle = Instant::now();
        let by_stanza: Vec<_> = self.bases.par_iter().map(|case| stanza(sentence, names, case)).collect();
        let times = (middle - start, middle.elapsed());
        let mut kinds: BTreeMap<String, Vec<String>> = BTreeMap::new();
        let mut same = BTreeMap::new();
        for ((one, other), case) in by_closure.iter().zip(&by_stanza).zip(&self.closures.bases) {
            if one.kind() == other.kind() {
                *same.entry(one.kind()).or_insert(0) += 1;
            }
            if one != other {
                let kind = format!("closure {}, stanza {}", one.kind(), other.kind());
                let (k, knots, alpha) = (case.k(), case.knots(), case.basis().index());
                kinds.entry(kind).or_default().push(format!(
                    "k = {k}, U = {knots}, α = {alpha}\n        closure {one}\n        stanza  {other}"
                ));
            }
        }
        let same: Vec<_> = same.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
        println!("  {head}: {} cases, equal in {}; {}", by_closure.len(), same.join(", "), timed(times));
        for (kind, cases) in kinds {
            let only_witness = kind == "closure refuted, stanza refuted";
            println!("    {} {} × {kind}", if only_witness { " " } else { "*" }, cases.len());
            cases.iter().take(self.settings.show).for_each(|case| println!("      {case}"));
        }
        let first = |all: &[Says]| all.iter().find(|says| says.kind() == "refuted").cloned();
        witness(first(&by_closure), first(&by_stanza));
    }

    fn as_a_whole(&self, head: &str, form: &Form, sentence: &Sentence, names: Names<'_>) {
        let start = Instant::now();
        let one = match form.judge(&self.closures) {
            Ok(claims::Verdict::Proved { .. }) => Says::Holds,
            Ok(claims::Verdict::Refuted(witness)) => Says::Refuted(listed(&witness.given)),
            Ok(claims::Verdict::Undecided(why)) => Says::Undecided(why),
            Ok(claims::Verdict::NotFormal(_) | claims::Verdict::NotApplicable(_)) => Says::Nothing,
            Err(fault) => Says::Fault(fault.0),
        };
        let middle = Instant::now();
        let cases = self.stanzas.of(sentence);
        let other = match judge::judge(sentence, names, &cases) {
            Ok(judge::Verdict::Proved { .. }) => Says::Holds,
            Ok(judge::Verdict::Refuted(witness)) => Says::Refuted(listed(&witness.given())),
            Ok(judge::Verdict::Undecided(why)) => Says::Undecided(why),
            Ok(judge::Verdict::NotApplicable(_)) => Says::Nothing,
            Err(fault) => Says::Fault(fault.0),
        };
        let times = (middle - start, middle.elapsed());
        let mark = if one.kind() == other.kind() { " " } else { "*" };
        println!("  {head}: {} cases as a whole; {}", cases.len(), timed(times));
        println!("    {mark} closure {}, stanza {other}", one.kind());
        witness(
            Some(one).filter(|says| says.kind() == "refuted"),
            Some(other).filter(|says| says.kind() == "refuted"),
        );
    }
}

fn of_paper(sentence: &Sentence) -> bool {
    sentence
        .given
        .iter()
        .any(|binder| matches!(binder, language::Binder::Instances(_) | language::Binder::Indices(_)))
}

fn timed((closure, stanza): (Duration, Duration)) -> String {
    format!("closure {:.2} s, stanza {:.2} s", closure.as_secs_f64(), stanza.as_secs_f64())
}

fn witness(one: Option<Says>, other: Option<Says>) {
    match (one, other) {
        (None, None) => {}
        (Some(one), Some(other)) if one == other => println!("      witness {one}"),
        (one, other) => {
            let show = |says: Option<Says>| says.map_or_else(|| "none".to_owned(), |says| says.to_string());
            println!("    * witness: closure {}\n               stanza  {}", show(one), show(other));
        }
    }
}

#[test]
#[ignore = "a tool for who writes stanzas: it runs as long as a report"]
fn guard() {
    let settings = Settings::read();
    let files = files();
    let guard = Guard::new(settings);
    for claim in claims::claims().iter().filter(|claim| guard.settings.wants(claim.id)) {
        let found = files.iter().find_map(|file| {
            Some((file.claims.iter().find(|stanza| &*stanza.id == claim.id)?, file.definitions.as_slice()))
        });
        let Some((stanza, definitions)) = found else {
            println!("{}: no stanza", claim.id);
            continue;
        };
        println!("{}", claim.id);
        let names = Names { definitions, library: &files };
        guard.compare("printed", &claim.printed, &stanza.printed, names);
        match (&claim.amended, &stanza.amended) {
            (Some(form), Some(said)) => guard.compare("amended", form, said, names),
            (None, None) => {}
            (form, _) => {
                println!("  * amended: only the {}", if form.is_some() { "closure" } else { "stanza" })
            }
        }
        if let Some(sentence) = stanza.fails.as_ref().and_then(Said::sentence) {
            let cases = guard.stanzas.of(sentence);
            let start = Instant::now();
            let verdict = judge::judge(sentence, names, &cases);
            let shown = match &verdict {
                Ok(judge::Verdict::Refuted(witness)) => format!("refuted at {}", listed(&witness.given())),
                Ok(verdict) => verdict.status().to_owned(),
                Err(fault) => fault.to_string(),
            };
            println!("  fails: {shown} ({} cases, {:.2} s)", cases.len(), start.elapsed().as_secs_f64());
        }
    }
}
