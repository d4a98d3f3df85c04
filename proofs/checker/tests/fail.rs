//! Certificates that do not hold are rejected, and for the reason that is theirs.

use knotproof_checker::{WORK, check, check_within};

/// A statement for k = 1 and 2 with the sections given.
fn statement(sections: &str) -> String {
    format!(
        r#"(statement 2 (claim "test") (form printed) (verdict proved) (scope knots) (degrees 1 2)
    (family "mobius" (parameter r () (> 0)) (rise (* (parameter r) (- (var x) (var a)))) (fall (- (var b) (var x))))
            (sentence (for (degree 1) (knots)) (if) (then (chain (int 0) (= (int 0))))) (because "It says so.") {sections})"#
    )
}

/// One section that both degrees read, with one goal and its rule.
fn reason(declarations: &str, goal: &str, rule: &str) -> String {
    let sections = format!("(section {declarations} (goals {goal}))");
    let proof = format!("(proof 1 (section 1 (goal 1 {rule})) (section 2 (goal 1 {rule})))");
    match check(&statement(&sections), &proof) {
        Ok(checked) => format!("accepted: {checked}"),
        Err(rejected) => rejected.to_string(),
    }
}

/// Five knots around the span 0: t_{-2} to t_3.
const W: &str = "(window W -2 any any some any any)";
/// The same with an r that is no constant.
const LET_R: &str = "(window W -2 any any some any any) (let r (/ 1 u))";

#[test]
fn the_frame_of_this_test_accepts_what_holds() {
    let good = [
        ("(real a)", "(= (+ a a) (* 2 a))", "(by)"),
        (W, "(> (G 0 k (in W 0)) 0)", "(by)"),
        (W, "(= (G 1 k (in W 0)) 0)", "(by)"),
        // A function that vanishes at the place does not need the knots beyond.
        ("(window W 0 some some)", "(= (G 0 1 (to W 1)) 0)", "(by)"),
        (
            "(window W 0 some some)",
            "(= (+ (G 0 2 (in W 0)) (G 0 2 (in W 1))) (G 0 2 (in W 0)))",
            "(by (functions 2))",
        ),
    ];
    for (declarations, goal, rule) in good.iter().take(4) {
        assert!(
            reason(declarations, goal, rule).starts_with("accepted"),
            "{goal}: {}",
            reason(declarations, goal, rule)
        );
    }
    let (declarations, goal, rule) = good[4];
    assert!(reason(declarations, goal, rule).contains("the two sides differ"));
}

#[test]
fn goals_that_are_not_shown() {
    let table = [
        // False, or true but not shown by this rule.
        ("(real a)", "(= (^ a 2) a)", "(by)", "the two sides differ"),
        (W, "(= (G 0 k (in W 0)) 1)", "(by)", "the two sides differ"),
        (W, "(= (+ (G -1 1 (in W 0)) (G 0 1 (in W 0))) 2)", "(by (weights 1))", "the two sides differ"),
        (W, "(= (w 0 1 (in W 0)) (v 0 1 (in W 0)))", "(by (weights 1))", "the two sides differ"),
        (W, "(= (DG 0 1 (in W 0)) 0)", "(by)", "the two sides differ"),
        (W, "(= (Dw 0 1 (in W 0)) (at ((u (* 2 u))) (Dw 0 1 (in W 0))))", "(by)", "the two sides differ"),
        (W, "(> 0 (G 0 1 (in W 0)))", "(by)", "a coefficient below 0"),
        (W, "(> (G 1 1 (in W 0)) 0)", "(by)", "no monomial in positive parameters"),
        (W, "(> (G -1 2 (from W 0)) 0)", "(by (functions 2))", "or a real parameter"),
        ("(nonnegative a)", "(> a 0)", "(by)", "no monomial in positive parameters"),
        (W, "(> (w -1 2 (from W 0)) 0)", "(by (weights 1))", "no monomial in positive parameters"),
        ("(real a)", "(>= a 0)", "(by)", "or a real parameter"),
        ("(real a)", "(> (+ a 1) 0)", "(by)", "or a real parameter"),
        ("(positive a)", "(< a 0)", "(by)", "a coefficient below 0"),
        ("(positive a b)", "(>= a b)", "(by)", "a coefficient below 0"),
        (W, "(>= (Dw 0 2 (in W 0)) 0)", "(by (weights 1))", "or a real parameter"),
        // A weight's unknown is bound to its two ends: with the same knots but another u it is another one.
        (
            W,
            "(= (w 0 2 (in W 0)) (at ((u (* 2 u))) (w 0 2 (in W 0))))",
            "(by (weights 1))",
            "the two sides differ",
        ),
        (
            W,
            "(= (G 0 2 (in W 0)) (at ((r 1)) (G 0 2 (in W 0))))",
            "(by (functions 2))",
            "the two sides differ",
        ),
        (W, "(>= (w 0 1 (in W 0)) (v 0 1 (in W 0)))", "(by (weights 1))", "a coefficient below 0"),
        // Nor is a function the same at another u or on another span, whether it is unfolded or not.
        (W, "(= (G 0 2 (in W 0)) (at ((u 1)) (G 0 2 (in W 0))))", "(by)", "the two sides differ"),
        (
            W,
            "(= (G 0 2 (in W 0)) (at ((u 1)) (G 0 2 (in W 0))))",
            "(by (functions 2))",
            "the two sides differ",
        ),
        (
            "(window W 0 some some some)",
            "(= (G 0 2 (in W 0)) (G 0 2 (in W 1)))",
            "(by (functions 2))",
            "the two sides differ",
        ),
        (
            "(window W 0 some some some)",
            "(= (G 0 2 (in W 0)) (G 0 2 (in W 1)))",
            "(by)",
            "the two sides differ",
        ),
        ("(window W -1 some some some)", "(order -1 2 (in W 0) 1)", "(orders)", "the order is 0"),
        // An abbreviation before the new r keeps the old one.
        ("(let a r) (let r 2)", "(= a r)", "(by)", "the two sides differ"),
        ("(let a r)", "(= (at ((r 2)) a) 2)", "(by)", "the two sides differ"),
        ("(window W 0 r r)", "(= (at ((r 2)) (t W 1)) 2)", "(by)", "the two sides differ"),
        (
            "(window W 0 some) (window V 0 some)",
            "(= (G 0 2 (in W 0)) (G 0 2 (in V 0)))",
            "(by (functions 2))",
            "the two sides differ",
        ),
        // With p = 2u·h and q = 2·h in both, the interval the same, and yet another x and another derivative.
        (
            "(knots W 0 0 1)",
            "(= (at ((u (/ u 2)) (r 2)) (Dw 0 1 (in W 0))) (at ((u (/ (* 2 u) 2)) (r 1)) (Dw 0 1 (in W 0))))",
            "(by (weights 1))",
            "the two sides differ",
        ),
        // `at` replaces r in a derivative that was taken with r constant: it is not that of 1/2.
        (W, "(= (at ((r (/ 1 u))) (DG 0 1 (in W 0))) 0)", "(by)", "the two sides differ"),
        // With r moving against u, weights would stand still, and slopes and orders with them.
        (LET_R, "(= (G 0 1 (in W 0)) 1/2)", "(by)", "section 1: r moves with u"),
        (LET_R, "(> (DG 0 1 (in W 0)) 0)", "(by)", "section 1: r moves with u"),
        (LET_R, "(order 0 1 (in W 0) 0)", "(orders)", "section 1: r moves with u"),
        (LET_R, "(outside (in W 0) u (1))", "(functional (1 1) (-1 2))", "section 1: r moves with u"),
        (
            W,
            "(= (+ (each i 1 600 (at ((u (integer i))) (G 0 2 (in W 0))))) 0)",
            "(by (functions 2))",
            "the number of unknowns is beyond the limits",
        ),
        // The wrong rule.
        ("(real a)", "(= a a)", "(orders)", "the rule is none for this formula"),
        ("(positive a)", "(= a a)", "(split a 1 (by) (by))", "the rule is none for this formula"),
        ("(positive a)", "(> a 0)", "(by (using (1 1)))", "the rule is none for this formula"),
        ("(positive a)", "(> a 0)", "(split a 1 (by (weights 1)) (by))", "the rule is none for this formula"),
        ("(positive a)", "(> a 0)", "(split a 1 (by) (evaluate))", "the rule is none for this formula"),
        (W, "(defined (G 0 1 (in W 0)))", "(by (functions 1))", "the rule is none for this formula"),
        (W, "(order 0 1 (in W 0) 1)", "(by)", "the rule is none for this formula"),
        ("(positive a)", "(> a 0)", "(functional (1 1))", "the rule is none for this formula"),
        // Lemmas that are not there.
        ("(real a)", "(= a 0)", "(by (using (1 1)))", "no equation 1 so far among the lemmas"),
        ("(real a)", "(= a 0)", "(by (using (0 1)))", "no equation 0 so far among the lemmas"),
        ("(real a)", "(= a 0)", "(by (using (-1 1)))", "no equation -1 so far among the lemmas"),
        ("(real a)", "(= a 0)", "(by (using (-9223372036854775808 1)))", "no equation -9223372036854775808"),
        ("(real a)", "(= a 0)", "(by (using (9223372036854775807 1)))", "no equation 9223372036854775807"),
        ("(real a)", "(= a 0)", "(by (using (9223372036854775808 1)))", "expected a whole number that fits"),
        // Splits.
        ("(positive a)", "(> (- a 1) 0)", "(split a 1 (by) (by))", "a coefficient below 0"),
        ("(positive a)", "(> (- a 1) 0)", "(split a 1/2 (by) (by))", "a coefficient below 0"),
        ("(positive a)", "(> (- 1 a) 0)", "(split a 1 (by) (by))", "a coefficient below 0"),
        // a = 1 belongs to the second half: there nothing but a − 1 ≥ 0 is known.
        (
            "(positive a)",
            "(> (^ (- a 1) 2) 0)",
            "(split a 1 (by) (by))",
            "no monomial in positive parameters",
        ),
        ("(real a)", "(> (+ 1 (^ a 2)) 0)", "(split a 1 (by) (by))", "expected a parameter with a sign"),
        ("(positive a)", "(> a 0)", "(split b 1 (by) (by))", "unknown name b"),
        // Divisors.
        ("(real a)", "(= (/ a a) 1)", "(by)", "a divisor without a sign"),
        ("(nonnegative a)", "(= (/ a a) 1)", "(by)", "a divisor without a sign"),
        ("(positive a)", "(= (/ a 0) (/ a 0))", "(by)", "a divisor without a sign"),
        ("(positive a b)", "(defined (/ 1 (- a b)))", "(by)", "a divisor without a sign"),
        ("(real a)", "(defined (/ 1 (+ 1 a)))", "(by)", "a divisor without a sign"),
        // Orders.
        (W, "(order 0 1 (in W 0) 0)", "(orders)", "the order is 1"),
        (W, "(order 1 1 (in W 0) 0)", "(orders)", "the function is 0"),
        (W, "(order 0 1 (from W 0) 1)", "(orders)", "expected in"),
        (W, "(order -2 2 (in W 0) 1)", "(orders)", "the order is 0"),
        (W, "(order -1 2 (in W 0) 0)", "(orders)", "a lowest coefficient in u without a sign"),
        (W, "(order 0 -1 (in W 0) 0)", "(orders)", "a degree is beyond the limits"),
        // Functionals and poles.
        (W, "(outside (in W 0) u (1))", "(functional (1 1))", "the functional is not 0 on the list"),
        (W, "(outside (in W 0) u (1))", "(functional (1 1) (-1 1))", "0 for the first function"),
        (
            W,
            "(outside (in W 0) (* 2 u) (1 u))",
            "(functional (1 0) (-2 1) (1 2))",
            "0 for the first function",
        ),
        (W, "(outside (in W 0) (/ 1 u) (1))", "(functional (1 0) (-1 1))", "a divisor without a sign"),
        (W, "(outside (in W 0) (* r u) (1))", "(functional (1 0) (-1 1))", "a parameter besides u"),
        (W, "(outside (to W 0) u (1))", "(functional (1 0) (-1 1))", "expected in"),
        (W, "(outside (in W 0) u (1))", "(functional)", "the rule is none for this formula"),
        (W, "(outside (in W 0) u (1))", "(functional (1 1) (-1 -1))", "expected a point u ≥ 0"),
        (W, "(pole (in W 0) ((/ 1 (+ u 1)) u) -2)", "(evaluate)", "no pole there"),
        (W, "(pole (in W 0) ((/ (+ u 1) (+ u 1))) -1)", "(evaluate)", "no pole there"),
        (W, "(pole (in W 0) ((/ 1 (+ u r))) -1)", "(evaluate)", "a parameter besides u"),
        (W, "(pole (in W 0) () -1)", "(evaluate)", "expected a list of terms"),
    ];
    for (declarations, goal, rule, want) in table {
        let found = reason(declarations, goal, rule);
        assert!(found.contains(want), "{declarations} {goal} {rule}\n  found: {found}\n  wanted: {want}");
    }
}

#[test]
fn declarations_and_terms_that_mean_nothing() {
    let goal = "(= 0 0)";
    let table = [
        // Windows and places.
        ("(window W 0 some)", "(= (G -1 2 (in W 0)) 1)", "not determined by the window W: t_-1"),
        ("(window W 0 some)", "(= (t W 2) 1)", "not determined by the window W: t_2"),
        ("(window W 0 some)", "(= (t W -1) 1)", "not determined by the window W: t_-1"),
        ("(window W 0 some)", "(= (x (in W 1)) 1)", "not determined by the window W: t_2"),
        ("(window W 0 any)", "(= (x (in W 0)) 1)", "span 0 of W is not positive"),
        ("(knots W 0 1 1 2)", "(= (x (in W 0)) 1)", "span 0 of W is not positive"),
        (
            "(window W 0 some some)",
            "(= (w 0 1 (in W 1)) 1)",
            "not determined by the window W: w_0^1 on span 1",
        ),
        ("(window W 0 some some)", "(= (w 1 1 (in W 0)) 1)", "w_1^1 on span 0"),
        ("(window W 0 some some)", "(= (w 0 0 (in W 0)) 1)", "w_0^0 on span 0"),
        ("(window W 0 some)", "(= (x (in V 0)) 1)", "unknown name V"),
        ("(window W 0 some)", "(= (G 0 -1 (in W 0)) 1)", "a degree is beyond the limits"),
        ("(window W 0 some)", "(= (G 0 101 (in W 0)) 1)", "a degree is beyond the limits"),
        ("(real a) (window W 0 a)", goal, "gap 0 of window W"),
        ("(positive a b) (window W 0 (- a b))", goal, "gap 0 of window W"),
        ("(positive a) (window W 0 (/ 1 a))", goal, "gap 0 of window W"),
        ("(window W 0 some u)", goal, "gap 1 of window W"),
        ("(window W 0 -1)", goal, "gap 0 of window W"),
        ("(let a u) (window W 0 some a)", goal, "gap 1 of window W"),
        ("(window W 0 V) (window V 0 some)", goal, "unknown name V"),
        (
            "(knots W 0 1 0)",
            goal,
            "gap 0 of window W is not a polynomial without minus in parameters that are not real or u",
        ),
        ("(knots W 0 1)", goal, "not determined by the window W: a gap"),
        ("(knots W 0 0 k)", goal, "expected a number"),
        ("(window W 0)", goal, "not determined by the window W: a gap"),
        ("(window t 0 some)", goal, "expected a name that is no word"),
        // What makes r move with x, in one step or in several, by its numerator or its denominator.
        ("(let r u)", goal, "r moves with u"),
        ("(let r (/ 1 u))", goal, "r moves with u"),
        ("(let r (/ u (+ 1 u)))", goal, "r moves with u"),
        ("(let r (* r u))", goal, "r moves with u"),
        ("(let r (/ u u))", goal, "r moves with u"),
        ("(let a (+ 1 u)) (let b (/ 2 a)) (let r b)", goal, "r moves with u"),
        ("(window W 0 some) (let r (x (in W 0)))", goal, "r moves with u"),
        ("(window W 0 some) (let r (G 0 0 (in W 0)))", "(= (/ 1 u) r)", "the two sides differ"),
        ("(window W 0 some some) (let r (G 0 1 (in W 0)))", goal, "r moves with u"),
        ("(window W 0 some) (let r (Dw 0 1 (in W 0)))", goal, "r moves with u"),
        ("(let r (at ((u (* 2 u))) u))", goal, "r moves with u"),
        ("(let r u) (window W 0 r)", goal, "r moves with u"),
        // Names.
        ("(let any 1)", goal, "the name any is taken"),
        ("(let some 0)", "(= some 0)", "the name some is taken"),
        ("(window any 0 some)", goal, "the name any is taken"),
        ("(real (some 1))", goal, "the name some is taken"),
        ("", "(each any 0 1 (= 0 0))", "the name any is taken"),
        ("(real a a)", goal, "the name a is taken"),
        ("(real a) (positive a)", goal, "the name a is taken"),
        ("(real u)", goal, "the name u is taken"),
        ("(positive k)", goal, "the name k is taken"),
        ("(positive any)", goal, "the name any is taken"),
        ("(real (d 0) (d 0))", goal, "the name d is taken"),
        ("(real d (d 0))", goal, "the name d is taken"),
        ("(real W) (window W 0 some)", goal, "the name W is taken"),
        ("(window W 0 some) (window W 0 some)", goal, "the name W is taken"),
        ("(let u 1)", goal, "the name u is taken"),
        ("(let r 0)", goal, "r is not positive"),
        ("(let a -2) (let r a)", goal, "r is not positive"),
        ("(positive a) (let r (- 1 a))", goal, "r is not positive"),
        ("(positive a) (let r (/ (- 1 a) a))", goal, "r is not positive"),
        ("(nonnegative a) (let r a)", goal, "r is not positive"),
        ("(real a) (let r a)", goal, "r is not positive"),
        ("(let a b) (let b 1)", goal, "unknown name b"),
        ("(let a (x (in W 0))) (window W 0 some)", goal, "unknown name W"),
        ("(window W 0 some (W 0))", goal, "unknown name W"),
        ("(window W 0 a) (positive a)", goal, "unknown name a"),
        ("(window W 0 (each i 1 0 any))", goal, "not determined by the window W: a gap"),
        ("(each k 1 2)", goal, "the name k is taken"),
        ("(real i)", "(each i 1 1 (= 0 0))", "the name i is taken"),
        ("", "(each i 1 1 (each i 1 1 (= 0 0)))", "the name i is taken"),
        ("", "(= k k)", "unknown name k"),
        ("", "(= (integer n) 0)", "unknown name n"),
        ("(real (d 0))", "(= (d 1) (d 1))", "unknown name d"),
        ("(real (d 0))", "(= d d)", "unknown name d"),
        ("(window W 0 some some some)", "(= (de-boor 1 1 1 (in W 1)) 0)", "unknown name d"),
        ("", "(= (at ((a 1)) 1) 1)", "expected u or a parameter of the family, each once"),
        ("(positive a)", "(= (at ((a 1)) 1) 1)", "expected u or a parameter of the family, each once"),
        ("(positive (u 1))", goal, "the name u is taken"),
        ("", "(= (at ((u 1) (u 1)) 1) 1)", "expected u or a parameter of the family, each once"),
        ("(let a 1)", "(= (at ((a 2)) a) 2)", "expected u or a parameter of the family, each once"),
        ("", "(= (at ((u -1)) 1) 1)", "u is not positive"),
        ("(nonnegative a)", "(= (at ((u a)) 1) 1)", "u is not positive"),
        ("(positive a)", "(= (at ((u (/ (- a 1) a))) 1) 1)", "u is not positive"),
        ("", "(= (at ((r 0)) 1) 1)", "r is not positive"),
        ("", "(= (at () 1) 1)", "expected a replacement"),
        // Numbers that are not allowed, or too large.
        ("", "(= (^ 2 -1) 1)", "an exponent is beyond the limits"),
        ("", "(= (^ 2 1000000) 1)", "an exponent is beyond the limits"),
        ("", "(= (^ (^ u 1000) 1000) 1)", "an exponent is beyond the limits"),
        ("", "(= (^ (^ (^ 3 1000) 1000) 1000) 1)", "a number is beyond the limits"),
        ("", "(= (integer (* 1000 1001 k)) 1)", "an integer is beyond the limits"),
        ("", "(= (integer 9223372036854775807) 1)", "an integer is beyond the limits"),
        ("", "(= (integer -9223372036854775808) 1)", "an integer is beyond the limits"),
        ("", "(= (integer 9223372036854775808) 1)", "expected a whole number"),
        ("", "(= (integer (binomial -1 0)) 1)", "the upper number of a binomial is beyond the limits"),
        ("", "(= (+ (each i 1 1000000 (each j 1 1000000 1))) 1)", "the expansion is beyond the limits"),
        ("", "(each i 1 1000000 (= 0 0))", "the expansion is beyond the limits"),
        ("", "(= (+ (each i 1 30000 1 2 3)) 1)", "the expansion is beyond the limits"),
        ("(real (each i 1 249 (a i)))", goal, "the number of parameters is beyond the limits"),
        ("(window W 0 (each i 1 249 any))", goal, "the number of parameters is beyond the limits"),
        ("", "(= (det (1 2) (3)) 0)", "expected a square matrix with 8 rows at most"),
        ("", "(= (det (1) (3)) 0)", "expected a square matrix with 8 rows at most"),
    ];
    for (declarations, goal, want) in table {
        let found = reason(declarations, goal, "(by)");
        assert!(found.contains(want), "{declarations} {goal}\n  found: {found}\n  wanted: {want}");
    }
}

#[test]
fn texts_that_are_not_the_format() {
    let table = [
        ("(real a)", "(= 0 0) (= 1 1)", "(by)) (goal 2 (by)) (goal 3 (by)", "a proof of a goal that"),
        ("(real a)", "(= 0 0) (= 1 1)", "(by)", "goal 2 is missing in its place"),
        ("(real a)", "(= 0 0)", "(by)) (goal 3 (by)", "a proof of a goal that"),
        ("(real a)", "(= 0 0) (= 1 1)", "(by)) (goal 3 (by)", "goal 2 is missing in its place"),
        ("", "(= 0 0)", "", "expected another number of fields"),
        ("", "(= 0 0)", "by", "expected a rule"),
        ("", "(= 0 0)", "()", "expected a rule"),
        ("", "(= 0 0)", "(sorry)", "expected a rule"),
        ("", "(= 0 0)", "(by) (by)", "expected another number of fields"),
        ("", "(= 0 0)", "(by (weights 1) (weights 1))", "expected an option that is none of the others"),
        ("", "(= 0 0)", "(by (functions 1) (functions 1))", "expected an option that is none of the others"),
        ("", "(= 0 0)", "(by (weights))", "expected an option"),
        ("", "(= 0 0)", "(by (weights k))", "expected a whole number"),
        ("", "(= 0 0)", "(by (weights -1))", "expected a degree"),
        ("", "(= 0 0)", "(by (weights 1/2))", "expected a whole number"),
        ("", "(= 0 0)", "(by (using))", "expected an option"),
        ("", "(= 0 0)", "(by (trust 1))", "expected an option that is none of the others"),
        ("", "(> u 0)", "(split u 0 (by) (by))", "expected a positive number"),
        ("", "(> u 0)", "(split u -1 (by) (by))", "expected a positive number"),
        ("", "(> u 0)", "(split u 1 (by))", "expected another number of fields"),
        ("", "(= 0 0) extra", "(by)", "goal 2 is missing in its place"),
        ("", "", "(by)", "expected goals"),
        ("", "(= 0)", "(by)", "expected a formula"),
        ("", "(= 0 0 0)", "(by)", "expected a formula"),
        ("", "(<= 0 0)", "(by)", "expected a formula"),
        ("", "(!= 0 0)", "(by)", "expected a string, a name or a number in lowest terms"),
        ("", "(true)", "(by)", "expected a formula"),
        ("", "(= (+) 0)", "(by)", "expected a term"),
        ("", "(= (f) 0)", "(by)", "expected a term"),
        ("", "(= () 0)", "(by)", "expected a term"),
        ("", "(= \"0\" 0)", "(by)", "expected a term"),
        ("", "(= 01 1)", "(by)", "expected a string, a name or a number in lowest terms"),
        ("", "(= 2/4 1/2)", "(by)", "expected a string, a name or a number in lowest terms"),
        ("", "(= -0 0)", "(by)", "expected a string, a name or a number in lowest terms"),
        ("", "(= 0.5 1/2)", "(by)", "expected a string, a name or a number in lowest terms"),
        ("", "(= (each i 1 2 0) 0)", "(by)", "expected a name that is no word"),
        ("", "(= (+ (each i 1 2)) 0)", "(by)", "expected a name, two integers and what is repeated"),
        ("", "(= (- 1 2 3) 0)", "(by)", "expected a name"),
        ("", "(= (x (at W 0)) 0)", "(by)", "expected in, from or to"),
        ("", "(= (det) 0)", "(by)", "expected a term"),
        ("(real)", "(= 0 0)", "(by)", "expected a declaration or the goals"),
        ("(real 1)", "(= 0 0)", "(by)", "expected a name"),
        ("(real (a))", "(= 0 0)", "(by)", "expected a name with an index"),
        ("(complex a)", "(= 0 0)", "(by)", "expected a declaration or the goals"),
        ("(real a) (each i 1 2)", "(= 0 0)", "(by)", "expected a declaration or the goals"),
        ("(each i 1 2 3)", "(= 0 0)", "(by)", "expected another number of fields"),
    ];
    for (declarations, goal, rule, want) in table {
        let found = reason(declarations, goal, rule);
        assert!(found.contains(want), "{declarations} {goal} {rule}\n  found: {found}\n  wanted: {want}");
    }
    let deep = "(- ".repeat(200) + "1" + &")".repeat(200);
    assert!(reason("", &format!("(= {deep} 1)"), "(by)").contains("the nesting is beyond the limits"));
}

#[test]
fn every_degree_has_a_goal_and_every_section_a_proof() {
    let proved = |count: usize, goals: &str| {
        let sections: String = (1..=count).map(|n| format!(" (section {n} {goals})")).collect();
        format!("(proof 1{sections})")
    };
    let table = [
        (
            "(section (goals (each i 2 k (= 0 0))))",
            "(proof 1 (section 1) (section 2 (goal 1 (by))))".into(),
            "no goal for k = 1",
        ),
        ("(section (each i 5 k) (goals (= 0 0)))", proved(2, "(goal 1 (by))"), "no goal for k = 1"),
        ("(section (goals (= 0 0)))", proved(1, "(goal 1 (by))"), "section 2 is missing in its place"),
        ("(section (goals (= 0 0)))", proved(3, "(goal 1 (by))"), "a proof of a section that"),
        (
            "(section (goals (= 0 0)))",
            "(proof 1 (section 2 (goal 1 (by))))".into(),
            "section 1 is missing in its place",
        ),
        ("(section (goals (= 0 0)))", "(proof 1)".into(), "section 1 is missing in its place"),
        (
            "(section (goals (= 0 0)))",
            "(proof 2 (section 1 (goal 1 (by))))".into(),
            "proof: format 1 is missing in its place",
        ),
        (
            "(section (goals (= 0 0)))",
            proved(2, "(goal 1 (by))") + " x",
            "proof: line 1: expected one bracket",
        ),
        ("(section (goals (= 0 0)))", proved(2, ""), "goal 1 is missing in its place"),
        (
            "(section (goals (= 0 1)))",
            proved(2, "(lemma 1 (= 0 1) (by)) (goal 1 (by (using (1 1))))"),
            "section 1, lemma 1, rule by: the two sides differ",
        ),
        (
            "(section (goals (= 0 1)))",
            proved(2, "(lemma 1 (= 0 1) (by (using (1 1)))) (goal 1 (by (using (1 1))))"),
            "no equation 1 so far among the lemmas",
        ),
        (
            "(section (goals (= 0 1)))",
            proved(2, "(lemma 2 (= 0 0) (by)) (goal 1 (by))"),
            "lemma 1 is missing in its place",
        ),
        (
            "(section (goals (= 0 1)))",
            proved(2, "(lemma 1 (> 1 0) (by)) (goal 1 (by (using (1 1))))"),
            "no equation 1 so far among the lemmas",
        ),
        (
            "(section (goals (= 1 1)))",
            proved(2, "(goal 1 (by)) (lemma 1 (> 1 0) (by))"),
            "section 1: line 1: expected goal",
        ),
        ("", proved(2, "(goal 1 (by))"), "there is no goal for k = 1"),
    ];
    for (sections, proof, want) in table {
        let found =
            check(&statement(sections), &proof).map_or_else(|e| e.to_string(), |c| format!("accepted: {c}"));
        assert!(found.contains(want), "{sections} {proof}\n  found: {found}\n  wanted: {want}");
    }
}

#[test]
fn headers_have_every_part_once_and_in_order() {
    let good = statement("(section (goals (= 0 0)))");
    let proof = "(proof 1 (section 1 (goal 1 (by))) (section 2 (goal 1 (by))))";
    assert!(check(&good, proof).is_ok());
    for (part, instead) in [
        ("(statement 2", "(statement 1"),
        ("(statement 2", "(statement 3"),
        ("(statement 2", "(proof 2"),
        ("(claim \"test\")", ""),
        ("(claim \"test\")", "(claim \" \")"),
        ("(claim \"test\")", "(claim test)"),
        ("(claim \"test\")", "(claim \"test 1\")"),
        ("(claim \"test\")", "(claim \"1test\")"),
        ("(claim \"test\")", "(claim \"te\u{455}t\")"),
        ("(claim \"test\")", "(claim \"test (printed): proved, scope knots\")"),
        ("(because \"It says so.\")", "(because \"It \u{1b}[2Jsays so.\")"),
        ("(because \"It says so.\")", "(because \"It says\u{200b} so.\")"),
        ("(because \"It says so.\")", "(because \"It says\u{9f} so.\")"),
        ("(claim \"test\")", "(claim \"a\" \"b\")"),
        ("(form printed)", "(form printed) (form printed)"),
        ("(form printed)", "(form other)"),
        ("(form printed)", "(form (degree 1))"),
        ("(form printed)", "(form (degree 1 2))"),
        ("(form printed) (verdict proved)", "(verdict proved) (form printed)"),
        ("proved", "evidence"),
        ("knots", "degree"),
        ("(degrees 1 2)", "(degrees 2 1)"),
        ("(degrees 1 2)", "(degrees -1 2)"),
        ("(degrees 1 2)", "(degrees 1 101)"),
        ("(degrees 1 2)", "(degrees)"),
        ("(degrees 1 2)", "(degrees 1 1)"),
        ("(degrees 1 2)", "(degrees 1 2 3/2)"),
        ("(degrees 1 2)", "(degrees 1 k)"),
        ("(degrees 1 2)", "(degrees (1 2))"),
        ("(degrees 1 2)", "(degrees (each i 1 2 i))"),
        ("(because \"It says so.\")", ""),
        ("(section (goals (= 0 0)))", "(section)"),
        ("(section (goals (= 0 0)))", "(section (goals (= 0 0)) (note 1))"),
    ] {
        assert!(good.contains(part), "{part}");
        let place = check(&good.replacen(part, instead, 1), proof).map_err(|rejected| rejected.place);
        assert_eq!(place, Err("statement".to_owned()), "{part} -> {instead}");
    }
}

#[test]
fn the_name_of_a_claim_is_not_long() {
    let proof = "(proof 1 (section 1 (goal 1 (by))) (section 2 (goal 1 (by))))";
    let named = |length: usize| {
        check(&statement("(section (goals (= 0 0)))").replace("test\"", &("n".repeat(length) + "\"")), proof)
    };
    assert!(named(100).is_ok() && named(101).is_err());
}

/// Short texts that ask for much, each in its own way; all are given up on, and none because of its length.
#[test]
fn work_is_limited() {
    let sum = "(+ (each j 1 30 (a j)))";
    let table = [
        // Products, powers, common denominators.
        format!("(= (^ {sum} 6) 0)"),
        format!("(= (* (each i 1 99 {sum})) 0)"),
        "(= (^ (+ 1 u r) 1000) 0)".to_owned(),
        "(= (+ (each i 1 90 (/ 1 (+ u r (integer i))))) 1)".to_owned(),
        // Long numbers.
        "(= (* (each i 1 40000 (^ 3 900))) 1)".to_owned(),
        // Nothing is added to much, much to nothing, much is looked at, or replaced by itself.
        format!("(= (+ (^ {sum} 3) (each i 1 40000 0)) 0)"),
        format!("(= (* 0 (each i 1 40000 (/ 1 (^ {sum} 3)))) 0)"),
        format!("(= (at ((u (^ {sum} 3))) (+ (each i 1 40000 (G 5 1 (in W 0))))) 0)"),
        format!("(= (at ((u (^ {sum} 3))) (+ (each i 1 40000 (at ((r 1)) 0)))) 0)"),
        // Determinants.
        format!("(= (det {}) 0)", format!("({})", format!("{sum} ").repeat(8)).repeat(8)),
        // The definition.
        "(= (DG 0 20 (in V 10)) 1)".to_owned(),
        "(= (G 0 100 (in V 10)) 1)".to_owned(),
        // Integers.
        format!("(= (+ (each i 1 40000 (integer (+ {})))) 0)", "0 ".repeat(500)),
    ];
    let declarations =
        "(positive (each i 1 30 (a i))) (window W 0 some some) (window V 0 (each i 0 20 some))";
    let ranges: String = (0..3_000).map(|i| format!("(each i{i} 1 1)")).collect();
    let long = (0..300).map(|i| format!("(let b{i} (^ (+ (each i 1 30 (a i))) 3))")).collect::<String>();
    let mut sections: Vec<_> =
        table.iter().map(|goal| format!("(section {declarations} (goals {goal}))")).collect();
    sections.push(format!("(section {ranges} (goals (= 0 0)))"));
    sections.push(format!("(section {declarations} {long} (goals (= 0 0)))"));
    sections.push("(section (window X 0 (each i 1 200 any) (each i 1 9000 0)) (goals (= 0 0)))".to_owned());
    for sections in sections {
        let statement = statement(&sections).replace("(degrees 1 2)", "(degrees 1)");
        let checked = check_within(WORK / 1_000, &statement, "(proof 1 (section 1 (goal 1 (by))))");
        let found = checked.map_or_else(|rejected| rejected.to_string(), |checked| checked.to_string());
        assert!(
            found.ends_with("the work is beyond the limits"),
            "{}: {found}",
            sections.chars().rev().take(90).collect::<String>().chars().rev().collect::<String>()
        );
    }
}

/// The count depends on the texts and on nothing else.
#[test]
fn work_is_counted_and_not_timed() {
    let statement = statement(&format!("(section {W} (goals (> (G 0 k (in W 0)) 0)))"));
    let proof = "(proof 1 (section 1 (goal 1 (by))) (section 2 (goal 1 (by))))";
    let enough = |work: usize| check_within(work, &statement, proof).is_ok();
    let (mut little, mut enough_work) = (0, 1_000_000);
    while enough_work - little > 1 {
        let middle = (little + enough_work) / 2;
        if enough(middle) { enough_work = middle } else { little = middle }
    }
    assert!(little > 100);
    let other = std::thread::scope(|scope| scope.spawn(|| (enough(little), enough(enough_work))).join());
    assert_eq!(other.ok(), Some((false, true)));
    assert!(check(&statement, proof).is_ok());
}

#[test]
fn a_long_text_is_not_read() {
    let proof = "(proof 1 (section 1 (goal 1 (by))) (section 2 (goal 1 (by))))";
    let good = statement("(section (goals (= 0 0)))");
    let of_length = |length: usize| format!("{good}{}", " ".repeat(length - good.len()));
    assert!(check(&of_length(4_000_000), proof).is_ok());
    let rejected = check(&of_length(4_000_001), proof).map_err(|rejected| rejected.to_string());
    assert_eq!(rejected, Err("statement: the text is beyond the limits".to_owned()));
}
