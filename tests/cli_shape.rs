//! The command `shape`: its JSON, its exit codes, and what it refuses.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a failure is a failed test")]

use knotproof::analysis::{ExtremumKind, Partition, Pieces, Shape};
use knotproof::scalar::{BigRational, integer, parse_rational, rational};
use knotproof::search::{Candidate, Enumeration, Goal, Sample, Search, Space, local_maxima};
use knotproof::spline::{Basis, Index, KnotVector};
use proptest::prelude::*;
use serde_json::{Value, json};

fn shape(arguments: &[&str]) -> (i32, Value) {
    let mut command = crate::program();
    let output = command.args(["shape", "--format", "json"]).args(arguments).output().unwrap();
    let text = if output.stdout.is_empty() { output.stderr } else { output.stdout };
    (output.status.code().unwrap(), serde_json::from_slice(&text).unwrap())
}

const TWO: [&str; 6] = ["--degree", "3", "--knots", "0 0 0 0 1 2 4 4", "--index", "2"];

#[test]
fn one_function_with_two_maxima() {
    let (exit, result) = shape(&[&TWO[..], &["--alpha", "5/2", "--width", "1e-9"]].concat());
    assert_eq!((exit, &result["schema"]), (1, &json!("knotproof.shape/1")));
    let function = &result["functions"][0];
    assert_eq!(function["local_maxima"], 2);
    assert_eq!((&function["strong"], &function["weak"]), (&json!(false), &json!(true)));
    assert_eq!(function["extrema"][1]["interval"], json!(["1", "1"]));
    assert_eq!(function["slopes"][1], json!({"at": "1", "left": "-3/6272", "right": "25/6272"}));
}

#[test]
fn several_indices_and_all_functions() {
    let (exit, result) = shape(&["--degree", "1", "--knots", "0 1 2 3", "--alpha", "-1", "--alpha", "inf"]);
    assert_eq!((exit, result["functions"].as_array().unwrap().len()), (0, 4));
}

#[test]
fn every_ratio_and_every_place_of_a_knot() {
    let counts = |result: &Value| -> Vec<u64> {
        let cells = result["functions"][0]["cells"].as_array().unwrap().clone();
        cells.iter().map(|cell| cell["local_maxima"].as_u64().unwrap()).collect()
    };
    let uniform = ["--degree", "4", "--knots", "0 1 2 3 4 5 5 5 5", "--index", "0", "--alpha", "all"];
    let (exit, result) = shape(&uniform);
    assert_eq!((exit, counts(&result)), (1, vec![1, 2, 1, 2, 1]));
    let cells = &result["functions"][0]["cells"];
    assert_eq!((&cells[0]["ratio"][0], &cells[4]["ratio"][1]), (&json!("0"), &Value::Null));
    assert_eq!(result["functions"][0]["ends"][0]["events"], json!([{"span": 2, "at": "end"}]));
    let (exit, result) = shape(&[&TWO[..], &["--alpha", "5/2", "--free-knot", "5"]].concat());
    assert_eq!((exit, counts(&result)), (1, vec![1, 2, 1]));
    let (exit, _) = shape(&["--degree", "2", "--knots", "0 1 2 3 3", "--alpha", "all"]);
    assert_eq!(exit, 0);
}

#[test]
fn what_is_refused() {
    for (arguments, argument) in [
        (&["--alpha", "5/2", "--width", "0"][..], "--width"),
        (&["--alpha", "all", "--alpha", "2"], "--alpha"),
        (&["--alpha", "all", "--free-knot", "5"], "--free-knot"),
        (&["--alpha", "2", "--free-knot", "7"], "--free-knot"),
        (&["--alpha", "2", "--free-knot", "1"], "--free-knot"),
    ] {
        let (exit, result) = shape(&[&TWO[..], arguments].concat());
        assert_eq!((exit, &result["error"]["argument"]), (2, &json!(argument)), "{result}");
    }
}

/// What `shape` prints for people.
fn printed(arguments: &[&str]) -> String {
    let output = crate::program().arg("shape").args(arguments).output().unwrap();
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The example of the guide. The minimum is 285/448, and the maxima were computed elsewhere, in fractions:
/// 0.63616077817840… at 0.99973284899…, and 0.63616339785051… at 1.00134775120….
#[test]
fn the_text_for_a_function_with_two_maxima() {
    let arguments = [&TWO[..], &["--alpha", "5/2"]].concat();
    let found = printed(&arguments);
    let expected = "\
Knots (0, 0, 0, 0, 1, 2, 4, 4), degree 3

G_2, α = 5/2, on [0, 4]
2 local maxima; the supremum is attained at exactly one point
          x                                 ≈             value ≈       at
 maximum  [1048295/1048576, 131037/131072]  0.9997328490  0.6361607782
 minimum  1                                 1.000000000   0.6361607143  knot
 maximum  [1049989/1048576, 524995/524288]  1.001347751   0.6361633979
 knot  slope from the left  from the right
 0     –                    0
 1     -3/6272              25/6272
 2     -1431/3872           -1695/3872
 4     0                    –
";
    assert_eq!(found, expected);
    // The decimals do not depend on how wide the intervals may be.
    let decimals = |text: &str| -> Vec<(String, String)> {
        rows(text).into_iter().map(|row| (row.x, row.value)).collect()
    };
    for width in ["1", "1e6", "1e-3", "1e-30"] {
        assert_eq!(decimals(&printed(&[&arguments[..], &["--width", width]].concat())), decimals(&found));
    }
}

/// A row of the table of extrema.
struct Row {
    maximum: bool,
    x: String,
    value: String,
}

/// The extrema of all functions in a text, in order.
fn rows(text: &str) -> Vec<Row> {
    let row = |line: &str| {
        let kind = line.trim_start().split(' ').next()?;
        let maximum = ["minimum", "maximum"].iter().position(|&known| known == kind)? == 1;
        let columns: Vec<_> = line.split("  ").map(str::trim).filter(|column| !column.is_empty()).collect();
        Some(Row { maximum, x: columns[2].to_owned(), value: columns[3].to_owned() })
    };
    text.lines().filter_map(row).collect()
}

/// Is the decimal the number between these bounds, rounded? They are far closer than its last digit.
fn is_rounded(text: &str, (lo, hi): &(BigRational, BigRational)) -> bool {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let places = digits.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let unit =
        parse_rational(&format!("1e{exponent}")).unwrap() / integer(10).pow(i32::try_from(places).unwrap());
    let value = parse_rational(text).unwrap();
    let half = unit / integer(2);
    &value - &half <= *hi && *lo <= value + half
}

/// All that is printed of the extrema of a basis is right to the last digit, and each maximum is printed above the minima
/// beside it.
fn prints_what_is_so(basis: &Basis, i: usize) {
    let knots: Vec<_> = basis.knots().knots().iter().map(ToString::to_string).collect();
    let (degree, index) = (basis.degree().to_string(), i.to_string());
    let alpha = basis.index().to_string();
    for width in ["0x1p-20", "1"] {
        let arguments =
            ["--degree", &degree, "--knots", &knots.join(" "), "--alpha", &alpha, "--index", &index];
        let found = rows(&printed(&[&arguments[..], &["--width", width]].concat()));
        let shape = Shape::of(&Pieces::of(basis), i);
        assert_eq!(found.len(), shape.extrema().len());
        let fine = rational(1, 10).pow(200);
        for (row, extremum) in found.iter().zip(shape.extrema()) {
            assert_eq!(row.maximum, extremum.kind == ExtremumKind::Maximum);
            assert!(
                is_rounded(&row.value, &extremum.height().bounds_within(&fine)),
                "{arguments:?}: {}",
                row.value
            );
            assert!(is_rounded(&row.x, &extremum.x().bounds_within(&fine)), "{arguments:?}: {}", row.x);
        }
        for (pair, of) in found.windows(2).zip(shape.extrema().windows(2)) {
            let [x, y] = [&pair[0], &pair[1]].map(|row| parse_rational(&row.x).unwrap());
            assert!(x < y, "{arguments:?}: {x} {y}");
            let jump = shape
                .jumps()
                .iter()
                .any(|jump| of[0].place.interval().1 <= &jump.at && &jump.at <= of[1].place.interval().0);
            if pair[0].maximum != pair[1].maximum && !jump {
                let (maximum, minimum) =
                    if pair[0].maximum { (&pair[0], &pair[1]) } else { (&pair[1], &pair[0]) };
                let [maximum, minimum] = [maximum, minimum].map(|row| parse_rational(&row.value).unwrap());
                assert!(maximum > minimum, "{arguments:?}: {maximum} {minimum}");
            }
        }
    }
}

fn basis(degree: usize, knots: Vec<BigRational>, index: Index) -> Basis {
    Basis::new(KnotVector::new(knots).unwrap(), degree, index).unwrap()
}

/// Random functions with several maxima, whose dips are a thousandth of the height at most, and as a rule far less.
#[test]
fn maxima_are_printed_above_their_minima() {
    for degree in 3..=5 {
        let space = Space::Random(Sample { count: 3000, seed: 3, spread: 9 });
        let cases = Enumeration::of(&Search { degree, find: Goal::Several, space }).unwrap();
        let several = |candidate: &Candidate| local_maxima(candidate).maxima > 1;
        let found: Vec<_> = cases.between(0..3000).map(|(_, case)| case).filter(several).take(6).collect();
        assert!(found.len() >= 3, "degree {degree}: {}", found.len());
        for candidate in found {
            let full = candidate.full_knots();
            prints_what_is_so(&basis(degree, full.rational(), candidate.index()), full.index);
        }
    }
}

/// Next to the r where two maxima become one, the dip is as small as one likes: here 10^-12, 10^-36 and 10^-60 or so.
#[test]
fn dips_far_below_ten_digits_are_printed_too() {
    let mut knots: Vec<_> = (0..=5).map(integer).collect();
    knots.extend(vec![integer(5); 3]);
    for bits in [20, 60, 100] {
        let width = rational(1, 2).pow(bits);
        let partition = Partition::by_ratio(&basis(4, knots.clone(), Index::infinity()), 0, &width);
        let two = partition.cells().iter().find(|cell| cell.local_maxima == Some(2)).unwrap();
        let near = basis(4, knots.clone(), Index::from_ratio(two.from.clone()).unwrap());
        prints_what_is_so(&near, 0);
        let values: Vec<_> = rows(&printed(&[
            "--degree",
            "4",
            "--knots",
            "0 1 2 3 4 5 5 5 5",
            "--index",
            "0",
            "--alpha",
            &near.index().to_string(),
        ]))
        .into_iter()
        .map(|row| row.value.len())
        .collect();
        assert!(values.len() == 3 && values.iter().all(|digits| *digits > 10), "{values:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn random_functions_are_printed_as_they_are(
        gaps in prop::collection::vec(prop_oneof![3 => 1_usize..=9, 1 => Just(0), 1 => Just(100)], 4..=9),
        degree in 1_usize..=3,
        (p, q) in (1_i64..=40, 1_i64..=40),
    ) {
        let mut knots = vec![integer(0)];
        for gap in gaps {
            knots.push(&knots[knots.len() - 1] + integer(gap));
        }
        let index = Index::from_ratio(rational(p, q)).unwrap();
        if let Ok(vector) = KnotVector::new(knots) && let Ok(basis) = Basis::new(vector, degree, index) {
            prints_what_is_so(&basis, 0);
        }
    }
}

/// The ends of cells are irrational, and their decimals are settled whatever the width.
#[test]
fn the_ends_of_cells_are_printed_as_they_are() {
    let uniform = ["--degree", "4", "--knots", "0 1 2 3 4 5 5 5 5", "--index", "0", "--alpha", "all"];
    for width in ["0x1p-20", "1", "1e-30"] {
        let found = printed(&[&uniform[..], &["--width", width]].concat());
        let bounds: Vec<_> = found.lines().filter_map(|line| Some(line.split_once(" between ")?.1)).collect();
        let numbers = ["0", "≈ 0.3956988184", "≈ 0.4015382852", "≈ 2.490422550", "≈ 2.527174592", "∞"];
        let expected: Vec<_> = numbers.windows(2).map(|pair| pair.join(" and ")).collect();
        assert_eq!(bounds, expected);
    }
}
