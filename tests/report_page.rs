//! The page of the report: complete, self-contained, escaped, and with witnesses worked out to the exact values.

use std::sync::LazyLock;

use knotproof::claims::claims;
use knotproof::report::{Difference, PageSource, Report, page};
use knotproof::scalar::rational;
use knotproof::spline::{Basis, KnotVector, Side};

/// Claims of every kind: about the weight, at one x, at two, with a witness that has no x, and one that is true.
const CLAIMS: [&str; 6] = ["P2.1.3", "C2.4", "T3.5.2", "T3.5.3", "T3.5.4", "Conj3.1.strong.continuous"];

static REPORT: LazyLock<Report> = LazyLock::new(|| {
    let mut chosen = claims();
    chosen.retain(|claim| CLAIMS.contains(&claim.id));
    Report::of(&chosen, |_| {}).expect("the claims can be judged")
});

const SOURCE: PageSource<'_> =
    PageSource { compared: None, pictures: &[], certificates: Some("../proofs/certs") };

/// The part of the page about a claim.
fn section<'a>(page: &'a str, claim: &str) -> &'a str {
    let start = page
        .find(&format!("<details class=\"claim\" id=\"claim={claim}\""))
        .expect("the claim has a section");
    let rest = &page[start..];
    &rest[..rest[1..].find("<details class=\"claim\"").map_or(rest.len(), |end| end + 1)]
}

/// The text without tags.
fn text(html: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for c in html.chars() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            c if !inside && !c.is_whitespace() => text.push(c),
            _ => {}
        }
    }
    text
}

#[test]
fn the_page_stands_alone_and_is_the_same_every_time() {
    let html = page(&REPORT, &SOURCE).unwrap();
    for claim in CLAIMS {
        assert!(html.contains(&format!("data-claim=\"{claim}\"")), "{claim} has no row");
        assert!(section(&html, claim).contains("<math>"), "{claim} has no formula");
    }
    for outside in ["src=\"http", "href=\"http", "@import", "url("] {
        assert!(!html.contains(outside), "the page loads something: {outside}");
    }
    assert!(html.contains("href=\"../proofs/certs/T3.5.2.printed.proof\""));
    assert!(!page(&REPORT, &PageSource { certificates: None, ..SOURCE }).unwrap().contains("../proofs"));
    assert_eq!(html, page(&REPORT, &SOURCE).unwrap());
}

#[test]
fn a_witness_is_worked_out_to_the_values_of_the_basis() {
    let html = page(&REPORT, &SOURCE).unwrap();
    let shown = text(section(&html, "T3.5.3"));
    // U = (0, 0, 1, 2), k = 1, α = −1, so r = 1/2; at x = 3/2 only G_1 = 1 − w with w = (1/4)/(1/4 + 1/2) lives.
    let knots = KnotVector::new([0, 0, 1, 2].map(|t| rational(t, 1)).to_vec()).unwrap();
    let basis = Basis::new(knots, 1, "-1".parse().unwrap()).unwrap();
    assert_eq!(basis.values(&rational(3, 2), Side::Right), [rational(0, 1), rational(2, 3)]);
    assert!(shown.contains("w21=12·(32−1)12·(32−1)+(2−32)=13"), "{shown}");
    assert!(shown.contains("G11=(1−w21)G20=(1−13)·1=23"), "{shown}");
    // A symmetry is between two indices.
    let symmetry = section(&html, "T3.5.4");
    assert_eq!(symmetry.matches("class=\"working\"").count(), 2);
    // The two slopes at the knot between the maxima.
    let conjecture = text(section(&html, "Conj3.1.strong.continuous"));
    assert!(conjecture.contains("=−36272") && conjecture.contains("=256272"), "{conjecture}");
}

#[test]
fn witnesses_about_the_weight_show_both_sides() {
    let html = page(&REPORT, &SOURCE).unwrap();
    for claim in ["P2.1.3", "C2.4"] {
        let shown = text(section(&html, claim));
        assert!(shown.contains("Theleftsideis0andtherightside1−0=1."), "{shown}");
    }
}

#[test]
fn differences_are_shown_with_the_name_of_what_they_are_from() {
    let difference = Difference {
        id: "T3.5.2".into(),
        of: "as printed".into(),
        recorded: "undecided: <limit>".into(),
        found: "proved".into(),
    };
    let differences = [difference];
    let source = PageSource { compared: Some(("old & \"new\".json", &differences)), ..SOURCE };
    let html = page(&REPORT, &source).unwrap();
    assert!(
        html.contains("undecided: &#60;limit&#62;") || html.contains("undecided: &lt;limit&gt;"),
        "not escaped"
    );
    assert!(!html.contains("<limit>") && !html.contains("old & \"new\""));
    assert!(html.contains("1 verdict is not as there"));
    let same = page(&REPORT, &PageSource { compared: Some(("old.json", &[])), ..SOURCE }).unwrap();
    assert!(same.contains("Every verdict is as in old.json."));
}

#[test]
fn what_a_record_says_is_never_markup() {
    let mut report = REPORT.clone();
    let evil = "<script>alert(1)</script> \" onload='x' & x_<b> ^<i> (<u>)/<s>";
    let record = &mut report.claims[0];
    record.statement = evil.into();
    record.locator = evil.into();
    record.note = Some(evil.into());
    record.as_printed.statement = evil.into();
    record.as_printed.hypotheses = vec![evil.into()];
    let finding = &mut record.as_printed.finding;
    finding.reason = Some(evil.into());
    finding.remarks = vec![evil.into()];
    if let Some(witness) = &mut finding.witness {
        witness.given = vec![(evil.into(), evil.into())];
        witness.claimed = evil.into();
        witness.found = evil.into();
        witness.reproduce = Some(evil.into());
    }
    let html = page(&report, &SOURCE).unwrap();
    for markup in ["<script>alert", "<b>", "<i>", "<u>", "<s>", "\" onload"] {
        assert!(!html.contains(markup), "{markup} got through");
    }
}
