//! The corners of the paper's curves: values known by other means, the extremes, and the JSON.

use knotproof::language::paper;
use knotproof::report::{Corner, Turn, corners};
use knotproof::scalar::{BigRational, rational};

fn at<'a>(corners: &'a [Corner], instance: &str, alpha: &str, knot: i64) -> &'a Corner {
    let here = |corner: &&Corner| {
        corner.instance == instance && corner.alpha.to_string() == alpha && corner.knot == rational(knot, 1)
    };
    corners.iter().find(here).expect("the figure shows it")
}

fn turn(corner: &Corner) -> &Turn {
    corner.turn.as_ref().expect("both derivatives are not 0")
}

#[test]
fn a_degree_3_curve_has_a_corner_at_a_simple_knot() {
    let corners = corners(paper());
    let corner = at(&corners, "S1", "-1", 1);
    assert_eq!(corner.left, [rational(1672, 225), rational(28, 9)]);
    assert_eq!(corner.right, [rational(1312, 225), rational(22, 9)]);
    assert_eq!(corner.determinant, rational(16, 675));
    // 1 − cos² = det²/(|D⁻|²·|D⁺|²).
    let square = |v: &[BigRational]| v.iter().map(|c| c * c).sum::<BigRational>();
    let sine = &corner.determinant * &corner.determinant / (square(&corner.left) * square(&corner.right));
    assert_eq!(rational(1, 1) - sine, turn(corner).cos2);
    assert_eq!(
        (turn(corner).angle_degrees.as_str(), turn(corner).speed_ratio.as_str()),
        ("0.0266630", "0.784842")
    );
    assert!(!turn(corner).turns_back);
}

/// Every curve, every α, every knot; a derivative is 0 only where the double point lies over the double knot.
#[test]
fn all_corners_are_there() {
    let corners = corners(paper());
    assert_eq!(corners.len(), 561);
    for corner in &corners {
        let stops = ["S3", "S6"].contains(&corner.instance.as_str()) && corner.multiplicity == 2;
        assert_eq!(corner.turn.is_none(), stops, "{corner:?}");
    }
}

/// For degree ≥ 2, at simple knots: the classical curve has no corner and no jump of the speed there.
#[test]
fn what_is_lost_is_small_in_direction_and_large_in_speed() {
    let corners = corners(paper());
    let smooth: Vec<_> = corners.iter().filter(|corner| corner.multiplicity < corner.degree).collect();
    let (classical, other): (Vec<_>, Vec<_>) = smooth
        .into_iter()
        .filter_map(|corner| Some((corner, corner.turn.as_ref()?)))
        .partition(|(corner, _)| corner.alpha.is_infinite());
    assert!(classical.iter().all(|(corner, turn)| corner.left == corner.right && turn.angle_degrees == "0"));
    assert!(other.iter().all(|(_, turn)| !turn.turns_back));
    let (sharpest, turn) = other.iter().min_by(|a, b| a.1.cos2.cmp(&b.1.cos2)).expect("some");
    assert_eq!(
        (sharpest.instance.as_str(), sharpest.alpha.to_string(), &sharpest.knot),
        ("S4", "-1/5".into(), &rational(2, 1))
    );
    assert_eq!(turn.angle_degrees, "0.996360");
    // The speed: 88/25 = 1/0.284…, and its conjugate.
    let fastest = other.iter().map(|(_, turn)| &turn.speed_ratio_squared).max().expect("some");
    let slowest = other.iter().map(|(_, turn)| &turn.speed_ratio_squared).min().expect("some");
    assert_eq!(*fastest, rational(88 * 88, 25 * 25));
    assert_eq!(*slowest, rational(25 * 25, 88 * 88));
}

#[test]
fn exact_numbers_are_written_as_fractions() {
    let corners = corners(paper());
    let json = serde_json::to_value(at(&corners, "S1", "-1", 1)).expect("plain data");
    assert_eq!(json["knot"], "1");
    assert_eq!(json["alpha"], "-1");
    assert_eq!(json["left"], serde_json::json!(["1672/225", "28/9"]));
    assert_eq!(json["determinant"], "16/675");
    assert_eq!(json["turn"]["angle_degrees"], "0.0266630");
    let stops = serde_json::to_value(at(&corners, "S3", "-1", 2)).expect("plain data");
    assert!(stops["turn"].is_null());
}
