//! Illustration 5.6: the trace of C6a in degree 2 and of C6b in degrees 2 to 4 is another one for every finite α.

use std::fmt::Write as _;

use super::Formal;
use super::example::{Example, of_degree};
use super::place::Place;

/// A polynomial in x and y: terms (coefficient, exponent of x, exponent of y).
type Implicit = &'static [(i64, usize, usize)];

/// A curve, the knot at which its point is looked at for r > 1 and for r < 1, and for every span of the curve for ∞ an
/// algebraic curve that contains it (by elimination of u), with the sign of its polynomial at the point.
struct Separated {
    name: &'static str,
    degree: usize,
    above: Witness,
    below: Witness,
    implicit: &'static [Implicit],
}

/// The point at the first knot of a span, and the signs, one for each span.
struct Witness {
    span: usize,
    signs: &'static [char],
}

const CURVES: [Separated; 4] = [
    Separated {
        name: "C6a",
        degree: 2,
        above: Witness { span: 3, signs: &['+', '+'] },
        below: Witness { span: 3, signs: &['+', '+'] },
        implicit: &[
            &[(64, 2, 0), (-16, 1, 1), (-360, 1, 0), (1, 0, 2), (120, 0, 1)],
            &[(16, 2, 0), (-8, 1, 1), (-168, 1, 0), (1, 0, 2), (-12, 0, 1), (684, 0, 0)],
        ],
    },
    Separated {
        name: "C6b",
        degree: 2,
        above: Witness { span: 3, signs: &['+', '+', '+', '-'] },
        below: Witness { span: 3, signs: &['+', '+', '+', '-'] },
        implicit: &[
            &[(16, 2, 0), (56, 1, 1), (-360, 1, 0), (49, 0, 2), (-430, 0, 1), (1025, 0, 0)],
            &[(100, 2, 0), (-280, 1, 1), (900, 1, 0), (196, 0, 2), (-260, 0, 1), (-2975, 0, 0)],
            &[(100, 2, 0), (-280, 1, 1), (-1100, 1, 0), (196, 0, 2), (540, 0, 1), (3025, 0, 0)],
            &[(36, 2, 0), (84, 1, 1), (-396, 1, 0), (49, 0, 2), (-762, 0, 1), (1089, 0, 0)],
        ],
    },
    Separated {
        name: "C6b",
        degree: 3,
        above: Witness { span: 5, signs: &['+', '+', '-'] },
        below: Witness { span: 4, signs: &['+', '-', '-'] },
        implicit: &[
            &[
                (2744, 3, 0),
                (35868, 2, 1),
                (251364, 2, 0),
                (156282, 1, 2),
                (-1174884, 1, 1),
                (435498, 1, 0),
                (226981, 0, 3),
                (-2174379, 0, 2),
                (6640887, 0, 1),
                (-5160833, 0, 0),
            ],
            &[
                (2000, 3, 0),
                (-11400, 2, 1),
                (4500, 2, 0),
                (21660, 1, 2),
                (-17100, 1, 1),
                (-249750, 1, 0),
                (-13718, 0, 3),
                (16245, 0, 2),
                (-31725, 0, 1),
                (1076625, 0, 0),
            ],
            &[
                (17576, 3, 0),
                (123708, 2, 1),
                (-1086900, 2, 0),
                (290238, 1, 2),
                (-2185764, 1, 1),
                (11196690, 1, 0),
                (226981, 0, 3),
                (-3623973, 0, 2),
                (12602127, 0, 1),
                (-33035435, 0, 0),
            ],
        ],
    },
    Separated {
        name: "C6b",
        degree: 4,
        above: Witness { span: 5, signs: &['-', '+'] },
        below: Witness { span: 5, signs: &['+', '-'] },
        implicit: &[
            &[
                (1, 4, 0),
                (-56, 3, 1),
                (-60256, 3, 0),
                (1176, 2, 2),
                (186144, 2, 1),
                (982746, 2, 0),
                (-10976, 1, 3),
                (212856, 1, 2),
                (-595224, 1, 1),
                (-6005856, 1, 0),
                (38416, 0, 4),
                (-145432, 0, 3),
                (-75852, 0, 2),
                (-1970816, 0, 1),
                (12090921, 0, 0),
            ],
            &[
                (1, 4, 0),
                (56, 3, 1),
                (73864, 3, 0),
                (1176, 2, 2),
                (-413840, 2, 1),
                (1401906, 2, 0),
                (10976, 1, 3),
                (-235592, 1, 2),
                (6780312, 1, 1),
                (-26891896, 1, 0),
                (38416, 0, 4),
                (-727160, 0, 3),
                (5681060, 0, 2),
                (-36696304, 0, 1),
                (100332641, 0, 0),
            ],
        ],
    },
];

/// The polynomial at a point given by terms.
fn at(implicit: Implicit, [x, y]: &[String; 2]) -> String {
    let mut sum = String::from("(+");
    for (coefficient, a, b) in implicit {
        let _ = write!(sum, " (* {coefficient} (^ {x} {a}) (^ {y} {b}))");
    }
    sum + ")"
}

pub(super) fn formal(claim: &str, amended: bool) -> Option<Formal> {
    const BECAUSE: &str = "For every finite α the point of the curve at one knot is no point of the curve for ∞. Every span of the latter lies on an algebraic curve f = 0, given in the goals; and f is not 0 at the point, for r = 1 + s and for r = 1/(1 + s).";
    (claim == "Ill5.6.between" && !amended).then(|| Formal::on_all_indices(&[2, 3, 4], BECAUSE, differ()))
}

/// The sections for all four.
fn differ() -> String {
    let mut sections = String::new();
    for curve in &CURVES {
        for instance in of_degree(&[curve.name], &[curve.degree]) {
            let on = Example::new(&instance);
            let spans = on.spans();
            let point = |place| [0, 1].map(|c| on.coordinate(c, place));
            let on_curve = |(implicit, span): (&Implicit, &usize)| -> String {
                Place::closed(*span).map(|place| format!("(= {} 0)", at(implicit, &point(place)))).concat()
            };
            let goals: String = curve.implicit.iter().zip(&spans).map(on_curve).collect();
            sections += &on.section("(let r 1)", &goals);
            for (alpha, witness) in
                [("(let r (+ 1 s))", &curve.above), ("(let r (/ 1 (+ 1 s)))", &curve.below)]
            {
                let off = |(implicit, sign): (&Implicit, &char)| {
                    let compare = if *sign == '+' { '>' } else { '<' };
                    format!("({compare} {} 0)", at(implicit, &point(Place::start(witness.span))))
                };
                let goals: String = curve.implicit.iter().zip(witness.signs).map(off).collect();
                sections += &on.section(&format!("(positive s) {alpha}"), &goals);
            }
        }
    }
    sections
}
