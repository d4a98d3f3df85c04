//! Introduction and section 2: the weight φ_α.

use crate::analysis::{Piece, coordinate_between};
use crate::scalar::{BigRational, RationalAlgebra, RationalFunction, Ring, integer, rational};
use crate::spline::{Index, weight};

use super::case::WeightCase;
use super::cause::Cause;
use super::claim::{Claim, Form};
use super::hypothesis::WeightHypothesis::{FiniteIndex, Proper};
use super::statement::Statement;
use super::verdict::{Judgement, Ledger, Stop, Witness};

/// φ_α(x, a, b) by D2.3 and in the paper's own form, for every real x, a, b.
fn phi(index: &Index, x: &BigRational, a: &BigRational, b: &BigRational) -> BigRational {
    if !(a <= x && x < b) {
        return integer(0);
    }
    match index.alpha() {
        Some(alpha) => &alpha * (x - a) / (x + (&alpha - integer(1)) * b - &alpha * a),
        None => (x - a) / (b - a),
    }
}

/// x on (a, b), and f_α and 1 − f_α there, as functions of the positive coordinate.
fn on_interval(case: &WeightCase) -> (Piece, Piece, Piece) {
    let x = coordinate_between(&case.a, &case.b);
    let (f, complement) = weight(&x.embed(case.index.ratio()), &x, &case.a, &case.b);
    (x, f, complement)
}

/// df/dx for a function of the positive coordinate of an interval.
fn derivative(f: &Piece, x: &Piece) -> Option<Piece> {
    f.derivative().over(&x.derivative())
}

/// x ↦ scale·x + shift.
#[derive(Clone)]
struct Affine {
    scale: BigRational,
    shift: BigRational,
}

impl Affine {
    /// A few maps of each direction, simple ones first.
    fn examples(rising: bool) -> Vec<Self> {
        let sign = if rising { 1 } else { -1 };
        let scales = [rational(sign, 1), rational(2 * sign, 1), rational(sign, 3)];
        let shifts = [integer(0), integer(1), rational(-1, 2)];
        let maps = scales.iter().flat_map(|scale| {
            shifts.iter().map(move |shift| Self { scale: scale.clone(), shift: shift.clone() })
        });
        maps.collect()
    }

    fn apply<S: RationalAlgebra>(&self, x: &S) -> S {
        x.times(&x.embed(&self.scale)).plus(&x.embed(&self.shift))
    }
}

impl std::fmt::Display for Affine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "x ↦ {}·x + {}", self.scale, self.shift)
    }
}

/// A function of x as the definition gives it at a point.
type AtPoint<'a> = &'a dyn Fn(&BigRational) -> BigRational;

/// left(x) = right(x): between a and b as functions, and at the given points.
struct Identity<'a> {
    left: (&'a str, AtPoint<'a>),
    right: (String, AtPoint<'a>),
    inside: Option<(Piece, Piece)>,
    points: Vec<BigRational>,
}

impl Identity<'_> {
    fn judge(&self, case: &WeightCase, extra: &[(&str, String)], ledger: &mut Ledger) -> Judgement {
        let sides = |x: &BigRational| ((self.left.1)(x), (self.right.1)(x));
        let mut failing = self.points.iter().filter(|x| {
            let (left, right) = sides(x);
            !ledger.equal(&left, &right)
        });
        if let Some(x) = failing.next() {
            let mut at = extra.to_vec();
            at.push(("x", x.to_string()));
            let claimed = format!("{} = {}", self.left.0, self.right.0);
            let (left, right) = sides(x);
            let mut found = format!("the left side is {left} and the right side {right}");
            // The points of a case may coincide.
            let mut others: Vec<&BigRational> = Vec::new();
            for other in failing {
                if other != x && !others.contains(&other) {
                    others.push(other);
                }
            }
            let others: Vec<_> = others.into_iter().map(ToString::to_string).collect();
            if !others.is_empty() {
                found += &format!("; it fails at x = {} as well", others.join(", "));
            }
            return Err(refuted(case, &at, claimed, found));
        }
        match &self.inside {
            Some((left, right)) if !ledger.equal(left, right) => {
                let middle = (&case.a + &case.b) / integer(2);
                let claimed = format!("{} = {} for every x in (a, b)", self.left.0, self.right.0);
                let found = format!("at x = {middle} the left side is {}", (self.left.1)(&middle));
                let found = format!("{found} and the right side {}", (self.right.1)(&middle));
                Err(refuted(case, extra, claimed, found))
            }
            _ => Ok(()),
        }
    }
}

/// One point of every region that a and b cut the line into, and then the ends, but for the inside of (a, b).
fn around(a: &BigRational, b: &BigRational) -> Vec<BigRational> {
    let (low, high) = if a <= b { (a, b) } else { (b, a) };
    let mut points = vec![low - integer(1), high + integer(1), low.clone(), high.clone()];
    if a > b {
        points.push((a + b) / integer(2));
    }
    points.dedup();
    points
}

fn refuted(case: &WeightCase, at: &[(&str, String)], claimed: String, found: String) -> Stop {
    let mut given = vec![
        ("α".to_owned(), case.index.to_string()),
        ("a".to_owned(), case.a.to_string()),
        ("b".to_owned(), case.b.to_string()),
    ];
    given.extend(at.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
    Stop::Refuted(Box::new(Witness { given, claimed, found, reproduce: None }))
}

fn expect(holds: bool, case: &WeightCase, claimed: &str, found: impl FnOnce() -> String) -> Judgement {
    if holds { Ok(()) } else { Err(refuted(case, &[], claimed.to_owned(), found())) }
}

/// 0 ≤ φ < 1, or ≤ 1, for all real x.
fn range(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    for x in around(&case.a, &case.b) {
        let value = phi(&case.index, &x, &case.a, &case.b);
        expect(ledger.equal(&value, &integer(0)), case, "φ = 0 at the ends and outside", || {
            format!("φ({x}) = {value}")
        })?;
    }
    if case.a < case.b {
        let (_, f, complement) = on_interval(case);
        expect(ledger.positive(&f), case, "φ > 0 on (a, b)", || "it is not".into())?;
        expect(ledger.positive(&complement), case, "φ < 1 on (a, b)", || "it is not".into())?;
    }
    Ok(())
}

/// Rising from 0 at a to the limit 1 at b.
fn climbs(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    let (x, f, _) = on_interval(case);
    let slope = derivative(&f, &x).is_some_and(|slope| ledger.positive(&slope));
    expect(slope, case, "φ′ > 0 on (a, b)", || "it is not".into())?;
    for (end, value, wanted) in
        [("a", f.evaluate(&integer(0)), integer(0)), ("b", f.at_infinity(), integer(1))]
    {
        let reached = value.as_ref().is_some_and(|value| ledger.equal(value, &wanted));
        expect(reached, case, &format!("f(x) → {wanted} for x → {end}"), || {
            format!("the limit is {value:?}")
        })?;
    }
    Ok(())
}

fn shape(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    climbs(case, ledger)?;
    for x in around(&case.a, &case.b) {
        let value = phi(&case.index, &x, &case.a, &case.b);
        expect(ledger.equal(&value, &integer(0)), case, "φ = 0 at a and outside of [a, b)", || {
            format!("φ({x}) = {value}")
        })?;
    }
    Ok(())
}

/// Every increasing Möbius map with f(a) = 0, f(b) = 1 has one pole c outside of [a, b] and is
/// f(x) = (b − c)(x − a)/((b − a)(x − c)); it is f_α for α = (b − c)/(b − a), with c as a variable: for every
/// such f at once. The pole b − α(b − a) tells α, so it is the only one. For c = a − s with s > 0 it is greater than 1,
/// for c = b + s negative.
fn classification(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    let c = Piece::variable(&integer(1));
    let x = RationalFunction::variable(&c);
    let (a, b) = (x.embed(&case.a), x.embed(&case.b));
    let (c, one) = (RationalFunction::constant(c), x.one());
    let alpha = b.minus(&c).over(&b.minus(&a));
    let f = b.minus(&c).times(&x.minus(&a)).over(&b.minus(&a).times(&x.minus(&c)));
    let f_alpha = alpha.as_ref().and_then(|alpha| {
        let denominator = x.plus(&alpha.minus(&one).times(&b)).minus(&alpha.times(&a));
        alpha.times(&x.minus(&a)).over(&denominator)
    });
    let same = matches!((&f, &f_alpha), (Some(f), Some(g)) if ledger.equal(f, g));
    expect(same, case, "f = f_α for α = (b − c)/(b − a), c the pole of f", || "they differ".into())?;
    let pole = alpha.map(|alpha| b.minus(&alpha.times(&b.minus(&a))));
    let told = pole.is_some_and(|pole| ledger.equal(&pole, &c));
    expect(told, case, "the pole of f_α is c, so that c tells α", || "it is not".into())?;
    let s = Piece::variable(&integer(1));
    let (length, one) = (s.embed(&(&case.b - &case.a)), s.one());
    let left = length.plus(&s).over(&length).map(|alpha| alpha.minus(&one));
    let right = s.over(&length);
    for (distance, claimed) in [(left, "α > 1 for c < a"), (right, "−α > 0 for c > b")] {
        expect(distance.is_some_and(|d| ledger.positive(&d)), case, claimed, || "it is not".into())?;
    }
    climbs(case, ledger)
}

fn denominator_has_no_zero(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    let Some(alpha) = case.index.alpha() else { return Ok(()) };
    let x = coordinate_between(&case.a, &case.b);
    let constant = (&alpha - integer(1)) * &case.b - &alpha * &case.a;
    let d = x.plus(&x.embed(&constant));
    let oriented = if alpha > integer(0) { d } else { d.negate() };
    let ends = [oriented.evaluate(&integer(0)), oriented.at_infinity()];
    let ends_differ = ends.iter().all(|end| end.as_ref().is_some_and(|end| ledger.differ(end, &integer(0))));
    expect(ends_differ && ledger.positive(&oriented), case, "x + (α − 1)b − αa ≠ 0 on [a, b]", || {
        "it vanishes somewhere".into()
    })
}

/// f_α as a function of r with u as a parameter: at r = 1, the limit |α| → ∞, it is continuous and affine.
fn classical_limit(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    let u = coordinate_between(&case.a, &case.b);
    let ratio = RationalFunction::variable(&u);
    let x = RationalFunction::constant(u.clone());
    let (f, _) = weight(&ratio, &x, &case.a, &case.b);
    let limit = f.evaluate(&u.one());
    let affine = u.minus(&u.embed(&case.a)).over(&u.embed(&(&case.b - &case.a)));
    let same = matches!((&limit, &affine), (Some(limit), Some(affine)) if ledger.equal(limit, affine));
    expect(same, case, "f_α(x) → (x − a)/(b − a)", || format!("the limit is {limit:?}"))
}

/// f_α(a + b − x) = 1 − f_β(x), with β the conjugate index; a + b − x is u ↦ 1/u.
fn reflection(other: fn(&Index) -> Index) -> impl Fn(&WeightCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (x, f, complement) = on_interval(case);
        let beta = other(&case.index);
        let (g, g_complement) = weight(&x.embed(beta.ratio()), &x, &case.a, &case.b);
        let holds = ledger.equal(&f.reciprocal_argument(), &g_complement)
            && ledger.equal(&f, &g.reciprocal_argument().negate().plus(&x.one()))
            && ledger.equal(&complement, &g.reciprocal_argument());
        expect(holds, case, "f_α(a + b − x) = 1 − f_{1−α}(x)", || {
            let middle = (&case.a + &case.b) / integer(2);
            let (left, right) =
                (phi(&case.index, &middle, &case.a, &case.b), phi(&beta, &middle, &case.a, &case.b));
            format!("at x = {middle} the left side is {left} and the right side {}", integer(1) - right)
        })
    }
}

fn increasing_map(case: &WeightCase, ledger: &mut Ledger) -> Judgement {
    for map in Affine::examples(true) {
        let (ta, tb) = (map.apply(&case.a), map.apply(&case.b));
        let inside = (case.a < case.b).then(|| {
            let (x, f, _) = on_interval(case);
            (weight(&x.embed(case.index.ratio()), &map.apply(&x), &ta, &tb).0, f)
        });
        Identity {
            left: ("φ_α(T(x), T(a), T(b))", &|x| phi(&case.index, &map.apply(x), &ta, &tb)),
            right: ("φ_α(x, a, b)".to_owned(), &|x| phi(&case.index, x, &case.a, &case.b)),
            inside,
            points: around(&case.a, &case.b),
        }
        .judge(case, &[("T", map.to_string())], ledger)?;
    }
    Ok(())
}

/// P2.1.3: the two weights add up to 1 for a < x < b, and everywhere else to the given number, which is 1 in print
/// and 0 in truth.
fn decreasing_map(outside: usize) -> impl Fn(&WeightCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        for map in Affine::examples(false) {
            let (ta, tb) = (map.apply(&case.a), map.apply(&case.b));
            let conjugate = case.index.conjugate();
            let inside = (case.a < case.b).then(|| {
                let (x, ..) = on_interval(case);
                let left = weight(&x.embed(case.index.ratio()), &map.apply(&x), &tb, &ta).0;
                (left, weight(&x.embed(conjugate.ratio()), &x, &case.a, &case.b).1)
            });
            Identity {
                left: ("φ_α(T(x), T(b), T(a))", &|x| phi(&case.index, &map.apply(x), &tb, &ta)),
                right: (format!("{outside} − φ_{{1−α}}(x, a, b)"), &|x| {
                    integer(outside) - phi(&conjugate, x, &case.a, &case.b)
                }),
                inside,
                points: around(&case.a, &case.b),
            }
            .judge(case, &[("T", map.to_string())], ledger)?;
        }
        Ok(())
    }
}

/// C2.4: the two weights add up to 1 for a + b − t2 < x < a + b − t1, and elsewhere on [a, b] to the given number, which
/// is 1 in print and 0 in truth.
fn mirrored_interval(outside: usize) -> impl Fn(&WeightCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let places: Vec<_> = (0..=4).map(|i| &case.a + (&case.b - &case.a) * rational(i, 4)).collect();
        let mirror = |x: &BigRational| &case.a + &case.b - x;
        for (i, t1) in places.iter().enumerate() {
            for t2 in &places[i + 1..] {
                let (low, high) = (mirror(t2), mirror(t1));
                let conjugate = case.index.conjugate();
                let x = coordinate_between(&low, &high);
                let mirrored = x.embed(&(&case.a + &case.b)).minus(&x);
                let left = weight(&x.embed(case.index.ratio()), &mirrored, t1, t2).0;
                let right = weight(&x.embed(conjugate.ratio()), &x, &low, &high).1;
                let middle = |x: &BigRational, y: &BigRational| (x + y) / integer(2);
                // One point of every part of [a, b] outside, and then the ends.
                let mut points =
                    vec![middle(&case.a, &low), middle(&high, &case.b), low.clone(), high.clone()];
                points.extend([case.a.clone(), case.b.clone()]);
                Identity {
                    left: ("φ_α(a + b − x, t1, t2)", &|x| phi(&case.index, &mirror(x), t1, t2)),
                    right: (format!("{outside} − φ_{{1−α}}(x, a + b − t2, a + b − t1)"), &|x| {
                        integer(outside) - phi(&conjugate, x, &low, &high)
                    }),
                    inside: Some((left, right)),
                    points,
                }
                .judge(case, &[("t1", t1.to_string()), ("t2", t2.to_string())], ledger)?;
            }
        }
        Ok(())
    }
}

/// f_α″ > 0 on (a, b) for α < 0 and f_α″ < 0 for α > 1.
fn curvature(convex: fn(&Index) -> bool) -> impl Fn(&WeightCase, &mut Ledger) -> Judgement {
    move |case, ledger| {
        let (x, f, _) = on_interval(case);
        let second = derivative(&f, &x).and_then(|slope| derivative(&slope, &x));
        let (convex, word) = if convex(&case.index) { (true, "convex") } else { (false, "concave") };
        let oriented = second.map(|second| if convex { second } else { second.negate() });
        expect(
            oriented.is_some_and(|f| ledger.positive(&f)),
            case,
            &format!("φ_α is {word} on (a, b)"),
            || "its second derivative has the other sign".into(),
        )
    }
}

/// The claims about the weight.
pub(super) fn claims() -> Vec<Claim> {
    let statement =
        |text, conclusion: fn(&WeightCase, &mut Ledger) -> Judgement| Statement::new(text, conclusion);
    const TRIED: &str = "The engine tries nine maps T, the certificate is about all of them.";
    vec![
        Claim::new(
            "phi.range",
            "Introduction",
            Form::Weight(statement("φ_α(x,a,b) lies in [0,1) for all real x, a, b.", range)),
        ),
        Claim::new(
            "phi.shape",
            "Introduction",
            Form::Weight(
                statement(
                    "For a < b, x ↦ φ_α(x,a,b) is continuous and strictly increasing on [a,b), 0 outside [a,b), and tends to 1 as x → b from the left.",
                    shape,
                )
                .given([Proper]),
            ),
        ),
        Claim::new(
            "L2.1",
            "Lemma 2.1",
            Form::Weight(
                statement(
                    "For a < b: every homographic f, not affine, strictly increasing on [a,b] with f(a) = 0 and f(b) = 1 is f_α for exactly one α in (−∞,0) ∪ (1,∞), and every such α gives one.",
                    classification,
                )
                .given([Proper, FiniteIndex]),
            ),
        )
        .note("Judged for every f at once: the pole of f is a variable."),
        Claim::new(
            "R2.2.1",
            "Remark 2.2 (1)",
            Form::Weight(
                statement("For a < b and x in [a,b]: x + (α−1)b − αa ≠ 0.", denominator_has_no_zero)
                    .given([Proper, FiniteIndex]),
            ),
        ),
        Claim::new(
            "R2.2.2a",
            "Remark 2.2 (2)",
            Form::Weight(
                statement(
                    "For a < b, f_α is continuous and strictly increasing on [a,b], with image [0,1].",
                    climbs,
                )
                .given([Proper]),
            ),
        ),
        Claim::new(
            "R2.2.2b",
            "Remark 2.2 (2)",
            Form::Weight(
                statement("For a < b: f_α(x) → (x−a)/(b−a) as |α| → ∞.", classical_limit).given([Proper]),
            ),
        ),
        Claim::new(
            "R2.2.2c",
            "Remark 2.2 (2)",
            Form::Weight(
                Statement::new(
                    "For a < b and x in [a,b]: f_α(a+b−x) = 1 − f_{1−α}(x) and f_α(x) = 1 − f_{1−α}(a+b−x).",
                    reflection(Index::conjugate),
                )
                .given([Proper]),
            ),
        ),
        Claim::new(
            "P2.1.1",
            "Proposition 2.1 (1)",
            Form::Weight(statement("0 ≤ φ_α(x,a,b) ≤ 1 for all (x,a,b) in R³.", range)),
        ),
        Claim::new(
            "P2.1.2",
            "Proposition 2.1 (2)",
            Form::Weight(statement(
                "T affine, strictly increasing: φ_α(T(x),T(a),T(b)) = φ_α(x,a,b) for all (x,a,b) in R³.",
                increasing_map,
            )),
        )
        .note(TRIED),
        Claim::new(
            "P2.1.3",
            "Proposition 2.1 (3)",
            Form::Weight(Statement::new(
                "T affine, strictly decreasing: φ_α(T(x),T(b),T(a)) = 1 − φ_{1−α}(x,a,b) for all (x,a,b) in R³.",
                decreasing_map(1),
            )),
        )
        .fails_by(Cause::OutsideInterval)
        .amended(Form::Weight(Statement::new(
            "T affine, strictly decreasing: for all (x,a,b) in R³, φ_α(T(x),T(b),T(a)) + φ_{1−α}(x,a,b) is 1 if a < x < b, and 0 otherwise.",
            decreasing_map(0),
        )))
        .note("So it is false for every x outside of (a,b), the ends included, and for every a ≥ b. The engine tries nine maps T, the certificate is about all of them."),
        Claim::new(
            "C2.4",
            "Corollary 2.4",
            Form::Weight(
                Statement::new(
                    "a ≤ t1 < t2 ≤ b: for all x in [a,b], φ_α(a+b−x,t1,t2) = 1 − φ_{1−α}(x,a+b−t2,a+b−t1).",
                    mirrored_interval(1),
                )
                .given([Proper]),
            ),
        )
        .fails_by(Cause::OutsideInterval)
        .amended(Form::Weight(
            Statement::new(
                "a ≤ t1 < t2 ≤ b: for all x in [a,b], φ_α(a+b−x,t1,t2) + φ_{1−α}(x,a+b−t2,a+b−t1) is 1 if a+b−t2 < x < a+b−t1, and 0 otherwise.",
                mirrored_interval(0),
            )
            .given([Proper]),
        ))
        .note("So it is false for every x of [a,b] outside of (a+b−t2, a+b−t1). The engine tries the t1 and t2 that divide [a,b] into quarters, the certificate is about all of them."),
        Claim::new(
            "Ill2.1",
            "Illustration 2.1",
            Form::Weight(
                Statement::new(
                    "On (a,b), φ_α(·,a,b) is convex for α < 0 and concave for α > 1 (printed for (0,1)).",
                    curvature(|index| *index.ratio() < integer(1)),
                )
                .given([Proper, FiniteIndex]),
            ),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::small_cases::Cases;
    use crate::claims::statement::judge;
    use crate::claims::verdict::Verdict;

    fn verdict(
        conclusion: impl Fn(&WeightCase, &mut Ledger) -> Judgement + Send + Sync + 'static,
    ) -> Verdict {
        let statement = Statement::new("", conclusion).given([Proper, FiniteIndex]);
        judge(&statement, &Cases::all().weights).unwrap()
    }

    #[test]
    fn false_variants_are_refuted() {
        // The conjugate replaced by the index itself; convex and concave exchanged.
        assert!(matches!(verdict(reflection(Index::clone)), Verdict::Refuted(_)));
        assert!(matches!(verdict(curvature(|index| *index.ratio() > integer(1))), Verdict::Refuted(_)));
        assert!(matches!(verdict(decreasing_map(1)), Verdict::Refuted(_)));
        assert!(matches!(verdict(mirrored_interval(1)), Verdict::Refuted(_)));
    }

    #[test]
    fn their_true_counterparts_are_proved() {
        assert!(matches!(verdict(reflection(Index::conjugate)), Verdict::Proved { .. }));
        assert!(matches!(verdict(curvature(|index| *index.ratio() < integer(1))), Verdict::Proved { .. }));
        assert!(matches!(verdict(decreasing_map(0)), Verdict::Proved { .. }));
        assert!(matches!(verdict(mirrored_interval(0)), Verdict::Proved { .. }));
    }
}
