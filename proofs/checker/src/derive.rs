//! From a claim's sentence to sections: for every place of x the window there, and what has to be shown on it.
//!
//! Whatever is not understood, or not decided, is no derivation. Hypotheses may be left out: what is shown is then stronger.

use std::collections::HashSet;
use std::rc::Rc;

use crate::case::{At, Bound, Case, Stop, read};
use crate::error::{Reason, Result};
use crate::family::Family;
use crate::numbers::declared;
use crate::obligation::{
    Obligation, Point, Subject, is_variable, may_be_infinite, names_index, obligations, side, subjects,
};
use crate::place::{Place, fine};
use crate::token::Node;
use crate::truth::Truth;
use crate::value::Value;
use crate::work::spend;

/// (order 0 d …), where the function begins at the first of q knots, for q = 1, …, d + 1.
fn orders_at_knots<'t>(d: i64) -> Vec<Node<'t>> {
    let section = |q: i64| {
        let gap = |e: i64| match e {
            _ if e == q - 1 => Node::name_of("some"),
            _ if (0..q).contains(&e) => Node::whole_of(0),
            _ => Node::name_of("any"),
        };
        let head = [Node::name_of("W"), Node::whole_of(-d)];
        let window = Node::made("window", head.into_iter().chain((-d..=q + d).map(gap)).collect());
        let place = Node::made("in", vec![Node::name_of("W"), Node::whole_of(q - 1)]);
        let order =
            Node::made("order", vec![Node::whole_of(0), Node::whole_of(d), place, Node::whole_of(d + 1 - q)]);
        Node::made("section", vec![window, Node::made("goals", vec![order])])
    };
    (1..=d + 1).map(section).collect()
}

/// The sections of a sentence for degree k.
pub(crate) fn sections<'t>(
    family: &Rc<Family<'t>>,
    definitions: &[Node<'t>],
    sentence: &Node<'t>,
    k: i64,
) -> Result<Vec<Node<'t>>> {
    let mut all = Vec::new();
    for subject in subjects(definitions, sentence, k)? {
        for (number, obligation) in (1..).zip(obligations(sentence, k, &subject, false)?) {
            if let Some(Ok([d])) = obligation.conclusion.as_ref().map(|of| of.part::<1>("order")) {
                all.extend(orders_at_knots(d.whole()?));
                continue;
            }
            let mut walk = Walk::new(&obligation, family, definitions, k)?;
            let found = match subject {
                Subject::Example(_) | Subject::Weights => walk.numbers(&subject)?,
                Subject::Knots => match walk.all()? {
                    Err(_) if obligation.is("symmetric") => {
                        walk.mirrored = true;
                        walk.all()?
                    }
                    found => found,
                }
                .map_err(|place| place.to_string()),
            };
            all.extend(found.map_err(|place| Reason::Undecided(number, place))?);
        }
    }
    Ok(all)
}

/// One obligation for one degree.
pub(crate) struct Walk<'w, 't> {
    pub(crate) family: &'w Rc<Family<'t>>,
    pub(crate) obligation: &'w Obligation<'t>,
    /// Those of the obligation, and the intervals of its reals.
    pub(crate) hypotheses: Vec<Node<'t>>,
    pub(crate) point: Point<'t>,
    pub(crate) definitions: &'w [Node<'t>],
    pub(crate) k: i64,
    mirrored: bool,
    /// What is known of r, and of the ratios of other indices.
    pub(crate) declared: Vec<Node<'t>>,
    pub(crate) ratios: Vec<(&'t str, Node<'t>)>,
    /// Their order may still be asked for.
    pub(crate) free: bool,
}

impl<'w, 't> Walk<'w, 't> {
    fn new(
        obligation: &'w Obligation<'t>,
        family: &'w Rc<Family<'t>>,
        definitions: &'w [Node<'t>],
        k: i64,
    ) -> Result<Self> {
        let hypotheses = obligation.all_hypotheses();
        let point = match (&obligation.subject, obligation.point()) {
            (Some(Subject::Knots), point) => point?,
            (Some(Subject::Example(_)), Ok(Point::Real(name))) => Point::Real(name),
            _ => Point::Any,
        };
        let known = match may_be_infinite(&hypotheses) {
            false => side(&hypotheses),
            true if obligation.subject == Some(Subject::Knots) => {
                return Err(Reason::NoWindow(
                    "a hypothesis takes an index for a number that may be infinite",
                ));
            }
            true => None,
        };
        // An order of 1 and r.
        let declared = known.map_or_else(Vec::new, |side| declared(&[(-side).max(0), side.max(0)]));
        Ok(Walk {
            family,
            obligation,
            hypotheses,
            point,
            definitions,
            k,
            mirrored: false,
            declared,
            ratios: Vec::new(),
            free: false,
        })
    }

    /// The sections of all places, or the place where something is not decided.
    fn all(&self) -> Result<std::result::Result<Vec<Node<'t>>, Place>> {
        let mut found = Vec::new();
        for coarse in [Place::Before, Place::Inside, Place::Start, Place::End, Place::After] {
            if self.at(coarse, &mut found)? {
                continue;
            }
            let finer: Vec<_> = match coarse {
                Place::Start => fine(Place::First, self.k).chain(fine(Place::Knot, self.k)).collect(),
                Place::End => fine(Place::Last, self.k).collect(),
                _ => return Ok(Err(coarse)),
            };
            for place in finer {
                if !self.at(place, &mut found)? {
                    return Ok(Err(place));
                }
            }
        }
        Ok(Ok(found))
    }

    /// The section of a place, if anything is to be shown there; `false` if something is not decided that has to be.
    fn at(&self, place: Place, found: &mut Vec<Node<'t>>) -> Result<bool> {
        if self.obligation.forbids(place, self.k)? {
            return Ok(true);
        }
        let mut case = Case::new(self.family, self.definitions, self.k, place)?;
        case.symmetric = self.obligation.is("symmetric");
        case.mirrored = self.mirrored;
        // Gaps are closed first: the window is one for all cases.
        case.open()?;
        if !case.learn(&self.hypotheses)?
            || !case.coincide(&self.hypotheses)?
            || !case.learn(&self.hypotheses)?
        {
            return Ok(true);
        }
        let fixed = case.open()?;
        for (name, of) in &self.obligation.reals {
            let bound = self.real(&mut case, name, of.as_ref())?;
            case.reals.push((name, bound));
        }
        self.show(case, fixed, found)
    }

    /// What a real is: x, or any number of its sign.
    pub(crate) fn real(
        &self,
        case: &mut Case<'w, 't>,
        name: &'t str,
        of: Option<&Node<'t>>,
    ) -> Result<Bound<'t>> {
        let own = Node::name_of(name);
        Ok(match of {
            _ if self.point == Point::Real(name) => Bound::Point(At::X),
            Some(sign) if sign.is_word(">") => Bound::Free(case.parameter("positive", own)?),
            Some(sign) if sign.is_word("<") => {
                Bound::Free(case.parameter("positive", own)?.times(Value::whole(-1))?)
            }
            _ => Bound::Free(case.parameter("real", own)?),
        })
    }

    /// The section of a case, if anything is to be shown there; `false` if something is not decided that has to be.
    pub(crate) fn show(
        &self,
        mut case: Case<'w, 't>,
        fixed: Vec<Node<'t>>,
        found: &mut Vec<Node<'t>>,
    ) -> Result<bool> {
        if self.is_false(&mut case)? {
            return Ok(true);
        }
        let mut goals = Vec::new();
        if !self.cases(&self.obligation.integers, &mut case, &mut goals)? {
            return Ok(false);
        }
        if goals.is_empty() {
            return Ok(true);
        }
        let mut named = HashSet::new();
        let mut note = |node: &Node<'t>| {
            if node.is_flat() {
                named.insert(node.clone());
            }
            false
        };
        goals.iter().for_each(|goal: &Node<'t>| _ = goal.any(&mut note));
        // A parameter is a name, or one with numbers.
        let declared = case.parameters.iter().filter(|(_, name)| named.contains(name));
        let mut fields: Vec<_> = declared.map(|(sign, name)| Node::made(sign, vec![name.clone()])).collect();
        fields.extend(self.declared.iter().cloned());
        fields.extend(fixed);
        fields.push(Node::made("goals", goals));
        found.push(Node::made("section", fields));
        Ok(true)
    }

    /// Every choice of the integers, the last one fastest; `false` if one of them is not decided.
    fn cases(
        &self,
        integers: &[Vec<Node<'t>>],
        case: &mut Case<'w, 't>,
        goals: &mut Vec<Node<'t>>,
    ) -> Result<bool> {
        let Some((first, rest)) = integers.split_first() else { return self.one(case, goals) };
        let [name, low, high] = first.as_slice() else { return Ok(false) };
        let each = case.each([name, low, high], |case, _| {
            // What is false already is so whatever the others are.
            (case.knot, case.on_knot) = (None, false);
            if !case.learn(&self.hypotheses)? || self.is_false(case)? || self.cases(rest, case, goals)? {
                Ok(())
            } else {
                Err(Stop::Undecided)
            }
        });
        Ok(read(each)?.is_some())
    }

    /// Whether a hypothesis is false with the integers so far.
    pub(crate) fn is_false(&self, case: &mut Case<'w, 't>) -> Result<bool> {
        for hypothesis in &self.hypotheses {
            if case.truth(hypothesis)? == Truth::False {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// All integers are chosen.
    fn one(&self, case: &mut Case<'w, 't>, goals: &mut Vec<Node<'t>>) -> Result<bool> {
        let facts = case.facts.clone();
        let decided = if case.learn(&self.hypotheses)? { self.decided(case, goals)? } else { true };
        case.facts = facts;
        Ok(decided)
    }

    fn decided(&self, case: &mut Case<'w, 't>, goals: &mut Vec<Node<'t>>) -> Result<bool> {
        let (mut open, mut undefined) = (false, false);
        let coarse = matches!(case.place, Place::Start | Place::End);
        if let Point::Knot(knot) = &self.point {
            case.knot = case.index(knot)?;
            case.on_knot = false;
            let x = Node::made("x", Vec::new());
            let at_knot = Node::made("chain", vec![x, Node::made("=", vec![knot.clone()])]);
            match case.truth(&at_knot)? {
                Truth::False => return Ok(true),
                truth => {
                    open |= coarse && !truth.is_true();
                    undefined |= truth == Truth::Undefined;
                }
            }
            case.on_knot = true;
        }
        for hypothesis in &self.hypotheses {
            match case.truth(hypothesis)? {
                Truth::False => return Ok(true),
                Truth::Undefined => undefined = true,
                truth if truth.is_true() => {}
                // It may be decided at a finer place, or for an order of ratios.
                _ => {
                    open |= if coarse {
                        self.names_point(hypothesis)
                    } else {
                        self.free && names_index(hypothesis)
                    }
                }
            }
        }
        if undefined {
            return Ok(false);
        }
        let Some(conclusion) = &self.obligation.conclusion else { return Ok(false) };
        let truth = case.truth(conclusion)?;
        match truth {
            truth if truth.is_true() => Ok(true),
            Truth::Goals(new) if !open => {
                spend(goals.len())?;
                for goal in new {
                    if !goals.contains(&goal) {
                        goals.push(goal);
                    }
                }
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    fn names_point(&self, hypothesis: &Node<'t>) -> bool {
        hypothesis.any(&mut |node| match &self.point {
            Point::Any => false,
            Point::Real(name) => is_variable(node, name),
            Point::Knot(knot) => node == knot,
        })
    }
}
