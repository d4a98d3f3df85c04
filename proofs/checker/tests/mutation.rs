//! Every token of every accepted certificate is deleted, doubled and changed. A changed proof is rejected or proves
//! the same statement; a changed statement is rejected or known to be another one.

mod common;

use std::fs;
use std::path::Path;

use knotproof_checker::{check, check_within};

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

/// Numbers at the ends of what a machine holds, and of what the format allows.
const EXTREME: [&str; 18] = [
    "-9223372036854775808",
    "-9223372036854775807",
    "9223372036854775807",
    "9223372036854775808",
    "18446744073709551616",
    "-1000000",
    "1000000",
    "1000001",
    "65535",
    "65536",
    "4294967296",
    "2147483647",
    "100",
    "101",
    "0",
    "-1",
    "1/9223372036854775808",
    "-340282366920938463463374607431768211457/2",
];

/// The numbers of a linear congruence: the same mutants on every machine.
struct Dice(u64);

impl Dice {
    /// One of so many.
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % sides.max(1)
    }

    /// The text with a number, a token or some bytes changed.
    fn mutant(&mut self, text: &str) -> String {
        let mut tokens = tokens(text);
        let is_number =
            |token: &String| token.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit());
        let numbers: Vec<usize> = (0..tokens.len()).filter(|at| is_number(&tokens[*at])).collect();
        for _ in 0..=self.roll(2) {
            let at = self.roll(tokens.len());
            match self.roll(5) {
                0..3 => {
                    let at = numbers.get(self.roll(numbers.len())).copied().unwrap_or(at);
                    tokens[at] = EXTREME[self.roll(EXTREME.len())].to_owned();
                }
                3 => tokens[at] = tokens[self.roll(tokens.len())].clone(),
                _ => {
                    let mut bytes = tokens.join(" ").into_bytes();
                    let (at, length) = (self.roll(bytes.len()), self.roll(4));
                    let with: Vec<u8> =
                        (0..self.roll(4)).filter_map(|_| u8::try_from(self.roll(256)).ok()).collect();
                    bytes.splice(at..(at + length).min(bytes.len()), with);
                    return String::from_utf8_lossy(&bytes).into_owned();
                }
            }
        }
        tokens.join(" ")
    }
}

/// The program's certificates with extreme numbers and odd bytes in them: every answer is an answer, whatever the
/// file. Where a proof was changed, nothing else is proved.
#[test]
fn no_text_stops_the_checker() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../certs");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "statement"));
    files.sort();
    assert!(files.len() > 100);
    let (mut dice, mut tried, mut reached) = (Dice(1), 0, 0);
    for file in files {
        let (statement, proof) =
            (fs::read_to_string(&file).unwrap(), fs::read_to_string(file.with_extension("proof")).unwrap());
        if statement.len() + proof.len() > 10_000 {
            continue;
        }
        for _ in 0..20 {
            tried += 1;
            let in_proof = dice.roll(3) == 0;
            let mutant = dice.mutant(if in_proof { &proof } else { &statement });
            let texts = if in_proof { (&statement, &mutant) } else { (&mutant, &proof) };
            match check_within(100_000, texts.0, texts.1) {
                Ok(checked) if in_proof => assert_eq!(check(&statement, &proof), Ok(checked), "{mutant}"),
                Ok(_) => reached += 1,
                Err(rejected) => reached += usize::from(rejected.place.starts_with("section")),
            }
        }
    }
    assert!(tried > 1_000 && reached > tried / 10, "{reached} of {tried} came as far as a section");
}
