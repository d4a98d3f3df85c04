use crate::certificate::statement::{Shown, Statement};
use crate::certificate::{Sexp, prove};
use crate::language::{Claim, Form, canonical, claims};
use super::derive;

#[test]
fn dump() {
    use std::io::Write as _;
    let only = std::env::var("ONLY").unwrap_or_default();
    let out = std::env::var("OUT").unwrap_or_default();
    let most: usize = std::env::var("MOST").ok().and_then(|s| s.parse().ok()).unwrap_or(8);
    let entries: toml::Value = toml::from_str(include_str!("../../../papers/rational-bsplines/windows.toml")).unwrap();
    for entry in entries["window"].as_array().unwrap() {
        let text = |name: &str| entry[name].as_str().unwrap().to_owned();
        let (id, form) = (text("claim"), text("form"));
        if entry.get("refutes").is_some() || !id.contains(&only) || form.starts_with("degree") { continue; }
        let form_ = if form == "amended" { Form::Amended } else { Form::Printed };
        let claim = claims().into_iter().find(|c| c.id() == id).unwrap();
        let Some(sentence) = claim.sentence(form_) else { continue };
        let degrees: Vec<usize> = entry["degrees"].as_array().unwrap().iter().map(|d| d.as_integer().unwrap() as usize).filter(|d| *d <= most).collect();
        let start = std::time::Instant::now();
        let derived: Result<Vec<_>, _> = degrees.iter().map(|k| derive(sentence, claim.definitions, claim, *k)).collect();
        let derived = match derived { Ok(d) => d, Err(e) => { println!("NO {id}.{form}: {e}"); continue } };
        let goals: usize = derived.iter().flatten().map(|s| s.goals.len()).sum();
        let n: usize = derived.iter().map(Vec::len).sum();
        let t = start.elapsed();
        let text = canonical(sentence, claim.definitions, &|id, printed| {
            let named = Claim::of(claim.library).find(|other| other.id() == id)?;
            let form = if printed { Form::Printed } else { named.strongest() };
            Some((named.sentence(form)?, named.definitions))
        }).unwrap();
        let statement = Statement { claim: id.clone(), form: form_, refuted: false, scope: crate::judge::Scope::Knots, degrees, sentence: Sexp::parse_all(&text).unwrap(), shown: Shown::Derived(derived) };
        match prove(&statement) {
            Err(e) => println!("UNPROVED {id}.{form}: {e}"),
            Ok(proof) => {
                println!("OK {id}.{form}: {n} sections {goals} goals, {t:.1?} {:.1?}", start.elapsed());
                let write = |ext: &str, text: String| std::fs::File::create(format!("{out}/{id}.{form}.{ext}")).unwrap().write_all(text.as_bytes()).unwrap();
                write("statement", statement.to_sexp().pretty());
                write("proof", crate::certificate::proof::to_sexp(&proof).pretty());
                write("sections", statement.expand().unwrap().iter().map(|s| format!("{}\n", s.to_sexp().pretty())).collect());
            }
        }
    }
}
