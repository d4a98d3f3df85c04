//! A sentence in brackets, for a checker that reads no language: one form for each variant of the tree, no precedence.

use std::collections::BTreeSet;

use num_rational::BigRational;

use super::super::family::{Family, Parameter};
use super::super::rows::Row;
use super::super::syntax::{
    Adjective, Argument, Binder, Definition, Fold, Formula, Function, Gap, Int, Interval, Item, Member, Name,
    Over, Pattern, Range, Real, Relation, Sentence, Side, Use,
};

/// The sentence that another one names, by identifier and form (printed?), with the definitions of its file.
pub type Claimed<'a> = dyn Fn(&str, bool) -> Option<(&'a Sentence, &'a [Definition])> + 'a;

/// `(define …)` for each definition that the sentence uses, directly or through others, then `(sentence …)`: the form that
/// proofs/FORMAT.md describes. Two different sentences have two different texts.
///
/// # Errors
/// The name of a claim that `named` does not know, or of a definition that two of the files read differently.
pub fn canonical<'a>(
    sentence: &'a Sentence,
    definitions: &'a [Definition],
    examples: &[Row],
    named: &Claimed<'a>,
) -> Result<String, Name> {
    let mut walk = Walk { definitions, examples, named, used: BTreeSet::new(), defines: Vec::new() };
    let text = walk.sentence("sentence", sentence)?;
    walk.defines.push(text);
    Ok(walk.defines.join("\n"))
}

/// `(family "NAME" (parameter …)… (rise …) (fall …) (dual …))`, with the name that it has in its file.
///
/// # Errors
/// What a certificate can't say of its weights: what both shares are divided by, or the name of a definition.
pub fn canonical_family(family: &Family) -> Result<String, Name> {
    if family.over.is_some() {
        return Err("over".into());
    }
    if let Some(definition) = family.definitions.first() {
        return Err(definition.name.clone());
    }
    let mut walk = Walk {
        definitions: &[],
        examples: &[],
        named: &|_, _| None,
        used: BTreeSet::new(),
        defines: Vec::new(),
    };
    let mut parts = vec![format!("\"{}\"", family.name)];
    for Parameter { name, indices, bounds, .. } in &family.parameters {
        let indices = indices.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
        let bounds = bounds.iter().map(|(of, bound)| format!(" ({} {})", relation(*of), number(bound)));
        parts.push(format!("(parameter {name} ({indices}){})", bounds.collect::<String>()));
    }
    parts.push(walk.reals("rise", [&family.rise])?);
    parts.push(walk.reals("fall", [&family.fall])?);
    if let Some(dual) = &family.dual {
        let all: Result<Vec<_>, _> = dual.iter().map(|(name, term)| walk.reals(name, [term])).collect();
        parts.push(bracket("dual", all?));
    }
    Ok(bracket("family", parts))
}

struct Walk<'w, 'a> {
    definitions: &'a [Definition],
    examples: &'w [Row],
    named: &'w Claimed<'a>,
    /// Definitions that are printed, or about to be.
    used: BTreeSet<Name>,
    defines: Vec<String>,
}

type Text = Result<String, Name>;

fn bracket(head: &str, fields: impl IntoIterator<Item = String>) -> String {
    let mut text = format!("({head}");
    for field in fields {
        text.push(' ');
        text.push_str(&field);
    }
    text + ")"
}

impl<'a> Walk<'_, 'a> {
    fn sentence(&mut self, head: &str, of: &'a Sentence) -> Text {
        let mut given = Vec::new();
        for binder in &of.given {
            given.push(self.binder(binder)?);
        }
        let parts = [bracket("for", given), self.list("if", &of.assume)?, self.list("then", &of.then)?];
        Ok(bracket(head, parts))
    }

    /// The definitions of a name, once: first those that they use.
    fn define(&mut self, name: &Name) -> Result<(), Name> {
        if !self.used.insert(name.clone()) {
            return Ok(());
        }
        let mut own = Vec::new();
        for definition in self.definitions.iter().filter(|definition| definition.name == *name) {
            let pattern = |pattern: &Pattern| match pattern {
                Pattern::Number(number) => number.to_string(),
                Pattern::Any(name) => name.to_string(),
            };
            let patterns = definition.indices.iter().map(pattern).collect::<Vec<_>>().join(" ");
            let variable = definition.variable.as_ref().map_or("none", |name| name);
            let body = self.real(&definition.body)?;
            own.push(format!("(define {name} ({patterns}) {variable} {body})"));
        }
        self.defines.append(&mut own);
        Ok(())
    }

    /// The sentence of another stanza. Its definitions have to be the same, as a name has one meaning in a statement.
    fn claim(&mut self, id: &Name, printed: bool) -> Text {
        let (sentence, theirs) = (self.named)(id, printed).ok_or_else(|| id.clone())?;
        let ours = std::mem::replace(&mut self.definitions, theirs);
        let of = |all: &'a [Definition], name: &Name| {
            all.iter().filter(|other| other.name == *name).collect::<Vec<_>>()
        };
        let text = self.sentence("sentence", sentence)?;
        self.definitions = ours;
        let differs = |name: &&Name| {
            let (a, b) = (of(ours, name), of(theirs, name));
            !a.is_empty() && !b.is_empty() && a != b
        };
        match self.used.iter().find(differs) {
            Some(name) => Err(name.clone()),
            None => Ok(bracket("claim", [format!("\"{id}\""), text])),
        }
    }

    fn list(&mut self, head: &str, all: &'a [Formula]) -> Text {
        let all: Result<Vec<_>, _> = all.iter().map(|formula| self.formula(formula)).collect();
        Ok(bracket(head, all?))
    }

    fn binder(&mut self, of: &'a Binder) -> Text {
        Ok(match of {
            Binder::Degree { least, most } => bracket(
                "degree",
                [Some(*least), *most].into_iter().flatten().map(|degree| degree.to_string()),
            ),
            Binder::Knots(adjectives) => {
                bracket("knots", adjectives.iter().map(|a| adjective(*a).to_owned()))
            }
            Binder::Gaps(gaps) => {
                let gaps: Result<Vec<_>, _> = gaps.iter().map(|gap| self.gap(gap)).collect();
                bracket("gaps", gaps?)
            }
            Binder::Instances(all) => bracket("instances", all.iter().flat_map(|name| self.example(name))),
            Binder::Indices(all) => bracket(
                "alphas",
                all.iter().map(|index| index.as_ref().map_or("infinity".to_owned(), number)),
            ),
            Binder::Index(name) => format!("(index {name})"),
            Binder::Integer(range) => self.range("integer", range)?,
            Binder::Point(name, interval) => format!("(point {name} {})", self.interval(interval)?),
            Binder::Real { name, sign: None } => format!("(real {name})"),
            Binder::Real { name, sign: Some(sign) } => format!("(real {name} {})", relation(*sign)),
            Binder::Points(name) => format!("(points {name})"),
        })
    }

    /// The examples of a name, in numbers; of one that there is not, its name.
    fn example(&self, name: &Name) -> Vec<String> {
        let row = |row: &Row| {
            let list = |head: &str, of: &[BigRational]| bracket(head, of.iter().map(number));
            let point = |point: &Vec<BigRational>| {
                format!("({})", point.iter().map(number).collect::<Vec<_>>().join(" "))
            };
            let points = row.points.iter().map(|all| bracket("points", all.iter().map(point)));
            let head = [name.to_string(), row.degree.to_string(), list("knots", &row.knots)];
            bracket("instance", head.into_iter().chain(points))
        };
        match self.examples.iter().filter(|row| row.name.as_ref() == Some(name)).map(row).collect::<Vec<_>>()
        {
            none if none.is_empty() => vec![name.to_string()],
            rows => rows,
        }
    }

    fn gap(&mut self, gap: &'a Gap) -> Text {
        let size = self.real(&gap.size)?;
        match &gap.each {
            None => Ok(format!("(gap {size})")),
            Some(range) => Ok(format!("(gap {size} {})", self.range("integers", range)?)),
        }
    }

    fn range(&mut self, head: &str, of: &'a Range) -> Text {
        let ends = [self.int(&of.from)?, self.int(&of.to)?];
        Ok(format!("({head} {} {})", of.name, ends.join(" ")))
    }

    fn interval(&mut self, of: &'a Interval) -> Text {
        let end = |closed| if closed { "closed" } else { "open" };
        let (from, to) = (self.real(&of.from)?, self.real(&of.to)?);
        Ok(format!("({} {from} {} {to})", end(of.from_closed), end(of.to_closed)))
    }

    fn over(&mut self, of: &'a Over) -> Text {
        match of {
            Over::Integers(range) => self.range("integers", range),
            Over::Reals(name, interval) => Ok(format!("(reals {name} {})", self.interval(interval)?)),
        }
    }

    fn formula(&mut self, of: &'a Formula) -> Text {
        let mut all = |head: &str, parts: [&'a Formula; 2]| {
            let [a, b] = parts.map(|part| self.formula(part));
            Ok(format!("({head} {} {})", a?, b?))
        };
        match of {
            Formula::Implies(a, b) => all("=>", [a, b]),
            Formula::Iff(a, b) => all("<=>", [a, b]),
            Formula::All(over, of) => self.quantified("all", over, of),
            Formula::Some(over, of) => self.quantified("some", over, of),
            Formula::One(over, of) => self.quantified("one", over, of),
            Formula::Chain(first, rest) => {
                let mut fields = vec![self.real(first)?];
                for (sign, next) in rest {
                    fields.push(format!("({} {})", relation(*sign), self.real(next)?));
                }
                Ok(bracket("chain", fields))
            }
            Formula::Within(of, interval) => {
                Ok(format!("(in {} {})", self.real(of)?, self.interval(interval)?))
            }
            Formula::Among(of, from, to) => self.ints("among", [of, from, to]),
            Formula::Instance(names) => Ok(bracket("instance", names.iter().map(ToString::to_string))),
            Formula::Not(of) => Ok(format!("(not {})", self.formula(of)?)),
            Formula::And(all) => self.list("and", all),
            Formula::Or(all) => self.list("or", all),
            Formula::Word(of) => self.word("", of),
            Formula::Claim { id, printed } => self.claim(id, *printed),
        }
    }

    fn quantified(&mut self, head: &str, over: &'a Over, of: &'a Formula) -> Text {
        Ok(format!("({head} {} {})", self.over(over)?, self.formula(of)?))
    }

    fn ints<const N: usize>(&mut self, head: &str, all: [&'a Int; N]) -> Text {
        let all: Result<Vec<_>, _> = all.into_iter().map(|int| self.int(int)).collect();
        Ok(bracket(head, all?))
    }

    fn int(&mut self, of: &'a Int) -> Text {
        match of {
            Int::Number(number) => Ok(number.to_string()),
            Int::Bound(name) => Ok(name.to_string()),
            Int::Degree => Ok("k".to_owned()),
            Int::Last => Ok("n".to_owned()),
            Int::M => Ok("m".to_owned()),
            Int::Plus(a, b) => self.ints("+", [a, b]),
            Int::Minus(a, b) => self.ints("-", [a, b]),
            Int::Times(a, b) => self.ints("*", [a, b]),
            Int::Least(a, b) => self.ints("min", [a, b]),
            Int::Greatest(a, b) => self.ints("max", [a, b]),
            Int::Binomial(a, b) => self.ints("binomial", [a, b]),
            Int::Word(of) => self.word("", of),
        }
    }

    fn reals<const N: usize>(&mut self, head: &str, all: [&'a Real; N]) -> Text {
        let all: Result<Vec<_>, _> = all.into_iter().map(|real| self.real(real)).collect();
        Ok(bracket(head, all?))
    }

    /// A name with indices.
    fn indexed(&mut self, head: &str, name: &Name, indices: &'a [Int]) -> Text {
        let indices: Result<Vec<_>, _> = indices.iter().map(|int| self.int(int)).collect();
        Ok(bracket(&format!("{head} {name}"), indices?))
    }

    fn real(&mut self, of: &'a Real) -> Text {
        match of {
            Real::Number(value) => Ok(number(value)),
            Real::Whole(int) => self.ints("int", [int]),
            Real::Bound(name) => Ok(format!("(var {name})")),
            Real::Index(name) => Ok(format!("(alpha {name})")),
            Real::Ratio => Ok("ratio".to_owned()),
            Real::Infinity => Ok("infinity".to_owned()),
            Real::Knot(i) => self.ints("t", [i]),
            Real::Coefficient(name, indices) => self.indexed("coefficient", name, indices),
            Real::Parameter(name, indices) => self.indexed("parameter", name, indices),
            Real::Plus(a, b) => self.reals("+", [a, b]),
            Real::Minus(a, b) => self.reals("-", [a, b]),
            Real::Times(a, b) => self.reals("*", [a, b]),
            Real::Over(a, b) => self.reals("/", [a, b]),
            Real::Negated(a) => self.reals("neg", [a]),
            Real::Power(a, e) => Ok(format!("(^ {} {})", self.real(a)?, self.int(e)?)),
            Real::Absolute(a) => self.reals("abs", [a]),
            Real::Root(a) => self.reals("sqrt", [a]),
            Real::Least(a, b) => self.reals("min", [a, b]),
            Real::Greatest(a, b) => self.reals("max", [a, b]),
            Real::Fold(fold, range, body) => {
                let head = match fold {
                    Fold::Sum => "sum",
                    Fold::Product => "product",
                    Fold::Least => "least",
                    Fold::Greatest => "greatest",
                };
                let ends = [self.int(&range.from)?, self.int(&range.to)?].join(" ");
                Ok(format!("({head} {} {ends} {})", range.name, self.real(body)?))
            }
            Real::Defined(name, indices) => self.defined(name, indices),
            Real::Value(function, argument) => {
                Ok(format!("(of {} {})", self.function(function)?, self.argument(argument)?))
            }
            Real::Word(of) => self.word("word-", of),
        }
    }

    fn defined(&mut self, name: &Name, indices: &'a [Int]) -> Text {
        self.define(name)?;
        self.indexed("defined", name, indices)
    }

    fn function(&mut self, of: &'a Function) -> Text {
        match of {
            Function::Basis { i, degree: None } => self.ints("G", [i]),
            Function::Basis { i, degree: Some(degree) } => self.ints("G", [i, degree]),
            Function::Weight { i, degree } => self.ints("w", [i, degree]),
            Function::Phi { cut, from, to } => self.reals(if *cut { "phi" } else { "f" }, [from, to]),
            Function::Defined(name, indices) => self.defined(name, indices),
            Function::Derivative(of, order) => Ok(format!("(D {} {})", self.function(of)?, self.int(order)?)),
        }
    }

    fn argument(&mut self, of: &'a Argument) -> Text {
        let head = match of.side {
            None => "at",
            Some(Side::Left) => "left",
            Some(Side::Right) => "right",
        };
        let mut fields = vec![self.real(&of.at)?];
        if let Some(member) = &of.member {
            fields.push(self.member(member)?);
        }
        Ok(bracket(head, fields))
    }

    fn member(&mut self, of: &'a Member) -> Text {
        match of {
            Member::Index(alpha) => self.reals("alpha", [alpha]),
            Member::Ratio(ratio) => self.reals("ratio", [ratio]),
            Member::Parameter(name, _) => Err(Name::clone(name)),
            Member::Dual => Ok("(dual)".to_owned()),
        }
    }

    /// Words that measure have a head of their own: `sup` of a term is a term.
    fn word(&mut self, mark: &str, of: &'a Use) -> Text {
        let items: Result<Vec<_>, _> = of.of.iter().map(|item| self.item(item)).collect();
        Ok(bracket(&format!("{mark}{}", of.word.name().replace('_', "-")), items?))
    }

    fn item(&mut self, of: &'a Item) -> Text {
        match of {
            Item::Function(function, None) => Ok(format!("(function {})", self.function(function)?)),
            Item::Function(function, Some(member)) => {
                Ok(format!("(function {} {})", self.function(function)?, self.member(member)?))
            }
            Item::Expression(of, name, None) => Ok(format!("(expression {} {name})", self.real(of)?)),
            Item::Expression(of, name, Some(interval)) => {
                Ok(format!("(expression {} {name} {})", self.real(of)?, self.interval(interval)?))
            }
            Item::Coefficients(name) => Ok(format!("(coefficients {name})")),
            Item::Real(real) => self.reals("real", [real]),
            Item::Int(int) => self.ints("integer", [int]),
        }
    }
}

/// In lowest terms, as rationals always are.
fn number(value: &BigRational) -> String {
    value.to_string()
}

fn relation(of: Relation) -> &'static str {
    match of {
        Relation::Equal => "=",
        Relation::Unequal => "/=",
        Relation::Less => "<",
        Relation::AtMost => "<=",
        Relation::Greater => ">",
        Relation::AtLeast => ">=",
    }
}

fn adjective(of: Adjective) -> &'static str {
    match of {
        Adjective::Open => "open",
        Adjective::Clamped => "clamped",
        Adjective::Symmetric => "symmetric",
        Adjective::Simple => "simple",
        Adjective::Equidistant => "equidistant",
        Adjective::Bernstein => "bernstein",
        Adjective::Inner => "inner",
        Adjective::Interior => "interior",
    }
}
