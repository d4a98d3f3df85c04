//! Sentences: what `for` binds, under which hypotheses, and what follows.

use std::sync::Arc;

use num_rational::BigRational;
use num_traits::Zero;

use super::complaint::{Complaint, Fault, Origin, fault};
use super::known::{Kind, Known, Subjects, nearest};
use super::raw::{Domain, DomainKind, Node, Parser, Raw, RawBinder, RawSentence, Says, whole};
use super::resolve::{Named, Scope};
use super::syntax::{Adjective, Binder, Formula, Name, Range, Relation, Sentence};

impl Adjective {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Open,
        Self::Clamped,
        Self::Symmetric,
        Self::Simple,
        Self::Equidistant,
        Self::Bernstein,
        Self::Inner,
        Self::Interior,
    ];

    /// As written.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Clamped => "clamped",
            Self::Symmetric => "symmetric",
            Self::Simple => "simple",
            Self::Equidistant => "equidistant",
            Self::Bernstein => "bernstein",
            Self::Inner => "inner",
            Self::Interior => "interior",
        }
    }
}

/// Reads a sentence of three parts: the binders, and lists of hypotheses and of conclusions.
///
/// # Errors
/// The first fault, with its place in the part that it is in.
pub fn sentence(given: &str, assume: &[&str], then: &[&str], known: &Known) -> Result<Sentence, Complaint> {
    let complain = |name: String, text: &str| {
        let origin = Arc::new(Origin { name, text: text.to_owned() });
        move |fault: Fault| Complaint::new(&origin, fault.at, fault.rule, fault.advice)
    };
    let mut reader = Reader::new(known);
    let given = reader.given(given).map_err(complain("for".to_owned(), given))?;
    let mut formulas = |part: &str, texts: &[&str]| -> Result<Vec<Formula>, Complaint> {
        let read = |(at, text): (usize, &&str)| {
            reader.formula(text).map_err(complain(format!("{part} {}", at + 1), text))
        };
        texts.iter().enumerate().map(read).collect()
    };
    let assume = formulas("if", assume)?;
    Ok(Sentence { given, assume, then: formulas("then", then)? })
}

/// Reads a sentence of one line: `BINDERS : FORMULA`, or `BINDERS | HYPOTHESIS; HYPOTHESIS : FORMULA; FORMULA`.
///
/// # Errors
/// The first fault, with its place.
pub fn one_line(text: &str) -> Result<Sentence, Complaint> {
    Known::default().one_line(text)
}

impl Known {
    /// The same, where these names are known.
    ///
    /// # Errors
    /// The first fault, with its place.
    pub fn one_line(&self, text: &str) -> Result<Sentence, Complaint> {
        self.line(text, "")
    }

    /// The same where knots are given: `k; U` need not be written.
    ///
    /// # Errors
    /// The first fault, with its place.
    pub fn one_line_on_knots(&self, text: &str) -> Result<Sentence, Complaint> {
        self.line(text, "k; U")
    }

    /// Of `implied` what is needed, unless degree or knots are bound.
    fn line(&self, text: &str, implied: &str) -> Result<Sentence, Complaint> {
        let read = |raw: &RawSentence, implied| {
            let mut reader = Reader::new(self);
            let mut given = reader.given(implied)?;
            given.extend(reader.binders(&raw.given)?);
            let mut formulas = |nodes: &[Node]| -> Result<Vec<Formula>, Fault> {
                nodes.iter().map(|node| reader.scope.formula(node)).collect()
            };
            Ok(Sentence { given, assume: formulas(&raw.assume)?, then: formulas(&raw.then)? })
        };
        let read = || {
            let raw = whole(text, Parser::line)?;
            let bound = raw.given.iter().any(|binder| ["k", "U"].contains(&binder.name.as_str()));
            // A sentence about weights needs no knots.
            read(&raw, "").or_else(|fault| if bound { Err(fault) } else { read(&raw, implied) })
        };
        let origin = || Arc::new(Origin { name: "sentence".to_owned(), text: text.to_owned() });
        read().map_err(|fault: Fault| Complaint::new(&origin(), fault.at, fault.rule, fault.advice))
    }
}

/// Reads the parts of one sentence in order, the binders first.
pub(super) struct Reader<'a> {
    scope: Scope<'a>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(known: &'a Known) -> Self {
        let has = Subjects::default();
        Self { scope: Scope { known, has, defining: false, own: Vec::new(), named: Named::default() } }
    }

    /// The binders of `for`.
    pub(super) fn given(&mut self, text: &str) -> Result<Vec<Binder>, Fault> {
        self.binders(&whole(text, Parser::binders)?)
    }

    /// A hypothesis or a conclusion.
    pub(super) fn formula(&mut self, text: &str) -> Result<Formula, Fault> {
        self.scope.formula(&whole(text, Parser::expression)?)
    }

    /// What was named.
    pub(super) fn named(self) -> Named {
        self.scope.named
    }

    fn binders(&mut self, raw: &[RawBinder]) -> Result<Vec<Binder>, Fault> {
        raw.iter().map(|raw| self.binder(raw)).collect()
    }

    fn binder(&mut self, raw: &RawBinder) -> Result<Binder, Fault> {
        let of_index = raw.name == "alpha"
            || matches!(&raw.says, Says::Words(words) if words.iter().any(|(w, _)| w == "index"));
        if let (Some(family), true) = (&self.scope.known.family, of_index) {
            let rule = format!("the family {} has no index", family.name);
            return fault(&raw.at, rule, "leave the binder out: a sentence runs over the parameters");
        }
        match (raw.name.as_str(), &raw.says) {
            ("k", says) => self.degree(raw, says),
            ("U", says) => self.knots(raw, says),
            ("alpha", Says::In(domain)) => Ok(Binder::Indices(self.indices(domain)?)),
            ("alpha", _) => fault(
                &raw.at,
                "every sentence runs over `alpha`",
                "leave it out, or list indices: `alpha in {-1, 2, infinity}`; a condition stands in `if`",
            ),
            (name, Says::In(domain)) => match domain.kind {
                DomainKind::Range(..) => {
                    let (from, to) = self.scope.ends(domain)?;
                    Ok(Binder::Integer(Range { name: self.bind(raw, Kind::Int)?, from, to }))
                }
                DomainKind::Interval { .. } => {
                    let interval = self.scope.interval(domain)?;
                    Ok(Binder::Point(self.bind(raw, Kind::Real)?, interval))
                }
                DomainKind::Set(_) => fault(
                    &domain.at,
                    format!("`{name}` runs in a range or an interval"),
                    "write `0..n` or `[t[0], t[m]]`",
                ),
            },
            (_, Says::Compared(relation, node)) => {
                let zero = matches!(&node.raw, Raw::Number(text) if text == "0");
                if *relation == Relation::Equal || !zero {
                    let advice = "write `s > 0`, or `x in [a, b]`; another condition stands in `if`";
                    return fault(&node.at, "a free real is compared with 0 only", advice);
                }
                Ok(Binder::Real { name: self.bind(raw, Kind::Real)?, sign: Some(*relation) })
            }
            (_, Says::Gaps(_)) => no_gaps(raw),
            (_, Says::Words(words)) => match words.as_slice() {
                [] => Ok(Binder::Real { name: self.bind(raw, Kind::Real)?, sign: None }),
                [(word, _)] if word == "index" => Ok(Binder::Index(self.bind(raw, Kind::Index)?)),
                [(word, _)] if word == "points" => Ok(Binder::Points(self.bind(raw, Kind::Coefficients)?)),
                [(word, at), ..] => {
                    let close = nearest(word, ["index", "points"].into_iter());
                    let advice = close.map_or("write `;` between binders", |close| {
                        if close == "index" { "write `index`" } else { "write `points`" }
                    });
                    fault(at, format!("`{word}` is nothing that a name can be"), advice)
                }
            },
        }
    }

    fn bind(&mut self, raw: &RawBinder, kind: Kind) -> Result<Name, Fault> {
        self.scope.free(&raw.name, &raw.at)?;
        let name = Name::from(raw.name.as_str());
        self.scope.has.names.push((Arc::clone(&name), kind));
        Ok(name)
    }

    fn degree(&mut self, raw: &RawBinder, says: &Says) -> Result<Binder, Fault> {
        if std::mem::replace(&mut self.scope.has.degree, true) {
            return fault(&raw.at, "`k` is bound already", "write `k` once, before `U`");
        }
        let literal = |node: &Node| match &node.raw {
            Raw::Number(text) if text.parse::<usize>().is_ok() => Ok(text.parse().unwrap_or_default()),
            _ => fault(&node.at, "a degree is bounded by a number", "write `k >= 1`, `k in 1..3` or `k = 0`"),
        };
        let (least, most) = match says {
            Says::Gaps(_) => return no_gaps(raw),
            Says::Words(words) if words.is_empty() => (0, None),
            Says::Words(words) => return fault(&words[0].1, "a degree has no adjectives", "write `k; U`"),
            Says::Compared(Relation::AtLeast, node) => (literal(node)?, None),
            Says::Compared(Relation::AtMost, node) => (0, Some(literal(node)?)),
            Says::Compared(Relation::Equal, node) => (literal(node)?, Some(literal(node)?)),
            Says::Compared(_, node) => {
                return fault(&node.at, "a degree is bounded by `>=`, `<=` or `=`", "write `k >= 1`");
            }
            Says::In(Domain { kind: DomainKind::Range(from, to), at }) => {
                let (least, most) = (literal(from)?, literal(to)?);
                if most < least {
                    return fault(at, "this range is empty", format!("write `{most}..{least}`"));
                }
                (least, Some(most))
            }
            Says::In(domain) => return fault(&domain.at, "a degree runs in a range", "write `k in 1..3`"),
        };
        Ok(Binder::Degree { least, most })
    }

    fn knots(&mut self, raw: &RawBinder, says: &Says) -> Result<Binder, Fault> {
        if std::mem::replace(&mut self.scope.has.knots, true) {
            return fault(&raw.at, "`U` is bound already", "write it once");
        }
        match says {
            Says::In(Domain { kind: DomainKind::Set(names), .. }) => {
                self.scope.has.degree = true;
                self.scope.has.instance = true;
                Ok(Binder::Instances(self.scope.instances(names)?))
            }
            Says::Words(_) | Says::Gaps(_) if !self.scope.has.degree => {
                fault(&raw.at, "knots belong to a degree: n = m - k - 1", "write `k; U`")
            }
            Says::Gaps(nodes) => {
                // They may not speak of themselves.
                self.scope.has.knots = false;
                let gaps = self.scope.gaps(nodes)?;
                self.scope.has.knots = true;
                Ok(Binder::Gaps(gaps))
            }
            Says::Words(words) => {
                let mut adjectives: Vec<Adjective> = Vec::new();
                for (word, at) in words {
                    match Adjective::ALL.into_iter().find(|adjective| adjective.name() == word) {
                        Some(adjective) if !adjectives.contains(&adjective) => adjectives.push(adjective),
                        Some(_) => return fault(at, format!("`{word}` is said twice"), "say it once"),
                        None => {
                            let names = || Adjective::ALL.into_iter().map(Adjective::name);
                            let advice = match nearest(word, names()) {
                                Some(close) => format!("did you mean `{close}`?"),
                                None => format!("knots are {}", names().collect::<Vec<_>>().join(", ")),
                            };
                            return fault(at, format!("knots are not `{word}`"), advice);
                        }
                    }
                }
                adjectives.sort_unstable();
                Ok(Binder::Knots(adjectives))
            }
            Says::In(domain) => fault(
                &domain.at,
                "knots are those of instances, or any",
                "write `U in {U0, C5}`, `U` or `U open`",
            ),
            Says::Compared(_, node) => {
                fault(&node.at, "knots are no number", "write `U in {U0, C5}`, `U` or `U open`")
            }
        }
    }

    /// The indices of a list; 0 and 1 are none.
    fn indices(&mut self, domain: &Domain) -> Result<Vec<Option<BigRational>>, Fault> {
        let DomainKind::Set(all) = &domain.kind else {
            return fault(&domain.at, "`alpha` runs in a list", "write `alpha in {-1, 2, infinity}`");
        };
        let index = |node: &Node| -> Result<Option<BigRational>, Fault> {
            if matches!(&node.raw, Raw::Name { name, primes: 0 } if name == "infinity") {
                return Ok(None);
            }
            let between = |value: &BigRational| {
                *value >= BigRational::zero() && *value <= BigRational::from_integer(1.into())
            };
            match self.scope.real(node)?.literal() {
                Some(value) if !between(&value) => Ok(Some(value)),
                Some(_) => fault(&node.at, "an index is less than 0 or greater than 1", "take another one"),
                None => fault(&node.at, "a list of indices has numbers only", "write `{-1, 6/5, infinity}`"),
            }
        };
        all.iter().map(index).collect()
    }
}

fn no_gaps<T>(raw: &RawBinder) -> Result<T, Fault> {
    fault(&raw.at, "only knots have gaps", "write `U gaps (1, each(i in 1..k: 0))`")
}
