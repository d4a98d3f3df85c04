//! Which figures there are.

use crate::meaning::{Example, examples_named};
use crate::scalar::parse_rational;
use crate::spline::{Basis, KnotVector};

use super::super::conjecture;
use super::canvas::{PictureError, failed};
use super::curve::Panels;
use super::rising::{self, Rising};
use super::weight::Weights;
use super::{basis, curve, limit, slopes, weight};

/// A figure: its name, what it shows, and the claims that it belongs to.
#[derive(Debug)]
pub struct Figure {
    /// `fig1` to `fig33` are those of the paper; other names are ours.
    pub name: &'static str,
    /// The number in the paper.
    pub number: Option<usize>,
    /// One line of text.
    pub title: &'static str,
    /// Identifiers of claims that are about it.
    pub claims: &'static [&'static str],
    subject: Subject,
}

#[derive(Debug)]
enum Subject {
    Weights(&'static Weights),
    /// Name and degree.
    Bases(&'static str, usize),
    /// Names, panels, and whether the convex hull is drawn.
    Curves(&'static [&'static str], Panels, bool),
    /// D⁺ − D⁻ at the knots of an instance.
    Slopes(&'static str),
    /// The traces of an instance as α → 0⁻ and α → 1⁺.
    Limit(&'static str),
    /// Sums or shares of the functions of an instance.
    Rises(&'static str, Rising),
    /// One function: degree, knots, α, i.
    Function(usize, &'static str, &'static str, usize),
}

/// Those of the paper in its order, then ours.
///
/// ```
/// use knotproof::report::figures;
///
/// let paper: Vec<_> = figures::all().iter().filter_map(|figure| figure.number).collect();
/// assert_eq!(paper, (1..=33).collect::<Vec<_>>());
/// ```
#[must_use]
pub fn all() -> &'static [Figure] {
    FIGURES
}

/// The figure of that name; a number stands for one of the paper: `7` is `fig7`.
#[must_use]
pub fn figure(name: &str) -> Option<&'static Figure> {
    let number = name.parse().ok();
    FIGURES.iter().find(|figure| figure.name == name || (number.is_some() && figure.number == number))
}

impl Figure {
    /// The name of the SVG file.
    #[must_use]
    pub fn file(&self) -> String {
        format!("{}.svg", self.name)
    }

    /// The figure as SVG: one file without references to others, the same bytes every time.
    ///
    /// # Errors
    /// [`PictureError`], a bug of this program.
    pub fn svg(&self) -> Result<String, PictureError> {
        match self.subject {
            Subject::Weights(weights) => weight::svg(self.title, weights),
            Subject::Bases(name, degree) => {
                let of_degree = |instance: &Example| instance.degree == degree;
                let instance = examples_named(name).into_iter().find(of_degree);
                basis::svg(self.title, &instance.ok_or_else(|| failed(format!("there is no {name}")))?)
            }
            Subject::Curves(names, panels, hull) => {
                let instances: Vec<Example> = names.iter().flat_map(|name| examples_named(name)).collect();
                curve::svg(self.title, &instances, panels, hull)
            }
            Subject::Slopes(name) => slopes::svg(self.title, name),
            Subject::Limit(name) => limit::svg(self.title, name),
            Subject::Rises(name, rising) => rising::svg(self.title, name, rising),
            Subject::Function(degree, knots, alpha, i) => {
                let knots: Vec<_> =
                    knots.split(' ').map(parse_rational).collect::<Result<_, _>>().map_err(failed)?;
                let knots = KnotVector::new(knots).map_err(failed)?;
                let basis = Basis::new(knots, degree, alpha.parse().map_err(failed)?).map_err(failed)?;
                conjecture::function(self.title, &basis, i)
            }
        }
    }
}

const BELOW: &[&str] = &["-1/3", "-1", "-4", "inf"];
const ABOVE: &[&str] = &["4/3", "2", "5", "inf"];
/// Conjugates near 0 and 1, between, and far out.
const COMPARED: &[&[&str]] = &[&["-1/3", "4/3", "inf"], &["-1", "2", "inf"], &["-20", "21", "inf"]];

const UNIT: Weights = Weights { interval: (0, 1), from: -1, to: 2, panels: &[BELOW] };
const UNIT_ABOVE: Weights = Weights { panels: &[ABOVE], ..UNIT };
const WIDER: Weights = Weights { interval: (1, 3), from: 0, to: 6, panels: COMPARED };

const PHI: &[&str] = &["Ill2.1", "phi.range", "phi.shape", "R2.2.2a"];
const CONJUGATES: &[&str] = &["Ill2.1", "R2.2.2b", "R2.2.2c", "Ill2.1.crucial"];
const PERIODIC: &[&str] = &["Ill5.1.translate", "Ill5.1.support", "Ill5.1.effect"];
const FIGURE_7: &[&str] = &["Ill5.1.fig7", "Ill5.1.translate", "Ill5.1.support", "D3.2.examples"];
const UNEVEN: &[&str] = &["Ill5.2.support", "Ill5.1.effect", "Rem5.1.conj", "Rem5.1.approx"];
const SYMMETRIC_BASIS: &[&str] = &["Ill5.3.symmetry", "T3.5.4", "Rem5.1.conj", "Rem5.1.approx"];
const OPEN: &[&str] = &["P3.1.3", "Rem5.1.conj", "Rem5.1.approx"];
const REGULARITY: &[&str] = &["Ill5.4.regularity", "Rem5.1.conj", "Rem5.1.approx"];
const C5: &[&str] = &["Ill5.5.1", "Ill5.5.2", "Ill5.5.2.zero", "Ill5.5.2.general", "Ill5.7.hull", "Rem5.2"];
const C6: &[&str] = &[
    "Ill5.6.k1",
    "Ill5.6.bezier",
    "Ill5.6.bezier.function",
    "Ill5.6.between",
    "Ill5.6.increasing",
    "Ill5.7.hull",
    "Rem5.2",
];
const C7: &[&str] =
    &["Ill5.7.local", "Ill5.7.hull", "Ill5.7.shift", "Ill5.7.shift.order", "Ill5.7.small", "Rem5.2"];
const SYMMETRY: &[&str] = &["Ill5.8.symmetry", "Ill5.8.remarkable", "Fig27-33"];
const DOUBLE_POINT: &[&str] =
    &["Ill5.8.symmetry", "Ill5.8.double", "Ill5.8.double.near", "Ill5.8.remarkable", "Fig27-33"];
const FIGURE_29: &[&str] = &[
    "Ill5.8.fig29",
    "Ill5.8.symmetry",
    "Ill5.8.multiplicity",
    "Ill5.8.double",
    "Ill5.8.double.near",
    "Ill5.8.remarkable",
    "Fig27-33",
];
const DOUBLE_KNOT: &[&str] = &[
    "Ill5.8.symmetry",
    "Ill5.8.multiplicity",
    "Ill5.8.double",
    "Ill5.8.double.near",
    "Ill5.8.remarkable",
    "Fig27-33",
];
const C7_NAMES: &[&str] = &["C7a", "C7b", "C7c"];

const fn paper(
    number: usize,
    name: &'static str,
    title: &'static str,
    claims: &'static [&'static str],
    subject: Subject,
) -> Figure {
    Figure { name, number: Some(number), title, claims, subject }
}

const fn ours(
    name: &'static str,
    title: &'static str,
    claims: &'static [&'static str],
    subject: Subject,
) -> Figure {
    Figure { name, number: None, title, claims, subject }
}

const fn symmetric(name: &'static [&'static str]) -> Subject {
    Subject::Curves(name, Panels::Together, false)
}

static FIGURES: &[Figure] = &[
    paper(1, "fig1", "Fig. 1: weights on [0, 1], α < 0", PHI, Subject::Weights(&UNIT)),
    paper(2, "fig2", "Fig. 2: weights on [0, 1], the conjugates", PHI, Subject::Weights(&UNIT_ABOVE)),
    paper(
        3,
        "fig3",
        "Fig. 3: weights on [1, 3], conjugate and large α",
        CONJUGATES,
        Subject::Weights(&WIDER),
    ),
    paper(4, "fig4", "Fig. 4: U0, degree 0", PERIODIC, Subject::Bases("U0", 0)),
    paper(5, "fig5", "Fig. 5: U0, degree 1", PERIODIC, Subject::Bases("U0", 1)),
    paper(6, "fig6", "Fig. 6: U0, degree 2", PERIODIC, Subject::Bases("U0", 2)),
    paper(7, "fig7", "Fig. 7: U0, degree 3", FIGURE_7, Subject::Bases("U0", 3)),
    paper(8, "fig8", "Fig. 8: U0, degree 2", UNEVEN, Subject::Bases("U0", 2)),
    paper(9, "fig9", "Fig. 9: U1, degree 2", UNEVEN, Subject::Bases("U1", 2)),
    paper(10, "fig10", "Fig. 10: U2, degree 2", UNEVEN, Subject::Bases("U2", 2)),
    paper(11, "fig11", "Fig. 11: U3, degree 2", UNEVEN, Subject::Bases("U3", 2)),
    paper(12, "fig12", "Fig. 12: U4, degree 2", SYMMETRIC_BASIS, Subject::Bases("U4", 2)),
    paper(13, "fig13", "Fig. 13: U5, degree 2", SYMMETRIC_BASIS, Subject::Bases("U5", 2)),
    paper(14, "fig14", "Fig. 14: U6, degree 2", OPEN, Subject::Bases("U6", 2)),
    paper(15, "fig15", "Fig. 15: U7, degree 2", OPEN, Subject::Bases("U7", 2)),
    paper(16, "fig16", "Fig. 16: U8, degree 2", OPEN, Subject::Bases("U8", 2)),
    paper(17, "fig17", "Fig. 17: U9, degree 2", REGULARITY, Subject::Bases("U9", 2)),
    paper(18, "fig18", "Fig. 18: U10, degree 2", REGULARITY, Subject::Bases("U10", 2)),
    paper(19, "fig19", "Fig. 19: U11, degree 2", REGULARITY, Subject::Bases("U11", 2)),
    paper(20, "fig20", "Fig. 20: U12, degree 2", REGULARITY, Subject::Bases("U12", 2)),
    paper(21, "fig21", "Fig. 21: U13, degree 2", REGULARITY, Subject::Bases("U13", 2)),
    paper(22, "fig22", "Fig. 22: C5, degree 3", C5, Subject::Curves(&["C5"], Panels::Conjugates, true)),
    paper(
        23,
        "fig23",
        "Fig. 23: C6a, degrees 1 to 3",
        C6,
        Subject::Curves(&["C6a"], Panels::Conjugates, true),
    ),
    paper(
        24,
        "fig24",
        "Fig. 24: C6b, degrees 1 to 5",
        C6,
        Subject::Curves(&["C6b"], Panels::Conjugates, true),
    ),
    paper(25, "fig25", "Fig. 25: C7, degree 3, α < 0", C7, Subject::Curves(C7_NAMES, Panels::Negative, true)),
    paper(26, "fig26", "Fig. 26: C7, degree 3, α > 1", C7, Subject::Curves(C7_NAMES, Panels::Positive, true)),
    paper(27, "fig27", "Fig. 27: S1, degree 3", SYMMETRY, symmetric(&["S1"])),
    paper(28, "fig28", "Fig. 28: S2, degree 3", DOUBLE_POINT, symmetric(&["S2"])),
    paper(29, "fig29", "Fig. 29: S3, degree 3", FIGURE_29, symmetric(&["S3"])),
    paper(30, "fig30", "Fig. 30: S4, degree 3", SYMMETRY, symmetric(&["S4"])),
    paper(31, "fig31", "Fig. 31: S5, degree 3", DOUBLE_POINT, symmetric(&["S5"])),
    paper(32, "fig32", "Fig. 32: S6, degree 3", DOUBLE_KNOT, symmetric(&["S6"])),
    paper(33, "fig33", "Fig. 33: S7, degree 3", DOUBLE_POINT, symmetric(&["S7"])),
    ours(
        "derivative-jumps",
        "Derivatives jump at simple knots, and stop as α → ∞",
        &["Rem3.1", "abstract.regularity", "Ill5.4.regularity"],
        Subject::Slopes("U9"),
    ),
    ours(
        "two-maxima",
        "G_2, k = 3, U = (0, 0, 0, 0, 1, 2, 4, 4), α = 5/2: two local maxima",
        &["Conj3.1.strong", "Conj3.1.strong.continuous"],
        Subject::Function(3, "0 0 0 0 1 2 4 4", "5/2", 2),
    ),
    ours(
        "trace-limit",
        "C5 as α → 0 and as α → 1: the trace tends to a polygon and an arc",
        &["X.limit", "X.limit.trace", "X.limit.arc"],
        Subject::Limit("C5"),
    ),
    ours(
        "rising",
        "Sums of the functions from one on rise, whatever α",
        &["X.monotone"],
        Subject::Rises("U9", Rising::Sums),
    ),
    ours(
        "shares",
        "The share of the second of two neighbours rises, whatever α",
        &["X.minors"],
        Subject::Rises("U9", Rising::Shares),
    ),
];
