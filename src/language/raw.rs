//! Tokens → a raw tree with places: brackets and precedence, no names and no types.

use super::complaint::{Fault, Place, fault};
use super::syntax::{Fold, Relation, Side};
use super::token::{Token, tokens};

/// A deeper tree is refused: everything after it walks down by recursion.
const DEEPEST: usize = 64;
/// How deep the parser itself goes: a bracket and an operator in it are one level of the tree each.
const RECURSION: usize = 2 * DEEPEST;

/// A part of a text.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) at: Place,
    pub(super) raw: Raw,
    depth: usize,
}

#[derive(Debug)]
pub(super) enum Raw {
    Number(String),
    Name {
        name: String,
        primes: usize,
    },
    Index {
        of: Box<Node>,
        by: Vec<Node>,
    },
    Call {
        of: Box<Node>,
        with: Vec<Given>,
    },
    Negated(Box<Node>),
    Infix(Infix, Box<Node>, Box<Node>),
    Chain(Box<Node>, Vec<(Relation, Node)>),
    In(Box<Node>, Box<Domain>),
    Not(Box<Node>),
    And(Vec<Node>),
    Or(Vec<Node>),
    /// sum, all, …, of a name in a domain.
    Over {
        what: Quantity,
        name: String,
        name_at: Place,
        domain: Box<Domain>,
        body: Box<Node>,
    },
    Claim {
        id: String,
        printed: bool,
    },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Infix {
    Plus,
    Minus,
    Times,
    Over,
    Power,
    Implies,
    Iff,
}

/// What is made of all terms or formulas of a domain.
#[derive(Debug, Clone, Copy)]
pub(super) enum Quantity {
    Fold(Fold),
    All,
    Some,
    One,
    /// In a list of gaps only.
    Each,
}

/// What stands in the brackets behind a name.
#[derive(Debug)]
pub(super) struct Given {
    pub(super) node: Node,
    pub(super) side: Option<Side>,
    /// `alpha = …`, `r = …`, or a word alone: `dual`.
    pub(super) member: Option<RawMember>,
}

/// A name, its place, and what it is to be.
pub(super) type RawMember = (String, Place, Option<Node>);

#[derive(Debug)]
pub(super) struct Domain {
    pub(super) at: Place,
    pub(super) kind: DomainKind,
}

#[derive(Debug)]
pub(super) enum DomainKind {
    Range(Node, Node),
    Interval { from: Node, from_closed: bool, to: Node, to_closed: bool },
    Set(Vec<Node>),
}

/// A name of `for` with what is said of it.
#[derive(Debug)]
pub(super) struct RawBinder {
    pub(super) name: String,
    pub(super) at: Place,
    pub(super) says: Says,
}

#[derive(Debug)]
pub(super) enum Says {
    /// `open symmetric`, `index`, `points`, or nothing.
    Words(Vec<(String, Place)>),
    In(Domain),
    Compared(Relation, Node),
    /// `U gaps (1, each(i in 1..k: 0))`.
    Gaps(Vec<Node>),
}

/// The head of a definition: `b[i,q](x)`, `C(x)`, `c`.
#[derive(Debug)]
pub(super) struct Head {
    pub(super) name: String,
    pub(super) at: Place,
    pub(super) indices: Vec<Node>,
    pub(super) variable: Option<(String, Place)>,
}

/// How tight an operator binds its sides, for the parser and for what is printed.
pub(super) mod level {
    pub(in super::super) const TOP: u8 = 0;
    pub(in super::super) const IFF: u8 = 1;
    pub(in super::super) const IMPLIES: u8 = 2;
    pub(in super::super) const OR: u8 = 3;
    pub(in super::super) const AND: u8 = 4;
    pub(in super::super) const NOT: u8 = 5;
    pub(in super::super) const RELATION: u8 = 6;
    pub(in super::super) const SUM: u8 = 7;
    /// What is on the right of + and −.
    pub(in super::super) const TERM: u8 = 8;
    pub(in super::super) const PRODUCT: u8 = 9;
    /// What is on the right of · and /.
    pub(in super::super) const FACTOR: u8 = 10;
    pub(in super::super) const POWER: u8 = 11;
    pub(in super::super) const ATOM: u8 = 12;
}

use level::{AND, FACTOR, IFF, IMPLIES, NOT, OR, POWER, PRODUCT, RELATION, SUM, TERM};

pub(super) struct Parser<'a> {
    tokens: Vec<(Token<'a>, Place)>,
    next: usize,
    depth: usize,
}

type Parsed<T> = Result<T, Fault>;

/// The whole text is one of these.
pub(super) fn whole<'a, T>(text: &'a str, what: fn(&mut Parser<'a>) -> Parsed<T>) -> Parsed<T> {
    let mut parser = Parser { tokens: tokens(text)?, next: 0, depth: 0 };
    let read = what(&mut parser)?;
    match parser.peek() {
        Token::End => Ok(read),
        _ => parser.unexpected("the end, or an operator"),
    }
}

impl<'a> Parser<'a> {
    fn peek(&self) -> Token<'a> {
        self.tokens[self.next].0
    }

    fn after(&self) -> Token<'a> {
        self.tokens.get(self.next + 1).map_or(Token::End, |(token, _)| *token)
    }

    /// Where the next token is.
    fn here(&self) -> Place {
        self.tokens[self.next].1.clone()
    }

    /// From a byte to the end of what was read last.
    fn since(&self, start: usize) -> Place {
        start..self.tokens[self.next.saturating_sub(1)].1.end.max(start)
    }

    fn advance(&mut self) -> Token<'a> {
        let token = self.peek();
        self.next = (self.next + 1).min(self.tokens.len() - 1);
        token
    }

    fn sign(&mut self, sign: &str) -> bool {
        let found = self.peek() == Token::Sign(sign);
        if found {
            self.advance();
        }
        found
    }

    fn word(&mut self, word: &str) -> bool {
        let found = self.peek() == Token::Name(word, 0);
        if found {
            self.advance();
        }
        found
    }

    fn unexpected<T>(&self, expected: &str) -> Parsed<T> {
        let (found, advice) = match self.peek() {
            Token::Number(text) => (format!("`{text}`"), "a product is written with `*`"),
            Token::Name(name, _) | Token::Claim(name) => {
                (format!("`{name}`"), "a product is written with `*`")
            }
            Token::Sign(sign) => (
                format!("`{sign}`"),
                match sign {
                    ")" | "]" | "}" => "no bracket is open here that it would close",
                    ";" => "only binders and the formulas of a line are separated by `;`",
                    _ => "something is missing before it, or it is too much",
                },
            ),
            Token::End => ("the end".to_owned(), "complete it"),
        };
        fault(&self.here(), format!("expected {expected}, found {found}"), advice)
    }

    fn close(&mut self, close: &str, open: &Place) -> Parsed<()> {
        if self.sign(close) {
            return Ok(());
        }
        let Err(mut fault) = self.unexpected::<()>(&format!("`{close}`")) else { return Ok(()) };
        fault.advice = format!("close the bracket that is opened at character {}", open.start + 1);
        Err(fault)
    }

    /// One level deeper for as long as `read` reads.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth == RECURSION {
            return fault(&self.here(), format!("nested deeper than {DEEPEST}"), TOO_DEEP);
        }
        self.depth += 1;
        let read = read(self);
        self.depth -= 1;
        read
    }

    fn node(&self, start: usize, raw: Raw) -> Parsed<Node> {
        let at = self.since(start);
        let depth = 1 + raw.deepest();
        if depth > DEEPEST {
            return fault(&at, format!("nested deeper than {DEEPEST}"), TOO_DEEP);
        }
        Ok(Node { at, raw, depth })
    }

    /// A term or a formula; which of them it has to be is asked later.
    pub(super) fn expression(&mut self) -> Parsed<Node> {
        self.binding(IFF)
    }

    /// An expression whose operators bind at least as tight.
    fn binding(&mut self, least: u8) -> Parsed<Node> {
        self.nested(|parser| {
            let first = parser.prefix(least)?;
            parser.infix(first, least)
        })
    }

    /// A sign takes a product, −a·b, but behind an operator a factor only, a·−b·c.
    fn prefix(&mut self, least: u8) -> Parsed<Node> {
        let at = self.here();
        if self.word("not") {
            let of = self.binding(NOT)?;
            return self.node(at.start, Raw::Not(Box::new(of)));
        }
        if self.sign("-") {
            let of = self.binding(least.max(PRODUCT))?;
            return self.node(at.start, Raw::Negated(Box::new(of)));
        }
        let atom = self.atom()?;
        self.postfix(atom)
    }

    fn infix(&mut self, mut left: Node, least: u8) -> Parsed<Node> {
        loop {
            let Some(operator) = self.operator() else { return Ok(left) };
            let (binds, right) = operator.binding();
            if binds < least {
                return Ok(left);
            }
            let start = left.at.start;
            let raw = match operator {
                Operator::Infix(infix) => {
                    self.advance();
                    let right = Box::new(self.binding(right)?);
                    Raw::Infix(infix, Box::new(left), right)
                }
                Operator::Relation(_) => {
                    let mut rest = Vec::new();
                    while let Some(Operator::Relation(relation)) = self.operator() {
                        self.advance();
                        rest.push((relation, self.binding(right)?));
                    }
                    Raw::Chain(Box::new(left), rest)
                }
                Operator::And => Raw::And(self.list("and", left, right)?),
                Operator::Or => Raw::Or(self.list("or", left, right)?),
                Operator::In => {
                    self.advance();
                    Raw::In(Box::new(left), Box::new(self.domain()?))
                }
            };
            left = self.node(start, raw)?;
            if binds == IFF && matches!(self.operator(), Some(Operator::Infix(Infix::Iff))) {
                return fault(&self.here(), "`<=>` joins two formulas", "put two of the three in brackets");
            }
        }
    }

    fn list(&mut self, word: &str, first: Node, binds: u8) -> Parsed<Vec<Node>> {
        let mut all = vec![first];
        while self.word(word) {
            all.push(self.binding(binds)?);
        }
        Ok(all)
    }

    /// What the next token joins. A sign before `)`, `,` or `;` is a side.
    fn operator(&self) -> Option<Operator> {
        let side = || matches!(self.after(), Token::Sign(")" | "," | ";"));
        let infix = |infix| Some(Operator::Infix(infix));
        match self.peek() {
            Token::Sign("+") if !side() => infix(Infix::Plus),
            Token::Sign("-") if !side() => infix(Infix::Minus),
            Token::Sign("*") => infix(Infix::Times),
            Token::Sign("/") => infix(Infix::Over),
            Token::Sign("^") => infix(Infix::Power),
            Token::Sign("=>") => infix(Infix::Implies),
            Token::Sign("<=>") => infix(Infix::Iff),
            Token::Sign(sign) => relation(sign).map(Operator::Relation),
            Token::Name("and", 0) => Some(Operator::And),
            Token::Name("or", 0) => Some(Operator::Or),
            Token::Name("in", 0) => Some(Operator::In),
            _ => None,
        }
    }

    fn atom(&mut self) -> Parsed<Node> {
        let at = self.here();
        let raw = match self.peek() {
            Token::Number(text) => {
                self.advance();
                Raw::Number(text.to_owned())
            }
            Token::Claim(id) => {
                self.advance();
                let printed = self.sign(",");
                if printed && !self.word("printed") {
                    return self.unexpected("`printed`");
                }
                self.close(")", &at)?;
                Raw::Claim { id: id.to_owned(), printed }
            }
            Token::Name("and" | "or" | "in", _) => return self.unexpected("a term or a formula"),
            Token::Name(name, primes) => match (Quantity::named(name), self.tokens.get(self.next + 2)) {
                (Some(what), Some((Token::Name(..), _)))
                    if self.after() == Token::Sign("(")
                        && matches!(self.tokens.get(self.next + 3), Some((Token::Name("in", 0), _))) =>
                {
                    self.over(what)?
                }
                _ => {
                    self.advance();
                    Raw::Name { name: name.to_owned(), primes }
                }
            },
            Token::Sign("(") => {
                self.advance();
                let mut inner = self.expression()?;
                self.close(")", &at)?;
                inner.at = self.since(at.start);
                inner.depth += 1;
                return Ok(inner);
            }
            _ => return self.unexpected("a term or a formula"),
        };
        self.node(at.start, raw)
    }

    /// sum(i in 0..n: …) and the like, at the word.
    fn over(&mut self, what: Quantity) -> Parsed<Raw> {
        self.advance();
        let open = self.here();
        self.advance();
        let (name, name_at) = self.name()?;
        self.advance();
        let domain = Box::new(self.domain()?);
        if !self.sign(":") {
            return self.unexpected("`:` and what runs");
        }
        let body = Box::new(self.expression()?);
        self.close(")", &open)?;
        Ok(Raw::Over { what, name, name_at, domain, body })
    }

    fn name(&mut self) -> Parsed<(String, Place)> {
        let at = self.here();
        match self.peek() {
            Token::Name(name, 0) => {
                self.advance();
                Ok((name.to_owned(), at))
            }
            _ => self.unexpected("a name"),
        }
    }

    fn postfix(&mut self, mut of: Node) -> Parsed<Node> {
        loop {
            let (start, open) = (of.at.start, self.here());
            let raw = if self.sign("[") {
                let by = self.separated()?;
                self.close("]", &open)?;
                Raw::Index { of: Box::new(of), by }
            } else if matches!(of.raw, Raw::Name { .. } | Raw::Index { .. } | Raw::Call { .. })
                && self.sign("(")
            {
                let mut with = Vec::new();
                if self.peek() != Token::Sign(")") {
                    with.push(self.given()?);
                }
                while self.sign(",") {
                    with.push(self.given()?);
                }
                self.close(")", &open)?;
                Raw::Call { of: Box::new(of), with }
            } else {
                return Ok(of);
            };
            of = self.node(start, raw)?;
        }
    }

    fn separated(&mut self) -> Parsed<Vec<Node>> {
        let mut all = vec![self.expression()?];
        while self.sign(",") {
            all.push(self.expression()?);
        }
        Ok(all)
    }

    fn given(&mut self) -> Parsed<Given> {
        let node = self.expression()?;
        let side = match (self.sign("-"), self.sign("+")) {
            (true, _) => Some(Side::Left),
            (_, true) => Some(Side::Right),
            _ => None,
        };
        if !self.sign(";") {
            return Ok(Given { node, side, member: None });
        }
        let (name, at) = self.name()?;
        let value = match (name.as_str(), self.sign("=")) {
            (_, true) => Some(self.binding(SUM)?),
            ("dual", false) => None,
            _ => return self.unexpected("`=`"),
        };
        Ok(Given { node, side, member: Some((name, at, value)) })
    }

    fn domain(&mut self) -> Parsed<Domain> {
        let open = self.here();
        let kind = if self.sign("{") {
            let all = self.separated()?;
            self.close("}", &open)?;
            DomainKind::Set(all)
        } else {
            let bracket = self.sign("[");
            let paren = !bracket && self.sign("(");
            let mut from = self.binding(SUM)?;
            if (bracket || paren) && self.sign(",") {
                let to = self.binding(SUM)?;
                let to_closed = self.sign("]");
                if !to_closed {
                    self.close(")", &open)?;
                }
                DomainKind::Interval { from, from_closed: bracket, to, to_closed }
            } else {
                if bracket {
                    return self.unexpected("`,` and the other end of the interval");
                }
                if paren {
                    self.close(")", &open)?;
                    from.at = self.since(open.start);
                    from = self.infix(from, SUM)?;
                }
                if !self.sign("..") {
                    let Err(mut fault) = self.unexpected::<()>("`..`") else {
                        return self.unexpected("`..`");
                    };
                    fault.advice = "integers run in `0..n`, reals in `[a, b]` or `(a, b)`".to_owned();
                    return Err(fault);
                }
                DomainKind::Range(from, self.binding(SUM)?)
            }
        };
        Ok(Domain { at: self.since(open.start), kind })
    }

    /// A binder of `for`.
    fn binder(&mut self) -> Parsed<RawBinder> {
        let (name, at) = self.name()?;
        let says = if self.word("in") {
            Says::In(self.domain()?)
        } else if let Some(Operator::Relation(relation)) = self.operator() {
            self.advance();
            Says::Compared(relation, self.binding(SUM)?)
        } else if self.word("gaps") {
            let open = self.here();
            if !self.sign("(") {
                return self.unexpected("`(` and the gaps");
            }
            let gaps = self.separated()?;
            self.close(")", &open)?;
            Says::Gaps(gaps)
        } else {
            let mut words = Vec::new();
            while let Token::Name(..) = self.peek() {
                words.push(self.name()?);
            }
            Says::Words(words)
        };
        Ok(RawBinder { name, at, says })
    }

    /// The binders of `for`, with `;` between them; there may be none.
    pub(super) fn binders(&mut self) -> Parsed<Vec<RawBinder>> {
        let mut all = Vec::new();
        if matches!(self.peek(), Token::End | Token::Sign(":" | "|")) {
            return Ok(all);
        }
        loop {
            all.push(self.binder()?);
            if !self.sign(";") {
                return Ok(all);
            }
        }
    }

    /// Formulas with `;` between them.
    fn formulas(&mut self) -> Parsed<Vec<Node>> {
        let mut all = vec![self.expression()?];
        while self.sign(";") {
            all.push(self.expression()?);
        }
        Ok(all)
    }

    /// `BINDERS | HYPOTHESES : FORMULAS`.
    pub(super) fn line(&mut self) -> Parsed<RawSentence> {
        let given = self.binders()?;
        let assume = if self.sign("|") { self.formulas()? } else { Vec::new() };
        if !self.sign(":") {
            return self.unexpected("`;` and another binder, `|` and a hypothesis, or `:` and the formula");
        }
        Ok(RawSentence { given, assume, then: self.formulas()? })
    }

    /// The head of a definition.
    pub(super) fn head(&mut self) -> Parsed<Head> {
        let (name, at) = self.name()?;
        let open = self.here();
        let mut indices = Vec::new();
        if self.sign("[") {
            indices = self.separated()?;
            self.close("]", &open)?;
        }
        let open = self.here();
        let mut variable = None;
        if self.sign("(") {
            variable = Some(self.name()?);
            self.close(")", &open)?;
        }
        Ok(Head { name, at, indices, variable })
    }
}

/// A sentence before its names are looked up.
pub(super) struct RawSentence {
    pub(super) given: Vec<RawBinder>,
    pub(super) assume: Vec<Node>,
    pub(super) then: Vec<Node>,
}

const TOO_DEEP: &str = "name a part of it in `define`, or say it in several formulas";

fn relation(sign: &str) -> Option<Relation> {
    Some(match sign {
        "=" => Relation::Equal,
        "!=" => Relation::Unequal,
        "<" => Relation::Less,
        "<=" => Relation::AtMost,
        ">" => Relation::Greater,
        ">=" => Relation::AtLeast,
        _ => return None,
    })
}

#[derive(Debug, Clone, Copy)]
enum Operator {
    Infix(Infix),
    Relation(Relation),
    And,
    Or,
    In,
}

impl Operator {
    /// How tight it binds, and how tight what is on its right has to.
    fn binding(self) -> (u8, u8) {
        match self {
            Self::Infix(Infix::Iff) => (IFF, IMPLIES),
            Self::Infix(Infix::Implies) => (IMPLIES, IMPLIES),
            Self::Or => (OR, AND),
            Self::And => (AND, NOT),
            Self::Relation(_) | Self::In => (RELATION, SUM),
            Self::Infix(Infix::Plus | Infix::Minus) => (SUM, TERM),
            Self::Infix(Infix::Times | Infix::Over) => (PRODUCT, FACTOR),
            // A sign may stand in an exponent, x^-1, which is read as a prefix.
            Self::Infix(Infix::Power) => (POWER, POWER),
        }
    }
}

impl Quantity {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "sum" => Self::Fold(Fold::Sum),
            "prod" => Self::Fold(Fold::Product),
            "min" => Self::Fold(Fold::Least),
            "max" => Self::Fold(Fold::Greatest),
            "all" => Self::All,
            "some" => Self::Some,
            "one" => Self::One,
            "each" => Self::Each,
            _ => return None,
        })
    }
}

impl Raw {
    /// The depth of its deepest part.
    fn deepest(&self) -> usize {
        let parts: Vec<&Node> = match self {
            Self::Number(_) | Self::Name { .. } | Self::Claim { .. } => Vec::new(),
            Self::Negated(of) | Self::Not(of) => vec![of],
            Self::Infix(_, left, right) => vec![left, right],
            Self::And(nodes) | Self::Or(nodes) => nodes.iter().collect(),
            Self::Index { of, by } => by.iter().chain([&**of]).collect(),
            Self::Call { of, with } => {
                let members = with.iter().filter_map(|given| given.member.as_ref()?.2.as_ref());
                with.iter().map(|given| &given.node).chain(members).chain([&**of]).collect()
            }
            Self::Chain(first, rest) => rest.iter().map(|(_, node)| node).chain([&**first]).collect(),
            Self::In(node, domain) => domain.parts().chain([&**node]).collect(),
            Self::Over { domain, body, .. } => domain.parts().chain([&**body]).collect(),
        };
        parts.into_iter().map(|node| node.depth).max().unwrap_or(0)
    }
}

impl Domain {
    fn parts(&self) -> impl Iterator<Item = &Node> {
        let (ends, set) = match &self.kind {
            DomainKind::Range(from, to) | DomainKind::Interval { from, to, .. } => (vec![from, to], &[][..]),
            DomainKind::Set(all) => (Vec::new(), all.as_slice()),
        };
        ends.into_iter().chain(set)
    }
}
