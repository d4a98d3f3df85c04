use super::derive;
use crate::certificate::statement::{Shown, Statement};
use crate::certificate::{Certificate, Sexp, prove};
use crate::language::{Claim, Form, canonical, claims};
use crate::report::Baseline;

fn all() -> Vec<(Form, Claim<'static>, crate::report::Finding)> {
    let recorded = Baseline::recorded().unwrap();
    let mut all = Vec::new();
    for claim in claims() {
        let Some(entry) = recorded.claims.iter().find(|entry| entry.id == claim.id()) else { continue };
        all.push((Form::Printed, claim, entry.as_printed.clone()));
        all.extend(entry.amended.iter().map(|f| (Form::Amended, claim, f.clone())));
        all.extend(entry.by_degree.iter().map(|of| (Form::Degree(of.degree), claim, of.finding.clone())));
    }
    all
}

fn sentence(claim: Claim<'static>, form: Form) -> Vec<Sexp> {
    let sentence = claim.sentence(form).unwrap();
    let text = canonical(sentence, claim.definitions, &|id, printed| {
        let named = Claim::of(claim.library).find(|other| other.id() == id)?;
        let form = if printed { Form::Printed } else { named.strongest() };
        Some((named.sentence(form)?, named.definitions))
    })
    .unwrap();
    Sexp::parse_all(&text).unwrap()
}

#[test]
fn points() {
    for (form, claim, finding) in all() {
        let Some(witness) = &finding.witness else { continue };
        let Some(point) = crate::certificate::point::point(witness) else {
            println!("NOPOINT {} {form}", claim.id());
            continue;
        };
        let statement = Statement {
            claim: claim.id().into(),
            form,
            refuted: true,
            scope: crate::judge::Scope::Instance,
            degrees: vec![witness.k.unwrap()],
            sentence: sentence(claim, form),
            shown: Shown::Point(point),
        };
        let c = Certificate { statement, proof: Vec::new() };
        match c.check() {
            Ok(_) => println!("POINT {} {}", claim.id(), form.name()),
            Err(_) if true => {}
            Err(e) => println!("REJECTED {} {} {e}", claim.id(), form.name()),
        }
    }
}

#[test]
fn dump() {
    use std::io::Write as _;
    let only = std::env::var("ONLY").unwrap_or_default();
    let out = std::env::var("OUT").unwrap_or_default();
    let most: usize = std::env::var("MOST").ok().and_then(|s| s.parse().ok()).unwrap_or(8);
    for (form, claim, finding) in all() {
        let id = claim.id();
        if finding.witness.is_some()
            || finding.certificate.is_none()
            || !id.contains(&only)
            || matches!(form, Form::Degree(_))
        {
            continue;
        }
        let Some(said) = claim.sentence(form) else { continue };
        let degrees: Vec<usize> = finding.degrees.clone().into_iter().filter(|d| *d <= most).collect();
        let start = std::time::Instant::now();
        let derived: Result<Vec<_>, _> =
            degrees.iter().map(|k| derive(said, claim.definitions, claim, *k)).collect();
        let derived = match derived {
            Ok(d) => d,
            Err(e) => {
                println!("NO {id} {form}: {e}");
                continue;
            }
        };
        let goals: usize = derived.iter().flatten().map(|s| s.goals.len()).sum();
        let n: usize = derived.iter().map(Vec::len).sum();
        let t = start.elapsed();
        let statement = Statement {
            claim: id.into(),
            form,
            refuted: false,
            scope: crate::judge::Scope::Knots,
            degrees,
            sentence: sentence(claim, form),
            shown: Shown::Derived(derived),
        };
        match prove(&statement) {
            Err(e) => println!("UNPROVED {id} {form}: {e}"),
            Ok(proof) => {
                let t2 = start.elapsed();
                let c = Certificate { statement, proof };
                let checked = c.check().map(|_| "accepted".to_owned()).unwrap_or_else(|e| format!("{e}"));
                println!(
                    "OK {id} {form}: {n} sections {goals} goals, {t:.1?} {t2:.1?} {:.1?} {checked} {}",
                    start.elapsed(),
                    c.proof_text().len()
                );
                if !out.is_empty() {
                    let write = |ext: &str, text: String| {
                        std::fs::File::create(format!("{out}/{id}.{}.{ext}", form.name()))
                            .unwrap()
                            .write_all(text.as_bytes())
                            .unwrap()
                    };
                    write("statement", c.statement_text());
                    write("proof", c.proof_text());
                    write(
                        "sections",
                        c.statement
                            .expand()
                            .unwrap()
                            .iter()
                            .map(|s| format!("{}\n", s.to_sexp().pretty()))
                            .collect(),
                    );
                }
            }
        }
    }
}
