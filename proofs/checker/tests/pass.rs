//! Certificates that hold are accepted: every rule, every option, every kind of term and formula.

mod common;

use knotproof_checker::check;

#[test]
fn all_hold() {
    for certificate in common::certificates() {
        let name = &certificate.name;
        let checked =
            check(&certificate.statement, &certificate.proof).unwrap_or_else(|e| panic!("{name}: {e}"));
        let goals = certificate.proof.matches("(goal ").count();
        let lemmas = certificate.proof.matches("(lemma ").count();
        assert_eq!((checked.goals, checked.lemmas), (goals, lemmas), "{name}");
        assert_eq!(checked.sections, certificate.proof.matches("(section ").count(), "{name}");
    }
}

#[test]
fn every_word_of_the_format_is_tried() {
    let all: Vec<String> = common::certificates().into_iter().map(|c| c.statement + &c.proof).collect();
    let words = "each real nonnegative positive let window knots goals any some in from to + - * / ^ t x w v Dw G DG \
        de-boor at det integer binomial = > >= < defined order outside pole lemma by weights functions using split \
        orders functional evaluate printed amended degree proved refuted points instance";
    for word in words.split_whitespace() {
        let found = |text: &String| text.split(['(', ')', ' ', '\n']).any(|token| token == word);
        assert!(all.iter().any(found), "{word}");
    }
}

#[test]
fn the_result_is_one_line() {
    let all = common::certificates();
    let unity = all.iter().find(|certificate| certificate.name == "unity").unwrap();
    let line = check(&unity.statement, &unity.proof).unwrap().to_string();
    assert_eq!(
        line,
        "T3.5.3 (printed): proved, scope knots, degrees 1 2 3 4; argued; sections 4, goals 4, lemmas 0"
    );
}

#[test]
fn white_space_means_nothing_else() {
    for certificate in common::certificates() {
        let wide = |text: &str| text.replace('(', "\t( ").replace(')', "\r\n)") + " \n";
        let checked = check(&certificate.statement, &certificate.proof);
        assert_eq!(check(&wide(&certificate.statement), &wide(&certificate.proof)), checked);
    }
}
