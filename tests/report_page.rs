//! The page of the report: complete, self-contained, escaped, and with witnesses worked out to the exact values.

use std::io::Read;
use std::sync::LazyLock;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::GzDecoder;
use knotproof::judge::{Bind, Bound, Shows};
use knotproof::language::{Known, Severity, Source, claims, paper};
use knotproof::report::{
    Baseline, Dependence, Difference, Errata, PageSource, Record, Report, Summary, by_severity, corners,
    errata_page, markdown, opening, page,
};
use knotproof::scalar::rational;
use knotproof::spline::{Basis, KnotVector, Side};

/// Claims of every kind: about the weight, at one x, at two, with a witness that has no x, and one that is true.
const CLAIMS: [&str; 6] = ["P2.1.3", "C2.4", "T3.5.2", "T3.5.3", "T3.5.4", "Conj3.1.strong.continuous"];

static REPORT: LazyLock<Report<'static>> = LazyLock::new(|| {
    let mut chosen = claims();
    chosen.retain(|claim| CLAIMS.contains(&claim.id()));
    Report::of(paper(), &chosen, None, |_, _| {}).expect("the claims can be judged").with_float()
});

const SOURCE: PageSource<'_> = PageSource {
    compared: None,
    pictures: &[],
    instances: &[],
    certificates: Some("../proofs/certs"),
    theory: Some("../proofs/theory"),
    beside: &[("the errata", "errata.md")],
};

/// All claims, with the recorded verdicts: nothing is judged.
static RECORDED: LazyLock<Report<'static>> = LazyLock::new(|| {
    Report::recorded(paper(), &claims(), &Baseline::recorded().expect("the recorded verdicts"))
});

/// The part of the page about a claim.
fn section<'a>(page: &'a str, claim: &str) -> &'a str {
    let start =
        page.find(&format!("<details class=\"claim\" id=\"{claim}\"")).expect("the claim has a section");
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
    for outside in ["src=\"", "<link", "@import", "url("] {
        assert!(!html.contains(outside), "the page loads something: {outside}");
    }
    assert_eq!(html.matches("href=\"http").count(), 1, "one link leads away: to the paper");
    assert!(
        html.contains("<a href=\"https://arxiv.org/abs/1805.04433\">")
            && html.contains("<a href=\"errata.md\">")
    );
    assert!(html.contains("href=\"../proofs/certs/T3.5.2.printed.proof\""));
    assert!(html.contains("<a href=\"../proofs/theory/StatementsBasis.v\"><code>T3_5_2_printed</code></a>"));
    let alone = PageSource { certificates: None, theory: None, ..SOURCE };
    assert!(!page(&REPORT, &alone).unwrap().contains("../proofs"));
    assert_eq!(html, page(&REPORT, &SOURCE).unwrap());
}

/// What a `script` element of the page carries in letters, and how many bytes it is compressed.
fn carried(html: &str, id: &str) -> (Vec<u8>, usize) {
    let start = format!("id=\"{id}\">");
    let rest = &html[html.find(&start).expect("the element is there") + start.len()..];
    let packed = STANDARD.decode(&rest[..rest.find('<').expect("it ends")]).expect("letters of base 64");
    let mut bytes = Vec::new();
    GzDecoder::new(packed.as_slice()).read_to_end(&mut bytes).expect("it is compressed");
    (bytes, packed.len())
}

#[test]
fn the_page_carries_the_program_and_the_certificates() {
    let html = page(&REPORT, &SOURCE).unwrap();
    for (module, most) in [("panel", 400_000), ("judge", 600_000), ("checker", 400_000)] {
        let (bytes, packed) = carried(&html, &format!("module-{module}"));
        assert!(bytes.starts_with(b"\0asm") && packed < most, "{module}: {packed}");
    }
    let (texts, _) = carried(&html, "certificates");
    let texts: std::collections::BTreeMap<String, (String, String)> = serde_json::from_slice(&texts).unwrap();
    assert!(texts.len() > 3 && texts.keys().eq(REPORT.certificates.keys()));
    for (name, (statement, proof)) in &texts {
        assert!(knotproof_checker::check(statement, proof).is_ok(), "{name}");
        assert!(html.contains(&format!("data-certificate=\"{name}\">Check it here")), "{name}");
    }
}

#[test]
fn the_panel_is_offered_the_sentences_that_are_about_knots() {
    let html = page(&RECORDED, &SOURCE).unwrap();
    let start = html.find("id=\"paper\">").unwrap() + "id=\"paper\">".len();
    let data: serde_json::Value =
        serde_json::from_str(html[start..].split("</script>").next().unwrap()).unwrap();
    let sentences = |of: &str| data[of].as_array().unwrap().clone();
    assert!(sentences("claims").len() > 30 && sentences("classical").len() > 5);
    for one in sentences("claims").iter().chain(&sentences("classical")) {
        let definitions: Vec<(String, String)> = serde_json::from_value(one["definitions"].clone()).unwrap();
        let definitions: Vec<_> =
            definitions.iter().map(|(head, body)| (head.as_str(), body.as_str())).collect();
        let known = Known::defining(&definitions).unwrap();
        let read = known.one_line_on_knots(one["sentence"].as_str().unwrap());
        assert!(read.is_ok(), "{one}: {read:?}");
    }
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
        let told = shown.split("But:").nth(1).and_then(|rest| rest.split('.').next()).expect("what is so");
        assert!(told.contains("=0,1−φ") && told.ends_with("=1"), "{told}");
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
    let finding = &mut record.as_printed.finding;
    finding.reason = Some(evil.into());
    finding.remarks = vec![evil.into()];
    if let Some(witness) = &mut finding.witness {
        witness.instance = Some(evil.into());
        witness.knots = vec![evil.into()];
        witness.alpha = evil.into();
        witness.given = vec![Bound { name: evil.into(), value: Bind::Number(evil.into()) }];
        witness.claimed = evil.into();
        witness.shows = Shows::Undefined(evil.into());
        witness.words = vec![evil.into()];
    }
    let html = page(&report, &SOURCE).unwrap();
    for markup in ["<script>alert", "<b>", "<i>", "<u>", "<s>", "\" onload"] {
        assert!(!html.contains(markup), "{markup} got through");
    }
}

/// The paper's statements and our questions, counted here in another way than there.
#[test]
fn the_counts_are_those_of_the_records() {
    let Summary { paper, questions } = &RECORDED.summary;
    for (source, counts) in [(Source::Paper, paper), (Source::Question, questions)] {
        let of = |status: &str| {
            let same = |record: &&Record| {
                (record.source, record.as_printed.finding.status.as_str()) == (source, status)
            };
            RECORDED.claims.iter().filter(same).count()
        };
        assert_eq!(
            counts.statements,
            RECORDED.claims.iter().filter(|record| record.source == source).count()
        );
        assert_eq!(counts.proved, of("proved"));
        assert_eq!(counts.refuted, of("refuted"));
        assert_eq!(counts.undecided, of("undecided"));
        assert_eq!(counts.not_formal, of("not-formal"));
        for parts in [&counts.refutations.by_severity, &counts.refutations.by_cause] {
            assert_eq!(parts.values().sum::<usize>(), counts.refuted, "{parts:?}");
            assert!(!parts.contains_key("unassigned"), "a refutation has no cause: {parts:?}");
        }
    }
    assert!(
        RECORDED
            .claims
            .iter()
            .all(|record| (record.source == Source::Question) == record.id.starts_with("X."))
    );
    // Both are on the page, in the text, and nowhere added up.
    let (html, text) = (page(&RECORDED, &SOURCE).unwrap(), markdown(&RECORDED, "proofs/certs"));
    for counts in [paper, questions] {
        assert_eq!(html.matches(&counts.words()).count(), 2, "at the top and above the table");
        assert!(text.contains(&counts.words()));
    }
    let both = paper.refuted + questions.refuted;
    assert!(!html.contains(&format!("{both} refuted")) && !text.contains(&format!("{both} refuted")));
}

/// The cells of the rows of a table.
fn rows(html: &str, id: &str) -> Vec<Vec<String>> {
    let table = html
        .split(&format!("<table id=\"{id}\""))
        .nth(1)
        .expect("the table")
        .split("</table>")
        .next()
        .expect("its end");
    let body = table.split("<tbody>").nth(1).expect("its body");
    let cells = |row: &str| row.replace("</th>", "</td>").split("</td>").map(text).collect();
    body.split("<tr").skip(1).map(|row| cells(&format!("<tr{row}"))).collect()
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect()
}

/// What a row of the table says is what the data say; the worst stands first.
#[test]
fn the_tables_are_ordered_by_severity_and_each_row_is_the_record() {
    let html = page(&RECORDED, &SOURCE).unwrap();
    let markdown = markdown(&RECORDED, "proofs/certs");
    for (source, id) in [(Source::Paper, "table"), (Source::Question, "questions")] {
        let records = by_severity(&RECORDED.claims, source);
        let shown = rows(&html, id);
        assert_eq!(shown.len(), records.len());
        let mut lines = markdown.lines();
        for (row, record) in shown.iter().zip(&records) {
            let json = serde_json::to_value(record).unwrap();
            let (printed, amended) = (&json["as_printed"], &json["amended"]);
            assert!(row[0].starts_with(json["id"].as_str().unwrap()), "{row:?}");
            let mut words = printed["status"].as_str().unwrap().to_owned();
            words += &match (json["severity"].as_str(), printed["scope"].as_str()) {
                (Some(severity), _) => format!("({severity})"),
                (None, Some(scope)) if printed.get("degrees").is_none() => format!("({scope})"),
                (None, Some(scope)) => format!("({scope},for"),
                (None, None) => String::new(),
            };
            assert!(row[2].starts_with(&words), "{row:?} is not {words}");
            assert_eq!(row[3].is_empty(), amended.is_null(), "{row:?}");
            assert!(row[3].starts_with(amended["status"].as_str().unwrap_or_default()), "{row:?}");
            // The sentence: its words, without what MathML makes of the signs between them.
            let letters = |text: &str| {
                text.replace("&lt;", "<")
                    .replace("&gt;", ">")
                    .chars()
                    .filter(|c| c.is_alphabetic() && *c != 'Σ')
                    .collect::<String>()
            };
            let sentence = squeezed(&record.title) + &squeezed(&record.statement);
            assert_eq!(letters(&row[1]), letters(&sentence), "{}", record.id);
            // In the same order in Markdown.
            let start = format!("| `{}` | ", record.id);
            let line = lines
                .find(|line| line.starts_with(&start))
                .unwrap_or_else(|| panic!("{start} is out of order"));
            assert!(line.contains(&format!("| {} |", record.words())), "{line}");
        }
        let ranks: Vec<_> = records
            .iter()
            .filter(|record| record.as_printed.finding.is_refuted())
            .map(|record| record.severity)
            .collect();
        assert!(ranks.is_sorted_by(|a, b| a >= b), "{ranks:?}");
        let last = records.iter().rposition(|record| record.as_printed.finding.is_refuted()).unwrap();
        assert!(records[..last].iter().all(|record| record.as_printed.finding.is_refuted()));
    }
}

#[test]
fn only_what_is_serious_is_red() {
    let html = page(&RECORDED, &SOURCE).unwrap();
    for record in &RECORDED.claims {
        let red = section(&html, &record.id).contains("class=\"badge refuted serious\"");
        assert_eq!(red, record.severity == Some(Severity::Serious), "{}", record.id);
    }
}

/// The degrees of a proof stand in the status itself.
#[test]
fn the_status_says_for_which_degrees() {
    let words = |id: &str| RECORDED.claims.iter().find(|record| record.id == id).unwrap().words();
    assert_eq!(words("T3.5.2"), "proved (degree, for every k, any weights)");
    assert_eq!(words("P3.1.2"), "proved (degree, for every k; any weights for 1 ≤ k ≤ 8)");
    assert_eq!(words("P2.1.1"), "proved (degree)");
    assert_eq!(words("abstract.regularity"), "proved (degree, for every k)");
    assert_eq!(words("C6.larger"), "proved (knots, for 1 ≤ k ≤ 6)");
}

#[test]
fn no_theorem_falls_and_the_sentence_changes_if_one_did() {
    let sentence = |report: &Report<'_>| Dependence::of(paper(), &report.claims).sentence;
    let said = sentence(&RECORDED).expect("all were judged");
    assert!(said.starts_with("No theorem of the paper falls"), "{said}");
    assert_eq!(opening(&RECORDED)[0], said);
    assert!(RECORDED.dependence.falls.is_empty());
    let changed = |id: &str, change: &dyn Fn(&mut Record)| {
        let mut report = RECORDED.clone();
        change(report.claims.iter_mut().find(|record| record.id == id).unwrap());
        sentence(&report).expect("all were judged")
    };
    // T3.5.4 without its amendment, T4.1 refuted, and P4.3 resting on an amendment that is not proved.
    assert!(changed("T3.5.4", &|record| record.amended = None).ends_with("1 falls: T3.5.4."));
    let refute = |record: &mut Record| record.as_printed.finding.status = "refuted".into();
    assert!(changed("T4.1", &refute).contains("falls: T4.1"));
    let undecided =
        |record: &mut Record| record.amended.as_mut().unwrap().finding.status = "undecided".into();
    assert!(changed("P4.3", &undecided).contains("falls: P4.3"));
    // An idea that fails is not saved by an amendment.
    assert!(changed("P4.2.1", &|record| record.severity = Some(Severity::Serious)).contains("falls: P4.2.1"));
    // The conjecture is no theorem; and of a part nothing is said.
    let conjecture = RECORDED.claims.iter().find(|record| record.id == "Conj3.1.strong").unwrap();
    assert!(!conjecture.stands());
    assert_eq!(sentence(&REPORT), None);
}

#[test]
fn the_opening_is_six_lines_from_the_data() {
    let lines = opening(&RECORDED);
    assert_eq!(lines.len(), 6, "{lines:#?}");
    for (line, words) in lines.iter().zip([
        "No theorem",
        "Conjecture 3.1, one maximum for each function, is false from k = 3 on",
        "turns by up to 0.99",
        "do not diminish variation from k = 3 on",
        "are true of every degree",
        "the errata are ready",
    ]) {
        assert!(line.contains(words), "{line}");
    }
    let mut report = RECORDED.clone();
    let record = report.claims.iter_mut().find(|record| record.id == "X.variation").unwrap();
    record.by_degree.retain(|of| of.degree != 3);
    assert!(opening(&report)[3].contains("from k = 4 on"), "{:?}", opening(&report));
    // The head of both: what was read, and what it is close to.
    let (html, text) = (page(&RECORDED, &SOURCE).unwrap(), markdown(&RECORDED, "proofs/certs"));
    for part in ["Juhász and Á. Róth", "1805.04433", "33 figures"] {
        let at =
            [&html, &text].map(|document| document.find(part).unwrap_or_else(|| panic!("{part} is missing")));
        assert!(
            at[0] < html.find("id=\"verdicts\"").unwrap() && at[1] < text.find("## The paper").unwrap(),
            "{part}"
        );
    }
}

#[test]
fn errata_have_one_entry_a_cause_with_all_its_claims() {
    let errata = Errata::of(&RECORDED);
    let counts = &RECORDED.summary.paper.refutations.by_cause;
    assert_eq!(errata.errata.len(), counts.len());
    let text = [errata.to_string(), errata_page(&errata).replace('\\', "")];
    for one in &errata.errata {
        assert_eq!(one.claims.len(), counts[one.cause], "{}", one.cause);
        let record = |id: &String| RECORDED.claims.iter().find(|record| record.id == *id).unwrap();
        let worst = one.claims.iter().map(|id| record(id).severity).max().flatten();
        assert_eq!(worst.map(Severity::name), Some(one.severity));
        let witness = record(&one.witness.claim).as_printed.finding.witness.as_ref().unwrap().to_string();
        assert_eq!(one.witness.text, witness);
        // Of those in the same standing, none is shorter.
        let shorter =
            one.claims.iter().map(record).filter(|other| {
                other.by_degree.is_empty() == record(&one.witness.claim).by_degree.is_empty()
            });
        assert!(
            shorter.into_iter().all(|other| other
                .as_printed
                .finding
                .witness
                .as_ref()
                .unwrap()
                .to_string()
                .chars()
                .count()
                >= witness.chars().count())
        );
        for text in &text {
            for part in one
                .locators
                .iter()
                .chain([&one.witness.text, &one.witness.again])
                .chain(one.amended.iter().map(|amendment| &amendment.statement))
            {
                assert!(text.contains(part.as_str()), "{part} is not in {text}");
            }
        }
        for amendment in &one.amended {
            let amended = record(&amendment.claim).amended.as_ref().unwrap();
            assert_eq!((&amendment.statement, amended.finding.is_proved()), (&amended.statement, true));
        }
    }
    let serious: Vec<_> =
        errata.errata.iter().filter(|one| one.severity == "serious").map(|one| one.cause).collect();
    assert_eq!(serious, ["conjecture"]);
    assert_eq!(errata.errata[0].cause, "conjecture", "the worst stands first");
    assert!(
        errata.errata[0].witness.again.starts_with("knotproof shape --degree 3"),
        "{:?}",
        errata.errata[0].witness
    );
    assert!(
        errata.errata.iter().flat_map(|one| &one.claims).all(|id| !id.starts_with("X.")),
        "only what the paper says"
    );
}

#[test]
fn corners_are_shown_as_they_are_computed() {
    let html = page(&REPORT, &SOURCE).unwrap();
    let (shown, text) = (rows(&html, "corner-table"), markdown(&REPORT, "proofs/certs"));
    let corners = corners(paper());
    assert_eq!(shown.len(), corners.len());
    for (row, corner) in shown.iter().zip(&corners) {
        let (angle, ratio) =
            corner.turn.as_ref().map_or(("–", "–"), |turn| (&turn.angle_degrees, &turn.speed_ratio));
        let expected = [
            &corner.instance,
            &corner.degree.to_string(),
            &corner.alpha.to_string(),
            &corner.knot.to_string(),
            &corner.multiplicity.to_string(),
            angle,
            ratio,
        ];
        assert_eq!(row[..7], expected);
        assert!(text.contains(&format!("| {} |\n", expected.join(" | "))), "{expected:?}");
    }
}

#[test]
fn the_family_of_two_maxima_has_an_example_with_numbers() {
    let html = page(&RECORDED, &SOURCE).unwrap();
    let shown = text(section(&html, "X.maxima"));
    for part in ["Anexamplewithnumbers", "r=53", "=5384", "κ=1124", "Degree3"] {
        assert!(shown.contains(part), "{part} in {shown}");
    }
    assert!(!text(section(&html, "X.maxima.most")).contains("Anexample"));
}

#[test]
fn again_is_the_shortest_command() {
    let html = page(&RECORDED, &SOURCE).unwrap();
    for (claim, command) in [
        (
            "Conj3.1.strong.continuous",
            "knotproof shape --degree 3 --knots 0,0,0,0,1,2,4,4 --alpha 5/2 --index 2",
        ),
        ("T3.5.1", "knotproof eval --degree 1 --knots 0,0,1,1 --alpha -1 --x 0"),
        ("T3.5.2", "knotproof report --claim T3.5.2"),
    ] {
        assert!(section(&html, claim).contains(&format!("<code>{command}</code>")), "{claim}");
    }
}
