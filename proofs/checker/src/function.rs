//! The functions of a sentence in a case: basis functions, weights and definitions at x.

use crate::case::{At, Bound, Case, Found, Stop};
use crate::error::Result;
use crate::integers::RANGE;
use crate::place::{Copies, Form, Place};
use crate::poly::Sign;
use crate::token::{Kind, Node, tree};
use crate::truth::Truth;
use crate::value::Value;

/// Whether another member is ∞, or that of another index by its name.
fn names_an_index(member: &Node<'_>) -> Found<bool> {
    Ok(match member.headed("another index")? {
        ("alpha", [alpha]) => alpha.is_word("infinity") || alpha.is("alpha"),
        _ => false,
    })
}

/// A value with its first two derivatives by x.
type Jet<'t> = [Value<'t>; 3];

fn sum<'t>(a: &Jet<'t>, b: &Jet<'t>) -> Result<Jet<'t>> {
    let of = |order: usize| a[order].clone().plus(b[order].clone());
    Ok([of(0)?, of(1)?, of(2)?])
}

fn product<'t>(a: &Jet<'t>, b: &Jet<'t>) -> Result<Jet<'t>> {
    let of = |i: usize, j: usize| a[i].clone().times(b[j].clone());
    let bend = of(2, 0)?.plus(of(1, 1)?.times(Value::whole(2))?)?.plus(of(0, 2)?)?;
    Ok([of(0, 0)?, of(1, 0)?.plus(of(0, 1)?)?, bend])
}

impl<'t> Case<'_, 't> {
    /// Whether a term is x.
    pub(crate) fn is_point(&mut self, node: &Node<'t>) -> Found<bool> {
        if let (Some(knot), true) = (self.knot.clone(), node.is("t"))
            && self.index(node)? == Some(knot)
        {
            return Ok(true);
        }
        let (value, x) = (self.real(node)?, self.x()?);
        match (value.plain, x.plain) {
            (Some(a), Some(b)) => Ok(a.minus(&b)?.is_zero()),
            _ => Ok(false),
        }
    }

    /// A function at an argument; where knots are numbers, whatever the argument is.
    pub(crate) fn of(&mut self, function: &Node<'t>, argument: &Node<'t>) -> Found<Value<'t>> {
        let (side, [x, member @ ..]) = argument.headed("an argument")? else { return Err(Stop::Undecided) };
        let other = match (member.first(), &self.member) {
            (None, member) => member.clone(),
            // Inside of another member only what names its own index means the same.
            (Some(member), Some(_)) if !names_an_index(member)? => return Err(Stop::Undecided),
            (Some(member), _) => Some(self.other_member(member)?),
        };
        let (at, moved) = match self.place_of(x) {
            Err(Stop::Undecided) if self.numbers.is_some() => (At::X, Some(self.real(x)?)),
            at => (at?, None),
        };
        let at = match (at, side) {
            (at, "at") => at,
            (At::X, "left") => At::Left,
            (At::X, "right") => At::Right,
            _ => return Err(Stop::Undecided),
        };
        let place = moved.map(|x| self.locate(x)).transpose()?;
        let member = std::mem::replace(&mut self.member, other);
        let value = self.function(function, at, 0);
        self.member = member;
        if let Some(place) = place {
            self.restore(place);
        }
        value
    }

    /// What is replaced for another member of the family.
    fn other_member(&mut self, member: &Node<'t>) -> Found<Node<'t>> {
        let inverse = || Node::made("/", vec![Node::whole_of(1), Node::name_of("r")]);
        let ratio = match member.headed("another index")? {
            ("dual", []) => return self.dual(),
            ("alpha", [alpha]) if alpha.is_word("infinity") => Node::whole_of(1),
            ("alpha", [alpha]) if *alpha == tree("(- (int 1) (alpha alpha))")? => inverse(),
            ("alpha", [alpha]) => match alpha.headed("an index")? {
                ("alpha", [name]) if !name.is_word("alpha") => self.other(name.name()?)?,
                _ => return Err(Stop::Undecided),
            },
            ("ratio", [ratio]) => {
                let value = self.real(ratio)?;
                let positive = value.plain.as_ref().is_some_and(|plain| self.sign(plain) == Sign::Positive);
                if positive { value.term } else { return Err(Stop::Undecided) }
            }
            _ => return Err(Stop::Undecided),
        };
        Ok(Node::made("r", vec![ratio]))
    }

    /// (dual WINDOW M): t_i is reflected to t_{m−i}, so that t_{s+e} goes to t_{s'+M−e} for the span s' of the mirror image.
    fn dual(&self) -> Found<Node<'t>> {
        let (window, m) = match &self.numbers {
            // One window has all knots, which count as they are counted.
            Some(_) => ("W", self.shown.1 - self.shown.0),
            None if self.symmetric => ("M", 1 + self.turn()),
            None => return Err(Stop::Undecided),
        };
        Ok(Node::made("dual", vec![Node::name_of(window), Node::whole_of(m)]))
    }

    /// r of another index that is bound.
    pub(crate) fn other(&mut self, name: &'t str) -> Found<Node<'t>> {
        if let Some((_, ratio)) = self.ratios.iter().find(|(known, _)| *known == name) {
            return Ok(ratio.clone());
        }
        match &self.numbers {
            Some(numbers) if numbers.values.is_some() => numbers.of("index", name, 0).ok_or(Stop::Undecided),
            _ => Ok(self.parameter("positive", Node::made(name, vec![Node::whole_of(0)]))?.term),
        }
    }

    /// An index α = r/(r − 1), as a number; nothing for ∞.
    pub(crate) fn alpha(&mut self, name: &Node<'t>) -> Found<Option<Value<'t>>> {
        if self.numbers.is_none() || self.member.is_some() {
            return Err(Stop::Undecided);
        }
        let name = name.name()?;
        let ratio = if name == "alpha" { Node::name_of("r") } else { self.other(name)? };
        let ratio = self.leaf(ratio)?;
        let less = ratio.clone().minus(Value::whole(1))?;
        if less.is_zero() { Ok(None) } else { self.over(ratio, less).map(Some) }
    }

    /// x, t_0 + t_m − x, or what the variable of a definition stands for.
    fn place_of(&mut self, node: &Node<'t>) -> Found<At> {
        if let Ok(("var", [name])) = node.headed("")
            && let Bound::Point(at) = self.bound(name)?
        {
            return Ok(at);
        }
        if let Ok(("-", [sum, x])) = node.headed("")
            && self.symmetric
            && *sum == tree("(+ (t 0) (t m))")?
            && self.place_of(x)? == At::X
        {
            return Ok(At::Mirrored);
        }
        if self.is_point(node)? { Ok(At::X) } else { Err(Stop::Undecided) }
    }

    /// A function, or its derivative: of order 1, that of a weight of order 2 as well.
    pub(crate) fn function(&mut self, node: &Node<'t>, at: At, order: i64) -> Found<Value<'t>> {
        match node.headed("a function")? {
            ("D", [of, by]) => match self.fixed(by)? {
                by @ 0..=RANGE if order + by <= RANGE => self.function(of, at, order + by),
                _ => Err(Stop::Undecided),
            },
            // By the ends alone, as that of knots whose indices it does not give.
            ("phi" | "f", _) if !self.family.is_by_ends() => Err(Stop::Undecided),
            (head @ ("phi" | "f"), [a, b]) if self.numbers.is_some() => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.weight(head == "phi", a, b, at, order)
            }
            ("G", [i, degree @ ..]) => {
                let i = self.int(i)?;
                let degree = degree.first().map_or(Ok(self.k), |degree| self.fixed(degree))?;
                if !(0..=self.k).contains(&degree) {
                    return Err(Stop::Undefined);
                }
                self.exists(&i, &Form::last(self.k - degree))?;
                self.on_window(if order == 0 { "G" } else { "DG" }, &i, degree, at, order)
            }
            ("w", [i, degree]) => {
                let (i, degree) = (self.int(i)?, self.fixed(degree)?);
                if degree < 1 {
                    return Err(Stop::Undecided);
                }
                self.exists(&i, &Form::last(self.k + 1 - degree))?;
                if order > 1 {
                    return Err(Stop::Undecided);
                }
                self.on_window(if order == 0 { "w" } else { "Dw" }, &i, degree, at, order)
            }
            (head @ ("phi" | "f"), [a, b]) if at == At::X && order <= 1 => {
                let (a, b) = (self.real(a)?, self.real(b)?);
                self.phi(head == "phi", a, b, order)
            }
            ("defined", [name, indices @ ..]) => self.defined(name, indices, at, order),
            _ => Err(Stop::Undecided),
        }
    }

    /// The weight of any interval, or a derivative of it; φ is 0 outside of it.
    fn weight(&mut self, cut: bool, a: Value<'t>, b: Value<'t>, at: At, order: i64) -> Found<Value<'t>> {
        if cut {
            let x = self.x()?;
            let [from, to] = match (at, order) {
                (At::Left, _) => ["<", "<="],
                (At::X, 1..) => ["<", "<"],
                _ => ["<=", "<"],
            };
            let inside = self.compare(a.clone(), from, x.clone())?.and(self.compare(x, to, b.clone())?);
            match inside {
                Truth::False if order == 0 => return Ok(Value::whole(0)),
                inside if inside.is_true() => {}
                _ => return Err(Stop::Undecided),
            }
        }
        let Some([rise, fall]) = self.family.weight else { return Err(Stop::Undecided) };
        let [rise, fall] = [self.jet(rise, [&a, &b])?, self.jet(fall, [&a, &b])?];
        let below = sum(&rise, &fall)?;
        // By the quotient rule, rise'·fall − rise·fall' over the square of the sum.
        let bent = |by: usize| {
            rise[by].clone().times(fall[0].clone())?.minus(rise[0].clone().times(fall[by].clone())?)
        };
        let square = below[0].clone().times(below[0].clone())?;
        match order {
            0 => self.over(rise[0].clone(), below[0].clone()),
            1 => self.over(bent(1)?, square),
            _ => {
                let turned = bent(1)?.times(below[1].clone())?.times(Value::whole(-2))?;
                self.over(bent(2)?.times(below[0].clone())?.plus(turned)?, square.times(below[0].clone())?)
            }
        }
    }

    /// A term of the weight of [a, b] with its derivatives by x.
    fn jet(&mut self, node: &Node<'t>, ends: [&Value<'t>; 2]) -> Found<Jet<'t>> {
        self.deeper(|own| own.jet_part(node, ends))
    }

    fn jet_part(&mut self, node: &Node<'t>, ends: [&Value<'t>; 2]) -> Found<Jet<'t>> {
        let constant = |value| [value, Value::whole(0), Value::whole(0)];
        let minus = constant(Value::whole(-1));
        if let Kind::Number(..) = node.kind {
            return Ok(constant(self.leaf(node.clone())?));
        }
        match node.headed("a term of a weight")? {
            ("var", [name]) if name.is_word("x") => Ok([self.x()?, Value::whole(1), Value::whole(0)]),
            ("var", [name]) => Ok(constant(ends[usize::from(name.is_word("b"))].clone())),
            ("int", [i]) => Ok(constant(Value::whole(self.fixed(i)?))),
            ("parameter", [name]) => {
                let other = self.member.as_ref().map(|member| member.headed("")).transpose()?;
                let value = match other {
                    None => name.clone(),
                    Some((own, [other])) if name.is_word(own) => other.clone(),
                    Some(_) => return Err(Stop::Undecided),
                };
                Ok(constant(self.leaf(value)?))
            }
            ("+", [a, b]) => Ok(sum(&self.jet(a, ends)?, &self.jet(b, ends)?)?),
            ("-", [a, b]) => Ok(sum(&self.jet(a, ends)?, &product(&minus, &self.jet(b, ends)?)?)?),
            ("neg", [a]) => Ok(product(&minus, &self.jet(a, ends)?)?),
            ("*", [a, b]) => Ok(product(&self.jet(a, ends)?, &self.jet(b, ends)?)?),
            ("^", [a, e]) => {
                let (a, e) = (self.jet(a, ends)?, self.fixed(e)?);
                if !(0..=RANGE / 2).contains(&e) {
                    return Err(Stop::Undecided);
                }
                Ok((0..e).try_fold(constant(Value::whole(1)), |power, _| product(&power, &a))?)
            }
            ("/", [a, b]) => match self.jet(b, ends)? {
                // What it is divided by has no x in it.
                [b, slope, _] if slope.is_zero() => {
                    let inverse = self.over(Value::whole(1), b)?;
                    Ok(product(&self.jet(a, ends)?, &constant(inverse))?)
                }
                _ => Err(Stop::Undecided),
            },
            _ => Err(Stop::Undecided),
        }
    }

    /// The weight of an interval between two knots of the window; φ is 0 outside of it.
    pub(crate) fn phi(&mut self, cut: bool, a: Value<'t>, b: Value<'t>, order: i64) -> Found<Value<'t>> {
        if cut {
            if order == 1 && self.place != Place::Inside {
                return Err(Stop::Undecided);
            }
            let x = self.x()?;
            let inside = self.compare(a.clone(), "<=", x.clone())?.and(self.compare(x, "<", b.clone())?);
            match inside {
                Truth::False => return Ok(Value::whole(0)),
                inside if inside.is_true() => {}
                _ => return Err(Stop::Undecided),
            }
        }
        let (Some(a @ ..=0), Some(b @ 1..)) = (a.knot, b.knot) else { return Err(Stop::Undecided) };
        self.term(if order == 0 { "w" } else { "Dw" }, [a, b - a, order], 0, At::X)
    }

    /// A function at the place of span e.
    pub(crate) fn term(
        &self,
        head: &'static str,
        [i, degree, order]: [i64; 3],
        e: i64,
        at: At,
    ) -> Found<Value<'t>> {
        let mirrored = at == At::Mirrored;
        let on = match (self.place, self.place.on_span()) {
            (_, None) => return Err(Stop::Undecided),
            (Place::First(_), _) if mirrored => "to",
            (_, Some("in")) => "in",
            _ if mirrored => "from",
            _ if e != 0 => "to",
            (_, Some(on)) => on,
        };
        if mirrored && self.member.as_ref().is_some_and(|member| member.is("dual")) {
            return Err(Stop::Undecided);
        }
        let window = Node::name_of(if mirrored { "M" } else { "W" });
        // Numbers are counted as they are, the knots of other windows from t_s.
        let from = match &self.numbers {
            Some(_) => self.facts.value(&Form::near(0)).ok_or(Stop::Undecided)?,
            None => 0,
        };
        let place = Node::made(on, vec![window, Node::whole_of(e + from)]);
        let mut fields = vec![Node::whole_of(i + from), Node::whole_of(degree), place];
        fields.extend((order > 1).then(|| Node::whole_of(order)));
        let mut term = Node::made(head, fields);
        let mut moved = Vec::new();
        if mirrored && self.place == Place::Inside {
            let inverse = Node::made("/", vec![Node::whole_of(1), Node::name_of("u")]);
            moved.push(Node::made("u", vec![inverse]));
        }
        let u = self.numbers.as_ref().and_then(|numbers| numbers.u.clone());
        moved.extend(u.map(|u| Node::made("u", vec![u])));
        moved.extend(self.member.clone());
        if !moved.is_empty() {
            term = Node::made("at", vec![Node::group_of(moved), term]);
        }
        match &self.numbers {
            // A weight tells where other functions are taken.
            Some(_) if !self.family.is_any() && (self.exact || head.ends_with('w')) => Ok(self.leaf(term)?),
            _ => Ok(Value { term, plain: None, knot: None }),
        }
    }

    /// A function that exists, at the place: 0 if it does not live on the span.
    fn on_window(
        &mut self,
        head: &'static str,
        i: &Form,
        degree: i64,
        at: At,
        order: i64,
    ) -> Found<Value<'t>> {
        let basis = head.ends_with('G');
        let (span, e) = match (self.place, at) {
            (Place::Before | Place::After, _) | (Place::First(_), At::Left) => return Ok(Value::whole(0)),
            (Place::End | Place::Last(_), At::Right) => return Ok(Value::whole(0)),
            (_, At::Mirrored) if head == "G" => (self.mirror()?, 0),
            (_, At::Mirrored) | (Place::Start, At::Left) => return Err(Stop::Undecided),
            (Place::Knot(Copies::Exactly(q)), At::Left) => (Form::near(-q), -q),
            (Place::Knot(Copies::AtLeast(q)), At::Left) => {
                // The span on the left is s − Q, or before that.
                let zero = basis && self.surely(&i.plus(-1, &Form::near(1 - q))?)?;
                return if zero { Ok(Value::whole(0)) } else { Err(Stop::Undecided) };
            }
            _ => (Form::near(0), 0),
        };
        let from = i.plus(-1, &span)?;
        let until = Form::number(-degree - i64::from(basis)).plus(-1, &from)?;
        if self.surely(&from.plus(-1, &Form::number(1))?)? || self.surely(&until)? {
            return Ok(Value::whole(0));
        }
        let i = e + self.facts.value(&from).ok_or(Stop::Undecided)?;
        let (first, last) = self.shown;
        if !basis && (i < first || i + degree > last) {
            return Err(Stop::Undecided);
        }
        self.term(head, [i, degree, order], e, at)
    }

    /// A definition for some indices, its variable at a place; or its derivative.
    pub(crate) fn defined(
        &mut self,
        name: &Node<'t>,
        indices: &[Node<'t>],
        at: At,
        order: i64,
    ) -> Found<Value<'t>> {
        let forms = indices.iter().map(|index| self.int(index)).collect::<Found<Vec<_>>>()?;
        for definition in self.definitions {
            let [own, patterns, variable, body] = definition.part("define")?;
            let Kind::List(patterns) = &patterns.kind else { continue };
            if own != name || patterns.len() != forms.len() {
                continue;
            }
            let (mut fits, mut ints) = (true, Vec::new());
            for (pattern, form) in patterns.iter().zip(&forms) {
                match pattern.whole() {
                    Ok(wanted) => fits &= self.facts.value(form).ok_or(Stop::Undecided)? == wanted,
                    Err(_) => ints.push((pattern.name()?, form.clone())),
                }
            }
            if fits {
                let reals = vec![(variable.name()?, Bound::Point(at))];
                let outer =
                    (std::mem::replace(&mut self.ints, ints), std::mem::replace(&mut self.reals, reals));
                let value = match order {
                    0 => self.real(body),
                    1 => self.slope(body),
                    _ => Err(Stop::Undecided),
                };
                (self.ints, self.reals) = outer;
                return value;
            }
        }
        Err(Stop::Undecided)
    }

    /// The derivative of the body of a definition.
    fn slope(&mut self, node: &Node<'t>) -> Found<Value<'t>> {
        self.deeper(|own| own.slope_part(node))
    }

    fn slope_part(&mut self, node: &Node<'t>) -> Found<Value<'t>> {
        if let Kind::Number(..) | Kind::Name("ratio") = node.kind {
            return Ok(Value::whole(0));
        }
        match node.headed("a real")? {
            // The only name of a real in a definition is that of its variable.
            ("var", _) => Ok(Value::whole(1)),
            ("int" | "t" | "coefficient", _) => self.real(node).map(|_| Value::whole(0)),
            ("+", [a, b]) => Ok(self.slope(a)?.plus(self.slope(b)?)?),
            ("-", [a, b]) => Ok(self.slope(a)?.minus(self.slope(b)?)?),
            ("neg", [a]) => Ok(self.slope(a)?.times(Value::whole(-1))?),
            ("*", [a, b]) => {
                let (f, g) = (self.real(a)?, self.real(b)?);
                Ok(self.slope(a)?.times(g)?.plus(f.times(self.slope(b)?)?)?)
            }
            ("sum", [name, low, high, body]) => self.fold(true, [name, low, high], &|own| own.slope(body)),
            ("of", [function, argument]) => match argument.headed("an argument")? {
                ("at", [x]) if x.is("var") => {
                    let at = self.place_of(x)?;
                    self.function(function, at, 1)
                }
                _ => Err(Stop::Undecided),
            },
            _ => Err(Stop::Undecided),
        }
    }
}
