//! The walk through terms: where brackets are needed, and what is a script, a fraction, a sum.

use num_bigint::Sign;

use super::super::raw::level::{ATOM, FACTOR, NOT, POWER, PRODUCT, SUM, TERM, TOP};
use super::super::syntax::{Argument, Fold, Function, Int, Item, Member, Range, Real, Side, Use};
use super::form::{AT_MOST, Big, COMMA, EQUAL, Form, GREEK, MAPS, MINUS, Operator, PLUS, SLASH, TIMES};

/// Prints the source, or notation for people.
#[derive(Debug, Clone, Copy)]
pub struct Walk {
    pub(super) source: bool,
}

impl Walk {
    pub(super) fn name(self, name: &str) -> Form {
        Form::atom(if self.source { name.to_owned() } else { notation(name) })
    }

    pub(super) fn int(self, int: &Int, least: u8) -> Form {
        match int {
            Int::Number(number) => self.number(number.to_string(), least),
            Int::Bound(name) => self.name(name),
            Int::Degree => Form::atom("k"),
            Int::Last => Form::atom("n"),
            Int::M => Form::atom("m"),
            Int::Minus(a, b) if **a == Int::Number(0) => self.negated(self.int(b, PRODUCT), least),
            Int::Plus(a, b) => self.infix(self.int(a, SUM), PLUS, self.int(b, TERM), SUM, least),
            Int::Minus(a, b) => self.infix(self.int(a, SUM), MINUS, self.int(b, TERM), SUM, least),
            Int::Times(a, b) => self.infix(self.int(a, PRODUCT), TIMES, self.int(b, FACTOR), PRODUCT, least),
            Int::Least(a, b) => self.call("min", [self.int(a, TOP), self.int(b, TOP)]),
            Int::Greatest(a, b) => self.call("max", [self.int(a, TOP), self.int(b, TOP)]),
            Int::Binomial(a, b) => {
                let name = if self.source { "binomial" } else { "binom" };
                self.call(name, [self.int(a, TOP), self.int(b, TOP)])
            }
            Int::Word(word) => self.word(word, least),
        }
    }

    pub(super) fn real(self, real: &Real, least: u8) -> Form {
        match real {
            Real::Number(value) => {
                let (top, bottom) = (Form::atom(value.numer().magnitude()), Form::atom(value.denom()));
                let fraction = |top, bottom| match self.source {
                    true => Form::joined([top, bottom], SLASH),
                    false => Form::Fraction([(Box::new(top), false), (Box::new(bottom), false)]),
                };
                let size = if value.is_integer() { top } else { fraction(top, bottom) };
                match value.numer().sign() {
                    Sign::Minus => self.negated(size, least),
                    _ => size.bracketed(!value.is_integer() && least > PRODUCT),
                }
            }
            Real::Whole(int) => self.int(int, least),
            Real::Bound(name) | Real::Index(name) => self.name(name),
            Real::Ratio => Form::atom("r"),
            Real::Infinity => Form::atom(if self.source { "infinity" } else { "∞" }),
            Real::Knot(i) => self.indexed("t", &[i]),
            Real::Coefficient(name, by) | Real::Parameter(name, by) | Real::Defined(name, by) => {
                self.indexed(name, &by.iter().collect::<Vec<_>>())
            }
            Real::Plus(a, b) => self.infix(self.real(a, SUM), PLUS, self.real(b, TERM), SUM, least),
            Real::Minus(a, b) => self.infix(self.real(a, SUM), MINUS, self.real(b, TERM), SUM, least),
            Real::Times(a, b) => {
                self.infix(self.real(a, PRODUCT), TIMES, self.real(b, FACTOR), PRODUCT, least)
            }
            Real::Over(a, b) if self.source => {
                self.infix(self.real(a, PRODUCT), SLASH, self.real(b, FACTOR), PRODUCT, least)
            }
            Real::Over(a, b) => {
                let needs = |real: &Real, least| matches!(self.real(real, least), Form::Fence("(", _, ")"));
                let (top, bottom) = (needs(a, PRODUCT), needs(b, FACTOR));
                let part = |real, needs| (Box::new(self.real(real, TOP)), needs);
                Form::Fraction([part(a, top), part(b, bottom)]).bracketed(least > PRODUCT)
            }
            Real::Negated(a) => self.negated(self.real(a, PRODUCT), least),
            Real::Power(a, e) => {
                let exponent = self.int(e, if self.source { POWER } else { TOP });
                Form::script(self.real(a, ATOM), None, Some(exponent)).bracketed(least > POWER)
            }
            Real::Absolute(a) if self.source => self.call("abs", [self.real(a, TOP)]),
            Real::Absolute(a) => Form::fenced("|", self.real(a, TOP), "|"),
            Real::Root(a) if self.source => self.call("sqrt", [self.real(a, TOP)]),
            Real::Root(a) => Form::Root(Box::new(self.real(a, ATOM))).bracketed(least > POWER),
            Real::Least(a, b) => self.call("min", [self.real(a, TOP), self.real(b, TOP)]),
            Real::Greatest(a, b) => self.call("max", [self.real(a, TOP), self.real(b, TOP)]),
            Real::Fold(fold, range, body) => self.fold(*fold, range, body, least),
            Real::Value(function, argument) => self.value(function, argument),
            Real::Word(word) => self.word(word, least),
        }
    }

    fn number(self, text: String, least: u8) -> Form {
        match text.strip_prefix('-') {
            Some(digits) => self.negated(Form::atom(digits), least),
            None => Form::Atom(text),
        }
    }

    fn negated(self, of: Form, least: u8) -> Form {
        Form::Row(vec![Form::Prefix(MINUS), of]).bracketed(least > SUM)
    }

    fn infix(self, a: Form, by: Operator, b: Form, own: u8, least: u8) -> Form {
        Form::joined([a, b], by).bracketed(least > own)
    }

    pub(super) fn call<const N: usize>(self, name: &str, of: [Form; N]) -> Form {
        Form::Row(vec![Form::atom(name), Form::fenced("(", Form::joined(of, COMMA), ")")])
    }

    /// t[i] and t_i.
    fn indexed(self, name: &str, by: &[&Int]) -> Form {
        let head = self.name(name);
        if by.is_empty() {
            return head;
        }
        let indices = Form::between(by.iter().map(|i| self.int(i, TOP)), &Form::atom(","));
        Form::script(head, Some(indices), None)
    }

    /// `i in 0..n`, for people 0 ≤ i ≤ n.
    pub(super) fn range(self, range: &Range) -> Form {
        let (name, from, to) = (self.name(&range.name), self.int(&range.from, SUM), self.int(&range.to, SUM));
        match self.source {
            true => {
                let ends = Form::Tight(Box::new(Form::Row(vec![from, Form::atom(".."), to])));
                Form::Row(vec![name, Form::words(" in "), ends])
            }
            false => Form::joined([from, name, to], AT_MOST),
        }
    }

    fn fold(self, fold: Fold, range: &Range, body: &Real, least: u8) -> Form {
        if self.source {
            let name = match fold {
                Fold::Sum => "sum",
                Fold::Product => "prod",
                Fold::Least => "min",
                Fold::Greatest => "max",
            };
            return self.over(name, self.range(range), self.real(body, TOP));
        }
        let (from, to) = (self.int(&range.from, TOP), self.int(&range.to, TOP));
        let first = Form::joined([self.name(&range.name), from], EQUAL);
        let big = match fold {
            Fold::Sum => Form::Big(Big::Sum, Box::new(first), Some(Box::new(to))),
            Fold::Product => Form::Big(Big::Product, Box::new(first), Some(Box::new(to))),
            Fold::Least => Form::Big(Big::Least, Box::new(self.range(range)), None),
            Fold::Greatest => Form::Big(Big::Greatest, Box::new(self.range(range)), None),
        };
        Form::Row(vec![big, self.real(body, TERM)]).bracketed(least > TERM)
    }

    /// `all(i in 0..n: …)` of the source.
    pub(super) fn over(self, name: &str, domain: Form, body: Form) -> Form {
        let inner = Form::Row(vec![domain, Form::words(": "), body]);
        Form::Row(vec![Form::atom(name), Form::fenced("(", inner, ")")])
    }

    fn value(self, function: &Function, argument: &Argument) -> Form {
        let mut point = self.real(&argument.at, TOP);
        if let Some(side) = argument.side {
            let sign = if side == Side::Left { MINUS } else { PLUS };
            let sign = Form::atom(if self.source {
                sign.0
            } else if side == Side::Left {
                "⁻"
            } else {
                "⁺"
            });
            let compound = !self.source && !matches!(point, Form::Atom(_) | Form::Script(..));
            point = Form::Row(vec![point.bracketed(compound), sign]);
        }
        let mut arguments = vec![point];
        if let Function::Phi { from, to, .. } = peeled(function) {
            arguments.extend([self.real(from, TOP), self.real(to, TOP)]);
        }
        let mut inner = vec![Form::joined(arguments, COMMA)];
        if self.source {
            inner.extend(argument.member.iter().flat_map(|member| self.member(member)));
        }
        let member = argument.member.as_ref().filter(|_| !self.source);
        Form::Row(vec![self.function(function, member), Form::fenced("(", Form::Row(inner), ")")])
    }

    /// `; alpha = …`.
    fn member(self, member: &Member) -> Vec<Form> {
        match member {
            Member::Index(of) => vec![Form::words("; alpha = "), self.real(of, SUM)],
            Member::Ratio(of) => vec![Form::words("; r = "), self.real(of, SUM)],
            Member::Parameter(name, of) => vec![Form::words(format!("; {name} = ")), self.real(of, SUM)],
            Member::Dual => vec![Form::words("; dual")],
        }
    }

    /// α or r=s, as a script.
    fn mark(self, member: &Member) -> Form {
        match member {
            Member::Index(of) => self.real(of, SUM),
            Member::Ratio(of) => Form::joined([Form::atom("r"), self.real(of, SUM)], EQUAL),
            Member::Parameter(name, of) => Form::joined([self.name(name), self.real(of, SUM)], EQUAL),
            Member::Dual => Form::atom("dual"),
        }
    }

    /// A function without its point; for people with its index before it, or at φ below it.
    pub(super) fn function(self, function: &Function, member: Option<&Member>) -> Form {
        let plain = match function {
            Function::Derivative(of, order) => return self.derivative(of, order, member),
            Function::Basis { i, degree: None } if self.source => self.indexed("G", &[i]),
            Function::Basis { i, degree: Some(d) } if self.source => self.indexed("G", &[i, d]),
            Function::Weight { i, degree } if self.source => self.indexed("w", &[i, degree]),
            Function::Basis { i, degree } => {
                let degree = degree.as_ref().unwrap_or(&Int::Degree);
                Form::script(Form::atom("G"), Some(self.int(i, TOP)), Some(self.int(degree, TOP)))
            }
            Function::Weight { i, degree } => {
                Form::script(Form::atom("w"), Some(self.int(i, TOP)), Some(self.int(degree, TOP)))
            }
            Function::Phi { cut, .. } => match self.source {
                true => Form::atom(if *cut { "phi" } else { "f" }),
                false => {
                    let below = member.map_or_else(|| Form::atom("α"), |member| self.mark(member));
                    return Form::script(Form::atom(if *cut { "φ" } else { "f" }), Some(below), None);
                }
            },
            Function::Defined(name, by) => self.indexed(name, &by.iter().collect::<Vec<_>>()),
        };
        self.before(member, plain)
    }

    fn before(self, member: Option<&Member>, form: Form) -> Form {
        match member {
            Some(member) => Form::Before(Box::new(self.mark(member)), Box::new(form)),
            None => form,
        }
    }

    /// `G'[i]`, `D(G[i], q)`; for people DG_i^k, D^qG_i^k, C′.
    fn derivative(self, of: &Function, order: &Int, member: Option<&Member>) -> Form {
        let phi = matches!(of, Function::Phi { .. });
        let defined = matches!(of, Function::Defined(..));
        let primes = match order {
            Int::Number(order) if (1..=3).contains(order) || (phi && *order > 0) => {
                usize::try_from(*order).unwrap_or(0)
            }
            _ => 0,
        };
        let primes = if matches!(of, Function::Derivative(..)) { 0 } else { primes };
        match (self.source, self.function(of, member.filter(|_| phi))) {
            (true, Form::Script(head, below, above)) if primes > 0 => {
                Form::Script(Box::new(Form::Row(vec![*head, Form::atom("'".repeat(primes))])), below, above)
            }
            (true, Form::Atom(name)) if primes > 0 => Form::Atom(name + &"'".repeat(primes)),
            (true, inner) => self.call("D", [inner, self.int(order, TOP)]),
            (false, inner) if defined && primes > 0 => {
                self.before(member, Form::Row(vec![inner, Form::atom("′".repeat(primes))]))
            }
            (false, inner) => {
                let above = (*order != Int::Number(1)).then(|| self.int(order, TOP));
                let sign = match above {
                    Some(above) => Form::script(Form::atom("D"), None, Some(above)),
                    None => Form::atom("D"),
                };
                let inner = inner.bracketed(defined || matches!(of, Function::Derivative(..)));
                self.before(member.filter(|_| !phi), Form::Row(vec![sign, inner]))
            }
        }
    }

    /// A word in its place: `mult(x)`, for people its sentence.
    pub(super) fn word(self, of: &Use, least: u8) -> Form {
        let items: Vec<Form> = of.of.iter().map(|item| self.item(item)).collect();
        if self.source {
            let inner = Form::joined(items, COMMA);
            return Form::Row(vec![Form::atom(of.word.name()), Form::fenced("(", inner, ")")]);
        }
        let mut row = Vec::new();
        for (at, part) in of.word.says().split('{').enumerate() {
            let place =
                part.split_once('}').and_then(|(index, after)| Some((index.parse::<usize>().ok()?, after)));
            match (at, place) {
                (1.., Some((index, after))) => {
                    let item = items.get(index).cloned();
                    // A template may have an item as an index: u_{0}.
                    let base = match row.last_mut() {
                        Some(Form::Words(words)) if words.ends_with('_') => {
                            words.pop();
                            words.pop().map(Form::atom)
                        }
                        _ => None,
                    };
                    row.extend(match base {
                        Some(base) => Some(Form::script(base, item, None)),
                        None => item,
                    });
                    row.push(Form::words(after));
                }
                // Braces around something else are those of an index: t_{n+1}.
                (1.., None) => row.push(Form::words(format!("{{{part}"))),
                _ => row.push(Form::words(part)),
            }
        }
        row.retain(|form| *form != Form::words(""));
        Form::Row(row).bracketed(least > NOT)
    }

    fn item(self, item: &Item) -> Form {
        match item {
            Item::Function(function, member) if self.source => {
                let head = std::iter::once(self.function(function, None));
                Form::Row(head.chain(member.iter().flat_map(|member| self.member(member))).collect())
            }
            Item::Function(function, member) => self.function(function, member.as_ref()),
            Item::Expression(real, name, within) if self.source => {
                let mut row = vec![self.real(real, TOP), Form::Operator(COMMA), self.name(name)];
                if let Some(within) = within {
                    row.extend([Form::words(" in "), self.interval(within)]);
                }
                Form::Row(row)
            }
            Item::Expression(real, name, None) => {
                Form::joined([self.name(name), self.real(real, TOP)], MAPS).bracketed(true)
            }
            Item::Expression(real, name, Some(within)) => Form::Row(vec![
                self.real(real, TOP),
                Form::words(" for "),
                self.name(name),
                Form::words(" in "),
                self.interval(within),
            ]),
            Item::Coefficients(name) if self.source => self.name(name),
            Item::Coefficients(name) => self.points(name),
            Item::Real(real) => self.real(real, TOP),
            Item::Int(int) => self.int(int, TOP),
        }
    }

    /// d_0, …, d_n.
    pub(super) fn points(self, name: &str) -> Form {
        let point = |i: &str| Form::script(self.name(name), Some(Form::atom(i)), None);
        Form::joined([point("0"), Form::atom("…"), point("n")], COMMA)
    }
}

/// The function under its derivatives.
fn peeled(function: &Function) -> &Function {
    match function {
        Function::Derivative(of, _) => peeled(of),
        other => other,
    }
}

/// Greek letters by their names, and digits at the end of a name below the line.
fn notation(name: &str) -> String {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let letters =
        GREEK.iter().find(|(word, _)| *word == stem).map_or(stem.to_owned(), |(_, c)| c.to_string());
    let below = |c: char| char::from_u32('₀' as u32 + c.to_digit(10).unwrap_or(0)).unwrap_or(c);
    letters.chars().chain(name[stem.len()..].chars().map(below)).collect()
}
