//! The knot vectors, indices and control polygons of the paper's illustrations (section 5), by name.

use num_rational::BigRational;

use crate::scalar::parse_rational;
use crate::spline::{Index, KnotVector, Point};

/// One of the paper's examples: a degree on a knot vector, with the indices it is shown for and, for a
/// curve, the control points.
#[derive(Debug, Clone, PartialEq)]
pub struct Instance {
    /// The name used here, such as `U4`, `C6a` or `S3`. One name can stand for several degrees.
    pub name: &'static str,
    /// Where the paper shows it.
    pub figure: &'static str,
    /// k.
    pub degree: usize,
    /// U.
    pub knots: KnotVector,
    /// The values of α.
    pub indices: Vec<Index>,
    /// d_0, …, d_n, for a curve.
    pub points: Option<Vec<Point>>,
}

/// The indices of the basis figures.
const BASES: &str = "-1 2 5 inf";
/// A and its conjugates: the indices of the curves C5, C6, C7. Figures 23 and 24 show −1 as well.
const CURVES: &str = "inf -4 -1/2 -1/5 -1/7 5 3/2 6/5 8/7";
const CURVES_BY_DEGREE: &str = "inf -4 -1 -1/2 -1/5 -1/7 5 2 3/2 6/5 8/7";
/// The indices of the symmetric curves, with their conjugates.
const SYMMETRIC: &str = "inf -1 -1/2 -1/5 2 3/2 6/5";

const C6A: &str = "0,0 3,9 6,3 9,6";
const C6B: &str = "1,3 0,5 5,5 3,0 8,0 7,3";
const C7_KNOTS: &str = "0 0 0 0 1 2 3 4 4 4 4";
const S1_KNOTS: &str = "0 0 0 0 1 2 3 3 3 3";
const S2_POINTS: &str = "4,0 0,11 8,14 8,14 16,11 12,0";
const S4_KNOTS: &str = "0 0 0 0 1 2 3 4 5 6 7 8 9 10 11 11 11 11";
const S5_POINTS: &str = "0,5 0,4 1,4 2,4 2,6 4,6 5,3 5,3 4,0 2,0 2,2 1,2 0,2 0,1";

/// Name, figure, degree, knots, indices, control points.
type Row = (&'static str, &'static str, usize, &'static str, &'static str, &'static str);

const ROWS: &[Row] = &[
    ("U0", "Fig. 4", 0, "0 1 2 3 4 5 6", BASES, ""),
    ("U0", "Fig. 5", 1, "0 1 2 3 4 5 6", BASES, ""),
    ("U0", "Fig. 6, 8", 2, "0 1 2 3 4 5 6", BASES, ""),
    ("U0", "Fig. 7", 3, "0 1 2 3 4 5 6", BASES, ""),
    ("U1", "Fig. 9", 2, "0 1 2 3 3 5 6", BASES, ""),
    ("U2", "Fig. 10", 2, "0 1 1 2 4 5 6", BASES, ""),
    ("U3", "Fig. 11", 2, "0 1 3/2 2 7/2 5 6", BASES, ""),
    ("U4", "Fig. 12", 2, "0 0 0 1 2 3 3 3", BASES, ""),
    ("U5", "Fig. 13", 2, "0 0 0 2/5 13/5 3 3 3", BASES, ""),
    ("U6", "Fig. 14", 2, "0 0 0 9/5 11/5 3 3 3", BASES, ""),
    ("U7", "Fig. 15", 2, "0 0 0 1 1 3 3 3", BASES, ""),
    ("U8", "Fig. 16", 2, "0 0 0 2 2 3 3 3", BASES, ""),
    ("U9", "Fig. 17", 2, "0 0 0 3/4 6/4 9/4 3 3 3", BASES, ""),
    ("U10", "Fig. 18", 2, "0 0 0 3/4 3/4 9/4 3 3 3", BASES, ""),
    ("U11", "Fig. 19", 2, "0 0 0 3/4 3/4 3/4 3 3 3", BASES, ""),
    ("U12", "Fig. 20", 2, "0 0 0 3/4 9/4 9/4 3 3 3", BASES, ""),
    ("U13", "Fig. 21", 2, "0 0 0 9/4 9/4 9/4 3 3 3", BASES, ""),
    ("C5", "Fig. 22", 3, "0 0 0 0 1 2 3 4 5 5 5 5", CURVES, "0,2 3/2,5 5/2,4 3,1 5,4 7,1 8,4 10,4"),
    ("C6a", "Fig. 23", 1, "0 0 1 2 3 3", CURVES_BY_DEGREE, C6A),
    ("C6a", "Fig. 23", 2, "0 0 0 3/2 3 3 3", CURVES_BY_DEGREE, C6A),
    ("C6a", "Fig. 23", 3, "0 0 0 0 3 3 3 3", CURVES_BY_DEGREE, C6A),
    ("C6b", "Fig. 24", 1, "0 0 1 2 3 4 5 5", CURVES_BY_DEGREE, C6B),
    ("C6b", "Fig. 24", 2, "0 0 0 5/4 5/2 15/4 5 5 5", CURVES_BY_DEGREE, C6B),
    ("C6b", "Fig. 24", 3, "0 0 0 0 5/3 10/3 5 5 5 5", CURVES_BY_DEGREE, C6B),
    ("C6b", "Fig. 24", 4, "0 0 0 0 0 5/2 5 5 5 5 5", CURVES_BY_DEGREE, C6B),
    ("C6b", "Fig. 24", 5, "0 0 0 0 0 0 5 5 5 5 5 5", CURVES_BY_DEGREE, C6B),
    ("C7a", "Fig. 25, 26", 3, C7_KNOTS, CURVES, "0,4 5,4 5,8 11,15/2 6,2 12,0 2,0"),
    ("C7b", "Fig. 25, 26", 3, C7_KNOTS, CURVES, "0,4 5,4 5,8 11,15/2 9,3 12,0 2,0"),
    ("C7c", "Fig. 25, 26", 3, C7_KNOTS, CURVES, "0,4 5,4 5,8 11,15/2 12,4 12,0 2,0"),
    ("S1", "Fig. 27", 3, S1_KNOTS, SYMMETRIC, "4,0 0,11 6,14 10,14 16,11 12,0"),
    ("S2", "Fig. 28", 3, S1_KNOTS, SYMMETRIC, S2_POINTS),
    ("S3", "Fig. 29", 3, "0 0 0 0 2 2 4 4 4 4", SYMMETRIC, S2_POINTS),
    ("S4", "Fig. 30", 3, S4_KNOTS, SYMMETRIC, "0,5 0,4 1,4 2,4 2,6 4,6 5,5 5,1 4,0 2,0 2,2 1,2 0,2 0,1"),
    ("S5", "Fig. 31", 3, S4_KNOTS, SYMMETRIC, S5_POINTS),
    ("S6", "Fig. 32", 3, "0 0 0 0 1 2 3 4 5 5 6 7 8 9 10 10 10 10", SYMMETRIC, S5_POINTS),
    (
        "S7",
        "Fig. 33",
        3,
        "0 0 0 0 1 2 3 4 5 6 7 8 9 10 10 10 10",
        SYMMETRIC,
        "0,2 0,3 1,4 3,4 5,4 6,3 6,2 6,1 5,0 3,0 1,0 0,1 0,2",
    ),
];

/// All instances of the paper, in its order.
#[must_use]
pub fn instances() -> Vec<Instance> {
    ROWS.iter().map(build).collect()
}

/// The instances of that name: one for each degree, none if the name is unknown.
#[must_use]
pub fn instances_named(name: &str) -> Vec<Instance> {
    ROWS.iter().filter(|row| row.0 == name).map(build).collect()
}

/// The table above is constant; a test builds all of it.
fn build(&(name, figure, degree, knots, indices, points): &Row) -> Instance {
    let number = |text: &str| match parse_rational(text) {
        Ok(value) => value,
        Err(error) => unreachable!("instance {name}: {error}"),
    };
    let numbers =
        |text: &str, separator: char| text.split(separator).map(number).collect::<Vec<BigRational>>();
    let knots = match KnotVector::new(numbers(knots, ' ')) {
        Ok(knots) => knots,
        Err(error) => unreachable!("instance {name}: {error}"),
    };
    let indices = indices.split(' ').map(|text| match text.parse() {
        Ok(index) => index,
        Err(error) => unreachable!("instance {name}: {error}"),
    });
    let points = (!points.is_empty()).then(|| points.split(' ').map(|point| numbers(point, ',')).collect());
    Instance { name, figure, degree, knots, indices: indices.collect(), points }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::{Basis, Curve};

    #[test]
    fn every_instance_is_valid() {
        let all = instances();
        assert_eq!(all.len(), ROWS.len());
        for instance in all {
            for index in instance.indices {
                let basis = Basis::new(instance.knots.clone(), instance.degree, index).unwrap();
                if let Some(points) = &instance.points {
                    Curve::new(basis, points.clone()).unwrap();
                }
            }
        }
    }
}
