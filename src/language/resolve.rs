//! Raw tree → typed tree: what every name means, and whether it may stand where it stands.

use std::sync::Arc;

use super::complaint::{Fault, Place, ensure, fault};
use super::known::{Kind, Known, Subjects, Vocabulary, nearest};
use super::raw::{Domain, DomainKind, Infix, Node, Quantity, Raw};
use super::syntax::{Formula, Function, Gap, Int, Interval, Name, Over, Range, Real, Relation};
use super::words::Word;

/// Greater exponents and orders of derivatives are refused where they are literals.
const GREATEST_EXPONENT: u64 = 1000;

/// The names in force while a text is read.
pub(super) struct Scope<'a> {
    pub(super) known: &'a Known,
    /// What of the case may be spoken of; in a definition, what is.
    pub(super) has: Subjects,
    /// In a definition, whoever uses it has to bind what is free in it.
    pub(super) defining: bool,
    /// Names bound inside of a formula, and a definition's own.
    pub(super) own: Vec<(Name, Kind)>,
    /// Definitions and claims that were named, and where.
    pub(super) named: Named,
}

/// What a text names of other texts.
#[derive(Debug, Default)]
pub(super) struct Named {
    pub(super) definitions: Vec<(Name, Vec<Int>, Place)>,
    pub(super) claims: Vec<(Name, Place)>,
}

/// A node with its type.
pub(super) enum Typed {
    Int(Int),
    Real(Real),
    Infinity,
    Formula(Formula),
    Function(Function),
    Coefficients(Name),
}

pub(super) type Resolved<T> = Result<T, Fault>;

impl Typed {
    pub(super) fn what(&self) -> &'static str {
        match self {
            Self::Int(_) => "an integer",
            Self::Real(_) => "a real number",
            Self::Infinity => "infinity",
            Self::Formula(_) => "a formula",
            Self::Function(_) => "a function",
            Self::Coefficients(_) => "the name of control values",
        }
    }

    pub(super) fn of(real: Real) -> Self {
        match real {
            Real::Whole(int) => Self::Int(int),
            real => Self::Real(real),
        }
    }

    pub(super) fn real(self, at: &Place) -> Resolved<Real> {
        let advice = match self {
            Self::Int(int) => return Ok(Real::Whole(int)),
            Self::Real(real) => return Ok(real),
            Self::Infinity => "it stands only beside an index: `alpha = infinity`".to_owned(),
            Self::Function(_) => "give it a point: `(x)`, or `(x-)` for a limit".to_owned(),
            Self::Coefficients(ref name) => format!("write `{name}[i]`"),
            Self::Formula(_) => "check the brackets".to_owned(),
        };
        fault(at, format!("expected a number, this is {}", self.what()), advice)
    }
}

impl Scope<'_> {
    pub(super) fn int(&mut self, node: &Node) -> Resolved<Int> {
        match self.typed(node)? {
            Typed::Int(int) => Ok(int),
            other => {
                let advice = "indices and ends of `a..b` are made of integers, k, n, m and names that run over integers";
                fault(&node.at, format!("expected an integer, this is {}", other.what()), advice)
            }
        }
    }

    pub(super) fn real(&mut self, node: &Node) -> Resolved<Real> {
        self.typed(node)?.real(&node.at)
    }

    pub(super) fn formula(&mut self, node: &Node) -> Resolved<Formula> {
        match self.typed(node)? {
            Typed::Formula(formula) => Ok(formula),
            other => {
                let rule = format!("expected a formula, this is {}", other.what());
                fault(&node.at, rule, "compare it with something: `= 0`, `> 0`")
            }
        }
    }

    fn formulas(&mut self, nodes: &[Node]) -> Resolved<Vec<Formula>> {
        nodes.iter().map(|node| self.formula(node)).collect()
    }

    fn ints(&mut self, nodes: &[Node]) -> Resolved<Vec<Int>> {
        nodes.iter().map(|node| self.int(node)).collect()
    }

    pub(super) fn typed(&mut self, node: &Node) -> Resolved<Typed> {
        Ok(match &node.raw {
            Raw::Number(text) => number(text, &node.at)?,
            Raw::Name { name, primes } => self.name(name, *primes, &node.at)?,
            Raw::Index { of, by } => self.indexed(of, by, &node.at)?,
            Raw::Call { of, with } => self.call(of, with, &node.at)?,
            Raw::Negated(of) => Typed::of(self.real(of)?.negated()),
            Raw::Infix(infix @ (Infix::Implies | Infix::Iff), left, right) => {
                let (left, right) = (Box::new(self.formula(left)?), Box::new(self.formula(right)?));
                Typed::Formula(match infix {
                    Infix::Implies => Formula::Implies(left, right),
                    _ => Formula::Iff(left, right),
                })
            }
            Raw::Infix(infix, left, right) => self.arithmetic(*infix, left, right)?,
            Raw::Chain(first, rest) => Typed::Formula(self.chain(first, rest)?),
            Raw::In(of, domain) => Typed::Formula(self.within(of, domain)?),
            Raw::Not(of) => Typed::Formula(Formula::Not(Box::new(self.formula(of)?))),
            Raw::And(all) => Typed::Formula(Formula::And(self.formulas(all)?)),
            Raw::Or(all) => Typed::Formula(Formula::Or(self.formulas(all)?)),
            Raw::Over { what, name, name_at, domain, body } => {
                self.over(*what, name, name_at, domain, body)?
            }
            Raw::Claim { id, printed } => {
                if let Some(claims) = &self.known.claims {
                    let advice = meant(id, claims.iter().map(|id| &**id));
                    let known = claims.contains(id.as_str());
                    ensure(known, &node.at, format!("no claim is called `{id}`"), advice)?;
                }
                let id = Name::from(id.as_str());
                self.named.claims.push((Arc::clone(&id), node.at.clone()));
                Typed::Formula(Formula::Claim { id, printed: *printed })
            }
        })
    }

    /// The parameter of the family with these indices; `None`, if the name is another one.
    fn parameter(&mut self, name: &str, by: &[Node], at: &Place) -> Resolved<Option<Typed>> {
        let known = self.known;
        let Some(family) = &known.family else { return Ok(None) };
        let Some((own, of)) = family.parameters.iter().find(|(own, _)| **own == *name) else {
            if matches!(name, "alpha" | "r" | "infinity") && self.find(name).is_none() {
                let rule = format!("the family {} has no `{name}`", family.name);
                return fault(at, rule, format!("it has {}", family.has()));
            }
            return Ok(None);
        };
        if by.len() != of.len() {
            let head = Vocabulary::head(own, of);
            return fault(at, format!("`{name}` has another number of indices"), format!("write `{head}`"));
        }
        Ok(Some(Typed::Real(Real::Parameter(Arc::clone(own), self.ints(by)?))))
    }

    /// In the file of a family there are numbers only: no functions that its weights make.
    pub(super) fn in_file(&self, name: &str, at: &Place) -> Resolved<()> {
        let made = matches!(name, "G" | "w" | "P" | "D" | "phi" | "f" | "abs" | "sqrt" | "min" | "max")
            || Word::ALL.iter().any(|word| word.name() == name);
        let allowed = !(made && self.known.family.as_ref().is_some_and(|family| family.in_file));
        let advice =
            "use numbers, x, a, b, i, d, s, k, t[i], parameters, definitions, + - * / ^, `sum`, `prod`";
        ensure(allowed, at, format!("`{name}` is nothing that weights are made of"), advice)
    }

    fn name(&mut self, name: &str, primes: usize, at: &Place) -> Resolved<Typed> {
        self.in_file(name, at)?;
        if primes == 0
            && let Some(parameter) = self.parameter(name, &[], at)?
        {
            return Ok(parameter);
        }
        if primes > 0 {
            return Ok(Typed::Function(derived(self.function_name(name, at)?, primes, at)?));
        }
        Ok(match name {
            "k" => {
                self.need_degree(at)?;
                Typed::Int(Int::Degree)
            }
            "n" | "m" => {
                self.need_knots(name, at)?;
                Typed::Int(if name == "n" { Int::Last } else { Int::M })
            }
            "alpha" if self.known.family.is_none() => Typed::Real(Real::Index(name.into())),
            "r" if self.known.family.is_none() => Typed::Real(Real::Ratio),
            "infinity" => Typed::Infinity,
            _ => match self.find(name) {
                Some((name, Kind::Int)) => Typed::Int(Int::Bound(name)),
                Some((name, Kind::Real)) => Typed::Real(Real::Bound(name)),
                Some((name, Kind::Index)) => Typed::Real(Real::Index(name)),
                Some((name, Kind::Coefficients)) => Typed::Coefficients(name),
                None => return self.unbound(name, at),
            },
        })
    }

    /// What has bound a name.
    fn find(&self, name: &str) -> Option<(Name, Kind)> {
        let mut bound = self.own.iter().chain(&self.has.names);
        bound.find(|(bound, _)| **bound == *name).map(|(name, kind)| (Arc::clone(name), *kind))
    }

    /// A name that nothing has bound: a definition, or in one a free real; else it is told what was meant.
    fn unbound(&mut self, name: &str, at: &Place) -> Resolved<Typed> {
        if let Some(defined) = self.defined(name, &[], at)? {
            return Ok(defined);
        }
        let file = self.known.family.as_ref().is_some_and(|family| family.in_file);
        if self.defining && !file && !is_reserved(name) {
            self.has.names.push((name.into(), Kind::Real));
            return Ok(Typed::Real(Real::Bound(name.into())));
        }
        self.unknown(name, at)
    }

    fn unknown<T>(&self, name: &str, at: &Place) -> Resolved<T> {
        const WHOLE: &[(&str, &str)] = &[
            ("U", "t[i]"),
            ("t", "t[i]"),
            ("G", "G[i](x)"),
            ("w", "w[i,d](x)"),
            ("P", "P[i,1]"),
            ("D", "D(G[i], 2)(x)"),
            ("phi", "phi(x, a, b)"),
            ("f", "f(x, a, b)"),
            ("sum", "sum(i in 0..n: …)"),
            ("prod", "prod(i in 0..n: …)"),
            ("all", "all(i in 0..n: …)"),
            ("some", "some(i in 0..n: …)"),
            ("one", "one(i in 0..n: …)"),
        ];
        if let Some((_, form)) = WHOLE.iter().find(|(word, _)| *word == name) {
            return fault(
                at,
                format!("`{name}` stands here without what belongs to it"),
                format!("write `{form}`"),
            );
        }
        let bound = self.own.iter().chain(&self.has.names).map(|(name, _)| &**name);
        let family = self.known.family.iter().flat_map(|family| &family.parameters);
        let bound = bound.chain(family.map(|(name, _)| &**name));
        let defined = self.known.definitions.iter().map(|definition| &*definition.name);
        let words = Word::ALL.iter().map(|word| word.name());
        let advice = match nearest(name, bound.chain(defined).chain(words).chain(RESERVED.iter().copied())) {
            Some(close) => format!("did you mean `{close}`?"),
            None if self.known.family.as_ref().is_some_and(|family| family.in_file) => {
                "make it a parameter, or define it in `define`".to_owned()
            }
            None => "bind it in `for`, or define it in `define`".to_owned(),
        };
        fault(at, format!("nothing is called `{name}` here"), advice)
    }

    fn need(
        &mut self,
        of: fn(&mut Subjects) -> &mut bool,
        at: &Place,
        rule: String,
        advice: &str,
    ) -> Resolved<()> {
        let has = of(&mut self.has);
        *has |= self.defining;
        ensure(*has, at, rule, advice)
    }

    fn need_degree(&mut self, at: &Place) -> Resolved<()> {
        self.need(|has| &mut has.degree, at, "`k` is not bound".to_owned(), "begin `for` with `k`")
    }

    fn need_knots(&mut self, name: &str, at: &Place) -> Resolved<()> {
        self.need(|has| &mut has.knots, at, format!("`{name}` needs knots"), "bind them in `for`: `k; U`")
    }

    fn need_instance(&mut self, name: &str, at: &Place) -> Resolved<()> {
        let rule = format!("`{name}` needs an instance of the paper");
        self.need(|has| &mut has.instance, at, rule, "bind it in `for`: `U in {…}`")
    }

    /// A definition with these indices, if it is one.
    fn defined(&mut self, name: &str, by: &[Node], at: &Place) -> Resolved<Option<Typed>> {
        let known = self.known;
        let named: Vec<_> = known.definitions.iter().filter(|definition| *definition.name == *name).collect();
        let Some(first) = named.first() else { return Ok(None) };
        if first.indices.len() != by.len() {
            return fault(
                at,
                format!("`{name}` is defined with {} indices, here are {}", first.indices.len(), by.len()),
                format!("write `{}`", first.head()),
            );
        }
        let needs = known.subjects(name);
        if needs.degree {
            self.need_degree(at)?;
        }
        if needs.knots {
            self.need_knots(name, at)?;
        }
        if needs.instance {
            self.need_instance(name, at)?;
        }
        for (needed, kind) in &needs.names {
            let bound = self.has.names.iter().find(|(bound, _)| bound == needed).map(|(_, kind)| *kind);
            match bound {
                Some(bound) if bound == *kind => {}
                None if self.defining => self.has.names.push((Arc::clone(needed), *kind)),
                _ => {
                    let advice = match kind {
                        Kind::Coefficients => format!("bind it in `for`: `{needed} points`"),
                        _ => format!("bind it in `for`: `{needed}`"),
                    };
                    return fault(at, format!("the definition of `{name}` speaks of `{needed}`"), advice);
                }
            }
        }
        let function = first.variable.is_some();
        let (name, by) = (Arc::clone(&first.name), self.ints(by)?);
        self.named.definitions.push((Arc::clone(&name), by.clone(), at.clone()));
        Ok(Some(match function {
            true => Typed::Function(Function::Defined(name, by)),
            false => Typed::Real(Real::Defined(name, by)),
        }))
    }

    /// A name that is said without indices and derived: `C'`.
    fn function_name(&mut self, name: &str, at: &Place) -> Resolved<Function> {
        match self.defined(name, &[], at)? {
            Some(Typed::Function(function)) => Ok(function),
            _ => {
                fault(at, format!("`{name}` is no function"), "a prime stands behind a function: `G'[i](x)`")
            }
        }
    }

    fn indexed(&mut self, of: &Node, by: &[Node], at: &Place) -> Resolved<Typed> {
        let Raw::Name { name, primes } = &of.raw else {
            return fault(at, "indices stand behind a name", "write them in one bracket: `G[i,d]`");
        };
        ensure(name != "U", &of.at, "`U` has no indices", "a knot is `t[i]`")?;
        self.in_file(name, &of.at)?;
        if let Some(parameter) = self.parameter(name, by, at)? {
            return no_prime(*primes, &of.at).map(|()| parameter);
        }
        let several = |least: usize, most: usize, form: &str| {
            let right = (least..=most).contains(&by.len());
            ensure(right, at, format!("`{name}` has another number of indices"), format!("write `{form}`"))
        };
        let function = match name.as_str() {
            "t" => {
                self.need_knots("t", &of.at)?;
                several(1, 1, "t[i]")?;
                no_prime(*primes, &of.at)?;
                return Ok(Typed::Real(Real::Knot(self.place(&by[0])?)));
            }
            "G" => {
                self.need_knots("G", &of.at)?;
                several(1, 2, "G[i]` or `G[i,d]")?;
                Function::Basis {
                    i: self.place(&by[0])?,
                    degree: by.get(1).map(|d| self.place(d)).transpose()?.filter(|d| *d != Int::Degree),
                }
            }
            "w" => {
                self.need_knots("w", &of.at)?;
                several(2, 2, "w[i,d]")?;
                Function::Weight { i: self.place(&by[0])?, degree: self.place(&by[1])? }
            }
            "P" => {
                self.need_instance("P", &of.at)?;
                several(2, 2, "P[i,1]` or `P[i,2]")?;
                no_prime(*primes, &of.at)?;
                let (i, c) = (self.place(&by[0])?, self.int(&by[1])?);
                let coordinate = !matches!(c, Int::Number(c) if !(1..=2).contains(&c));
                let rule = "a point of the plane has the coordinates 1 and 2";
                ensure(coordinate, &by[1].at, rule, "write `P[i,1]` or `P[i,2]`")?;
                return Ok(Typed::Real(Real::Coefficient("P".into(), vec![i, c])));
            }
            name => match self.find(name) {
                Some((name, Kind::Coefficients)) => {
                    several(1, 1, &format!("{name}[i]"))?;
                    no_prime(*primes, &of.at)?;
                    return Ok(Typed::Real(Real::Coefficient(name, vec![self.place(&by[0])?])));
                }
                Some((name, _)) => {
                    let rule = format!("`{name}` is a number, it has no indices");
                    return fault(&of.at, rule, "a product is written with `*`");
                }
                None => match self.defined(name, by, at)? {
                    Some(Typed::Function(function)) => function,
                    Some(other) => return no_prime(*primes, &of.at).map(|()| other),
                    None if self.defining
                        && !self.known.family.as_ref().is_some_and(|family| family.in_file)
                        && by.len() == 1
                        && *primes == 0
                        && !is_reserved(name) =>
                    {
                        self.has.names.push((name.into(), Kind::Coefficients));
                        return Ok(Typed::Real(Real::Coefficient(name.into(), vec![self.place(&by[0])?])));
                    }
                    None => return self.unknown(name, &of.at),
                },
            },
        };
        Ok(Typed::Function(derived(function, *primes, &of.at)?))
    }

    /// An index of t, G, w, P or control values: none is below 0.
    pub(super) fn place(&mut self, node: &Node) -> Resolved<Int> {
        let int = self.int(node)?;
        let exists = !matches!(int, Int::Number(below) if below < 0);
        ensure(exists, &node.at, "no index is below 0, on any knots", "indices and degrees begin at 0")?;
        Ok(int)
    }

    /// Reads with one more name.
    pub(super) fn bound<T>(
        &mut self,
        name: &str,
        kind: Kind,
        at: &Place,
        read: impl FnOnce(&mut Self, Name) -> Resolved<T>,
    ) -> Resolved<T> {
        self.free(name, at)?;
        let name = Name::from(name);
        self.own.push((Arc::clone(&name), kind));
        let read = read(self, name);
        self.own.pop();
        read
    }

    /// May the name be bound here?
    pub(super) fn free(&self, name: &str, at: &Place) -> Resolved<()> {
        not_reserved(name, at)?;
        let bound = self.own.iter().chain(&self.has.names).any(|(bound, _)| **bound == *name);
        let defined = self.known.definitions.iter().any(|definition| *definition.name == *name);
        let family = self.known.family.iter().flat_map(|family| &family.parameters);
        let bound = bound || family.into_iter().any(|(own, _)| **own == *name);
        let rule = format!("`{name}` is bound already, or defined");
        ensure(!bound && !defined, at, rule, "take another name: none hides another")
    }

    fn arithmetic(&mut self, infix: Infix, left: &Node, right: &Node) -> Resolved<Typed> {
        if infix == Infix::Power {
            let (base, exponent) = (self.real(left)?, self.int(right)?);
            bounded(&exponent, &right.at)?;
            return Ok(Typed::Real(Real::Power(Box::new(base), exponent)));
        }
        let (a, b) = (self.real(left)?, self.real(right)?);
        let value = match infix {
            Infix::Plus => a.plus(b),
            Infix::Minus => a.minus(b),
            Infix::Times => a.times(b),
            _ if b == Real::Whole(Int::Number(0)) => {
                return fault(&right.at, "nothing is divided by 0", "check the denominator");
            }
            _ => a.over(b),
        };
        Ok(Typed::of(value))
    }

    /// Infinity is compared with indices only.
    fn chain(&mut self, first: &Node, rest: &[(Relation, Node)]) -> Resolved<Formula> {
        let mut terms = Vec::with_capacity(rest.len() + 1);
        for node in std::iter::once(first).chain(rest.iter().map(|(_, node)| node)) {
            terms.push(match self.typed(node)? {
                Typed::Infinity => Real::Infinity,
                other => other.real(&node.at)?,
            });
        }
        for (at, (relation, node)) in rest.iter().enumerate() {
            let (a, b) = (&terms[at], &terms[at + 1]);
            let infinite = [a, b].contains(&&Real::Infinity);
            let index = |term: &Real| matches!(term, Real::Index(_) | Real::Infinity);
            let equality = matches!(relation, Relation::Equal | Relation::Unequal);
            if infinite && !(index(a) && index(b) && equality && a != b) {
                let at = if *a == Real::Infinity { first.at.start..node.at.end } else { node.at.clone() };
                let advice = "it stands only beside an index: `alpha = infinity`, `alpha != infinity`";
                return fault(&at, "`infinity` is no number", advice);
            }
        }
        let mut terms = terms.into_iter();
        let Some(first) = terms.next() else { return fault(&first.at, "nothing is compared", "write `= 0`") };
        Ok(Formula::Chain(first, rest.iter().map(|(relation, _)| *relation).zip(terms).collect()))
    }

    fn within(&mut self, of: &Node, domain: &Domain) -> Resolved<Formula> {
        match &domain.kind {
            DomainKind::Set(names) => match &of.raw {
                Raw::Name { name, primes: 0 } if name == "U" => {
                    self.need_instance("U in {…}", &of.at)?;
                    Ok(Formula::Instance(self.instances(names)?))
                }
                _ => {
                    let advice = "write `U in {U0, C5}`, or `= a or … = b`";
                    fault(&domain.at, "only the knots of instances are in a list", advice)
                }
            },
            DomainKind::Range(..) => {
                let of = self.int(of)?;
                let (from, to) = self.ends(domain)?;
                Ok(Formula::Among(of, from, to))
            }
            _ => Ok(Formula::Within(self.real(of)?, self.interval(domain)?)),
        }
    }

    /// Names of instances.
    pub(super) fn instances(&self, nodes: &[Node]) -> Resolved<Vec<Name>> {
        let instance = |node: &Node| {
            let Raw::Name { name, primes: 0 } = &node.raw else {
                return fault(&node.at, "expected the name of an instance", "write `U in {U0, C5}`");
            };
            if let Some(known) = &self.known.instances {
                let advice = meant(name, known.iter().map(|known| &**known));
                ensure(
                    known.contains(name.as_str()),
                    &node.at,
                    format!("no instance is called `{name}`"),
                    advice,
                )?;
            }
            Ok(Name::from(name.as_str()))
        };
        nodes.iter().map(instance).collect()
    }

    /// The gaps of knots.
    pub(super) fn gaps(&mut self, nodes: &[Node]) -> Resolved<Vec<Gap>> {
        let gap = |node: &Node| match &node.raw {
            Raw::Over { what: Quantity::Each, name, name_at, domain, body } => {
                let (from, to) = self.ends(domain)?;
                self.bound(name, Kind::Int, name_at, |scope, name| {
                    Ok(Gap { each: Some(Range { name, from, to }), size: scope.real(body)? })
                })
            }
            _ => Ok(Gap { each: None, size: self.real(node)? }),
        };
        nodes.iter().map(gap).collect()
    }

    pub(super) fn ends(&mut self, domain: &Domain) -> Resolved<(Int, Int)> {
        let DomainKind::Range(from, to) = &domain.kind else {
            return fault(&domain.at, "expected a range of integers", "write `0..n`");
        };
        let (from, to) = (self.int(from)?, self.int(to)?);
        if let (Int::Number(from), Int::Number(to)) = (&from, &to) {
            ensure(from <= to, &domain.at, "this range is empty", format!("write `{to}..{from}`"))?;
        }
        Ok((from, to))
    }

    pub(super) fn interval(&mut self, domain: &Domain) -> Resolved<Interval> {
        let DomainKind::Interval { from, from_closed, to, to_closed } = &domain.kind else {
            let advice = "write `[a, b]`, `(a, b)`, `[a, b)` or `(a, b]`";
            return fault(&domain.at, "expected an interval", advice);
        };
        let (from, to) = (self.real(from)?, self.real(to)?);
        if let (Some(a), Some(b)) = (from.literal(), to.literal()) {
            let inhabited = a < b || (a == b && *from_closed && *to_closed);
            ensure(inhabited, &domain.at, "this interval is empty", "its left end comes first")?;
        }
        Ok(Interval { from, from_closed: *from_closed, to, to_closed: *to_closed })
    }

    fn over(
        &mut self,
        what: Quantity,
        name: &str,
        at: &Place,
        domain: &Domain,
        body: &Node,
    ) -> Resolved<Typed> {
        if let DomainKind::Interval { .. } = domain.kind {
            let interval = self.interval(domain)?;
            let rule = "only integers are summed, multiplied or compared one by one";
            let formula = !matches!(what, Quantity::Fold(_));
            ensure(formula, &domain.at, rule, "write `i in 0..n`, or `sup(…, x in [a, b])`")?;
            return self.bound(name, Kind::Real, at, |scope, name| {
                let body = Box::new(scope.formula(body)?);
                Ok(Typed::Formula(quantified(what, Over::Reals(name, interval), body)))
            });
        }
        let (from, to) = self.ends(domain)?;
        self.bound(name, Kind::Int, at, |scope, name| {
            let range = Range { name, from, to };
            Ok(match what {
                Quantity::Fold(fold) => Typed::Real(Real::Fold(fold, range, Box::new(scope.real(body)?))),
                _ => Typed::Formula(quantified(what, Over::Integers(range), Box::new(scope.formula(body)?))),
            })
        })
    }
}

fn quantified(what: Quantity, over: Over, body: Box<Formula>) -> Formula {
    match what {
        Quantity::Some => Formula::Some(over, body),
        Quantity::One => Formula::One(over, body),
        _ => Formula::All(over, body),
    }
}

/// Names with a meaning of their own.
const RESERVED: &[&str] = &[
    "k", "n", "m", "t", "G", "w", "U", "P", "D", "r", "alpha", "infinity", "phi", "f", "sum", "prod", "min",
    "max", "abs", "sqrt", "binomial", "all", "some", "one", "and", "or", "not", "in", "claim", "printed",
    "index", "points", "gaps", "each",
];

fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name) || Word::ALL.iter().any(|word| word.name() == name)
}

/// May it be a name of one's own?
pub(super) fn not_reserved(name: &str, at: &Place) -> Resolved<()> {
    ensure(!is_reserved(name), at, format!("`{name}` has a meaning already"), "take another name")?;
    ensure(!name.contains('_'), at, "a name has letters and digits only", "leave the `_` out")
}

fn number(text: &str, at: &Place) -> Resolved<Typed> {
    if let Ok(int) = text.parse() {
        return Ok(Typed::Int(Int::Number(int)));
    }
    match crate::scalar::parse_rational(text) {
        Ok(number) => Ok(Typed::Real(Real::number(number))),
        Err(error) => fault(at, error.to_string(), "write digits, `1/2` or `0.5`"),
    }
}

fn no_prime(primes: usize, at: &Place) -> Resolved<()> {
    ensure(primes == 0, at, "numbers have no derivative", "a prime stands behind a function: `G'[i](x)`")
}

fn meant<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> String {
    match nearest(name, among) {
        Some(close) => format!("did you mean `{close}`?"),
        None => "give one that is registered".to_owned(),
    }
}

/// The derivative that so many primes mean.
pub(super) fn derived(function: Function, primes: usize, at: &Place) -> Resolved<Function> {
    let order = Int::Number(i64::try_from(primes).unwrap_or(i64::MAX));
    bounded(&order, at)?;
    Ok(if primes == 0 { function } else { Function::Derivative(Box::new(function), order) })
}

/// An exponent, or the order of a derivative, of a size that can be computed with.
pub(super) fn bounded(exponent: &Int, at: &Place) -> Resolved<()> {
    let small = !matches!(exponent, Int::Number(e) if e.unsigned_abs() > GREATEST_EXPONENT);
    let rule = format!("an exponent has at most the size {GREATEST_EXPONENT}");
    ensure(small, at, rule, "name what it stands for")
}
