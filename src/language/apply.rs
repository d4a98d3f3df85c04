//! What stands in brackets behind a name: points, and what built-in functions and words are said of.

use super::complaint::{Fault, Place, ensure, fault};
use super::known::Kind;
use super::raw::{Given, Node, Raw, RawMember};
use super::resolve::{Resolved, Scope, Typed, bounded, derived};
use super::syntax::{Argument, Formula, Function, Int, Item, Member, Real, Use};
use super::words::{Sort, Word};

impl Scope<'_> {
    /// What stands in brackets behind something: a point, or what a built-in function or a word is said of.
    pub(super) fn call(&mut self, of: &Node, with: &[Given], at: &Place) -> Resolved<Typed> {
        if let Raw::Name { name, primes } = &of.raw {
            self.in_file(name, &of.at)?;
            if matches!(name.as_str(), "phi" | "f") {
                return self.phi(name, *primes, with, at);
            }
            if let (0, Some(typed)) = (*primes, self.built_in(name, with, at)?) {
                return Ok(typed);
            }
        }
        let function = self.function(of)?;
        ensure(with.len() == 1, at, "a function is taken at one point", "write `(x)`")?;
        Ok(Typed::Real(Real::Value(Box::new(function), Box::new(self.argument(&with[0], None)?))))
    }

    fn function(&mut self, of: &Node) -> Resolved<Function> {
        match self.typed(of)? {
            Typed::Function(function) => Ok(function),
            other => {
                let rule = format!("expected a function, this is {}", other.what());
                fault(&of.at, rule, "a product is written with `*`, a function `G[i]`")
            }
        }
    }

    /// phi(x, a, b): the first is the point, the last one carries the member.
    fn phi(&mut self, name: &str, primes: usize, with: &[Given], at: &Place) -> Resolved<Typed> {
        let [point, from, to] = with else {
            let rule = format!("`{name}` takes a point and two ends");
            return fault(at, rule, format!("write `{name}(x, a, b)`"));
        };
        if let Some(family) = self.known.family.as_ref().filter(|family| !family.by_ends) {
            let rule = format!("a weight of the family {} depends on more than two ends", family.name);
            return fault(at, rule, "write `w[i,d](x)`");
        }
        for end in [from, to] {
            no_side(end)?;
        }
        let last = point.member.is_none() && from.member.is_none();
        ensure(last, at, "the other index comes last", format!("write `{name}(x, a, b; alpha = …)`"))?;
        let function =
            Function::Phi { cut: name == "phi", from: self.real(&from.node)?, to: self.real(&to.node)? };
        let argument = self.argument(point, to.member.as_ref())?;
        Ok(Typed::Real(Real::Value(Box::new(derived(function, primes, at)?), Box::new(argument))))
    }

    fn argument(&mut self, given: &Given, member: Option<&RawMember>) -> Resolved<Argument> {
        let member = self.member(given.member.as_ref().or(member))?;
        Ok(Argument { at: self.real(&given.node)?, side: given.side, member })
    }

    fn member(&mut self, member: Option<&RawMember>) -> Resolved<Option<Member>> {
        let Some((name, at, value)) = member else { return Ok(None) };
        let Some(value) = value else { return Ok(Some(Member::Dual)) };
        let known = self.known;
        if let Some(family) = &known.family {
            let own = family.parameters.iter().find(|(own, of)| **own == **name && of.is_empty());
            let Some((own, _)) = own else {
                let advice =
                    format!("write `; dual`, or a parameter without an index; it has {}", family.has());
                return fault(at, format!("the family {} has no `{name}` here", family.name), advice);
            };
            return Ok(Some(Member::Parameter(own.clone(), self.real(value)?)));
        }
        Ok(Some(match name.as_str() {
            "alpha" => Member::Index(match self.typed(value)? {
                Typed::Infinity => Real::Infinity,
                Typed::Real(Real::Index(name)) if *name == *"alpha" => return Ok(None),
                other => other.real(&value.at)?,
            }),
            "r" => Member::Ratio(self.real(value)?),
            _ => return fault(at, format!("the family has no `{name}`"), "write `; alpha = …` or `; r = …`"),
        }))
    }

    /// abs(a), D(f, q), words.
    fn built_in(&mut self, name: &str, with: &[Given], at: &Place) -> Resolved<Option<Typed>> {
        let plain = |count: usize, form: &str| {
            let rule = format!("`{name}` takes another number of terms");
            ensure(with.len() == count, at, rule, format!("write `{form}`"))?;
            with.iter().try_for_each(|given| {
                no_side(given)?;
                no_member(given)
            })
        };
        Ok(Some(match name {
            "abs" | "sqrt" => {
                plain(1, &format!("{name}(a)"))?;
                let of = Box::new(self.real(&with[0].node)?);
                Typed::Real(if name == "abs" { Real::Absolute(of) } else { Real::Root(of) })
            }
            "min" | "max" => {
                plain(2, &format!("{name}(a, b)` or `{name}(i in 0..n: …)"))?;
                let (a, b) = (self.real(&with[0].node)?, self.real(&with[1].node)?);
                Typed::of(if name == "min" { a.least(b) } else { a.greatest(b) })
            }
            "binomial" => {
                plain(2, "binomial(a, b)")?;
                let (a, b) = (self.int(&with[0].node)?, self.int(&with[1].node)?);
                Typed::Int(Int::Binomial(Box::new(a), Box::new(b)))
            }
            "D" => {
                plain(2, "D(G[i], q)")?;
                let (function, order) = (self.function(&with[0].node)?, self.place(&with[1].node)?);
                bounded(&order, &with[1].node.at)?;
                Typed::Function(Function::Derivative(Box::new(function), order))
            }
            _ => match Word::ALL.iter().find(|word| word.name() == name) {
                Some(word) => self.word(*word, with, at)?,
                None => return Ok(None),
            },
        }))
    }

    fn word(&mut self, word: Word, with: &[Given], at: &Place) -> Resolved<Typed> {
        let mut of = Vec::new();
        let mut rest = with.iter();
        let wrong_number = || Fault {
            at: at.clone(),
            rule: format!("`{}` is said of another number of things", word.name()),
            advice: format!("write it like `{}`", shape(word)),
        };
        for sort in word.takes() {
            let given = rest.next().ok_or_else(wrong_number)?;
            no_side(given)?;
            if *sort != Sort::Function {
                no_member(given)?;
            }
            of.push(match sort {
                Sort::Int => Item::Int(self.int(&given.node)?),
                Sort::Real => Item::Real(self.real(&given.node)?),
                Sort::Function => {
                    Item::Function(self.function(&given.node)?, self.member(given.member.as_ref())?)
                }
                Sort::Coefficients => match self.typed(&given.node)? {
                    Typed::Coefficients(name) => Item::Coefficients(name),
                    other => {
                        let rule =
                            format!("`{}` is said of control values, this is {}", word.name(), other.what());
                        let advice = "give the name of control values that `for` binds: `d points`";
                        return fault(&given.node.at, rule, advice);
                    }
                },
                Sort::Expression => {
                    let variable = rest.next().ok_or_else(wrong_number)?;
                    self.expression(&given.node, &variable.node)?
                }
                Sort::Truth => continue,
            });
        }
        if rest.next().is_some() {
            return Err(wrong_number());
        }
        let used = Box::new(Use { word, of });
        Ok(match word.gives() {
            Sort::Int => Typed::Int(Int::Word(used)),
            Sort::Truth => Typed::Formula(Formula::Word(used)),
            _ => Typed::Real(Real::Word(used)),
        })
    }

    /// A term as a function of `x`, or of `x in [a, b]`.
    fn expression(&mut self, term: &Node, variable: &Node) -> Resolved<Item> {
        let (name, domain) = match &variable.raw {
            Raw::In(name, domain) => (&**name, Some(&**domain)),
            _ => (variable, None),
        };
        let Raw::Name { name, primes: 0 } = &name.raw else {
            let rule = "expected the variable of the term before it";
            return fault(&variable.at, rule, "write `C(x), x` or `C(x), x in [a, b]`");
        };
        let interval = domain.map(|domain| self.interval(domain)).transpose()?;
        self.bound(name, Kind::Real, &variable.at, |scope, name| {
            Ok(Item::Expression(scope.real(term)?, name, interval))
        })
    }
}

fn no_side(given: &Given) -> Resolved<()> {
    let advice = "write `G[i](x-)`";
    ensure(given.side.is_none(), &given.node.at, "a limit is taken at the point of a function", advice)
}

fn no_member(given: &Given) -> Resolved<()> {
    let at = given.member.as_ref().map_or(&given.node.at, |(_, at, _)| at);
    let advice = "write it behind the point: `G[i](x; alpha = …)`";
    ensure(given.member.is_none(), at, "only a function has another index", advice)
}

/// How a word is written.
fn shape(word: Word) -> String {
    let of = word.takes().iter().map(|sort| match sort {
        Sort::Int => "k",
        Sort::Real | Sort::Truth => "x",
        Sort::Function => "G[i]",
        Sort::Expression => "C(x), x in [a, b]",
        Sort::Coefficients => "d",
    });
    format!("{}({})", word.name(), of.collect::<Vec<_>>().join(", "))
}
