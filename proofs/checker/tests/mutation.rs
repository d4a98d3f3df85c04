//! Every token of every accepted certificate is deleted, doubled and changed. A changed proof is rejected or proves
//! the same statement; a changed statement is rejected or known to be another one.

mod common;

use knotproof_checker::check;

fn tokens(text: &str) -> Vec<String> {
    let mut tokens = vec![String::new()];
    let mut quoted = false;
    for c in text.chars() {
        if c == '"' {
            quoted = !quoted;
        }
        match c {
            '(' | ')' if !quoted => tokens.extend([c.to_string(), String::new()]),
            _ if c.is_whitespace() && !quoted => tokens.push(String::new()),
            _ => tokens.last_mut().into_iter().for_each(|token| token.push(c)),
        }
    }
    tokens.retain(|token| !token.is_empty());
    tokens
}

/// What a token could be mistaken for.
fn others(token: &str) -> Vec<String> {
    let mut others: Vec<String> = match token.parse::<i64>() {
        Ok(number) => [number + 1, number - 1, -number, 1_000_000_007].map(|other| other.to_string()).into(),
        Err(_) => {
            let words =
                "1 0 ( ) k i u r W x by weights functions using split any some in from to + - * / = > >= <";
            words.split(' ').map(str::to_owned).collect()
        }
    };
    if let Some(inside) = token.strip_prefix('"') {
        others.push(format!("\"x{inside}"));
    }
    others.retain(|other| other != token);
    others
}

/// All texts with one token deleted, doubled or changed, and all with two neighbours swapped.
fn mutants(text: &str) -> Vec<String> {
    let tokens = tokens(text);
    let mut mutants = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let mut with = |instead: &[&str]| {
            let mut mutant: Vec<&str> = tokens.iter().map(String::as_str).collect();
            mutant.splice(at..=at, instead.iter().copied());
            mutants.push(mutant.join(" "));
        };
        with(&[]);
        with(&[token, token]);
        for other in others(token) {
            with(&[&other]);
        }
        if tokens.get(at + 1).is_some_and(|next| next != token) {
            let mut swapped = tokens.clone();
            swapped.swap(at, at + 1);
            mutants.push(swapped.join(" "));
        }
    }
    mutants
}

#[test]
fn a_changed_proof_proves_nothing_else() {
    let (mut tried, mut accepted) = (0, 0);
    for certificate in common::certificates() {
        let honest = check(&certificate.statement, &certificate.proof).unwrap();
        for mutant in mutants(&certificate.proof) {
            tried += 1;
            if let Ok(checked) = check(&certificate.statement, &mutant) {
                accepted += 1;
                assert_eq!(checked, honest, "{}: {mutant}", certificate.name);
            }
        }
    }
    // Another bound of a split or a smaller degree of unknowns may do as well, but not often.
    assert!(tried > 5_000 && accepted * 20 < tried, "{accepted} of {tried}");
}

/// Nothing but another name for the same, a weaker goal or another text can be proved by the same proof.
#[test]
fn a_changed_statement_needs_another_proof() {
    let (mut tried, mut accepted) = (0, 0);
    for certificate in common::certificates() {
        for mutant in mutants(&certificate.statement) {
            tried += 1;
            accepted += usize::from(check(&mutant, &certificate.proof).is_ok());
        }
    }
    assert!(tried > 30_000 && accepted * 10 < tried, "{accepted} of {tried}");
}

/// Goals made false by one token, where the old proof must not do.
#[test]
fn a_false_goal_is_not_proved_by_a_proof_of_the_true_one() {
    for (name, from, to) in [
        ("unity", " 1)))", " 2)))"),
        ("unity", "(- 0 k) 0 (G", "(- 1 k) 0 (G"),
        ("unity", "some", "any"),
        ("bernstein", "(binomial k i)", "(binomial k 0)"),
        ("bernstein", "(v k 1", "(w k 1"),
        ("positivity", "(> (G i", "(< (G i"),
        ("continuity", "(G i k (from", "(G (+ i 1) k (from"),
        ("continuity", "some", "any"),
        ("endpoint", "(* (integer k) r)", "(integer k)"),
        ("endpoint", "(- (/", "(+ (/"),
        ("endpoint", "(each i 2 k (=", "(each i 1 k (="),
        ("symmetry", "(r (/ 1 r))", "(r r)"),
        ("symmetry", "(G (- k i)", "(G i"),
        ("split", "(* 3 a)) 3)", "(* 4 a)) 3)"),
        ("split", "(nonnegative b)\n    (positive a)", "(nonnegative a b)"),
        ("order", "(in W k) i)", "(in W k) k)"),
        ("outside", "(x (in W 0)))", "(^ (x (in W 0)) 2))"),
        ("pole", " -1)", " -2)"),
        ("defined", "(+ u r)", "(- u r)"),
        ("lemmas", " 1)\n", " k)\n"),
        ("de-boor", "(* (d i)", "(* (d 0)"),
        ("det", "(- b a)", "(- a b)"),
        ("values", "4/9", "5/9"),
        ("values", "72/49", "73/49"),
        ("values", "(= (at ((r 3)) (- r s))", "(= (at ((r 4)) (- r s))"),
        ("values", "(u 2)) (- b a)) (- b a)", "(u 2)) (- b a)) (- 6 a)"),
        ("values", "(* a (v 0 1", "(* b (v 0 1"),
        ("gaps", "(/ (* s b) 2)", "(/ (* s b) 3)"),
        ("gaps", "(* s (x (in W 2)))", "(x (in W 2))"),
    ] {
        let all = common::certificates();
        let certificate = all.iter().find(|certificate| certificate.name == name).unwrap();
        assert!(certificate.statement.contains(from), "{name}: {from}");
        let changed = certificate.statement.replacen(from, to, 1);
        let place = check(&changed, &certificate.proof).expect_err(name).place;
        // Not for its syntax.
        assert!(place.starts_with("section "), "{name}: {to}: {place}");
    }
}
