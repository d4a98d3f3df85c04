//! Expressions that somebody wrote, in the syntax of Maxima: what `knotproof formula --as maxima` prints, and more.

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use thiserror::Error;

use crate::scalar::{integer, parse_rational};

/// What is wrong with a text, and where.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub struct ScriptError {
    /// The number of the line, from 1.
    pub line: usize,
    /// The number of the character in it, from 1.
    pub column: usize,
    /// What was expected, or what is too much.
    pub message: String,
    /// The line as far as it can be shown, and how many characters of that stand before the place.
    shown: (String, usize),
}

/// One line: the place and the message.
impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line, self.column, self.message)
    }
}

/// Characters of a line that are shown before a place, and in all.
const SHOWN: (usize, usize) = (40, 78);

impl ScriptError {
    /// Two lines for people: the line of the text, and below it a mark at the place.
    #[must_use]
    pub fn excerpt(&self) -> String {
        let (shown, before) = &self.shown;
        let margin = format!("{} | ", self.line);
        format!("{margin}{shown}\n{:>1$}", "^", margin.len() + before + 1)
    }

    /// The error at a byte of the text.
    pub(super) fn at(text: &str, byte: usize, message: impl Into<String>) -> Self {
        let before = text.get(..byte).unwrap_or(text);
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let column = before[start..].chars().count();
        let line = text[start..].lines().next().unwrap_or_default();
        let skipped = column.saturating_sub(SHOWN.0);
        // A tab or an escape code would move the mark, or more.
        let plain = |c: char| if c.is_control() { ' ' } else { c };
        let shown = line.chars().skip(skipped).take(SHOWN.1).map(plain).collect();
        Self {
            line: before.matches('\n').count() + 1,
            column: column + 1,
            message: message.into(),
            shown: (shown, column - skipped),
        }
    }
}

/// An expression. Places are bytes of the text.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Node {
    Number(BigRational),
    X,
    /// α.
    Alpha,
    /// r = α/(α − 1).
    Ratio,
    Negative(Box<Node>),
    /// A sum; `true` is a minus before the term.
    Sum(Vec<(bool, Node)>),
    /// A product; `true` is a division by the factor, at the place.
    Product(Vec<(bool, Node, usize)>),
    Power(Box<Node>, i32),
    /// The expression of the first condition that holds, or the last one.
    Choice(Vec<(Condition, Node)>, Box<Node>),
    /// An expression with the place where it begins: what is too large is found there.
    At(usize, Box<Node>),
}

/// A condition on x.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Condition {
    /// constant + slope·x compared with 0.
    Linear {
        constant: BigRational,
        slope: BigRational,
        relation: Relation,
    },
    All(Vec<Condition>),
    Any(Vec<Condition>),
    Not(Box<Condition>),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Relation {
    Less,
    AtMost,
    Greater,
    AtLeast,
    Equal,
    Different,
}

/// One expression of a script.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// i, if it is named G_i.
    pub index: Option<usize>,
    pub(super) body: Node,
    start: usize,
}

/// Definitions `G_i(x) := …`, or one expression, which may be a chain of `if … then … elseif … then … else …`.
///
/// ```
/// use knotproof::formula::Script;
///
/// let script = Script::read("G_1(x) := if 0 <= x and x <= 1 then x/(2 - x) else 0$")?;
/// assert_eq!(script.definitions()[0].index, Some(1));
/// let error = Script::read("x/(2 - y)").expect_err("y is no letter here");
/// assert_eq!((error.line, error.column), (1, 8));
/// # Ok::<(), knotproof::formula::ScriptError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Script {
    pub(super) text: String,
    definitions: Vec<Definition>,
}

/// How deep brackets, signs, powers and choices may be nested in each other.
const DEPTH: usize = 100;
/// The largest exponent, up or down.
const EXPONENT: i32 = 100;
/// The longest number, in digits.
const DIGITS: usize = 10_000;
/// The most comparisons.
const COMPARISONS: usize = 4_000;

impl Script {
    /// Reads a text.
    ///
    /// # Errors
    /// [`ScriptError`], for the first thing that is wrong.
    pub fn read(text: &str) -> Result<Self, ScriptError> {
        let mut reader = Reader { text, at: 0, depth: 0, comparisons: 0, comparing: false };
        let mut definitions: Vec<Definition> = Vec::new();
        reader.skip()?;
        while !reader.rest().is_empty() {
            let start = reader.at;
            let definition = reader.definition()?;
            let again = definitions.iter().any(|known| known.index == definition.index);
            let alone = definition.index.is_none() && !definitions.is_empty();
            if again || alone || definitions.iter().any(|known| known.index.is_none()) {
                let message = "expected the end: one expression, or definitions G_i(x) := … with different i";
                return Err(ScriptError::at(text, start, message));
            }
            definitions.push(definition);
            if !(reader.takes("$")? || reader.takes(";")? || reader.rest().is_empty()) {
                return Err(reader.expected("an operator, `;`, `$` or the end"));
            }
        }
        if definitions.is_empty() {
            return Err(reader.expected("an expression"));
        }
        Ok(Self { text: text.to_owned(), definitions })
    }

    /// An error about a definition, at the place where it begins.
    #[must_use]
    pub fn error(&self, definition: &Definition, message: impl Into<String>) -> ScriptError {
        ScriptError::at(&self.text, definition.start, message)
    }

    /// One at least: one without an index, or several of different indices.
    #[must_use]
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    comparisons: usize,
    /// Is this inside of a condition? There is no choice then, so that going back to try a parenthesis again is cheap.
    comparing: bool,
}

type Read<T> = Result<T, ScriptError>;

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// What stands at the place, for a message.
    fn expected(&self, what: &str) -> ScriptError {
        let found = match self.rest().chars().next() {
            None => "the end of the text".to_owned(),
            Some(c) if c.is_alphanumeric() => format!("`{}`", self.word_ahead()),
            Some(c) => format!("`{}`", c.escape_default()),
        };
        let found = if found.len() > 60 { "a long word".to_owned() } else { found };
        ScriptError::at(self.text, self.at, format!("expected {what}, and found {found}"))
    }

    /// White space and comments.
    fn skip(&mut self) -> Read<()> {
        loop {
            self.at = self.text.len() - self.rest().trim_start().len();
            let Some(comment) = self.rest().strip_prefix("/*") else { return Ok(()) };
            match comment.find("*/") {
                Some(end) => self.at += end + 4,
                None => {
                    return Err(ScriptError::at(self.text, self.at, "expected `*/`: the comment has no end"));
                }
            }
        }
    }

    fn advance(&mut self, bytes: usize) -> Read<()> {
        self.at += bytes;
        self.skip()
    }

    fn takes(&mut self, sign: &str) -> Read<bool> {
        let found = self.rest().starts_with(sign);
        if found {
            self.advance(sign.len())?;
        }
        Ok(found)
    }

    fn expects(&mut self, sign: &str) -> Read<()> {
        if self.takes(sign)? { Ok(()) } else { Err(self.expected(&format!("`{sign}`"))) }
    }

    fn word_ahead(&self) -> &'a str {
        let rest = self.rest();
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        &rest[..end]
    }

    /// A whole word: `if` is not the beginning of `iffy`.
    fn takes_word(&mut self, word: &str) -> Read<bool> {
        let found = self.word_ahead() == word;
        if found {
            self.advance(word.len())?;
        }
        Ok(found)
    }

    fn expects_word(&mut self, word: &str) -> Read<()> {
        if self.takes_word(word)? { Ok(()) } else { Err(self.expected(&format!("`{word}`"))) }
    }

    /// Reads something inside of something.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        if self.depth == DEPTH {
            let message = format!("the nesting is too deep: at most {DEPTH} levels");
            return Err(ScriptError::at(self.text, self.at, message));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// `G_i(x) := …`, or an expression.
    fn definition(&mut self) -> Read<Definition> {
        let (name, start) = (self.word_ahead(), self.at);
        let Some(digits) = name.strip_prefix("G_") else {
            return Ok(Definition { index: None, body: self.expression()?, start });
        };
        let index = digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok()).flatten();
        let Some(index) = index else { return Err(self.expected("G_i with a number i")) };
        self.advance(name.len())?;
        self.expects("(")?;
        self.expects_word("x")?;
        while self.takes(",")? {
            if !(self.takes_word("alpha")? || self.takes_word("r")?) {
                return Err(self.expected("`alpha` or `r`"));
            }
        }
        self.expects(")")?;
        self.expects(":=")?;
        Ok(Definition { index: Some(index), body: self.expression()?, start })
    }

    /// A sum or a choice.
    fn expression(&mut self) -> Read<Node> {
        let start = self.at;
        if self.comparing || !self.takes_word("if")? {
            return Ok(Node::At(start, Box::new(self.sum()?)));
        }
        let mut branches = Vec::new();
        loop {
            self.comparing = true;
            let condition = self.nested(Self::alternatives)?;
            self.comparing = false;
            self.expects_word("then")?;
            branches.push((condition, self.nested(Self::expression)?));
            if self.takes_word("elseif")? {
                continue;
            }
            self.expects_word("else")?;
            let otherwise = self.nested(Self::expression)?;
            return Ok(Node::Choice(branches, Box::new(otherwise)));
        }
    }

    fn sum(&mut self) -> Read<Node> {
        let mut terms = vec![(false, self.product()?)];
        loop {
            let minus = self.rest().starts_with('-');
            if !(self.takes("+")? || self.takes("-")?) {
                break;
            }
            terms.push((minus, self.product()?));
        }
        Ok(if terms.len() == 1 { terms.remove(0).1 } else { Node::Sum(terms) })
    }

    fn product(&mut self) -> Read<Node> {
        let mut factors = vec![(false, self.signed()?, self.at)];
        loop {
            let over = self.rest().starts_with('/');
            if !(self.takes("*")? || self.takes("/")?) {
                break;
            }
            let at = self.at;
            factors.push((over, self.signed()?, at));
        }
        Ok(if factors.len() == 1 { factors.remove(0).1 } else { Node::Product(factors) })
    }

    /// −x^2 is −(x^2).
    fn signed(&mut self) -> Read<Node> {
        if self.takes("-")? {
            return Ok(Node::Negative(Box::new(self.nested(Self::signed)?)));
        }
        if self.takes("+")? {
            return self.nested(Self::signed);
        }
        let base = self.atom()?;
        if !(self.takes("^")? || self.takes("**")?) {
            return Ok(base);
        }
        let at = self.at;
        let exponent = self.nested(Self::signed)?;
        let value = linear(&exponent).filter(|(_, slope)| slope.is_zero()).map(|(constant, _)| constant);
        let Some(value) = value.filter(BigRational::is_integer) else {
            return Err(ScriptError::at(self.text, at, "expected a whole number as exponent"));
        };
        match value.to_integer().to_i32() {
            Some(e) if (-EXPONENT..=EXPONENT).contains(&e) => Ok(Node::Power(Box::new(base), e)),
            _ => {
                let message = format!("the exponent is too large: from -{EXPONENT} to {EXPONENT}");
                Err(ScriptError::at(self.text, at, message))
            }
        }
    }

    fn atom(&mut self) -> Read<Node> {
        if self.takes("(")? {
            let inside = self.nested(Self::expression)?;
            self.expects(")")?;
            return Ok(inside);
        }
        let rest = self.rest();
        let length = rest.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(rest.len());
        if length > DIGITS {
            let message = format!("the number is too long: at most {DIGITS} digits");
            return Err(ScriptError::at(self.text, self.at, message));
        }
        let number = &rest[..length];
        if number.bytes().any(|byte| byte.is_ascii_digit()) {
            let value = parse_rational(number);
            let value = value.map_err(|error| ScriptError::at(self.text, self.at, error.to_string()))?;
            self.advance(length)?;
            return Ok(Node::Number(value));
        }
        for (name, node) in [("x", Node::X), ("alpha", Node::Alpha), ("r", Node::Ratio)] {
            if self.takes_word(name)? {
                return Ok(node);
            }
        }
        Err(self.expected("a number, `x`, `alpha`, `r`, `(` or a sign"))
    }

    /// Conditions with `or`.
    fn alternatives(&mut self) -> Read<Condition> {
        let mut any = vec![self.conjunction()?];
        while self.takes_word("or")? {
            any.push(self.conjunction()?);
        }
        Ok(if any.len() == 1 { any.remove(0) } else { Condition::Any(any) })
    }

    fn conjunction(&mut self) -> Read<Condition> {
        let mut all = vec![self.condition()?];
        while self.takes_word("and")? {
            all.push(self.condition()?);
        }
        Ok(if all.len() == 1 { all.remove(0) } else { Condition::All(all) })
    }

    fn condition(&mut self) -> Read<Condition> {
        if self.takes_word("not")? {
            return Ok(Condition::Not(Box::new(self.nested(Self::condition)?)));
        }
        // A parenthesis may hold a condition, or the beginning of a sum.
        if self.rest().starts_with('(') {
            let (start, comparisons) = (self.at, self.comparisons);
            self.advance(1)?;
            if let Ok(condition) = self.nested(Self::alternatives)
                && self.takes(")")?
            {
                return Ok(condition);
            }
            (self.at, self.comparisons) = (start, comparisons);
        }
        let start = self.at;
        self.comparisons += 1;
        if self.comparisons > COMPARISONS {
            let message = format!("these are too many comparisons: at most {COMPARISONS}");
            return Err(ScriptError::at(self.text, start, message));
        }
        let left = self.nested(Self::sum)?;
        let relations = [
            ("<=", Relation::AtMost),
            (">=", Relation::AtLeast),
            ("<", Relation::Less),
            (">", Relation::Greater),
            ("=", Relation::Equal),
            ("#", Relation::Different),
        ];
        for (sign, relation) in relations {
            if self.takes(sign)? {
                let right = self.nested(Self::sum)?;
                let difference = linear(&Node::Sum(vec![(false, left), (true, right)]));
                let message = "expected numbers and x in a condition, with x to the first power";
                let (constant, slope) =
                    difference.ok_or_else(|| ScriptError::at(self.text, start, message))?;
                return Ok(Condition::Linear { constant, slope, relation });
            }
        }
        Err(self.expected("an operator, or one of <, <=, >, >=, = and #"))
    }
}

/// (a, b) with node = a + bx, if it has such a form without letters but x.
fn linear(node: &Node) -> Option<(BigRational, BigRational)> {
    let zero = || integer(0);
    match node {
        Node::Number(value) => Some((value.clone(), zero())),
        Node::X => Some((zero(), integer(1))),
        Node::Alpha | Node::Ratio | Node::Choice(..) => None,
        Node::At(_, node) => linear(node),
        Node::Negative(node) => linear(node).map(|(a, b)| (-a, -b)),
        Node::Sum(terms) => terms.iter().try_fold((zero(), zero()), |(a, b), (minus, term)| {
            let (c, d) = linear(term)?;
            Some(if *minus { (a - c, b - d) } else { (a + c, b + d) })
        }),
        Node::Product(factors) => {
            factors.iter().try_fold((integer(1), zero()), |(a, b), (over, factor, _)| {
                let (c, d) = linear(factor)?;
                match (over, d.is_zero(), b.is_zero()) {
                    (true, true, _) if !c.is_zero() => Some((a / &c, b / c)),
                    (false, true, _) => Some((a * &c, b * c)),
                    (false, _, true) => Some((&a * c, a * d)),
                    _ => None,
                }
            })
        }
        Node::Power(base, exponent) => {
            let (a, b) = linear(base).filter(|(a, b)| b.is_zero() && !(a.is_zero() && *exponent < 0))?;
            let long = a.numer().bits().max(a.denom().bits()) > 1000;
            (!long).then(|| (num_traits::Pow::pow(a, BigInt::from(*exponent)), b))
        }
    }
}

impl Condition {
    /// Does it hold at x?
    pub(super) fn holds(&self, x: &BigRational) -> bool {
        match self {
            Self::Linear { constant, slope, relation } => {
                let value = (constant + slope * x).cmp(&integer(0));
                match relation {
                    Relation::Less => value.is_lt(),
                    Relation::AtMost => value.is_le(),
                    Relation::Greater => value.is_gt(),
                    Relation::AtLeast => value.is_ge(),
                    Relation::Equal => value.is_eq(),
                    Relation::Different => value.is_ne(),
                }
            }
            Self::All(conditions) => conditions.iter().all(|condition| condition.holds(x)),
            Self::Any(conditions) => conditions.iter().any(|condition| condition.holds(x)),
            Self::Not(condition) => !condition.holds(x),
        }
    }

    /// The x at which it can change.
    fn ends(&self, ends: &mut Vec<BigRational>) {
        match self {
            Self::Linear { constant, slope, .. } if !slope.is_zero() => ends.push(-constant / slope),
            Self::Linear { .. } => {}
            Self::All(conditions) | Self::Any(conditions) => {
                conditions.iter().for_each(|condition| condition.ends(ends));
            }
            Self::Not(condition) => condition.ends(ends),
        }
    }
}

impl Node {
    /// The x at which it can pass from one expression to another.
    pub(super) fn ends(&self, ends: &mut Vec<BigRational>) {
        match self {
            Self::Number(_) | Self::X | Self::Alpha | Self::Ratio => {}
            Self::Negative(node) | Self::Power(node, _) | Self::At(_, node) => node.ends(ends),
            Self::Sum(terms) => terms.iter().for_each(|(_, term)| term.ends(ends)),
            Self::Product(factors) => factors.iter().for_each(|(_, factor, _)| factor.ends(ends)),
            Self::Choice(branches, otherwise) => {
                for (condition, node) in branches {
                    condition.ends(ends);
                    node.ends(ends);
                }
                otherwise.ends(ends);
            }
        }
    }
}
