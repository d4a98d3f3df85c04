//! Floor 1: every scalar obeys the laws of its structure, and the suites of laws can fail.

use std::str::FromStr;

use knotproof::scalar::axioms::{self, BrokenLaw};
use knotproof::scalar::{
    BigRational, ExactField, Field, Jet, Monomial, Multivariate, OrderedField, Polynomial, Quotient,
    RationalAlgebra, RationalFunction, Ring, decimal, exact_value, integer, parse_rational, rational, ulp,
};
use knotproof::spline::{Active, KnotVector, PointWeights, triangle};
use num_bigint::BigInt;
use num_traits::{Pow, Signed};
use proptest::prelude::*;

const VARIABLES: usize = Multivariate::VARIABLES;

/// Any positive bit pattern, with every other one below or next to the normal range.
fn positive_float() -> impl Strategy<Value = f64> {
    prop_oneof![0..=u64::MAX >> 1, 0..3_u64 << 52].prop_map(f64::from_bits)
}

type Poly = Polynomial<BigRational>;
type Function = RationalFunction<BigRational>;

/// Numbers that lean towards trouble: 0, ±1, small ones that collide, huge and tiny ones.
fn number() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        Just(integer(0)),
        Just(integer(1)),
        Just(rational(-1, 1)),
        (-6_i64..=6, 1_i64..=6).prop_map(|(p, q)| rational(p, q)),
        (any::<i64>(), 1..=i64::MAX).prop_map(|(p, q)| rational(p, q)),
        (-3_i64..=3, -400_i32..=400).prop_map(|(p, e)| rational(p, 1) * integer(10).pow(e)),
    ]
}

fn small() -> impl Strategy<Value = BigRational> {
    (-3_i64..=3, 1_i64..=2).prop_map(|(p, q)| rational(p, q))
}

fn linear(root: &BigRational) -> Poly {
    Polynomial::new(-root, [integer(1)])
}

/// Products of few different linear factors, so that they repeat and are shared, times 1 + u² now and then.
fn polynomial() -> impl Strategy<Value = Poly> {
    let factors = prop::collection::vec(small(), 0..4);
    (small(), factors, any::<bool>()).prop_map(|(leading, roots, irreducible)| {
        let rest = if irreducible {
            Polynomial::new(integer(1), [integer(0), integer(1)])
        } else {
            Polynomial::constant(integer(1))
        };
        roots.iter().fold(rest.scaled(&leading), |product, root| product.times(&linear(root)))
    })
}

fn nonzero_polynomial() -> impl Strategy<Value = Poly> {
    polynomial().prop_filter("not 0", |p| !p.is_zero())
}

fn function() -> impl Strategy<Value = Function> {
    (polynomial(), nonzero_polynomial()).prop_map(|(p, q)| Function::new(&p, &q).expect("q is not 0"))
}

fn jet<S: Ring>(coefficients: &[S]) -> Jet<S> {
    let order = coefficients.len() - 1;
    let epsilon = Jet::variable(coefficients[0].zero(), order);
    let terms = coefficients.iter().enumerate();
    terms.fold(epsilon.zero(), |sum, (d, c)| {
        sum.plus(&Jet::constant(c.clone(), order).times(&epsilon.power(d)))
    })
}

fn jets(order: usize) -> impl Strategy<Value = Vec<Jet<BigRational>>> {
    let one = prop::collection::vec(number(), order + 1).prop_map(|c| jet(&c));
    prop::collection::vec(one, 3)
}

/// Integers that cancel often, and those at the ends of the machine's.
fn whole() -> impl Strategy<Value = BigInt> {
    let ends =
        prop_oneof![Just(i128::from(i64::MAX)), Just(i128::from(i64::MIN)), Just(i128::MAX), Just(i128::MIN)];
    prop_oneof![8 => (-3_i128..=3).boxed(), 1 => ends.boxed()].prop_map(BigInt::from)
}

/// Few terms in the first, a middle and the last variable; by the bound, five of them can be multiplied.
fn multivariate() -> impl Strategy<Value = Multivariate> {
    let variable = prop_oneof![Just(0_usize), Just(7), Just(8), Just(Multivariate::VARIABLES - 1)];
    let power = (variable, 0_usize..=3)
        .prop_map(|(v, e)| (0..e).fold(Monomial::ONE, |m, _| m.times(&Monomial::variable(v))));
    let monomial = (power.clone(), power).prop_map(|(m, n)| m.times(&n));
    prop::collection::vec((monomial, whole()), 0..5).prop_map(Multivariate::from_terms)
}

/// Products of few different factors over few others, so that they repeat, cancel and are shared.
fn quotient() -> impl Strategy<Value = Quotient> {
    let (r, u) = (Quotient::variable(0), Quotient::variable(1));
    let one = r.one();
    let parts = vec![r.clone(), u.clone(), u.plus(&one), r.times(&u).plus(&one), r.plus(&u), r.minus(&u)];
    let square = r.times(&r).minus(&u.times(&u));
    let part = prop::sample::select([parts, vec![square]].concat());
    let list = || prop::collection::vec(part.clone(), 0..3);
    (small(), list(), list()).prop_map(move |(constant, above, below)| {
        let above = above.iter().fold(one.embed(&constant), |product, f| product.times(f));
        below.iter().fold(above, |q, f| q.over(f).expect("no part is 0"))
    })
}

/// x_v ↦ the v-th of some different polynomials in one variable.
fn along_a_curve(v: usize) -> Poly {
    linear(&integer(v % 5)).times(&Polynomial::constant(rational(1, 2)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn polynomials_in_many_variables_are_a_ring(elements in prop::collection::vec(multivariate(), 3)) {
        prop_assert_eq!(axioms::ring(&elements), Ok(()));
    }

    #[test]
    fn quotients_are_a_field(elements in prop::collection::vec(quotient(), 2)) {
        prop_assert_eq!(axioms::field(&elements), Ok(()));
    }

    #[test]
    fn jets_over_quotients_are_an_algebra(c in prop::collection::vec(quotient(), 4)) {
        let elements = [jet(&c[..2]), jet(&c[2..])];
        prop_assert_eq!(axioms::rational_algebra(&elements), Ok(()));
    }

    /// Sorted lists of packed terms against lists of coefficients, and against numbers.
    #[test]
    fn operations_commute_with_evaluation(a in multivariate(), b in multivariate(), at in prop::collection::vec(small(), VARIABLES)) {
        let number = |p: &Multivariate| p.evaluate(&at[0], |v| at[v].clone());
        prop_assert_eq!(number(&a.plus(&b)), number(&a) + number(&b));
        prop_assert_eq!(number(&a.minus(&b)), number(&a) - number(&b));
        prop_assert_eq!(number(&a.times(&b)), number(&a) * number(&b));
        let function = |p: &Multivariate| {
            let zero = Function::constant(integer(0));
            p.evaluate(&zero, |v| Function::from_polynomial(along_a_curve(v))).numerator().clone()
        };
        prop_assert_eq!(function(&a.plus(&b)), function(&a).plus(&function(&b)));
        prop_assert_eq!(function(&a.times(&b)), function(&a).times(&function(&b)));
        // Substituting b for one variable is evaluating at a point that b determines.
        let mut moved = at.clone();
        moved[7] = number(&b);
        prop_assert_eq!(number(&a.substitute(7, &b)), a.evaluate(&at[0], |v| moved[v].clone()));
    }

    /// In one variable, the coefficients are those of the reference.
    #[test]
    fn one_variable_is_a_special_case(p in prop::collection::vec(whole(), 1..6), q in prop::collection::vec(whole(), 1..6)) {
        let rational = |c: &BigInt| BigRational::from_integer(c.clone());
        let poly = |c: &[BigInt]| Polynomial::new(integer(0), c.iter().map(rational));
        for v in [0, 13, VARIABLES - 1] {
            let x = Multivariate::variable(v);
            let many = |c: &[BigInt]| c.iter().rev().fold(x.zero(), |sum, c| sum.plus(&Multivariate::constant(c.clone())).times(&x));
            let back = |p: &Multivariate| {
                let constant = |c: &Multivariate| rational(&c.as_constant().expect("one variable occurs"));
                let mut c = p.coefficients_in(v).iter().map(constant).collect::<Vec<_>>().into_iter();
                Polynomial::new(c.next().expect("at least one"), c)
            };
            prop_assert_eq!(back(&many(&p)), poly(&p));
            prop_assert_eq!(back(&many(&p).plus(&many(&q))), poly(&p).plus(&poly(&q)));
            prop_assert_eq!(back(&many(&p).minus(&many(&q))), poly(&p).minus(&poly(&q)));
            prop_assert_eq!(back(&many(&p).times(&many(&q))), poly(&p).times(&poly(&q)));
        }
    }

    #[test]
    fn parts_of_a_polynomial_make_it_up(p in multivariate(), q in multivariate()) {
        for v in [0, 7, VARIABLES - 1] {
            let x = Multivariate::variable(v);
            let coefficients = p.coefficients_in(v);
            let sum = coefficients.iter().rev().fold(p.zero(), |sum, c| sum.times(&x).plus(c));
            prop_assert_eq!(&sum, &p);
            prop_assert!(coefficients.len() == p.degree_in(v) + 1 && coefficients.iter().all(|c| c.degree_in(v) == 0));
        }
        prop_assert_eq!(p.split().is_none(), p.is_zero());
        if let Some((c, m, rest)) = p.split() {
            prop_assert_eq!(&Multivariate::from(m).times(&rest).scaled(&c), &p);
            prop_assert_eq!(rest.split().map(|(c, m, _)| (c, m)), Some((1.into(), Monomial::ONE)));
            prop_assert_eq!(q.times(&p).divided_by(&p), Some(q));
        }
    }

    /// Along a curve, quotients are rational functions of one variable, which are kept in lowest terms.
    #[test]
    fn quotients_agree_with_rational_functions(a in quotient(), b in quotient(), at in prop::collection::vec(small(), 2)) {
        let curve = [Polynomial::new(integer(1), [integer(2), integer(3)]), linear(&integer(4))];
        let function = |q: &Quotient| {
            q.evaluate(&Function::constant(integer(0)), |v| Function::from_polynomial(curve[v].clone()))
                .expect("no factor is 0 along the curve")
        };
        let (p, q) = (function(&a), function(&b));
        prop_assert_eq!(function(&a.plus(&b)), p.plus(&q));
        prop_assert_eq!(function(&a.minus(&b)), p.minus(&q));
        prop_assert_eq!(function(&a.times(&b)), p.times(&q));
        prop_assert_eq!(a.over(&b).map(|x| function(&x)), p.over(&q));
        prop_assert_eq!(a.reciprocal().map(|x| function(&x)), p.reciprocal());
        prop_assert_eq!(a.reduced(), a.clone());
        let number = |q: &Quotient| q.evaluate(&at[0], |v| at[v].clone());
        if let (Some(x), Some(y)) = (number(&a), number(&b)) {
            prop_assert_eq!(number(&a.plus(&b)), Some(&x + &y));
            prop_assert_eq!(number(&a.times(&b)), Some(x * y));
        }
        // With the first variable replaced by the second one plus 1.
        let shifted = Multivariate::variable(1).plus(&Multivariate::constant(1));
        if let Some(q) = a.substitute(0, &shifted) {
            let moved = a.evaluate(&at[1], |v| if v == 0 { &at[1] + integer(1) } else { at[1].clone() });
            if moved.is_some() {
                prop_assert_eq!(number(&q), moved);
            }
        }
    }

    #[test]
    fn rationals_are_an_ordered_field(elements in prop::collection::vec(number(), 4)) {
        prop_assert_eq!(axioms::ordered_field(&elements), Ok(()));
    }

    #[test]
    fn jets_are_an_algebra(order_0 in jets(0), order_1 in jets(1), order_3 in jets(3)) {
        for elements in [order_0, order_1, order_3] {
            prop_assert_eq!(axioms::rational_algebra(&elements), Ok(()));
        }
    }

    #[test]
    fn polynomials_are_a_ring(elements in prop::collection::vec(polynomial(), 3)) {
        prop_assert_eq!(axioms::ring(&elements), Ok(()));
    }

    #[test]
    fn rational_functions_are_a_field(elements in prop::collection::vec(function(), 2)) {
        prop_assert_eq!(axioms::field(&elements), Ok(()));
    }

    #[test]
    fn jets_over_rational_functions_are_an_algebra(c in prop::collection::vec(function(), 4)) {
        let elements = [jet(&c[..2]), jet(&c[2..])];
        prop_assert_eq!(axioms::rational_algebra(&elements), Ok(()));
    }

    #[test]
    fn what_is_written_is_read_back(value in number()) {
        prop_assert_eq!(parse_rational(&value.to_string()), Ok(value));
    }

    #[test]
    fn decimals_are_read_digit_by_digit(whole in 0_u32.., fraction in "[0-9]{0,25}", e in -30_i32..30) {
        let places = i32::try_from(fraction.len()).expect("25 at most");
        let digits = BigRational::from_str(&format!("{whole}{fraction}")).expect("digits");
        let expected = -digits * integer(10).pow(e - places);
        prop_assert_eq!(parse_rational(&format!("-{whole}.{fraction}e{e}")), Ok(expected));
    }

    /// The sign, the exponent and the 52 bits of a float, as IEEE 754 lays them out, against its exact value.
    #[test]
    fn hexadecimal_floats_are_read_exactly(float in proptest::num::f64::ANY) {
        let bits = float.to_bits();
        let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        let sign = if bits >> 63 == 1 { "-" } else { "" };
        let (leading, exponent) = match i64::try_from(exponent).expect("11 bits") {
            0 => (0, -1022),
            e => (1, e - 1023),
        };
        let text = format!("{sign}0x{leading}.{fraction:013x}p{exponent}");
        match exact_value(float) {
            Some(exact) => prop_assert_eq!(parse_rational(&text), Ok(exact)),
            None => prop_assert_eq!(exponent, 1024),
        }
    }

    /// Rust writes a float so that reading it to nearest gives the float back.
    #[test]
    fn reading_to_nearest_is_rust_s_own(float in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL) {
        let exact = parse_rational(&format!("{float:e}")).expect("a finite float");
        prop_assert_eq!(0.0_f64.embed(&exact).to_bits(), float.to_bits());
    }

    /// Numbers near two floats, and exactly between them, where the even one must be taken.
    #[test]
    fn embedding_takes_the_nearest_float(low in positive_float(), eighths in 0_i64..=8) {
        let (Some(a), Some(b)) = (exact_value(low), exact_value(low.next_up())) else { return Ok(()) };
        let value = &a + (&b - &a) * rational(eighths, 8);
        let up = eighths > 4 || (eighths == 4 && low.to_bits() % 2 == 1);
        let expected = if up { low.next_up() } else { low };
        prop_assert_eq!(0.0_f64.embed(&value).to_bits(), expected.to_bits());
    }

    #[test]
    fn the_unit_in_the_last_place_is_the_gap_above(low in positive_float(), sevenths in 0_i64..7) {
        let (Some(a), Some(b)) = (exact_value(low), exact_value(low.next_up())) else { return Ok(()) };
        prop_assert_eq!(ulp(&(&a + (&b - &a) * rational(sevenths, 7))), &b - &a);
    }

    /// Within half a unit of the last digit that is shown.
    #[test]
    fn a_decimal_is_near(value in number(), significant in 1_usize..12) {
        let shown = parse_rational(&decimal(&value, significant)).expect("a number");
        let half = integer(10).pow(-i32::try_from(significant).expect("small")) * rational(5, 1);
        prop_assert!((&shown - &value).abs() <= value.abs() * half);
    }

    #[test]
    fn division_leaves_a_smaller_remainder(a in polynomial(), b in nonzero_polynomial()) {
        let (quotient, remainder) = a.divide(&b).expect("b is not 0");
        prop_assert_eq!(quotient.times(&b).plus(&remainder), a);
        prop_assert!(remainder.is_zero() || remainder.degree() < b.degree());
    }

    /// The greatest common divisor divides both, and what is left has none; a planted factor is found.
    #[test]
    fn the_common_divisor_is_the_greatest(
        a in nonzero_polynomial(), b in nonzero_polynomial(), common in nonzero_polynomial()
    ) {
        let (a, b) = (a.times(&common), b.times(&common));
        let gcd = a.gcd(&b);
        let exactly = |p: &Poly, q: &Poly| p.divide(q).filter(|(_, r)| r.is_zero()).map(|(quotient, _)| quotient);
        prop_assert_eq!(gcd.leading(), &integer(1));
        prop_assert!(exactly(&gcd, &common).is_some());
        let (p, q) = (exactly(&a, &gcd).expect("divides a"), exactly(&b, &gcd).expect("divides b"));
        prop_assert_eq!(p.gcd(&q), p.one());
        prop_assert_eq!(a.gcd(&b), b.gcd(&a));
    }

    /// From planted roots: each of them once.
    #[test]
    fn square_free_keeps_each_root_once(
        mut roots in prop::collection::vec(small(), 0..6), factor in small()
    ) {
        let product = |roots: &[BigRational]| {
            roots.iter().fold(Polynomial::constant(integer(1)), |p, root| p.times(&linear(root)))
        };
        prop_assume!(!Ring::is_zero(&factor));
        let repeated = product(&roots).scaled(&factor);
        roots.sort();
        roots.dedup();
        prop_assert_eq!(repeated.square_free().monic(), product(&roots));
    }

    #[test]
    fn substitutions_agree_with_evaluation(p in polynomial(), u in number()) {
        prop_assert_eq!(p.shifted_by_one().evaluate(&u), p.evaluate(&(&u + integer(1))));
        prop_assert_eq!(p.scaled_argument(&u).evaluate(&integer(3)), p.evaluate(&(&u * integer(3))));
        if let Some(inverse) = u.reciprocal() {
            let n = p.degree() + 2;
            prop_assert_eq!(p.reversed(n).evaluate(&u), u.power(n).times(&p.evaluate(&inverse)));
        }
    }

    /// The derivatives of P/Q by the quotient rule, and by running P/Q over jets.
    #[test]
    fn jets_know_the_derivatives(f in function(), x in number()) {
        let at_jet = |p: &Poly, jet: &Jet<BigRational>| {
            let lift = |c: &BigRational| Jet::constant(c.clone(), jet.order());
            p.coefficients().iter().rev().fold(jet.zero(), |value, c| value.times(jet).plus(&lift(c)))
        };
        let jet = Jet::variable(x.clone(), 3);
        let value = at_jet(f.numerator(), &jet).over(&at_jet(f.denominator(), &jet));
        let by_rule: Option<Vec<_>> =
            std::iter::successors(Some(f), |f| Some(f.derivative())).take(4).map(|f| f.evaluate(&x)).collect();
        prop_assert_eq!(value.map(|jet| jet.derivatives()), by_rule);
    }

    #[test]
    fn substitutions_in_a_rational_function_agree_with_evaluation(f in function(), u in small()) {
        prop_assume!(!Ring::is_zero(&u));
        prop_assert_eq!(f.reciprocal_argument().evaluate(&u), f.evaluate(&u.recip()));
        prop_assert_eq!(f.scaled_argument(&u).evaluate(&integer(2)), f.evaluate(&(&u * integer(2))));
        prop_assert_eq!(f.at_infinity(), f.reciprocal_argument().evaluate(&integer(0)));
    }
}

/// The rational functions of u whose coefficients are rational functions of r: what a piece is for every α.
#[test]
fn rational_functions_of_two_variables_are_a_field() {
    let r = Function::variable(&integer(1));
    let u = RationalFunction::variable(&r);
    let constant = RationalFunction::constant(r.clone());
    let mixed = u.plus(&constant).over(&u.times(&constant).plus(&u.one())).expect("1 + ru is not 0");
    assert_eq!(axioms::field(&[u.zero(), u.one(), u, constant, mixed]), Ok(()));
}

/// Degrees at the bound, both signs of the leading coefficient, long coefficients, neighbouring variables.
#[test]
fn the_laws_hold_on_nasty_polynomials() {
    let x = Multivariate::variable;
    let huge = Multivariate::constant(BigInt::from(i128::MAX).pow(3_u32));
    let difference = x(0).minus(&x(VARIABLES - 1));
    let elements = [
        x(0).zero(),
        x(0).one().negate(),
        x(7).power(25).minus(&x(8).power(25)),
        difference.power(4).times(&huge).plus(&x(8)),
        x(6).plus(&x(7)).plus(&x(8)).plus(&x(9)).negate(),
    ];
    assert_eq!(axioms::ring(&elements), Ok(()));
}

/// x¹²⁷ is a polynomial, x¹²⁸ is refused, whatever its neighbours are: an exponent never runs into the next one.
#[test]
fn an_exponent_above_the_bound_is_refused() {
    for v in 0..Multivariate::VARIABLES {
        let x = Multivariate::variable(v);
        let others = x.one().plus(&Multivariate::variable((v + 1) % VARIABLES));
        assert_eq!(x.power(127).times(&others).degree_in(v), 127);
        let refused =
            std::panic::catch_unwind(|| x.plus(&others).power(64).times(&x.plus(&others).power(64)));
        let message = *refused.expect_err("degree 128").downcast::<String>().expect("a message");
        assert!(message.contains("127"), "{message}");
    }
}

/// What the field of fractions is for: one run of the triangle is every α at once.
#[test]
fn the_triangle_over_quotients_holds_for_every_ratio() {
    let knots = KnotVector::new((0..8_i64).map(|t| rational(t, 1)).collect()).expect("rising");
    let [r, u] = [0, 1].map(Quotient::variable);
    for span in knots.spans() {
        let (start, end) = knots.ends(span).expect("a span of these knots");
        let symbolic: Active<Quotient> = {
            let x = r.embed(start).plus(&r.embed(end).times(&u)).over(&u.plus(&u.one())).expect("not 0");
            triangle(&PointWeights::new(&knots, r.clone(), x), span, 3, knots.m())
        };
        let sum = symbolic.values().iter().fold(r.zero(), |sum, g| sum.plus(g));
        assert_eq!(sum == r.one(), symbolic.values().len() == 4);
        for ratio in
            [rational(1, 1), rational(2, 1), rational(1, 3), rational(1_000_003, 7), rational(1, 1_000_000)]
        {
            let u = Function::variable(&ratio);
            let x = u.embed(start).plus(&u.embed(end).times(&u)).over(&u.plus(&u.one())).expect("not 0");
            let weights = PointWeights::new(&knots, u.embed(&ratio), x);
            let at_ratio = symbolic.map(|g| {
                g.evaluate(&u, |v| if v == 0 { u.embed(&ratio) } else { u.clone() }).expect("no pole")
            });
            assert_eq!(at_ratio, triangle(&weights, span, 3, knots.m()), "on span {span:?} at r = {ratio}");
        }
    }
}

#[test]
fn floats_obey_the_laws_where_nothing_rounds() {
    assert_eq!(axioms::ring(&[0.0, 1.0, -1.0, 3.0, 0.75, -5.0, 1024.0]), Ok(()));
    // Reciprocals are exact for powers of 2 alone.
    assert_eq!(axioms::ordered_field(&[0.0, -0.0, 1.0, -1.0, 0.5, -4.0, 1024.0, 0.001_953_125]), Ok(()));
}

#[test]
fn floats_break_the_laws_where_something_rounds() {
    let broken = axioms::ring(&[0.1, 0.2, 0.3]).expect_err("0.1 + 0.2 rounds");
    assert!(broken.to_string().contains("fails: "), "{broken}");
    assert!(axioms::field(&[3.0, 49.0]).is_err(), "49·(1/49) rounds");
    assert!(axioms::ring(&[f64::NAN]).is_err());
    assert!(axioms::ring(&[1e300, -1e300, 1e-300]).is_err());
}

/// What the compiler knows about each scalar.
#[test]
fn the_exact_fields_are_these() {
    fn exact_field<S: ExactField>() {}
    fn field<S: Field>() {}
    fn algebra<S: RationalAlgebra>() {}
    exact_field::<BigRational>();
    exact_field::<Function>();
    exact_field::<RationalFunction<Function>>();
    exact_field::<Quotient>();
    field::<f64>();
    algebra::<Jet<f64>>();
    algebra::<Jet<Function>>();
    algebra::<Jet<Quotient>>();
}

/// A field with one fault.
#[derive(Debug, Clone, PartialEq, PartialOrd)]
struct Faulty<const FAULT: char>(BigRational);

impl<const FAULT: char> Faulty<FAULT> {
    fn or(right: BigRational, fault: char, wrong: impl FnOnce() -> BigRational) -> Self {
        Self(if fault == FAULT { wrong() } else { right })
    }
}

impl<const FAULT: char> Ring for Faulty<FAULT> {
    fn zero(&self) -> Self {
        Self::or(integer(0), '0', || integer(1))
    }
    fn one(&self) -> Self {
        Self::or(integer(1), '1', || integer(2))
    }
    fn plus(&self, rhs: &Self) -> Self {
        // Saturating, as a careless fixed-width integer would.
        Self::or(&self.0 + &rhs.0, '+', || (&self.0 + &rhs.0).min(integer(3)))
    }
    fn minus(&self, rhs: &Self) -> Self {
        Self::or(&self.0 - &rhs.0, '-', || &rhs.0 - &self.0)
    }
    fn times(&self, rhs: &Self) -> Self {
        Self::or(&self.0 * &rhs.0, '*', || if self == rhs { integer(0) } else { &self.0 * &rhs.0 })
    }
    fn negate(&self) -> Self {
        Self::or(-&self.0, 'n', || self.0.clone())
    }
    fn is_zero(&self) -> bool {
        if FAULT == 'z' { self.0.is_negative() } else { self.0 == integer(0) }
    }
    fn power(&self, exponent: usize) -> Self {
        let exponent = i32::try_from(exponent).expect("a small exponent");
        let power = |e: i32| if self.0 == integer(0) && e > 0 { integer(0) } else { self.0.clone().pow(e) };
        Self::or(power(exponent), 'p', || power(exponent + 1))
    }
}

impl<const FAULT: char> RationalAlgebra for Faulty<FAULT> {
    fn embed(&self, value: &BigRational) -> Self {
        Self::or(value.clone(), 'e', || value.floor())
    }
    fn reciprocal(&self) -> Option<Self> {
        let missing = FAULT == 'u' && self.0 == integer(2);
        let inverse = self.0.reciprocal().filter(|_| !missing);
        if FAULT == 'd' && self.0 == integer(0) {
            return Some(self.clone());
        }
        inverse.map(|inverse| Self::or(inverse, '/', || self.0.clone()))
    }
}

impl<const FAULT: char> Field for Faulty<FAULT> {}
impl<const FAULT: char> OrderedField for Faulty<FAULT> {}

/// The same, ordered by the size of the denominator first.
#[derive(Debug, Clone, PartialEq)]
struct WronglyOrdered(BigRational);

impl PartialOrd for WronglyOrdered {
    fn partial_cmp(&self, rhs: &Self) -> Option<std::cmp::Ordering> {
        let key = |x: &Self| (x.0.denom().clone(), x.0.clone());
        Some(key(self).cmp(&key(rhs)))
    }
}

impl Ring for WronglyOrdered {
    fn zero(&self) -> Self {
        Self(integer(0))
    }
    fn one(&self) -> Self {
        Self(integer(1))
    }
    fn plus(&self, rhs: &Self) -> Self {
        Self(&self.0 + &rhs.0)
    }
    fn minus(&self, rhs: &Self) -> Self {
        Self(&self.0 - &rhs.0)
    }
    fn times(&self, rhs: &Self) -> Self {
        Self(&self.0 * &rhs.0)
    }
    fn negate(&self) -> Self {
        Self(-&self.0)
    }
}

impl RationalAlgebra for WronglyOrdered {
    fn embed(&self, value: &BigRational) -> Self {
        Self(value.clone())
    }
    fn reciprocal(&self) -> Option<Self> {
        self.0.reciprocal().map(Self)
    }
}

impl Field for WronglyOrdered {}
impl OrderedField for WronglyOrdered {}

fn elements() -> Vec<BigRational> {
    vec![integer(0), integer(1), integer(2), rational(-3, 2), rational(1, 3)]
}

fn suites<const FAULT: char>() -> [Result<(), BrokenLaw>; 4] {
    let elements: Vec<_> = elements().into_iter().map(Faulty::<FAULT>).collect();
    [
        axioms::ring(&elements),
        axioms::rational_algebra(&elements),
        axioms::field(&elements),
        axioms::ordered_field(&elements),
    ]
}

#[test]
fn every_single_fault_is_found() {
    assert!(suites::<' '>().iter().all(Result::is_ok), "without a fault it is a field");
    let in_the_ring = [
        suites::<'0'>(),
        suites::<'1'>(),
        suites::<'+'>(),
        suites::<'-'>(),
        suites::<'*'>(),
        suites::<'n'>(),
        suites::<'z'>(),
        suites::<'p'>(),
    ];
    for found in in_the_ring {
        assert!(found[0].is_err(), "{found:?}");
    }
    for found in [suites::<'e'>(), suites::<'/'>(), suites::<'d'>()] {
        assert!(found[0].is_ok() && found[1].is_err(), "{found:?}");
    }
    let unit = suites::<'u'>();
    assert!(unit[1].is_ok() && unit[2].is_err(), "{unit:?}");
    let ordered: Vec<_> = elements().into_iter().map(WronglyOrdered).collect();
    assert_eq!(axioms::field(&ordered), Ok(()));
    assert!(axioms::ordered_field(&ordered).is_err());
}

#[test]
fn a_fault_is_reported_with_both_sides() {
    let broken = suites::<'1'>()[0].clone().expect_err("1 is 2");
    assert!(broken.law.starts_with("a⁰ = 1 on [") && broken.left != broken.right, "{broken}");
}

#[test]
fn division_by_zero_is_no_value() {
    let zero = Polynomial::constant(integer(0));
    assert_eq!(linear(&integer(1)).divide(&zero), None);
    assert_eq!(zero.gcd(&zero), zero);
    assert_eq!(zero.square_free(), zero);
    assert_eq!(Function::new(&zero, &zero), None);
    assert_eq!(integer(1).over(&integer(0)), None);
    // A jet with c₀ = 0 is not 0, and still no unit.
    let epsilon = Jet::variable(integer(0), 2);
    assert_eq!((epsilon.reciprocal(), epsilon.valuation()), (None, Some(1)));
}
