//! The claim language: what is read, and that printing is read back.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::cast_possible_truncation,
    reason = "helpers of tests; seeds and sizes are small"
)]

use std::collections::HashMap;

use proptest::prelude::*;

use knotproof::language::{
    Adjective, Argument, Binder, Fold, Formula, Function, Int, Interval, Item, Known, Member, Name, Over,
    Print, Range, Real, Relation, Sentence, Side, Use, Word, canonical, claims, latex, mathml, one_line,
    schema, sentence, source, text,
};
use knotproof::scalar::rational;

/// One sentence of every kind that the page of the language shows.
const LINES: &[&str] = &[
    "k; U; j in 0..m-1; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = sum(i in j-k..j: G[i](x)) = 1",
    "k; U symmetric; i in 0..n; x in [t[0], t[m]] : G[i](t[0]+t[m]-x) = G[n-i](x; alpha = 1-alpha)",
    "k >= 1; U open : G'[1](t[0]+) = -G'[0](t[0]+) = k*alpha/((alpha-1)*(t[k+1]-t[0])); all(i in 2..n: G'[i](t[0]+) = 0)",
    "k >= 1; U; i in 0..n | t[i] < t[i+k+1]; continuous(G[i]) : maxima(G[i]) = 1",
    "a; b; x | a < b : 0 <= phi(x, a, b) < 1; phi(x, a, b; alpha = infinity) = max(0, (x-a)/(b-a)) or x >= b",
    "s < 0; h; a; b; x : phi(s*x+h, s*b+h, s*a+h) = 1 - phi(x, a, b; alpha = 1-alpha)",
    "U in {C5, C7a}; alpha in {-1/2, 6/5, infinity}; beta index; x in (t[0], t[m]) | alpha != infinity : abs(P[0,1]) >= 0 and G[0](x-; alpha = beta) = 1",
    "k in 1..3; U; d points; i in 0..n : changes(sum(j in 0..n: d[j]*G[j](x)), x in [t[0], t[m]]) <= polygon_changes(d)",
    "k = 2; U; x in (t[0], t[m]) : not some(i in 0..n: G[i](x) < 0) => one(i in 0..n: x in [t[i], t[i+1])) <=> claim(X.linear, printed)",
    "k; U; q in 0..k; x in (t[0], t[m]); r1 > 0 : D(G[0], q)(x+; r = r1) = -x^2 + binomial(k, q)*x^(k-q) - 2/3*x^-1",
    "k >= 3; q in 0..2; U gaps (each(j in 1..k: 0), 1, (k-2)*r - q, 1/8, each(j in 1..k: 0)) : m = 2*k+3",
    "k = 2; U in {U0, S3} : U in {S3} => t[4] = t[5]",
];

#[test]
fn every_form_is_read() {
    for line in LINES {
        if let Err(complaint) = one_line(line) {
            panic!("{complaint}");
        }
    }
}

#[test]
fn definitions_are_known_where_they_are_defined() {
    let known = Known::defining(&[
        ("C(x)", "sum(i in 0..n: d[i]*G[i](x))"),
        ("b[i,0](x)", "d[i]"),
        ("b[i,q](x)", "w[i,k-q+1](x)*b[i,q-1](x) + (1 - w[i,k-q+1](x))*b[i-1,q-1](x)"),
    ])
    .unwrap();
    let read = sentence("k; U; d points; j in k..n; x in [t[j], t[j+1])", &[], &["b[j,k](x) = C(x)"], &known);
    assert!(read.is_ok(), "{}", read.unwrap_err());
    let missing = sentence("k; U; x in [t[0], t[m]]", &[], &["C(x) = 0"], &known).unwrap_err();
    assert_eq!((missing.place(), missing.advice()), ((1, 1), "bind it in `for`: `d points`"), "{missing}");
}

/// Random well-typed trees, from the numbers of a seed.
struct Trees {
    state: u64,
    /// Integers and reals that are bound.
    ints: Vec<Name>,
    reals: Vec<Name>,
    /// How many names were bound inside.
    inner: usize,
}

impl Trees {
    fn new(seed: u64) -> Self {
        let names = |names: &[&str]| names.iter().map(|name| Name::from(*name)).collect();
        Self { state: seed, ints: names(&["i", "j1"]), reals: names(&["x", "s", "gamma"]), inner: 0 }
    }

    /// SplitMix64.
    fn below(&mut self, n: usize) -> usize {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    fn one_of(&mut self, names: fn(&Self) -> &Vec<Name>) -> Name {
        let at = self.below(names(self).len());
        names(self)[at].clone()
    }

    fn int(&mut self, depth: usize) -> Int {
        if depth == 0 || self.below(3) == 0 {
            return match self.below(6) {
                0 => Int::Number(self.below(12) as i64 - 3),
                1 => Int::Degree,
                2 => Int::Last,
                3 => Int::M,
                _ => Int::Bound(self.one_of(|trees| &trees.ints)),
            };
        }
        let (a, b) = (self.int(depth - 1), self.int(depth - 1));
        let whole = match self.below(8) {
            0 | 1 => Real::Whole(a).plus(Real::Whole(b)),
            2 | 3 => Real::Whole(a).minus(Real::Whole(b)),
            4 => Real::Whole(a).times(Real::Whole(b)),
            5 => Real::Whole(a).least(Real::Whole(b)),
            6 => return Int::Binomial(Box::new(a), Box::new(b)),
            _ => {
                let (word, of) = match self.below(4) {
                    0 => (Word::Multiplicity, Item::Real(self.real(depth - 1))),
                    1 => (
                        Word::Maxima,
                        Item::Function(self.function(depth - 1, false), self.member(depth - 1)),
                    ),
                    2 => (Word::Changes, self.expression(depth - 1)),
                    _ => (Word::PolygonChanges, Item::Coefficients("d".into())),
                };
                return Int::Word(Box::new(Use { word, of: vec![of] }));
            }
        };
        match whole {
            Real::Whole(int) => int,
            other => panic!("{other:?}"),
        }
    }

    /// An index: no literal below 0.
    fn index(&mut self, depth: usize) -> Int {
        match self.int(depth) {
            Int::Number(number) => Int::Number(number.abs()),
            other => other,
        }
    }

    fn bind<T>(&mut self, real: bool, read: impl FnOnce(&mut Self, Name) -> T) -> T {
        self.inner += 1;
        let name: Name = format!("{}{}", if real { "y" } else { "l" }, self.inner).into();
        let names = |trees: &mut Self| {
            if real { std::mem::take(&mut trees.reals) } else { std::mem::take(&mut trees.ints) }
        };
        let mut before = names(self);
        let kept = before.clone();
        before.push(name.clone());
        if real {
            self.reals = before
        } else {
            self.ints = before
        }
        let value = read(self, name);
        if real {
            self.reals = kept
        } else {
            self.ints = kept
        }
        value
    }

    fn range(&mut self, depth: usize, name: Name) -> Range {
        let (from, to) = (self.int(depth), self.int(depth));
        match (&from, &to) {
            (Int::Number(a), Int::Number(b)) if b < a => Range { name, from: to, to: from },
            _ => Range { name, from, to },
        }
    }

    fn interval(&mut self, depth: usize) -> Interval {
        let (from, to) = (self.real(depth), self.real(depth));
        let to = if from.literal().is_some() && to.literal().is_some() { Real::Ratio } else { to };
        Interval { from, from_closed: self.below(2) == 0, to, to_closed: self.below(2) == 0 }
    }

    fn expression(&mut self, depth: usize) -> Item {
        let within = (self.below(2) == 0).then(|| self.interval(depth));
        self.bind(true, |trees, name| Item::Expression(trees.real(depth), name, within))
    }

    fn member(&mut self, depth: usize) -> Option<Member> {
        match self.below(6) {
            0 => Some(Member::Index(Real::Infinity)),
            1 => Some(Member::Index(Real::Index("beta".into()))),
            2 => Some(Member::Index(Real::Whole(Int::Number(1)).minus(Real::Index("alpha".into())))),
            3 => Some(Member::Ratio(self.real(depth))),
            4 => Some(Member::Dual),
            _ => None,
        }
    }

    fn function(&mut self, depth: usize, phi: bool) -> Function {
        let basis = match self.below(if phi { 7 } else { 6 }) {
            0 | 1 => Function::Basis { i: self.index(depth), degree: None },
            2 => Function::Basis {
                i: self.index(depth),
                degree: Some(self.index(depth)).filter(|d| *d != Int::Degree),
            },
            3 => Function::Weight { i: self.index(depth), degree: self.index(depth) },
            4 => Function::Defined("C".into(), vec![]),
            5 => Function::Defined("b".into(), vec![self.int(depth), self.int(depth)]),
            _ => {
                let function =
                    Function::Phi { cut: self.below(2) == 0, from: self.real(depth), to: self.real(depth) };
                return match self.below(3) {
                    0 => Function::Derivative(Box::new(function), Int::Number(1 + self.below(5) as i64)),
                    _ => function,
                };
            }
        };
        match self.below(4) {
            0 => Function::Derivative(Box::new(basis), Int::Number(self.below(5) as i64)),
            1 => {
                let order = self.index(depth);
                Function::Derivative(Box::new(Function::Derivative(Box::new(basis), Int::Number(1))), order)
            }
            _ => basis,
        }
    }

    fn real(&mut self, depth: usize) -> Real {
        if depth == 0 || self.below(4) == 0 {
            return match self.below(8) {
                0 => Real::number(rational(self.below(9) as i64 - 4, 1 + self.below(3) as i64)),
                1 => Real::Index(["alpha", "beta"][self.below(2)].into()),
                2 => Real::Ratio,
                3 => Real::Whole(self.int(0)),
                4 => Real::Knot(self.index(0)),
                _ => Real::Bound(self.one_of(|trees| &trees.reals)),
            };
        }
        let depth = depth - 1;
        match self.below(18) {
            0 | 1 => self.real(depth).plus(self.real(depth)),
            2 | 3 => self.real(depth).minus(self.real(depth)),
            4 | 5 => self.real(depth).times(self.real(depth)),
            6 | 7 => match (self.real(depth), self.real(depth)) {
                (a, Real::Whole(Int::Number(0))) => a,
                (a, b) => a.over(b),
            },
            8 => self.real(depth).negated(),
            9 => Real::Power(Box::new(self.real(depth)), self.int(depth)),
            10 => Real::Absolute(Box::new(self.real(depth))),
            11 => Real::Root(Box::new(self.real(depth))),
            12 => self.real(depth).greatest(self.real(depth)),
            13 => Real::Whole(self.int(depth)),
            14 => Real::Coefficient("d".into(), vec![self.index(depth)]),
            15 => {
                let fold = [Fold::Sum, Fold::Product, Fold::Least, Fold::Greatest][self.below(4)];
                let range = self.range(depth, "l".into());
                self.bind(false, |trees, name| {
                    Real::Fold(fold, Range { name, ..range }, Box::new(trees.real(depth)))
                })
            }
            16 => Real::Word(Box::new(Use { word: Word::Supremum, of: vec![self.expression(depth)] })),
            _ => {
                let side = [None, Some(Side::Left), Some(Side::Right)][self.below(3)];
                let argument = Argument { at: self.real(depth), side, member: self.member(depth) };
                Real::Value(Box::new(self.function(depth, true)), Box::new(argument))
            }
        }
    }

    fn formula(&mut self, depth: usize) -> Formula {
        let terms = depth.min(2);
        if depth == 0 || self.below(4) == 0 {
            let relation = |trees: &mut Self| {
                use Relation::{AtLeast, AtMost, Equal, Greater, Less, Unequal};
                [Equal, Unequal, Less, AtMost, Greater, AtLeast][trees.below(6)]
            };
            return match self.below(8) {
                0 => Formula::Chain(Real::Index("alpha".into()), vec![(Relation::Unequal, Real::Infinity)]),
                1 => Formula::Within(self.real(terms), self.interval(terms)),
                2 => {
                    let range = self.range(terms, "i".into());
                    Formula::Among(self.int(terms), range.from, range.to)
                }
                3 => Formula::Claim {
                    id: ["T3.5", "X.linear"][self.below(2)].into(),
                    printed: self.below(2) == 0,
                },
                4 => {
                    let of = Item::Function(self.function(terms, false), self.member(terms));
                    Formula::Word(Box::new(Use { word: Word::Continuous, of: vec![of] }))
                }
                _ => {
                    let first = self.real(terms);
                    let rest = 1 + self.below(2);
                    Formula::Chain(first, (0..rest).map(|_| (relation(self), self.real(terms))).collect())
                }
            };
        }
        let depth = depth - 1;
        let over = self.below(2) == 0;
        match self.below(8) {
            0 => Formula::Not(Box::new(self.formula(depth))),
            1 | 2 => Formula::And((0..2 + self.below(2)).map(|_| self.formula(depth)).collect()),
            3 => Formula::Or((0..2 + self.below(2)).map(|_| self.formula(depth)).collect()),
            4 => Formula::Implies(Box::new(self.formula(depth)), Box::new(self.formula(depth))),
            5 => Formula::Iff(Box::new(self.formula(depth)), Box::new(self.formula(depth))),
            kind => {
                let (range, within) = (self.range(1, "l".into()), self.interval(1));
                self.bind(over, |trees, name| {
                    let over = match over {
                        true => Over::Reals(name, within),
                        false => Over::Integers(Range { name, ..range }),
                    };
                    let of = Box::new(trees.formula(depth));
                    match (kind, trees.below(2)) {
                        (6, _) => Formula::All(over, of),
                        (_, 0) => Formula::Some(over, of),
                        _ => Formula::One(over, of),
                    }
                })
            }
        }
    }

    /// The names that formulas speak of, in binders of every kind.
    fn sentence(&mut self, depth: usize) -> Sentence {
        let scope = std::mem::replace(&mut self.reals, vec!["s".into()]);
        let ints = std::mem::replace(&mut self.ints, vec!["i".into()]);
        let degree = match self.below(4) {
            0 => Binder::Degree { least: 0, most: None },
            1 => Binder::Degree { least: 2, most: None },
            2 => Binder::Degree { least: 0, most: Some(3) },
            _ => Binder::Degree { least: 1, most: Some(1 + self.below(2)) },
        };
        let knots = match self.below(3) {
            0 => Binder::Instances(
                ["U0", "C5"][..1 + self.below(2)].iter().map(|name| Name::from(*name)).collect(),
            ),
            _ => {
                let (first, last) = (self.below(4), 4 + self.below(4));
                Binder::Knots(vec![Adjective::ALL[first], Adjective::ALL[last]])
            }
        };
        let sign = [None, Some(Relation::Greater), Some(Relation::Less)][self.below(3)];
        let range = Range { name: "i".into(), from: Int::Number(0), to: Int::Last };
        let mut given = vec![
            degree,
            knots,
            Binder::Points("d".into()),
            Binder::Index("beta".into()),
            Binder::Real { name: "s".into(), sign },
            Binder::Real { name: "gamma".into(), sign: None },
            Binder::Integer(range),
        ];
        let second = self.range(1, "j1".into());
        given.push(Binder::Integer(second));
        given.push(Binder::Point("x".into(), self.interval(1)));
        (self.reals, self.ints) = (scope, ints);
        let assume = (0..self.below(3)).map(|_| self.formula(depth)).collect();
        Sentence { given, assume, then: (0..1 + self.below(2)).map(|_| self.formula(depth)).collect() }
    }
}

/// Definitions that the trees use.
fn known() -> Known {
    Known::defining(&[("C(x)", "x"), ("b[p,0](x)", "x"), ("b[p,q](x)", "q*x + p")]).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_source_is_read_back(seed in any::<u64>()) {
        let tree = Trees::new(seed).sentence(3);
        let text = source(&tree);
        match known().one_line(&text) {
            Ok(read) => prop_assert_eq!(read, tree, "{}", text),
            // Random trees may be too deep.
            Err(complaint) => prop_assert!(complaint.rule().contains("deeper"), "{}", complaint),
        }
    }
}

/// Each print of some trees belongs to one of them.
fn injective<T: Print + PartialEq>(trees: impl Iterator<Item = T>, print: fn(&T) -> String) {
    let mut seen: HashMap<String, T> = HashMap::new();
    for tree in trees {
        let printed = print(&tree);
        match seen.get(&printed) {
            Some(other) => assert_eq!(source(other), source(&tree), "{printed}"),
            None => _ = seen.insert(printed, tree),
        }
    }
}

fn formulas() -> impl Iterator<Item = Formula> {
    (0..20_000).map(|seed| Trees::new(seed).formula(seed as usize % 3))
}

#[test]
fn no_two_read_alike() {
    injective(formulas(), text);
    injective((0..2_000).map(|seed| Trees::new(seed).sentence(seed as usize % 2)), text);
}

#[test]
fn no_two_look_alike() {
    injective(formulas(), |tree| {
        let html = mathml(tree);
        let (before, after) = html.split_once("<annotation").unwrap_or((&html, ""));
        format!("{before}{}", after.split_once("</annotation>").map_or("", |(_, after)| after))
    });
}

#[test]
fn prints_for_people() {
    let line = "k; U; i in 0..n; x in (t[i], t[i+k+1]) : G[i](x) > 0";
    let sentence = one_line(line).unwrap();
    assert_eq!(text(&sentence), "For every U, every 0 ≤ i ≤ n and t_i < x < t_{i+k+1}: G_i^k(x) > 0.");
    assert_eq!(source(&sentence), line);
    assert_eq!(
        latex(&sentence),
        r"For every $U$, every $0 \le i \le n$ and $t_{i} < x < t_{i + k + 1}$: $G_{i}^{k}\left(x\right) > 0$."
    );
    assert!(mathml(&sentence).contains(
        "<msubsup><mrow><mi>G</mi></mrow><mrow><mi>i</mi></mrow><mrow><mi>k</mi></mrow></msubsup>"
    ));
    for (line, said) in [
        (
            "a; b; s < 0; x | a < b : phi(s*x, s*b, s*a) = 1 - phi(x, a, b; alpha = 1-alpha)",
            "For all real a, b, every s < 0 and every real x, if a < b: φ_α(s·x, s·b, s·a) = 1 − φ_{1−α}(x, a, b).",
        ),
        (
            "k >= 1; U open symmetric interior; i in 0..n | alpha != infinity : maxima(G[i]) = 1",
            "For every k ≥ 1, every open and symmetric U with interior knots of multiplicity at most k and every 0 ≤ i ≤ n, if α ≠ ∞: the number of local maxima of G_i^k is 1.",
        ),
        (
            "k = 2; U in {U0} : all(i in 1..n: G'[i](t[0]+) = 0)",
            "For k = 2 and U = U0: for all 1 ≤ i ≤ n: DG_i^k(t_0⁺) = 0.",
        ),
        ("x : -x^2 + 1/2*x = -(x + 1)/(x - 1)", "For every real x: −x^2 + 1/2·x = −(x + 1)/(x − 1)."),
    ] {
        assert_eq!(text(&one_line(line).unwrap()), said);
    }
}

#[test]
fn the_schema_takes_what_is_read() {
    let schema = jsonschema::validator_for(&serde_json::to_value(schema()).unwrap()).unwrap();
    let stanza = |claim: &str| toml::from_str::<serde_json::Value>(&format!("[[claim]]\n{claim}")).unwrap();
    let head = "id = 'A'\nat = '1'\ntitle = 'a'\n";
    assert!(
        schema
            .is_valid(&stanza(&format!("{head}for = 'k'\nif = []\nthen = ['k = 1']\ncause = 'end-points'")))
    );
    for wrong in ["thne = []", "cause = 'end-point'", "degrees = 'all'", "then = 'k = 1'"] {
        assert!(!schema.is_valid(&stanza(&format!("{head}{wrong}"))), "{wrong}");
    }
}

/// What certificates may be made of: brackets, numbers, names, claims in quotes.
fn has_tokens_of_certificates(text: &str) -> bool {
    let is_name = |word: &str| {
        let rest = |c: char| c.is_ascii_alphanumeric() || c == '.' || c == '-';
        word.starts_with(|c: char| c.is_ascii_alphabetic()) && word.chars().all(rest)
    };
    let is_number = |word: &str| {
        let digits = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
        let (up, down) = word.split_once('/').unwrap_or((word, "2"));
        digits(up.strip_prefix('-').unwrap_or(up)) && digits(down)
    };
    let sign =
        |word: &str| ["+", "-", "*", "/", "^", "=", "/=", "<", "<=", ">", ">=", "=>", "<=>"].contains(&word);
    let quoted =
        |word: &str| word.strip_prefix('"').and_then(|word| word.strip_suffix('"')).is_some_and(is_name);
    let mut words = text.split([' ', '\n', '(', ')']).filter(|word| !word.is_empty());
    words.all(|word| is_name(word) || is_number(word) || sign(word) || quoted(word))
        && text.matches('(').count() == text.matches(')').count()
}

#[test]
fn every_sentence_of_the_paper_has_canonical_brackets_of_its_own() {
    let named = |id: &str, printed: bool| {
        let claim = claims().into_iter().find(|claim| claim.id() == id)?;
        let amended = claim.stanza.amended.as_ref().filter(|_| !printed).and_then(|said| said.sentence());
        Some((amended.or(claim.stanza.printed.sentence())?, claim.definitions))
    };
    let mut seen: HashMap<String, (String, Sentence)> = HashMap::new();
    for claim in claims() {
        let said = [Some(&claim.stanza.printed), claim.stanza.amended.as_ref(), claim.stanza.fails.as_ref()];
        for sentence in said.into_iter().flatten().filter_map(|said| said.sentence()) {
            let text = canonical(sentence, claim.definitions, &claim.paper.examples, &named).unwrap();
            assert!(has_tokens_of_certificates(&text), "{}: {text}", claim.id());
            let own = claim.definitions.iter().map(source).collect::<String>();
            if let Some((others, other)) = seen.insert(text.clone(), (own.clone(), sentence.clone())) {
                // One text may stand in two files, where its definitions do.
                assert!(other == *sentence && (others == own || !text.contains("(define")), "{text}");
            }
        }
    }
    assert!(seen.len() > 150, "{} sentences", seen.len());
}

#[test]
fn no_two_have_the_same_brackets() {
    let bracket = |tree: &Sentence| {
        // Random trees name claims that are not there.
        canonical(tree, &[], &[], &|_, _| None).unwrap_or_else(|_| source(tree))
    };
    injective((0..4_000).map(|seed| Trees::new(seed).sentence(seed as usize % 3)), bracket);
}
