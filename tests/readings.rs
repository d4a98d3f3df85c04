//! What a sentence says against what is judged: general claims read once more, word by word, on small and nasty knot vectors,
//! by a few lines that share nothing with the reading of formulas.

#![allow(clippy::panic, reason = "helpers of tests")]

use knotproof::analysis::{Pieces, Shape};
use knotproof::judge::{Cases, Verdict, judge};
use knotproof::language::{Claim, Form, claims};
use knotproof::meaning::Instance;
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

    /// `T3.5.1`; as amended without the exceptions, of which it says what holds there.
    fn support(&self, form: Form) -> Vec<bool> {
        let k = self.k;
        self.of_all(|i, x| {
            let (low, high) = (&self.t[i], &self.t[i + k + 1]);
            let starts = x == low && self.t[i] == self.t[i + k] && self.t[i + k] < *high;
            let ends = x == self.last() && self.t[i] < self.t[i + 1] && self.t[i + 1] == *x;
            let (outside, exception) = (!(low < x && x < high), starts || ends);
            said(form, outside, exception).then(|| self.g(i, x) == integer(usize::from(form == Form::Fails)))
        })
    }

    /// `T3.5.3`; as amended of the spans with k ≤ j ≤ n, and inside of the others the sum is less.
    fn unity(&self, form: Form) -> Vec<bool> {
        let (k, n) = (self.k, self.n());
        let spans = (0..self.t.len() - 1).filter(|j| self.t[*j] < self.t[j + 1]);
        let says = |j: usize| {
            let (low, high) = (&self.t[j], &self.t[j + 1]);
            let inside = |x: &BigRational| (low < x || (low == x && form != Form::Fails)) && x < high;
            said(form, true, !(k..=n).contains(&j)).then(|| {
                self.places().into_iter().filter(inside).all(|x| {
                    let sum: BigRational = (0..=n).map(|i| self.g(i, &x)).sum();
                    let local: BigRational = (j.saturating_sub(k)..=j.min(n)).map(|i| self.g(i, &x)).sum();
                    if form == Form::Fails { sum < integer(1) } else { sum == integer(1) && local == sum }
                })
            })
        };
        spans.filter_map(says).collect()
    }

    /// `P3.1.2`; `None` if its hypotheses do not hold.
    fn continuity(&self) -> Option<Vec<bool>> {
        let (k, m) = (self.k, self.t.len() - 1);
        let base = m >= 2 * k && self.t[k] < self.t[m - k];
        let interior = self.t.get(k + 1..m - k).unwrap_or_default();
        (base && interior.iter().all(|t| self.multiplicity(t) <= k)).then(|| {
            self.of_all(|i, x| {
                let starts = *x == self.t[0];
                (self.t[0] <= *x && x < self.last()).then(|| starts || self.g(i, x) == self.left(i, x))
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

    /// `P4.1.1`, as amended without t_m for the last function, of which it says what holds there; `None` if U is not open.
    fn local_control(&self, form: Form) -> Option<Vec<bool>> {
        self.is_open().then(|| {
            self.of_all(|j, x| {
                let on_curve = self.t[0] <= *x && x <= self.last();
                let acts = self.t[j] <= *x && *x < self.t[j + self.k + 1];
                let last = x == self.last() && self.t[j] < self.t[j + 1] && self.t[j + 1] == *x;
                let one = usize::from(form == Form::Fails);
                said(form, on_curve && !acts, last).then(|| self.g(j, x) == integer(one))
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

/// Does a form say something, where the printed one does or does not, and what the amendment excludes is met or not?
fn said(form: Form, printed: bool, excluded: bool) -> bool {
    match form {
        Form::Printed | Form::Degree(_) | Form::Degrees => printed,
        Form::Amended => printed && !excluded,
        Form::Fails => excluded,
    }
}

fn reader(degree: usize, knots: &str, alpha: &str) -> (Reader, Basis) {
    let t: Vec<_> = knots.split(' ').map(|t| parse_rational(t).expect("a number")).collect();
    let index: Index = alpha.parse().expect("an index");
    let basis =
        Basis::new(KnotVector::new(t.clone()).expect("knots"), degree, index.clone()).expect("a basis");
    (Reader { k: degree, t, alpha: index.alpha() }, basis)
}

fn status(claim: Claim<'_>, form: Form, basis: &Basis) -> &'static str {
    let sentence = claim.sentence(form).expect("a sentence");
    let cases = Cases::only(Instance::of(basis.clone()));
    let verdict = judge(sentence, claim.into(), &cases.of(sentence, None)).expect("no fault");
    assert!(!matches!(verdict, Verdict::Undecided(_)), "{verdict:?}");
    verdict.status()
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
    let claim = |id: &str| all.iter().find(|claim| claim.id() == id).expect("a claim");
    let positive = |reader: &Reader| {
        reader.of_all(|i, x| {
            let inside = reader.t[i] < *x && *x < reader.t[i + reader.k + 1];
            inside.then(|| reader.g(i, x) > integer(0))
        })
    };
    let mut seen = std::collections::BTreeMap::<(&str, Form, &str), usize>::new();
    for &(degree, knots) in CASES {
        for alpha in ALPHAS {
            let (reader, basis) = reader(degree, knots, alpha);
            let conjecture = |continuous| (degree > 0).then(|| reader.one_maximum(&basis, continuous));
            let forms = [Form::Printed, Form::Amended, Form::Fails];
            let of_forms = forms.into_iter().flat_map(|form| {
                [
                    ("T3.5.1", form, Some(reader.support(form))),
                    ("T3.5.3", form, Some(reader.unity(form))),
                    ("P4.1.1", form, reader.local_control(form)),
                ]
            });
            let printed = [
                ("T3.5.2", Some(positive(&reader))),
                ("P3.1.2", reader.continuity()),
                ("P3.1.3", reader.ends()),
                ("Conj3.1.strong", conjecture(false)),
                ("Conj3.1.strong.continuous", conjecture(true)),
                ("X.maxima.classical", conjecture(true).filter(|_| alpha == "inf")),
            ];
            let printed = printed.into_iter().map(|(id, reading)| (id, Form::Printed, reading));
            for (id, form, reading) in of_forms.chain(printed) {
                let (expected, found) = (expected(reading), status(*claim(id), form, &basis));
                assert_eq!(found, expected, "{id}, {form}: k = {degree}, U = {knots}, α = {alpha}");
                *seen.entry((id, form, expected)).or_default() += 1;
            }
        }
    }
    // The cases tell true from false.
    let seen = |id: &str, form| ["proved", "refuted"].map(|status| seen.contains_key(&(id, form, status)));
    assert!(seen("P4.1.1", Form::Printed)[1]);
    for id in ["T3.5.1", "T3.5.3", "P3.1.3", "Conj3.1.strong", "Conj3.1.strong.continuous"] {
        assert_eq!(seen(id, Form::Printed), [true, true], "{id}");
    }
    for id in ["T3.5.2", "P3.1.2", "X.maxima.classical"] {
        assert_eq!(seen(id, Form::Printed), [true, false], "{id}");
    }
    for id in ["T3.5.1", "T3.5.3", "P4.1.1"] {
        assert_eq!([seen(id, Form::Amended), seen(id, Form::Fails)], [[true, false]; 2], "{id}");
    }
}
