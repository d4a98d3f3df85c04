//! Trees of brackets to the data of `syntax`. What is not described in the format is an error.

use crate::error::Reason;
use crate::fields::{Fields, number, wrong};
use crate::integer::{Int, Item};
use crate::syntax::{
    Formula, GapText, Knots, Of, Options, Parameter, Place, PlaceKind, Rule, SectionProof, SectionText,
    Statement, Term, WindowText,
};
use crate::token::{Kind, Node, is_plain_name};

impl<'a> Fields<'a> {
    fn items<T>(
        self,
        expected: &'static str,
        read: &dyn Fn(&'a Node) -> Result<T, Reason>,
    ) -> Result<Vec<Item<T>>, Reason> {
        self.all(expected, |node| match Fields::headed(node, expected) {
            Ok(("each", mut fields)) => {
                let (name, low, high) = fields.range()?;
                Ok(Item::Each(name, low, high, fields.items(expected, read)?))
            }
            _ => Ok(Item::One(read(node)?)),
        })
    }

    fn range(&mut self) -> Result<(String, Int, Int), Reason> {
        Ok((self.name()?, self.int()?, self.int()?))
    }

    fn int(&mut self) -> Result<Int, Reason> {
        int(self.next("an integer")?)
    }

    fn term(&mut self) -> Result<Term, Reason> {
        term(self.next("a term")?)
    }

    fn terms(&mut self) -> Result<Vec<Term>, Reason> {
        Fields::of(self.next("a list of terms")?, "a list of terms")?.all("a term", term)
    }

    fn place(&mut self) -> Result<Place, Reason> {
        let node = self.next("a place")?;
        let (head, mut fields) = Fields::headed(node, "a place")?;
        let kind = match head {
            "in" => PlaceKind::In,
            "from" => PlaceKind::From,
            "to" => PlaceKind::To,
            _ => return wrong(node.line, "in, from or to"),
        };
        let place = Place { kind, window: fields.name()?, span: fields.int()? };
        fields.end()?;
        Ok(place)
    }
}

fn int(node: &Node) -> Result<Int, Reason> {
    match &node.kind {
        Kind::Number(number) => {
            number.integer().map_or_else(|| wrong(node.line, "a whole number"), |n| Ok(Int::Number(n)))
        }
        Kind::Name(name) if is_plain_name(name) => Ok(Int::Name(name.clone())),
        Kind::List(_) => {
            let (head, mut fields) = Fields::headed(node, "an integer")?;
            match head {
                "+" => Ok(Int::Sum(fields.all("an integer", int)?)),
                "*" => Ok(Int::Product(fields.all("an integer", int)?)),
                "-" | "binomial" => {
                    let (a, b) = (Box::new(fields.int()?), Box::new(fields.int()?));
                    fields.end()?;
                    Ok(if head == "-" { Int::Difference(a, b) } else { Int::Binomial(a, b) })
                }
                _ => wrong(node.line, "an integer"),
            }
        }
        _ => wrong(node.line, "an integer"),
    }
}

fn parameter(node: &Node) -> Result<Parameter, Reason> {
    match &node.kind {
        Kind::Name(name) if is_plain_name(name) => Ok(Parameter(name.clone(), Vec::new())),
        Kind::List(_) => {
            let mut fields = Fields::of(node, "a parameter")?;
            Ok(Parameter(fields.head()?, fields.all("an index", int)?))
        }
        _ => wrong(node.line, "a parameter"),
    }
}

fn term(node: &Node) -> Result<Term, Reason> {
    match &node.kind {
        Kind::Number(number) => return Ok(Term::Number(number.clone())),
        Kind::Text(_) => return wrong(node.line, "a term"),
        Kind::Name(_) => return Ok(Term::Parameter(parameter(node)?)),
        Kind::List(_) => {}
    }
    let (head, mut fields) = Fields::headed(node, "a term")?;
    let boxed = |fields: &mut Fields<'_>| fields.term().map(Box::new);
    let term = match head {
        "+" => return Ok(Term::Sum(fields.items("a term", &term)?)),
        "*" => return Ok(Term::Product(fields.items("a term", &term)?)),
        "det" => {
            let rows = fields.all("a row", |row| Fields::of(row, "a row")?.all("a term", term))?;
            return Ok(Term::Determinant(rows));
        }
        "-" if fields.rest.len() == 1 => Term::Negative(boxed(&mut fields)?),
        "-" => Term::Difference(boxed(&mut fields)?, boxed(&mut fields)?),
        "/" => Term::Quotient(boxed(&mut fields)?, boxed(&mut fields)?),
        "^" => Term::Power(boxed(&mut fields)?, fields.int()?),
        "t" => Term::Knot(fields.name()?, fields.int()?),
        "x" => Term::Point(fields.place()?),
        "integer" => Term::Integer(fields.int()?),
        "w" | "v" | "Dw" | "G" | "DG" => {
            let of = match head {
                "w" => Of::Rise,
                "v" => Of::Fall,
                "Dw" => Of::Slope,
                "G" => Of::Value,
                _ => Of::Derivative,
            };
            Term::Function(of, fields.int()?, fields.int()?, fields.place()?)
        }
        "de-boor" => Term::DeBoor(fields.int()?, fields.int()?, fields.int()?, fields.place()?),
        "at" => {
            let pairs =
                Fields::of(fields.next("replacements")?, "replacements")?.all("a replacement", |pair| {
                    let mut pair = Fields::of(pair, "a replacement")?;
                    let replacement = (pair.name()?, pair.term()?);
                    pair.end()?;
                    Ok(replacement)
                })?;
            Term::At(pairs, boxed(&mut fields)?)
        }
        _ => return Ok(Term::Parameter(parameter(node)?)),
    };
    fields.end()?;
    Ok(term)
}

fn formula(node: &Node) -> Result<Formula, Reason> {
    let (head, mut fields) = Fields::headed(node, "a formula")?;
    let formula = match head {
        "=" => Formula::Equal(fields.term()?, fields.term()?),
        ">" => Formula::Greater(fields.term()?, fields.term()?),
        ">=" => Formula::AtLeast(fields.term()?, fields.term()?),
        "<" => {
            let smaller = fields.term()?;
            Formula::Greater(fields.term()?, smaller)
        }
        "defined" => Formula::Defined(fields.term()?),
        "order" => Formula::Order(fields.int()?, fields.int()?, fields.place()?, fields.int()?),
        "outside" => Formula::Outside(fields.place()?, fields.term()?, fields.terms()?),
        "pole" => Formula::Pole(fields.place()?, fields.terms()?, fields.number()?),
        _ => return wrong(node.line, "a formula"),
    };
    fields.end()?;
    Ok(formula)
}

fn gap(node: &Node) -> Result<GapText, Reason> {
    match &node.kind {
        Kind::Name(name) if name == "any" => Ok(GapText::Any),
        Kind::Name(name) if name == "some" => Ok(GapText::Some),
        _ => Ok(GapText::Term(term(node)?)),
    }
}

fn section(mut fields: Fields<'_>) -> Result<SectionText, Reason> {
    let mut ranges = Vec::new();
    while let Some(mut part) = fields.part("each") {
        ranges.push(part.range()?);
        part.end()?;
    }
    let mut parameters = |head| {
        fields
            .part(head)
            .map_or_else(|| Ok(Vec::new()), |part: Fields<'_>| part.items("a parameter", &parameter))
    };
    let (real, nonnegative, positive) =
        (parameters("real")?, parameters("nonnegative")?, parameters("positive")?);
    let (mut lets, mut windows) = (Vec::new(), Vec::new());
    while let Some(mut part) = fields.part("let") {
        lets.push((part.name()?, part.term()?));
        part.end()?;
    }
    while let Some(mut part) = fields.part("window") {
        let (name, first) = (part.head()?, part.int()?);
        windows.push(WindowText { name, first, knots: Knots::Gaps(part.items("a gap", &gap)?) });
    }
    while let Some(mut part) = fields.part("knots") {
        let (name, first, line) = (part.head()?, part.int()?, part.line);
        let numbers = part.all("a knot", number)?;
        if numbers.len() < 2 {
            return wrong(line, "two knots at least");
        }
        windows.push(WindowText { name, first, knots: Knots::Numbers(numbers) });
    }
    let goals = fields.need("goals")?.items("a formula", &formula)?;
    fields.end()?;
    Ok(SectionText { ranges, real, nonnegative, positive, lets, windows, goals })
}

pub(crate) fn statement(node: &Node) -> Result<Statement, Reason> {
    let ("statement", mut fields) = Fields::headed(node, "(statement 1 …)")? else {
        return wrong(node.line, "(statement 1 …)");
    };
    version(&mut fields)?;
    let mut part = fields.need("claim")?;
    let claim = part.text()?;
    part.end()?;
    let mut part = fields.need("form")?;
    let fixed = part.part("degree").map(|mut inner| inner.integer().and_then(|k| inner.end().map(|()| k)));
    let fixed = fixed.transpose()?;
    let form = match fixed {
        Some(degree) => format!("degree {degree}"),
        None => part.word("printed, amended or (degree K)", &["printed", "amended"])?,
    };
    part.end()?;
    let mut one_of = |head, expected, words: &[&str]| -> Result<String, Reason> {
        let mut part = fields.need(head)?;
        let word = part.word(expected, words)?;
        part.end()?;
        Ok(word)
    };
    let verdict = one_of("verdict", "proved or refuted", &["proved", "refuted"])?;
    let scope =
        one_of("scope", "points, instance, alpha or knots", &["points", "instance", "alpha", "knots"])?;
    let part = fields.need("degrees")?;
    let expected = "degrees from 0 to 100, rising";
    let line = part.line;
    let degrees = part.all(expected, |node| match number(node)?.integer().map(usize::try_from) {
        Some(Ok(degree @ 0..=100)) => Ok(degree),
        _ => wrong(node.line, expected),
    })?;
    if !degrees.is_sorted_by(|a, b| a < b) {
        return wrong(line, expected);
    }
    if fixed.is_some_and(|fixed| !degrees.iter().all(|degree| i64::try_from(*degree) == Ok(fixed))) {
        return Err(Reason::Degrees);
    }
    for head in ["text", "because"] {
        let mut part = fields.need(head)?;
        part.text()?;
        part.end()?;
    }
    let sections = fields.all("a section", |node| match Fields::headed(node, "a section")? {
        ("section", fields) => section(fields),
        _ => wrong(node.line, "a section"),
    })?;
    Ok(Statement { claim, form, verdict, scope, degrees, sections })
}

fn version(fields: &mut Fields<'_>) -> Result<(), Reason> {
    let line = fields.line;
    if fields.integer()? == 1 { Ok(()) } else { wrong(line, "format 1") }
}

fn rule(node: &Node) -> Result<Rule, Reason> {
    let (head, mut fields) = Fields::headed(node, "a rule")?;
    let rule = match head {
        "by" => {
            let mut options = Options::default();
            for (head, option) in [("weights", &mut options.weights), ("functions", &mut options.functions)] {
                if let Some(mut part) = fields.part(head) {
                    let degree = part.integer()?;
                    if degree < 0 {
                        return wrong(part.line, "a degree");
                    }
                    *option = Some(degree);
                    part.end()?;
                }
            }
            if let Some(part) = fields.part("using") {
                options.using = part.all("a lemma and its factor", |pair| {
                    let mut pair = Fields::of(pair, "a lemma and its factor")?;
                    let used = (pair.integer()?, pair.term()?);
                    pair.end()?;
                    Ok(used)
                })?;
            }
            Rule::By(options)
        }
        "split" => {
            let at = parameter(fields.next("a parameter")?)?;
            let (line, bound) = (fields.line, fields.number()?);
            if !bound.is_positive() {
                return wrong(line, "a positive number");
            }
            let first = rule(fields.next("a rule")?)?;
            Rule::Split(at, bound, Box::new(first), Box::new(rule(fields.next("a rule")?)?))
        }
        "orders" => Rule::Orders,
        "evaluate" => Rule::Evaluate,
        "functional" => {
            let pairs = fields.all("a number and a point", |pair| {
                let mut pair = Fields::of(pair, "a number and a point")?;
                let (line, factor, point) = (pair.line, pair.number()?, pair.number()?);
                pair.end()?;
                if point.is_positive() || point.is_zero() {
                    Ok((factor, point))
                } else {
                    wrong(line, "a point u ≥ 0")
                }
            })?;
            return Ok(Rule::Functional(pairs));
        }
        _ => return wrong(node.line, "a rule"),
    };
    fields.end()?;
    Ok(rule)
}

pub(crate) fn proof(node: &Node) -> Result<Vec<SectionProof>, Reason> {
    let ("proof", mut fields) = Fields::headed(node, "(proof 1 …)")? else {
        return wrong(node.line, "(proof 1 …)");
    };
    version(&mut fields)?;
    fields.all("a section", |node| {
        let ("section", mut fields) = Fields::headed(node, "a section")? else {
            return wrong(node.line, "a section");
        };
        let number = fields.integer()?;
        let (mut lemmas, mut goals) = (Vec::new(), Vec::new());
        while let Some(mut part) = fields.part("lemma") {
            let label = part.integer()?;
            lemmas.push((label, formula(part.next("a formula")?)?, rule(part.next("a rule")?)?));
            part.end()?;
        }
        while let Some(mut part) = fields.part("goal") {
            goals.push((part.integer()?, rule(part.next("a rule")?)?));
            part.end()?;
        }
        fields.end()?;
        Ok(SectionProof { number, lemmas, goals })
    })
}
