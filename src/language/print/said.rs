//! The walk through formulas and sentences: for people a sentence of English around formulas.

use num_rational::BigRational;

use super::super::raw::level::{
    AND, IFF as IFF_LEVEL, IMPLIES as IMPLIES_LEVEL, NOT, OR, RELATION, SUM, TOP,
};
use super::super::syntax::{
    Adjective, Binder, Definition, Formula, Gap, Int, Interval, Name, Over, Real, Relation, Sentence,
};
use super::form::{AT_LEAST, AT_MOST, COMMA, EQUAL, Form, GREATER, IFF, IMPLIES, LESS, Operator, UNEQUAL};
use super::term::Walk;

impl Walk {
    pub(super) fn formula(self, formula: &Formula, least: u8) -> Form {
        match formula {
            Formula::Chain(first, rest) => self.chain(first, rest).bracketed(least > RELATION),
            Formula::Within(of, within) => {
                self.inside(self.real(of, SUM), self.interval(within), least, " in ")
            }
            Formula::Among(of, from, to) => {
                self.inside(self.int(of, SUM), self.among(from, to), least, " in ")
            }
            Formula::Instance(names) => self.inside(Form::atom("U"), self.set(names), least, " in "),
            Formula::Not(of) => self.not(of).bracketed(least > NOT),
            Formula::And(all) => self.list(all, " and ", NOT).bracketed(least > AND),
            Formula::Or(all) => self.list(all, " or ", AND).bracketed(least > OR),
            Formula::Implies(a, b) if !self.source && least == TOP => Form::Row(vec![
                Form::words("if "),
                self.formula(a, OR),
                Form::words(", then "),
                self.formula(b, TOP),
            ]),
            Formula::Implies(a, b) => {
                let sides = [self.formula(a, OR), self.formula(b, IMPLIES_LEVEL)];
                Form::joined(sides, IMPLIES).bracketed(least > IMPLIES_LEVEL)
            }
            Formula::Iff(a, b) => {
                let sides = [self.formula(a, IMPLIES_LEVEL), self.formula(b, IMPLIES_LEVEL)];
                match !self.source && least == TOP {
                    true => Form::between(sides, &Form::words(" if and only if ")),
                    false => Form::joined(sides, IFF).bracketed(least > IFF_LEVEL),
                }
            }
            Formula::All(over, of) => self.quantified("all", "for all ", over, of, least),
            Formula::Some(over, of) => self.quantified("some", "for some ", over, of, least),
            Formula::One(over, of) => self.quantified("one", "for exactly one ", over, of, least),
            Formula::Word(word) => self.word(word, least),
            Formula::Claim { id, printed } if self.source => {
                Form::atom(format!("claim({id}{})", if *printed { ", printed" } else { "" }))
            }
            Formula::Claim { id, printed } => {
                let holds = if *printed { " holds as printed" } else { " holds" };
                Form::words(format!("{id}{holds}")).bracketed(least > RELATION)
            }
        }
    }

    fn list(self, all: &[Formula], word: &str, least: u8) -> Form {
        Form::between(all.iter().map(|formula| self.formula(formula, least)), &Form::words(word))
    }

    fn inside(self, what: Form, domain: Form, least: u8, word: &str) -> Form {
        Form::Row(vec![what, Form::words(word), domain]).bracketed(least > RELATION)
    }

    fn not(self, of: &Formula) -> Form {
        let inside = |what, domain| self.inside(what, domain, TOP, " not in ");
        match of {
            Formula::Within(of, within) if !self.source => inside(self.real(of, SUM), self.interval(within)),
            Formula::Among(of, from, to) if !self.source => inside(self.int(of, SUM), self.among(from, to)),
            Formula::Instance(names) if !self.source => inside(Form::atom("U"), self.set(names)),
            // In words, what is denied is put in brackets.
            other => {
                let least = if self.source { NOT } else { RELATION + 1 };
                Form::Row(vec![Form::words("not "), self.formula(other, least)])
            }
        }
    }

    /// `a = b < c`; what a word counts "is at most" something.
    fn chain(self, first: &Real, rest: &[(Relation, Real)]) -> Form {
        let word = |real: &Real| matches!(real, Real::Word(_) | Real::Whole(Int::Word(_)));
        if let (false, true, [(relation, other)]) = (self.source, word(first), rest) {
            let is = match relation {
                Relation::Equal => " is ",
                Relation::Unequal => " is not ",
                Relation::Less => " is less than ",
                Relation::AtMost => " is at most ",
                Relation::Greater => " is greater than ",
                Relation::AtLeast => " is at least ",
            };
            let other = self.real(other, if word(other) { TOP } else { SUM });
            return Form::Row(vec![self.real(first, TOP), Form::words(is), other]);
        }
        let mut row = vec![self.real(first, SUM)];
        for (relation, real) in rest {
            row.extend([Form::Operator(relation.operator()), self.real(real, SUM)]);
        }
        Form::Row(row)
    }

    pub(super) fn interval(self, interval: &Interval) -> Form {
        let open = if interval.from_closed { "[" } else { "(" };
        let close = if interval.to_closed { "]" } else { ")" };
        let ends = [&interval.from, &interval.to].map(|end| self.real(end, SUM));
        Form::fenced(open, Form::joined(ends, COMMA), close)
    }

    fn among(self, from: &Int, to: &Int) -> Form {
        let (from, to) = (self.int(from, SUM), self.int(to, SUM));
        match self.source {
            true => Form::Tight(Box::new(Form::Row(vec![from, Form::atom(".."), to]))),
            false => Form::fenced("{", Form::joined([from, Form::atom("…"), to], COMMA), "}"),
        }
    }

    fn set(self, names: &[Name]) -> Form {
        Form::fenced("{", Form::joined(names.iter().map(Form::atom), COMMA), "}")
    }

    fn quantified(self, source: &str, words: &str, over: &Over, of: &Formula, least: u8) -> Form {
        let domain = match over {
            Over::Integers(range) => self.range(range),
            Over::Reals(name, within) => {
                Form::Row(vec![self.name(name), Form::words(" in "), self.interval(within)])
            }
        };
        let body = self.formula(of, TOP);
        match self.source {
            true => self.over(source, domain, body),
            false => {
                Form::Row(vec![Form::words(words), domain, Form::words(": "), body]).bracketed(least > TOP)
            }
        }
    }

    pub(super) fn definition(self, definition: &Definition) -> Form {
        let mut head = definition.head();
        if !self.source {
            head = head.replace('[', "_{").replace(']', "}");
        }
        Form::joined([Form::atom(head), self.real(&definition.body, SUM)], EQUAL)
    }

    pub(super) fn sentence(self, sentence: &Sentence) -> Form {
        if self.source {
            let semicolon = Form::words("; ");
            let mut row =
                vec![Form::between(sentence.given.iter().map(|binder| self.binder(binder)), &semicolon)];
            let formulas =
                |all: &[Formula]| Form::between(all.iter().map(|one| self.formula(one, TOP)), &semicolon);
            if !sentence.assume.is_empty() {
                row.extend([Form::words(" | "), formulas(&sentence.assume)]);
            }
            row.extend([Form::words(" : "), formulas(&sentence.then)]);
            return Form::Row(row);
        }
        let mut row = Vec::new();
        let given = self.given(&sentence.given);
        if !given.is_empty() {
            row.extend([Form::words("For "), Form::enumerated(given)]);
        }
        if !sentence.assume.is_empty() {
            row.push(Form::words(if row.is_empty() { "If " } else { ", if " }));
            row.push(match sentence.assume.as_slice() {
                [only] if !matches!(only, Formula::And(_)) => self.formula(only, IFF_LEVEL),
                all => self.list(all, " and ", NOT),
            });
        }
        if !row.is_empty() {
            row.push(Form::words(": "));
        }
        // Only the last one may go on to the end.
        let last = sentence.then.len().saturating_sub(1);
        let then = sentence.then.iter().enumerate();
        let free = |at: usize, one: &Formula| {
            at == last && (last == 0 || !matches!(one, Formula::Implies(..) | Formula::Iff(..)))
        };
        let then = then.map(|(at, one)| self.formula(one, if free(at, one) { TOP } else { IFF_LEVEL }));
        row.extend([Form::between(then, &Form::words("; ")), Form::words(".")]);
        Form::Row(row)
    }

    /// What is said of each binder. A degree of which nothing is said is that of the knots behind it.
    fn given(self, given: &[Binder]) -> Vec<Form> {
        let plain = |at: usize| {
            matches!(given[at], Binder::Degree { least: 0, most: None })
                && matches!(given.get(at + 1), Some(Binder::Knots(_) | Binder::Gaps(_)))
        };
        let told: Vec<_> = (0..given.len()).filter(|at| !plain(*at)).map(|at| &given[at]).collect();
        let free = |binder: &Binder| matches!(binder, Binder::Real { sign: None, .. });
        let groups = told.chunk_by(|a, b| free(a) && free(b));
        groups
            .flat_map(|group| match group {
                [Binder::Real { name, sign: None }] => {
                    vec![Form::Row(vec![Form::words("every real "), self.name(name)])]
                }
                [Binder::Real { sign: None, .. }, ..] => {
                    let names = group.iter().filter_map(|binder| match binder {
                        Binder::Real { name, .. } => Some(self.name(name)),
                        _ => None,
                    });
                    vec![Form::Row(vec![Form::words("all real "), Form::joined(names, COMMA)])]
                }
                others => others.iter().map(|binder| self.binder(binder)).collect(),
            })
            .collect()
    }

    pub(super) fn binder(self, binder: &Binder) -> Form {
        let words = |words: &str, form: Form| match self.source {
            true => form,
            false => Form::Row(vec![Form::words(words), form]),
        };
        let in_ = |name: Form, domain: Form| Form::Row(vec![name, Form::words(" in "), domain]);
        match binder {
            Binder::Degree { least, most } => self.degree(*least, *most),
            Binder::Knots(adjectives) if self.source => {
                let names = adjectives.iter().map(|adjective| adjective.name());
                Form::atom(std::iter::once("U").chain(names).collect::<Vec<_>>().join(" "))
            }
            Binder::Knots(adjectives) => knots(adjectives),
            Binder::Gaps(gaps) => self.gaps(gaps),
            Binder::Instances(names) => match (self.source, names.as_slice()) {
                (false, [only]) => Form::joined([Form::atom("U"), Form::atom(only)], EQUAL),
                _ => words("every ", in_(Form::atom("U"), self.set(names))),
            },
            Binder::Indices(all) => {
                let index = |index: &Option<BigRational>| match index {
                    Some(value) => self.real(&Real::number(value.clone()), TOP),
                    None => self.real(&Real::Infinity, TOP),
                };
                let all = Form::joined(all.iter().map(index), COMMA);
                words("every ", in_(self.name("alpha"), Form::fenced("{", all, "}")))
            }
            Binder::Index(name) if self.source => Form::Row(vec![self.name(name), Form::words(" index")]),
            Binder::Index(name) => Form::Row(vec![
                Form::words("every index "),
                Form::joined([self.name(name), self.name("alpha")], UNEQUAL),
            ]),
            Binder::Integer(range) => words("every ", self.range(range)),
            Binder::Point(name, within) if !self.source && !within.from_closed && !within.to_closed => {
                let ends = [self.real(&within.from, SUM), self.name(name), self.real(&within.to, SUM)];
                Form::joined(ends, LESS)
            }
            Binder::Point(name, within) => words("every ", in_(self.name(name), self.interval(within))),
            Binder::Real { name, sign: None } => self.name(name),
            Binder::Real { name, sign: Some(sign) } => {
                words("every ", Form::joined([self.name(name), Form::atom("0")], sign.operator()))
            }
            Binder::Points(name) if self.source => Form::Row(vec![self.name(name), Form::words(" points")]),
            Binder::Points(name) => Form::Row(vec![Form::words("all control values "), self.points(name)]),
        }
    }

    fn degree(self, least: usize, most: Option<usize>) -> Form {
        let k = Form::atom("k");
        let (every, least_form) = (Form::words("every "), Form::atom(least));
        match (self.source, least, most) {
            (true, 0, None) => k,
            (true, _, None) => Form::joined([k, least_form], AT_LEAST),
            (true, _, Some(most)) if most == least => Form::joined([k, least_form], EQUAL),
            (true, _, Some(most)) => {
                Form::Row(vec![k, Form::words(" in "), least_form, Form::atom(".."), Form::atom(most)])
            }
            (false, 0, None) => Form::Row(vec![every, k]),
            (false, _, None) => Form::Row(vec![every, Form::joined([k, least_form], AT_LEAST)]),
            (false, _, Some(most)) if most == least => Form::joined([k, least_form], EQUAL),
            (false, 0, Some(most)) => Form::Row(vec![every, Form::joined([k, Form::atom(most)], AT_MOST)]),
            (false, _, Some(most)) => {
                Form::Row(vec![every, Form::joined([least_form, k, Form::atom(most)], AT_MOST)])
            }
        }
    }

    fn gaps(self, gaps: &[Gap]) -> Form {
        let gap = |gap: &Gap| match (&gap.each, self.source) {
            (None, _) => self.real(&gap.size, SUM),
            (Some(range), true) => self.over("each", self.range(range), self.real(&gap.size, TOP)),
            (Some(range), false) => Form::Row(vec![
                self.real(&gap.size, SUM),
                Form::words(" "),
                Form::fenced("(", Form::Row(vec![Form::words("for each "), self.range(range)]), ")"),
            ]),
        };
        let all = Form::joined(gaps.iter().map(gap), COMMA);
        match self.source {
            true => Form::Row(vec![Form::words("U gaps "), Form::fenced("(", all, ")")]),
            false => Form::Row(vec![Form::words("the knots U from 0 on with the gaps "), all]),
        }
    }
}

/// "every open and symmetric U with interior knots of multiplicity ≤ k".
fn knots(adjectives: &[Adjective]) -> Form {
    let (before, after): (Vec<_>, Vec<_>) = adjectives.iter().partition(|adjective| adjective.phrase().0);
    let say = |all: Vec<&Adjective>| all.iter().map(|adjective| Form::words(adjective.phrase().1)).collect();
    let mut row = vec![Form::words("every ")];
    if !before.is_empty() {
        row.extend([Form::enumerated(say(before)), Form::words(" ")]);
    }
    row.push(Form::atom("U"));
    if !after.is_empty() {
        row.extend([Form::words(" "), Form::enumerated(say(after))]);
    }
    Form::Row(row)
}

impl Adjective {
    /// Whether it stands before U, and how it is said.
    fn phrase(self) -> (bool, &'static str) {
        match self {
            Self::Open => (true, "open"),
            Self::Clamped => (true, "clamped"),
            Self::Symmetric => (true, "symmetric"),
            Self::Simple => (false, "with simple knots"),
            Self::Equidistant => (true, "equidistant"),
            Self::Bernstein => (false, "open without interior knots"),
            Self::Inner => (false, "with no knot inside of multiplicity above k"),
            Self::Interior => (false, "with interior knots of multiplicity at most k"),
        }
    }
}

impl Relation {
    fn operator(self) -> Operator {
        match self {
            Self::Equal => EQUAL,
            Self::Unequal => UNEQUAL,
            Self::Less => LESS,
            Self::AtMost => AT_MOST,
            Self::Greater => GREATER,
            Self::AtLeast => AT_LEAST,
        }
    }
}
