//! What a sentence says against what is judged: general statements read once more, word by word, on small and nasty knot
//! vectors, by a few lines that share nothing with the conclusions of the register.

#![allow(clippy::panic, reason = "helpers of tests")]

use knotproof::analysis::{Pieces, Shape};
use knotproof::claims::{BasisCase, Claim, Form, Origin, Verdict, claims, judge};
use knotproof::scalar::{BigRational, integer, parse_rational, rational};
use knotproof::spline::{Basis, Index, KnotVector};

/// Functions that are 0, knots of every multiplicity up to k + 3 at the ends and inside, degree 0, fewer functions than
/// k + 1, vectors that are not open, symmetric ones; and a function with two local maxima.
const CASES: &[(usize, &str)] = &[
    (0, "0 1"),
    (0, "0 0 1"),
    (0, "0 1 1"),
    (0, "0 1 1 2"),
    (0, "0 0 1 1 1 2"),
    (1, "0 1 2"),
    (1, "0 0 1 1"),
    (1, "0 0 1 2"),
    (1, "0 0 0 1 2"),
    (1, "0 0 0 3 3"),
    (1, "0 0 1 1 1"),
    (1, "0 1 1 1 2"),
    (1, "0 1 1 1 1 2"),
    (1, "0 0 1 1 2 2"),
    (2, "0 1 2 3 4"),
    (2, "0 0 0 1 1 1"),
    (2, "-1 0 1/3 1/3 7"),
    (2, "0 0 1 1 1 2 2"),
    (2, "0 0 0 0 1 1 1 1"),
    (2, "0 0 0 0 0 1 2 2 2"),
    (2, "0 0 0 1 1 1 2 2 2"),
    (2, "0 0 0 1 1 1 1 2 2 2"),
    (2, "0 1 1 1 1 1 2 3"),
    (3, "0 0 0 0 1 2 4 4"),
];
const ALPHAS: [&str; 3] = ["-1", "5/2", "inf"];

/// A knot vector, a degree and an index, with the functions by D2.3 and D3.3, to the letter.
struct Reader {
    k: usize,
    t: Vec<BigRational>,
    alpha: Option<BigRational>,
}

impl Reader {
    fn n(&self) -> usize {
        self.t.len() - self.k - 2
    }

    fn last(&self) -> &BigRational {
        &self.t[self.t.len() - 1]
    }

    /// D2.3.
    fn phi(&self, x: &BigRational, a: &BigRational, b: &BigRational, closed: bool) -> BigRational {
        if !(a <= x && (x < b || (closed && x == b && a < b))) {
            return integer(0);
        }
        match &self.alpha {
            Some(alpha) => alpha * (x - a) / (x + (alpha - integer(1)) * b - alpha * a),
            None => (x - a) / (b - a),
        }
    }

    /// D3.3 on the span s, so that x may be its right end as well.
    fn on_span(&self, s: usize, d: usize, i: usize, x: &BigRational) -> BigRational {
        if d == 0 {
            return integer(usize::from(i == s));
        }
        let w = |i: usize| self.phi(x, &self.t[i], &self.t[i + d], true);
        let mut value = integer(0);
        if (i..i + d).contains(&s) {
            value += w(i) * self.on_span(s, d - 1, i, x);
        }
        if (i + 1..=i + d).contains(&s) {
            value += (integer(1) - w(i + 1)) * self.on_span(s, d - 1, i + 1, x);
        }
        value
    }

    /// The value; at t_m the limit from the left.
    fn g(&self, i: usize, x: &BigRational) -> BigRational {
        let inside = |s: &usize| self.t[*s] <= *x && *x < self.t[s + 1];
        let at_end = |s: &usize| x == self.last() && self.t[*s] < *x && self.t[s + 1] == *x;
        let span = (0..self.t.len() - 1).find(|s| inside(s) || at_end(s));
        span.map_or_else(|| integer(0), |s| self.on_span(s, self.k, i, x))
    }

    /// The limit from the left.
    fn left(&self, i: usize, x: &BigRational) -> BigRational {
        let span = (0..self.t.len() - 1).find(|s| self.t[*s] < *x && *x <= self.t[s + 1]);
        span.map_or_else(|| integer(0), |s| self.on_span(s, self.k, i, x))
    }

    /// The knots, two points of every span, and one on either side of all.
    fn places(&self) -> Vec<BigRational> {
        let mut places = vec![&self.t[0] - integer(1), self.last() + integer(1)];
        places.extend_from_slice(&self.t);
        for pair in self.t.windows(2).filter(|pair| pair[0] < pair[1]) {
            let at = |share: BigRational| &pair[0] + (&pair[1] - &pair[0]) * share;
            places.extend([at(rational(1, 2)), at(rational(2, 7))]);
        }
        places
    }

    fn multiplicity(&self, x: &BigRational) -> usize {
        self.t.iter().filter(|t| *t == x).count()
    }

    fn is_open(&self) -> bool {
        let (k, m) = (self.k, self.t.len() - 1);
        m >= 2 * k && self.t[0] == self.t[k] && self.t[m - k] == self.t[m]
    }

    /// Over all i and all places: what the sentence says of each, `None` where it says nothing.
    fn of_all(&self, says: impl Fn(usize, &BigRational) -> Option<bool>) -> Vec<bool> {
        let places = self.places();
        (0..=self.n()).flat_map(|i| places.iter().filter_map(|x| says(i, x)).collect::<Vec<_>>()).collect()
    }

    /// `T3.5.1`, as printed and, with exceptions, as amended.
    fn support(&self, amended: bool) -> Vec<bool> {
        let k = self.k;
        self.of_all(|i, x| {
            let (low, high) = (&self.t[i], &self.t[i + k + 1]);
            let starts = x == low && self.t[i] == self.t[i + k] && self.t[i + k] < *high;
            let ends = x == self.last() && self.t[i] < self.t[i + 1] && self.t[i + 1] == *x;
            let one = amended && (starts || ends);
            let outside = !(low < x && x < high);
            outside.then(|| self.g(i, x) == integer(usize::from(one)))
        })
    }

    /// `T3.5.3`, as printed or as amended: is the sum 1 on every span, or exactly on those with k ≤ j ≤ n?
    fn unity(&self, amended: bool) -> Vec<bool> {
        let (k, n) = (self.k, self.n());
        let spans = (0..self.t.len() - 1).filter(|j| self.t[*j] < self.t[j + 1]);
        let says = |j: usize| {
            let inside = |x: &BigRational| self.t[j] <= *x && *x < self.t[j + 1];
            let is_one = self.places().into_iter().filter(inside).all(|x| {
                let sum: BigRational = (0..=n).map(|i| self.g(i, &x)).sum();
                let from = j.saturating_sub(k);
                let local: BigRational = (from..=j.min(n)).map(|i| self.g(i, &x)).sum();
                j >= k && j <= n && sum == integer(1) && local == sum
                    || (!(j >= k && j <= n) && sum == integer(1))
            });
            is_one == (!amended || (k..=n).contains(&j))
        };
        spans.map(says).collect()
    }

    /// `P3.1.2`; `None` if its hypotheses do not hold.
    fn continuity(&self) -> Option<Vec<bool>> {
        let (k, m) = (self.k, self.t.len() - 1);
        let base = m >= 2 * k && self.t[k] < self.t[m - k];
        let interior = self.t.get(k + 1..m - k).unwrap_or_default();
        (base && interior.iter().all(|t| self.multiplicity(t) <= k)).then(|| {
            self.of_all(|i, x| {
                let inside = self.t.contains(x) && self.t[0] < *x && x < self.last();
                inside.then(|| self.g(i, x) == self.left(i, x))
            })
        })
    }

    /// `P3.1.3`; `None` if U is not open.
    fn ends(&self) -> Option<Vec<bool>> {
        let one = |yes: bool| integer(usize::from(yes));
        let at_ends =
            |i: usize| [self.g(i, &self.t[0]) == one(i == 0), self.g(i, self.last()) == one(i == self.n())];
        self.is_open().then(|| (0..=self.n()).flat_map(at_ends).collect())
    }

    /// `P4.1.1`, as printed and, with t_m, as amended; `None` if U is not open.
    fn local_control(&self, amended: bool) -> Option<Vec<bool>> {
        self.is_open().then(|| {
            self.of_all(|j, x| {
                let on_curve = self.t[0] <= *x && x <= self.last();
                let acts = self.t[j] <= *x && *x < self.t[j + self.k + 1];
                let last = x == self.last() && self.t[j] < self.t[j + 1] && self.t[j + 1] == *x;
                let one = amended && last;
                (on_curve && !acts).then(|| self.g(j, x) == integer(usize::from(one)))
            })
        })
    }

    /// `Conj3.1.strong`, and `.continuous`: of the functions that are not 0 everywhere, each has one local maximum.
    fn one_maximum(&self, basis: &Basis, continuous: bool) -> Vec<bool> {
        let pieces = Pieces::of(basis);
        let jumps = |i: usize| {
            let inside = |x: &&BigRational| self.t[0] < **x && *x < self.last();
            self.t.iter().filter(inside).any(|x| self.g(i, x) != self.left(i, x))
        };
        let meant = |i: &usize| self.t[*i] < self.t[i + self.k + 1] && !(continuous && jumps(*i));
        (0..=self.n()).filter(meant).map(|i| Shape::of(&pieces, i).local_maxima().count() == 1).collect()
    }
}

fn reader(degree: usize, knots: &str, alpha: &str) -> (Reader, Basis) {
    let t: Vec<_> = knots.split(' ').map(|t| parse_rational(t).expect("a number")).collect();
    let index: Index = alpha.parse().expect("an index");
    let basis =
        Basis::new(KnotVector::new(t.clone()).expect("knots"), degree, index.clone()).expect("a basis");
    (Reader { k: degree, t, alpha: index.alpha() }, basis)
}

fn status(form: &Form, basis: &Basis) -> String {
    let Form::Basis(statement) = form else { panic!("a statement about bases") };
    let verdict = judge(statement, &[BasisCase::new(basis.clone(), Origin::User)]).expect("no fault");
    match verdict {
        Verdict::Proved { .. } | Verdict::Refuted(_) | Verdict::NotApplicable(_) => {
            verdict.status().to_owned()
        }
        other => panic!("{other:?}"),
    }
}

/// What the reading comes to.
fn expected(reading: Option<Vec<bool>>) -> &'static str {
    match reading {
        None => "not-applicable",
        Some(facts) if facts.is_empty() => "not-applicable",
        Some(facts) if facts.iter().all(|holds| *holds) => "proved",
        Some(_) => "refuted",
    }
}

#[test]
fn a_verdict_agrees_with_the_sentence_read_by_itself() {
    let all = claims();
    let claim = |id: &str| -> &Claim { all.iter().find(|claim| claim.id == id).expect("a claim") };
    let amended = |id: &str| claim(id).amended.as_ref().expect("it is amended");
    let positive = |reader: &Reader| {
        reader.of_all(|i, x| {
            let inside = reader.t[i] < *x && *x < reader.t[i + reader.k + 1];
            inside.then(|| reader.g(i, x) > integer(0))
        })
    };
    let mut seen = std::collections::BTreeMap::<(&str, &str), usize>::new();
    for &(degree, knots) in CASES {
        for alpha in ALPHAS {
            let (reader, basis) = reader(degree, knots, alpha);
            let conjecture = |continuous| (degree > 0).then(|| reader.one_maximum(&basis, continuous));
            let readings = [
                ("T3.5.1", &claim("T3.5.1").printed, Some(reader.support(false))),
                ("T3.5.1 amended", amended("T3.5.1"), Some(reader.support(true))),
                ("T3.5.2", &claim("T3.5.2").printed, Some(positive(&reader))),
                ("T3.5.3", &claim("T3.5.3").printed, Some(reader.unity(false))),
                ("T3.5.3 amended", amended("T3.5.3"), Some(reader.unity(true))),
                ("P3.1.2", &claim("P3.1.2").printed, reader.continuity()),
                ("P3.1.3", &claim("P3.1.3").printed, reader.ends()),
                ("P4.1.1", &claim("P4.1.1").printed, reader.local_control(false)),
                ("P4.1.1 amended", amended("P4.1.1"), reader.local_control(true)),
                ("Conj3.1.strong", &claim("Conj3.1.strong").printed, conjecture(false)),
                ("Conj3.1.strong.continuous", &claim("Conj3.1.strong.continuous").printed, conjecture(true)),
                (
                    "X.maxima.classical",
                    &claim("X.maxima.classical").printed,
                    conjecture(true).filter(|_| alpha == "inf"),
                ),
            ];
            for (name, form, reading) in readings {
                let expected = expected(reading);
                assert_eq!(status(form, &basis), expected, "{name}: k = {degree}, U = {knots}, α = {alpha}");
                *seen.entry((name, expected)).or_default() += 1;
            }
        }
    }
    // The cases tell true from false.
    assert!(seen.contains_key(&("P4.1.1", "refuted")), "{seen:?}");
    for name in ["T3.5.1", "T3.5.3", "P3.1.3", "Conj3.1.strong", "Conj3.1.strong.continuous"] {
        assert!(
            seen.contains_key(&(name, "proved")) && seen.contains_key(&(name, "refuted")),
            "{name}: {seen:?}"
        );
    }
    for name in
        ["T3.5.1 amended", "T3.5.2", "T3.5.3 amended", "P4.1.1 amended", "P3.1.2", "X.maxima.classical"]
    {
        assert!(
            seen.contains_key(&(name, "proved")) && !seen.contains_key(&(name, "refuted")),
            "{name}: {seen:?}"
        );
    }
}

/// A sentence about "every G_i^k" that leaves out those that are 0 says so, in itself or in what it assumes.
#[test]
fn what_is_said_of_maxima_is_said_of_functions_that_are_not_zero() {
    for claim in claims() {
        let speaks = claim.id.starts_with("Conj3.1") || claim.id.starts_with("X.maxima");
        for form in [Some(&claim.printed), claim.amended.as_ref()].into_iter().flatten() {
            let text = form.text();
            if speaks && text.contains("every G_i^k") {
                let simple = text.contains("simple");
                assert!(text.contains("t_i < t_{i+k+1}") || simple, "{}: {text}", claim.id);
            }
        }
    }
}
