//! A sentence as a proposition of Coq, over the definitions of `proofs/theory`: U is `t`, of which `t_0, …, t_m` count, α is its
//! slope ratio `r`, G_i^d(x) is `value r t m d i x`.
//!
//! Integers are natural numbers there, in which 0 − 1 is 0, and every G_i exists. So a sentence is printed twice: what it says,
//! and that everything exists that it names (`defined`): indices are in their ranges, nothing is divided by 0.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::super::syntax::{
    Adjective, Argument, Binder, Definition, Fold, Formula, Function, Int, Interval, Item, Member, Name,
    Over, Pattern, Range, Real, Relation, Sentence, Side, Use,
};
use super::super::words::Word;

/// A sentence in Coq.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proposition {
    /// What it says.
    pub says: String,
    /// That all exists that it names; `None` if the hypotheses say so themselves.
    pub defined: Option<String>,
}

/// What the theory has no term for, in words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no term of the theory says {0}")]
pub struct NotInCoq(pub String);

type Text = Result<String, NotInCoq>;

fn not_in_coq<T>(what: impl Into<String>) -> Result<T, NotInCoq> {
    Err(NotInCoq(what.into()))
}

/// The proposition that a sentence is, with the definitions of its file put in.
///
/// # Errors
/// [`NotInCoq`], if it names what the theory does not define.
pub fn coq(sentence: &Sentence, definitions: &[Definition]) -> Result<Proposition, NotInCoq> {
    let mut walk = Walk {
        definitions,
        open: Vec::new(),
        integers: BTreeMap::new(),
        reals: BTreeMap::new(),
        names: ["r", "k", "n", "m", "t", "R"].map(str::to_owned).to_vec(),
        ratio: "r".to_owned(),
        steps: Vec::new(),
    };
    walk.bind("r : R".to_owned());
    walk.assume("0 < r".to_owned());
    for binder in &sentence.given {
        walk.binder(binder)?;
    }
    for formula in &sentence.assume {
        let assumed = walk.formula(formula, Bind::Arrow)?;
        walk.assume(assumed);
    }
    let then: Result<Vec<_>, _> = sentence.then.iter().map(|one| walk.formula(one, Bind::And)).collect();
    let conclusion = then?.join(" /\\\n  ");
    Ok(walk.proposition(&conclusion))
}

/// One step on the way to the conclusion.
#[derive(Debug, Clone)]
enum Step {
    /// `forall … ,`
    Bind(String),
    /// `… ->`
    Assume(String),
    /// What has to be so for the next steps to make sense.
    Need(String),
}

/// A sum of names and of a number, on both sides of a minus.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Linear {
    plus: Vec<String>,
    minus: Vec<String>,
    constant: i64,
}

impl Linear {
    fn number(constant: i64) -> Self {
        Self { constant, ..Self::default() }
    }

    fn name(name: &str) -> Self {
        Self { plus: vec![name.to_owned()], ..Self::default() }
    }

    fn added(mut self, other: &Self) -> Self {
        for name in &other.plus {
            match self.minus.iter().position(|own| own == name) {
                Some(at) => _ = self.minus.remove(at),
                None => self.plus.push(name.clone()),
            }
        }
        for name in &other.minus {
            match self.plus.iter().position(|own| own == name) {
                Some(at) => _ = self.plus.remove(at),
                None => self.minus.push(name.clone()),
            }
        }
        self.constant += other.constant;
        self
    }

    fn negated(&self) -> Self {
        Self { plus: self.minus.clone(), minus: self.plus.clone(), constant: -self.constant }
    }

    /// The two sides of `a <= b` as natural numbers, for `b - a`.
    fn sides(&self) -> (String, String) {
        (side(&self.minus, -self.constant), side(&self.plus, self.constant))
    }
}

/// A sum of natural numbers, with a number only if that is positive: `(i + k).+1`.
fn side(names: &[String], constant: i64) -> String {
    let sum = names.join(" + ");
    if constant == 1 && (sum == "n + k" || sum == "k + n") {
        return "m".to_owned();
    }
    match (names.len(), constant) {
        (0, constant) => constant.max(0).to_string(),
        (_, ..=0) => sum,
        (1, 1..=4) => format!("{sum}.+{constant}"),
        (_, 1..=4) => format!("({sum}).+{constant}"),
        (_, _) => format!("{sum} + {constant}"),
    }
}

/// How tightly what stands around binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Top,
    /// The right of a minus, or a summand next to one.
    Term,
    /// Next to · and /.
    Factor,
    /// An argument.
    Atom,
}

/// The same for propositions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bind {
    /// The right of an arrow.
    Top,
    /// The left of an arrow.
    Arrow,
    /// Next to `/\`.
    And,
    /// Next to `~`.
    Not,
}

fn within(inner: bool, text: String) -> String {
    if inner { format!("({text})") } else { text }
}

struct Walk<'a> {
    definitions: &'a [Definition],
    /// Definitions that are being put in: one within itself is a recursion.
    open: Vec<Name>,
    integers: BTreeMap<Name, Linear>,
    reals: BTreeMap<Name, String>,
    /// All names of Coq that are bound.
    names: Vec<String>,
    /// r, or that of another index.
    ratio: String,
    steps: Vec<Step>,
}

impl<'a> Walk<'a> {
    fn bind(&mut self, names: String) {
        self.steps.push(Step::Bind(names));
    }

    fn assume(&mut self, formula: String) {
        self.steps.push(Step::Assume(formula));
    }

    /// Asks for what has to be so, unless it is assumed already.
    fn need(&mut self, formula: String) {
        let known = |step: &Step| matches!(step, Step::Assume(own) | Step::Need(own) if *own == formula);
        if !self.steps.iter().any(known) {
            self.steps.push(Step::Need(formula));
        }
    }

    /// a ≤ b as numbers of the theory; `None` where that is so whatever the names.
    fn at_most(&self, a: &Linear, b: &Linear) -> Option<String> {
        let difference = b.clone().added(&a.negated());
        let (low, high) = difference.sides();
        (low != "0").then(|| format!("({low} <= {high})%N"))
    }

    fn need_at_most(&mut self, a: &Linear, b: &Linear) {
        if let Some(formula) = self.at_most(a, b) {
            self.need(formula);
        }
    }

    /// Both texts, from the steps.
    fn proposition(&self, conclusion: &str) -> Proposition {
        let mut says = String::new();
        for step in &self.steps {
            match step {
                Step::Bind(names) => says += &format!("forall {names},\n  "),
                Step::Assume(formula) => says += &format!("{formula} ->\n  "),
                Step::Need(_) => {}
            }
        }
        says += conclusion;
        let last = self.steps.iter().rposition(|step| matches!(step, Step::Need(_)));
        let defined = last.map(|last| {
            let mut text = String::new();
            let mut closing = 0;
            for (at, step) in self.steps[..=last].iter().enumerate() {
                match (step, self.steps[..=last].get(at + 1)) {
                    (Step::Bind(names), _) => text += &format!("forall {names},\n  "),
                    (Step::Assume(formula), _) => text += &format!("{formula} ->\n  "),
                    (Step::Need(formula), None) => text += formula,
                    (Step::Need(formula), Some(Step::Need(_))) => text += &format!("{formula} /\\ "),
                    (Step::Need(formula), Some(_)) => {
                        text += &format!("{formula} /\\ (");
                        closing += 1;
                    }
                }
            }
            text + &")".repeat(closing)
        });
        Proposition { says, defined }
    }

    /// A name of Coq that is not bound yet, for a name of the language.
    fn fresh(&mut self, name: &Name) -> String {
        let mut own = name.to_string();
        while self.names.contains(&own) {
            own.push('\'');
        }
        self.names.push(own.clone());
        own
    }

    fn binder(&mut self, of: &Binder) -> Result<(), NotInCoq> {
        match of {
            Binder::Degree { least, most } => {
                self.bind("k : nat".to_owned());
                if *least > 0 {
                    self.assume(format!("({least} <= k)%N"));
                }
                if let Some(most) = most {
                    self.assume(format!("(k <= {most})%N"));
                }
            }
            Binder::Knots(adjectives) => {
                self.bind("(n m : nat) (t : nat -> R)".to_owned());
                self.assume("m = (n + k.+1)%N".to_owned());
                self.assume("knots t m".to_owned());
                for adjective in adjectives {
                    self.assume(said_of_knots(*adjective).to_owned());
                }
            }
            Binder::Integer(range) => {
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                self.need_at_most(&Linear::default(), &from);
                let name = self.fresh(&range.name);
                self.bind(format!("{name} : nat"));
                let own = Linear::name(&name);
                self.integers.insert(range.name.clone(), own.clone());
                let ends = [self.at_most(&from, &own), self.at_most(&own, &to)];
                ends.into_iter().flatten().for_each(|end| self.assume(end));
            }
            Binder::Point(name, interval) => {
                let own = self.fresh(name);
                let inside = self.interval(&own, interval)?;
                self.bind(format!("{own} : R"));
                self.reals.insert(name.clone(), own);
                self.assume(inside);
            }
            Binder::Real { name, sign } => {
                let own = self.fresh(name);
                self.bind(format!("{own} : R"));
                self.reals.insert(name.clone(), own.clone());
                if let Some(sign) = sign {
                    self.assume(relation(*sign, &own, "0"));
                }
            }
            Binder::Points(name) => {
                let own = self.fresh(name);
                self.bind(format!("{own} : nat -> R"));
                self.reals.insert(name.clone(), own);
            }
            Binder::Gaps(_) => return not_in_coq("knots by their gaps"),
            Binder::Instances(_) | Binder::Indices(_) => return not_in_coq("which example is meant"),
            Binder::Index(_) => return not_in_coq("two indices that are free"),
        }
        Ok(())
    }

    fn linear(&mut self, of: &Int) -> Result<Linear, NotInCoq> {
        Ok(match of {
            Int::Number(number) => Linear::number(*number),
            Int::Bound(name) => match self.integers.get(name) {
                Some(known) => known.clone(),
                None => return not_in_coq(format!("the integer {name}")),
            },
            Int::Degree => Linear::name("k"),
            Int::Last => Linear::name("n"),
            Int::M => Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 },
            Int::Plus(a, b) => self.linear(a)?.added(&self.linear(b)?),
            Int::Minus(a, b) => self.linear(a)?.added(&self.linear(b)?.negated()),
            Int::Times(a, b) => {
                let (a, b) = (self.natural(a)?, self.natural(b)?);
                Linear::name(&format!("({a} * {b})"))
            }
            Int::Binomial(a, b) => {
                let (a, b) = (self.natural(a)?, self.natural(b)?);
                Linear::name(&format!("'C({a}, {b})"))
            }
            Int::Least(a, b) => Linear::name(&format!("(minn {} {})", self.index(a)?, self.index(b)?)),
            Int::Greatest(a, b) => Linear::name(&format!("(maxn {} {})", self.index(a)?, self.index(b)?)),
            Int::Word(of) => match (of.word, of.of.as_slice()) {
                (Word::Multiplicity, [Item::Real(at)]) => {
                    let at = self.real(at, Level::Atom)?;
                    Linear::name(&format!("mult t m {at}"))
                }
                _ => return not_in_coq(format!("the word {}", of.word.name())),
            },
        })
    }

    /// An integer that is used as one, and so not below 0.
    fn natural(&mut self, of: &Int) -> Text {
        let linear = self.linear(of)?;
        self.need_at_most(&Linear::default(), &linear);
        Ok(natural(&linear))
    }

    /// The same as an argument.
    fn index(&mut self, of: &Int) -> Text {
        let natural = self.natural(of)?;
        Ok(argument(&natural))
    }

    fn interval(&mut self, x: &str, of: &Interval) -> Text {
        let (from, to) = (self.real(&of.from, Level::Top)?, self.real(&of.to, Level::Top)?);
        let sign = |closed| if closed { "<=" } else { "<" };
        Ok(format!("{from} {} {x} {} {to}", sign(of.from_closed), sign(of.to_closed)))
    }

    fn real(&mut self, of: &Real, level: Level) -> Text {
        Ok(match of {
            Real::Number(value) => number(value, level),
            Real::Whole(int) => {
                let linear = self.linear(int)?;
                whole(&linear, level)
            }
            // What stands for a name is an argument as it is.
            Real::Bound(name) => match self.reals.get(name) {
                Some(known) => known.clone(),
                None => return not_in_coq(format!("the number {name}")),
            },
            Real::Index(name) if &**name == "alpha" => {
                let r = self.ratio.clone();
                self.need(format!("{r} - 1 != 0"));
                within(level > Level::Term, format!("{r} / ({r} - 1)"))
            }
            Real::Index(_) | Real::Infinity => return not_in_coq("an index as a number"),
            Real::Ratio => self.ratio.clone(),
            Real::Knot(i) => {
                let (at, m) = (
                    self.linear(i)?,
                    Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 },
                );
                self.need_at_most(&at, &m);
                within(level == Level::Atom, format!("t {}", self.index(i)?))
            }
            Real::Coefficient(name, indices) => match (self.reals.get(name).cloned(), indices.as_slice()) {
                (Some(d), [i]) => {
                    let at = self.linear(i)?;
                    self.need_at_most(&at, &Linear::name("n"));
                    within(level == Level::Atom, format!("{d} {}", self.index(i)?))
                }
                _ => return not_in_coq("coordinates of points"),
            },
            Real::Parameter(..) => return not_in_coq("a parameter of a family"),
            Real::Plus(a, b) => {
                let (a, b) = (self.real(a, Level::Top)?, self.real(b, Level::Term)?);
                within(level > Level::Top, format!("{a} + {b}"))
            }
            Real::Minus(a, b) => {
                let (a, b) = (self.real(a, Level::Top)?, self.real(b, Level::Term)?);
                within(level > Level::Top, format!("{a} - {b}"))
            }
            Real::Times(a, b) => {
                let (a, b) = (self.real(a, Level::Term)?, self.real(b, Level::Factor)?);
                within(level > Level::Term, format!("{a} * {b}"))
            }
            Real::Over(a, b) => {
                let (a, b) = (self.real(a, Level::Term)?, self.real(b, Level::Factor)?);
                self.need(format!("{b} != 0 :> R"));
                within(level > Level::Term, format!("{a} / {b}"))
            }
            Real::Negated(a) => {
                let a = self.real(a, Level::Factor)?;
                within(level > Level::Top, format!("- {a}"))
            }
            Real::Power(a, e) => {
                let (a, e) = (self.real(a, Level::Atom)?, self.index(e)?);
                within(level > Level::Factor, format!("{a} ^+ {e}"))
            }
            Real::Absolute(a) => format!("`|{}|", self.real(a, Level::Top)?),
            Real::Root(_) => return not_in_coq("a root"),
            Real::Least(a, b) => {
                let (a, b) = (self.real(a, Level::Atom)?, self.real(b, Level::Atom)?);
                within(level == Level::Atom, format!("Num.min {a} {b}"))
            }
            Real::Greatest(a, b) => {
                let (a, b) = (self.real(a, Level::Atom)?, self.real(b, Level::Atom)?);
                within(level == Level::Atom, format!("Num.max {a} {b}"))
            }
            Real::Fold(fold, range, body) => {
                let sign = match fold {
                    Fold::Sum => "\\sum",
                    Fold::Product => "\\prod",
                    Fold::Least | Fold::Greatest => return not_in_coq("the greatest of a range"),
                };
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                let below = to.clone().added(&Linear::number(1));
                let first = self.natural(&range.from)?;
                let (name, body) = self.scoped(range, (&from, &to), |walk| walk.real(body, Level::Term))?;
                // Below its first number the range is empty, there as here.
                within(
                    level > Level::Top,
                    format!("{sign}_({first} <= {name} < {}) {body}", truncated(&below)),
                )
            }
            Real::Defined(name, indices) => self.defined(name, indices, None, level)?,
            Real::Value(function, argument) => self.value(function, argument, level)?,
            Real::Word(of) => return not_in_coq(format!("the word {}", of.word.name())),
        })
    }

    /// What is made within a range of integers; what it needs, it needs for each of them.
    fn scoped<T>(
        &mut self,
        range: &Range,
        (from, to): (&Linear, &Linear),
        make: impl FnOnce(&mut Self) -> Result<T, NotInCoq>,
    ) -> Result<(String, T), NotInCoq> {
        let name = self.fresh(&range.name);
        let own = Linear::name(&name);
        let before = self.integers.insert(range.name.clone(), own.clone());
        let ends: Vec<_> = [self.at_most(from, &own), self.at_most(&own, to)].into_iter().flatten().collect();
        let made = self.under(&format!("{name} : nat"), &ends, make)?;
        match before {
            Some(before) => _ = self.integers.insert(range.name.clone(), before),
            None => _ = self.integers.remove(&range.name),
        }
        self.names.retain(|bound| *bound != name);
        Ok((name, made))
    }

    /// The same under a name, if there is one, and assumptions: what is needed becomes one need.
    fn under<T>(
        &mut self,
        name: &str,
        assumed: &[String],
        make: impl FnOnce(&mut Self) -> Result<T, NotInCoq>,
    ) -> Result<T, NotInCoq> {
        let outside = self.steps.len();
        self.steps.extend(assumed.iter().cloned().map(Step::Assume));
        let inside = self.steps.len();
        let made = make(self)?;
        let needs: Vec<String> = self
            .steps
            .drain(outside..)
            .skip(inside - outside)
            .map(|step| match step {
                Step::Need(formula) | Step::Assume(formula) | Step::Bind(formula) => formula,
            })
            .collect();
        if !needs.is_empty() {
            let forall = if name.is_empty() { String::new() } else { format!("forall {name}, ") };
            let assumed: String = assumed.iter().map(|one| format!("{one} -> ")).collect();
            self.need(format!("({forall}{assumed}{})", needs.join(" /\\ ")));
        }
        Ok(made)
    }

    /// A definition of the file, with its indices and its argument put in.
    fn defined(&mut self, name: &Name, indices: &[Int], at: Option<String>, level: Level) -> Text {
        if self.open.contains(name) {
            return not_in_coq(format!("the recursion of {name}"));
        }
        let values: Result<Vec<_>, _> = indices.iter().map(|index| self.linear(index)).collect();
        let values = values?;
        let fits = |definition: &&Definition| {
            definition.name == *name
                && definition.indices.iter().zip(&values).all(|(pattern, value)| match pattern {
                    Pattern::Any(_) => true,
                    Pattern::Number(number) => *value == Linear::number(*number),
                })
        };
        let definitions: &'a [Definition] = self.definitions;
        let several = definitions.iter().filter(|definition| definition.name == *name).count() > 1;
        let Some(definition) = definitions.iter().find(fits).filter(|_| !several) else {
            return not_in_coq(format!("the recursion of {name}"));
        };
        let (integers, reals) = (self.integers.clone(), self.reals.clone());
        for (pattern, value) in definition.indices.iter().zip(values) {
            if let Pattern::Any(own) = pattern {
                self.integers.insert(own.clone(), value);
            }
        }
        if let Some((variable, at)) = definition.variable.as_ref().zip(at) {
            self.reals.insert(variable.clone(), at);
        }
        self.open.push(name.clone());
        let body = self.real(&definition.body, level);
        self.open.pop();
        (self.integers, self.reals) = (integers, reals);
        body
    }

    fn value(&mut self, function: &Function, argument: &Argument, level: Level) -> Text {
        let before = self.ratio.clone();
        let at = self.real(&argument.at, Level::Atom)?;
        if let Some(member) = &argument.member {
            self.ratio = self.member(member)?;
        }
        let text = self.at(function, &at, argument.side, level);
        self.ratio = before;
        text
    }

    /// The slope ratio of another index. α/(α − 1) of 1 − α is the inverse of that of α, 1 − ∞ = ∞ included.
    fn member(&mut self, of: &Member) -> Text {
        match of {
            Member::Ratio(ratio) => self.real(ratio, Level::Atom),
            Member::Dual => Ok(inverse(&self.ratio)),
            Member::Index(Real::Infinity) => Ok("1".to_owned()),
            Member::Index(Real::Minus(one, alpha))
                if is_one(one) && matches!(&**alpha, Real::Index(name) if &**name == "alpha") =>
            {
                Ok(inverse(&self.ratio))
            }
            Member::Index(Real::Index(name)) if &**name == "alpha" => Ok(self.ratio.clone()),
            Member::Index(other) => {
                let alpha = self.real(other, Level::Atom)?;
                self.need(format!("{alpha} - 1 != 0"));
                Ok(format!("({alpha} / ({alpha} - 1))"))
            }
            Member::Parameter(..) => not_in_coq("a parameter of a family"),
        }
    }

    fn at(&mut self, function: &Function, x: &str, side: Option<Side>, level: Level) -> Text {
        let r = self.ratio.clone();
        let text = match (function, side) {
            (Function::Basis { i, degree }, _) => {
                let name = match side {
                    None => "value",
                    Some(Side::Left) => "Gleft",
                    Some(Side::Right) => "Gright",
                };
                let (d, i) = self.basis(i, degree.as_ref())?;
                format!("{name} {r} t m {d} {i} {x}")
            }
            (Function::Weight { i, degree }, None) => {
                let (d, i) = self.weight(i, degree)?;
                format!("wt {r} t {d} {i} {x}")
            }
            (Function::Phi { cut, from, to }, None) => {
                let (a, b) = (self.real(from, Level::Atom)?, self.real(to, Level::Atom)?);
                if !cut {
                    self.need(format!("{r} * ({x} - {a}) + ({b} - {x}) != 0"));
                }
                format!("{} {r} {x} {a} {b}", if *cut { "phi" } else { "mob" })
            }
            (Function::Defined(name, indices), None) => {
                return self.defined(name, indices, Some(x.to_owned()), level);
            }
            (Function::Derivative(of, Int::Number(1)), Some(side)) => match &**of {
                Function::Basis { i, degree } => {
                    let name = if side == Side::Left { "DGleft" } else { "DGright" };
                    let (d, i) = self.basis(i, degree.as_ref())?;
                    format!("{name} {r} t m {d} {i} {x}")
                }
                Function::Weight { i, degree } => {
                    let name = if side == Side::Left { "wDleft" } else { "wDright" };
                    let (d, i) = self.weight(i, degree)?;
                    format!("{name} {r} t {d} {i} {x}")
                }
                Function::Defined(name, indices) => return self.slope(name, indices, x, side, level),
                _ => return not_in_coq("the derivative of a weight from D2.3"),
            },
            (Function::Derivative(..), _) => {
                return not_in_coq("a derivative that is not one of order 1 from one side");
            }
            (_, Some(_)) => return not_in_coq("the limit of a weight or of a curve"),
        };
        Ok(within(level == Level::Atom, text))
    }

    /// d and i of G_i^d, which exists for d ≤ k and i + d < m.
    fn basis(&mut self, i: &Int, degree: Option<&Int>) -> Result<(String, String), NotInCoq> {
        let degree = degree.unwrap_or(&Int::Degree);
        let (d, at) = (self.linear(degree)?, self.linear(i)?);
        self.need_at_most(&d, &Linear::name("k"));
        self.need_at_most(&at.added(&d), &Linear { plus: vec!["n".into(), "k".into()], ..Linear::default() });
        Ok((self.index(degree)?, self.index(i)?))
    }

    /// d and i of w_i^d, which exists for 1 ≤ d ≤ k and i + d ≤ m.
    fn weight(&mut self, i: &Int, degree: &Int) -> Result<(String, String), NotInCoq> {
        let (d, at) = (self.linear(degree)?, self.linear(i)?);
        self.need_at_most(&Linear::number(1), &d);
        self.need_at_most(&d, &Linear::name("k"));
        let m = Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 };
        self.need_at_most(&at.added(&d), &m);
        Ok((self.index(degree)?, self.index(i)?))
    }

    fn formula(&mut self, of: &Formula, level: Bind) -> Text {
        Ok(match of {
            Formula::Chain(first, rest) => self.chain(first, rest, level)?,
            Formula::Within(x, interval) => {
                let x = self.real(x, Level::Top)?;
                let inside = self.interval(&x, interval)?;
                within(level == Bind::Not, inside)
            }
            Formula::Among(j, from, to) => {
                let (j, from, to) = (self.linear(j)?, self.linear(from)?, self.linear(to)?);
                let ends: Vec<_> =
                    [self.at_most(&from, &j), self.at_most(&j, &to)].into_iter().flatten().collect();
                within(ends.len() > 1, ends.join(" /\\ "))
            }
            Formula::Not(of) => format!("~ {}", self.formula(of, Bind::Not)?),
            Formula::And(all) => {
                let all: Result<Vec<_>, _> = all.iter().map(|one| self.formula(one, Bind::And)).collect();
                within(level > Bind::Top, all?.join(" /\\ "))
            }
            Formula::Or(all) => {
                let all: Result<Vec<_>, _> = all.iter().map(|one| self.formula(one, Bind::And)).collect();
                within(level > Bind::Top, all?.join(" \\/ "))
            }
            Formula::Implies(a, b) => {
                let a = self.formula(a, Bind::Arrow)?;
                let b = self.under("", std::slice::from_ref(&a), |walk| walk.formula(b, Bind::Top))?;
                within(level > Bind::Top, format!("{a} -> {b}"))
            }
            Formula::Iff(a, b) => {
                let (a, b) = (self.formula(a, Bind::And)?, self.formula(b, Bind::And)?);
                within(level > Bind::Top, format!("{a} <-> {b}"))
            }
            Formula::All(over, of) => {
                let (bound, assumed, of) = self.quantified(over, of, Bind::Top)?;
                let assumed: String = assumed.iter().map(|one| format!("{one} -> ")).collect();
                within(level > Bind::Top, format!("forall {bound}, {assumed}{of}"))
            }
            Formula::Some(over, of) => {
                let (bound, assumed, of) = self.quantified(over, of, Bind::And)?;
                let assumed: String = assumed.iter().map(|one| format!("{one} /\\ ")).collect();
                within(level > Bind::Top, format!("exists {bound}, {assumed}{of}"))
            }
            Formula::One(..) => return not_in_coq("that there is exactly one"),
            Formula::Word(of) => self.word(of, level)?,
            Formula::Instance(_) => return not_in_coq("which example is meant"),
            Formula::Claim { id, .. } => return not_in_coq(format!("the sentence {id}")),
        })
    }

    fn quantified(
        &mut self,
        over: &Over,
        of: &Formula,
        level: Bind,
    ) -> Result<(String, Vec<String>, String), NotInCoq> {
        match over {
            Over::Integers(range) => {
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                self.need_at_most(&Linear::default(), &from);
                let (name, of) = self.scoped(range, (&from, &to), |walk| walk.formula(of, level))?;
                let own = Linear::name(&name);
                let ends =
                    [self.at_most(&from, &own), self.at_most(&own, &to)].into_iter().flatten().collect();
                Ok((format!("{name} : nat"), ends, of))
            }
            Over::Reals(name, interval) => {
                let own = self.fresh(name);
                let inside = self.interval(&own, interval)?;
                let before = self.reals.insert(name.clone(), own.clone());
                let bound = format!("{own} : R");
                let of = self.under(&bound, std::slice::from_ref(&inside), |walk| walk.formula(of, level))?;
                self.unbind(name, &own, before);
                Ok((bound, vec![inside], of))
            }
        }
    }

    /// Of equalities every pair is meant; that neighbours are equal says as much where everything exists.
    fn chain(&mut self, first: &Real, rest: &[(Relation, Real)], level: Bind) -> Text {
        let terms: Vec<&Real> = std::iter::once(first).chain(rest.iter().map(|(_, term)| term)).collect();
        let mut parts = Vec::new();
        if let [Real::Index(name), other] = terms.as_slice() {
            if &**name == "alpha" && matches!(other, Real::Infinity) {
                return Ok(within(level == Bind::Not, relation(rest[0].0, &self.ratio, "1")));
            }
        }
        if let ([Real::Whole(Int::Word(of)), Real::Whole(dimension)], [(Relation::Equal, _)]) =
            (terms.as_slice(), rest)
        {
            if let (Word::Rank, [Item::Int(degree)]) = (of.word, of.of.as_slice()) {
                return Ok(within(level > Bind::Top, self.independent(degree, dimension)?));
            }
        }
        if terms.iter().all(|term| matches!(term, Real::Whole(_))) {
            let mut values = Vec::new();
            for term in &terms {
                if let Real::Whole(int) = term {
                    values.push(self.linear(int)?);
                }
            }
            for ((sign, _), pair) in rest.iter().zip(values.windows(2)) {
                parts.push(compared(*sign, &pair[0], &pair[1]));
            }
        } else {
            let mut values = Vec::new();
            for term in &terms {
                values.push(self.real(term, Level::Top)?);
            }
            // a <= b < c is one term there.
            let rising = |sign: &Relation| matches!(sign, Relation::Less | Relation::AtMost);
            if let ([(one, _), (other, _)], [a, b, c]) = (rest, values.as_slice()) {
                if rising(one) && rising(other) {
                    return Ok(within(
                        level == Bind::Not,
                        format!("{a} {} {b} {} {c}", sign_of(*one), sign_of(*other)),
                    ));
                }
            }
            for ((sign, _), pair) in rest.iter().zip(values.windows(2)) {
                parts.push(relation(*sign, &pair[0], &pair[1]));
            }
        }
        let several = parts.len() > 1;
        Ok(within((several && level > Bind::Top) || level == Bind::Not, parts.join(" /\\ ")))
    }

    /// The words that the theory defines.
    fn word(&mut self, of: &Use, level: Bind) -> Text {
        match (of.word, of.of.as_slice()) {
            (Word::Rational, [Item::Expression(of, variable, Some(interval))]) => {
                self.on_interval("rational_on", of, variable, interval, level)
            }
            (Word::Smooth, [Item::Expression(of, variable, Some(interval))]) => {
                self.on_interval("smooth", of, variable, interval, level)
            }
            (Word::Defined, [Item::Real(Real::Value(function, at))]) => {
                let exists = self.expansion(function, at)?;
                Ok(within(level > Bind::Top, exists))
            }
            (other, _) => not_in_coq(format!("the word {}", other.name())),
        }
    }

    /// A property of a function on an open interval.
    fn on_interval(
        &mut self,
        property: &str,
        of: &Real,
        variable: &Name,
        interval: &Interval,
        level: Bind,
    ) -> Text {
        if interval.from_closed || interval.to_closed {
            return not_in_coq("that on a closed interval");
        }
        let (from, to) = (self.real(&interval.from, Level::Atom)?, self.real(&interval.to, Level::Atom)?);
        let own = self.fresh(variable);
        let inside = self.interval(&own, interval)?;
        let before = self.reals.insert(variable.clone(), own.clone());
        let bound = format!("{own} : R");
        let body = self.under(&bound, std::slice::from_ref(&inside), |walk| walk.real(of, Level::Top))?;
        self.unbind(variable, &own, before);
        Ok(within(level == Bind::Not, format!("{property} {from} {to} (fun {own} => {body})")))
    }

    /// That a limit or a derivative from one side exists: the function has an expansion there.
    fn expansion(&mut self, function: &Function, at: &Argument) -> Text {
        let basis = match function {
            Function::Derivative(of, Int::Number(1)) => of,
            other => other,
        };
        let (Function::Basis { i, degree }, Some(side), None) = (basis, at.side, &at.member) else {
            return not_in_coq("that this exists");
        };
        let (x, (d, i)) = (self.real(&at.at, Level::Atom)?, self.basis(i, degree.as_ref())?);
        let side = if side == Side::Left { "left" } else { "right" };
        let r = &self.ratio;
        Ok(format!("exists v l : R, {side}_taylor (G (wt {r} t) t {d} {i}) {x} v l"))
    }

    /// The derivative from one side of a definition of the file, which is linear in functions of the basis.
    fn slope(&mut self, name: &Name, indices: &[Int], x: &str, side: Side, level: Level) -> Text {
        let definitions: &'a [Definition] = self.definitions;
        let mut own = definitions.iter().filter(|definition| definition.name == *name);
        let (Some(definition), None, []) = (own.next(), own.next(), indices) else {
            return not_in_coq("the derivative of a definition with indices");
        };
        let Some(variable) = &definition.variable else { return Ok("0".to_owned()) };
        self.linear_slope(&definition.body, variable, x, side, level)
    }

    fn linear_slope(&mut self, of: &Real, variable: &Name, x: &str, side: Side, level: Level) -> Text {
        match of {
            Real::Fold(Fold::Sum, range, body) => {
                let (from, to) = (self.linear(&range.from)?, self.linear(&range.to)?);
                let below = to.clone().added(&Linear::number(1));
                let first = self.natural(&range.from)?;
                let slope = |walk: &mut Self| walk.linear_slope(body, variable, x, side, Level::Term);
                let (name, body) = self.scoped(range, (&from, &to), slope)?;
                let text = format!("\\sum_({first} <= {name} < {}) {body}", truncated(&below));
                Ok(within(level > Level::Top, text))
            }
            Real::Times(factor, of) if matches!(&**factor, Real::Coefficient(..)) => {
                let factor = self.real(factor, Level::Term)?;
                let slope = self.linear_slope(of, variable, x, side, Level::Factor)?;
                Ok(within(level > Level::Term, format!("{factor} * {slope}")))
            }
            Real::Value(function, at) if matches!(&**at, Argument { at: Real::Bound(name), side: None, member: None } if name == variable) =>
            {
                let slope = Function::Derivative(function.clone(), Int::Number(1));
                self.at(&slope, x, Some(side), level)
            }
            _ => not_in_coq("the derivative of this curve"),
        }
    }

    /// Forgets a real name that was bound.
    fn unbind(&mut self, name: &Name, own: &str, before: Option<String>) {
        match before {
            Some(before) => _ = self.reals.insert(name.clone(), before),
            None => _ = self.reals.remove(name),
        }
        self.names.retain(|bound| bound != own);
    }

    /// That the functions of a degree have as many dimensions as there are of them.
    fn independent(&mut self, degree: &Int, dimension: &Int) -> Text {
        let (d, wanted) = (self.linear(degree)?, self.linear(dimension)?);
        let count = Linear { plus: vec!["n".into(), "k".into()], minus: Vec::new(), constant: 1 };
        let count = count.added(&d.negated());
        if wanted.clone().added(&count.negated()) != Linear::default() {
            return not_in_coq("a dimension below the number of functions");
        }
        let (r, degree) = (self.ratio.clone(), self.index(degree)?);
        self.need_at_most(&d, &Linear::name("k"));
        let below = truncated(&count);
        Ok(format!(
            "forall c : nat -> R, (forall x : R, t 0%N <= x <= t m -> \\sum_(0 <= i < {below}) c i * value {r} t m {degree} i x = 0) -> forall i : nat, (i < {below})%N -> c i = 0"
        ))
    }
}

fn said_of_knots(adjective: Adjective) -> &'static str {
    match adjective {
        Adjective::Open => "Uopen t n k",
        Adjective::Clamped => "Uclamped t n k",
        Adjective::Symmetric => "Usymmetric t n k",
        Adjective::Simple => "Usimple t m",
        Adjective::Equidistant => "Uequidistant t m",
        Adjective::Bernstein => "Ubernstein t n k",
        Adjective::Inner => "Uinner t n k",
        Adjective::Interior => "Uinterior t n k",
    }
}

/// A number that is not below 0.
fn natural(of: &Linear) -> String {
    match of {
        of if of.minus.is_empty() && of.constant >= 0 => side(&of.plus, of.constant),
        _ => truncated(of),
    }
}

/// A difference of natural numbers, 0 if it is below that.
fn truncated(of: &Linear) -> String {
    let (low, high) = of.sides();
    match (low.as_str(), of.minus.len()) {
        ("0", _) => high,
        (_, 0..=1) if !low.contains(' ') => format!("{high} - {low}"),
        _ => format!("{high} - ({low})"),
    }
}

/// A natural number as an argument, where the scope is that of reals.
fn argument(natural: &str) -> String {
    let is_name = |text: &str| text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'');
    let (stem, successor) = natural.split_once(".+").unwrap_or((natural, "1"));
    if natural.chars().all(|c| c.is_ascii_digit()) {
        format!("{natural}%N")
    } else if is_name(stem) && is_name(successor) {
        natural.to_owned()
    } else {
        format!("({natural})%N")
    }
}

/// An integer as a real: `k%:R - 1`.
fn whole(of: &Linear, level: Level) -> String {
    let real =
        |name: &String| format!("{}%:R", if name.contains(' ') { format!("({name})") } else { name.clone() });
    let literal = |number: u64| if number < 2 { number.to_string() } else { format!("{number}%:R") };
    let number = literal(of.constant.unsigned_abs());
    let mut sum: Vec<String> = of.plus.iter().map(real).collect();
    if of.constant > 0 || sum.is_empty() && of.minus.is_empty() && of.constant == 0 {
        sum.push(number.clone());
    }
    let mut text = sum.join(" + ");
    let mut taken: Vec<String> = of.minus.iter().map(real).collect();
    if of.constant < 0 {
        taken.push(number);
    }
    for one in &taken {
        text += &if text.is_empty() { format!("- {one}") } else { format!(" - {one}") };
    }
    let atoms = sum.len() + taken.len();
    within(level > Level::Top && (atoms > 1 || !taken.is_empty()), text)
}

fn number(value: &BigRational, level: Level) -> String {
    let literal = |number: &num_bigint::BigInt| {
        if number.is_zero() || number.is_one() { number.to_string() } else { format!("{number}%:R") }
    };
    let text = match value.denom().is_one() {
        true => literal(&value.numer().abs()),
        false => format!("{} / {}", literal(&value.numer().abs()), literal(value.denom())),
    };
    match value.is_negative() {
        true => within(level > Level::Top, format!("- ({text})")),
        false => within(level > Level::Term && text.contains(' '), text),
    }
}

fn is_one(of: &Real) -> bool {
    matches!(of, Real::Whole(Int::Number(1)))
}

fn inverse(ratio: &str) -> String {
    format!("{ratio}^-1")
}

fn sign_of(sign: Relation) -> &'static str {
    match sign {
        Relation::Equal => "=",
        Relation::Unequal => "!=",
        Relation::Less | Relation::Greater => "<",
        Relation::AtMost | Relation::AtLeast => "<=",
    }
}

/// > and ≥ are read from the right.
fn relation(sign: Relation, a: &str, b: &str) -> String {
    match sign {
        Relation::Greater | Relation::AtLeast => format!("{b} {} {a}", sign_of(sign)),
        _ => format!("{a} {} {b}", sign_of(sign)),
    }
}

/// Two integers, each side without a minus.
fn compared(sign: Relation, a: &Linear, b: &Linear) -> String {
    let (a, b) = match sign {
        Relation::Greater | Relation::AtLeast => (b, a),
        _ => (a, b),
    };
    let (low, high) = b.clone().added(&a.negated()).sides();
    format!("({low} {} {high})%N", sign_of(sign))
}
