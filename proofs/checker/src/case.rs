//! One place of x with what is known there, while the integers of a sentence are chosen.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::env::Env;
use crate::error::{Reason, Result};
use crate::family::Family;
use crate::fraction::Fraction;
use crate::obligation::Subject;
use crate::place::{Copies, Facts, Form, Gap, Place};
use crate::poly::Sign;
use crate::section::Section;
use crate::sentence::Example;
use crate::token::Node;
use crate::value::Value;
use crate::work::spend;

/// Terms with the definitions in them are read so deep.
const DEPTH: usize = 120;

/// Why there is no value.
pub(crate) enum Stop {
    /// It is not known, or not understood.
    Undecided,
    /// Something may not exist.
    Undefined,
    Rejected(Reason),
}

impl From<Reason> for Stop {
    fn from(reason: Reason) -> Self {
        Stop::Rejected(reason)
    }
}

pub(crate) type Found<T> = std::result::Result<T, Stop>;

/// Where a function is taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum At {
    /// At x.
    X,
    /// By the limits there.
    Left,
    Right,
    /// At t_0 + t_m − x.
    Mirrored,
}

/// What the name of a real stands for.
#[derive(Clone)]
pub(crate) enum Bound<'t> {
    Point(At),
    Free(Value<'t>),
}

/// Knots that are numbers, of an example or where a sentence is refuted.
#[derive(Clone)]
pub(crate) struct Numbers<'t> {
    pub(crate) x: Option<Node<'t>>,
    /// Where x is on its span, if that is not u.
    pub(crate) u: Option<Node<'t>>,
    pub(crate) knots: Vec<Node<'t>>,
    /// The example that they are of.
    pub(crate) example: Option<Node<'t>>,
    /// Where all is a number: (parameter NAME value…), (points NAME value…) and (index NAME ratio), among others.
    pub(crate) values: Option<Vec<Node<'t>>>,
}

impl<'t> Numbers<'t> {
    pub(crate) fn of_knots(knots: &[Node<'t>], of: &Subject<'t>, values: Option<Vec<Node<'t>>>) -> Self {
        let example = if let Subject::Example(row) = of { Some(row.clone()) } else { None };
        Numbers { x: None, u: None, knots: knots.to_vec(), example, values }
    }

    pub(crate) fn of(&self, kind: &'static str, name: &str, at: usize) -> Option<Node<'t>> {
        let list = |value: &Node<'t>| match value.fields(kind) {
            Ok([own, list @ ..]) if own.is_word(name) => list.get(at).cloned(),
            _ => None,
        };
        self.values.as_ref()?.iter().find_map(list)
    }

    /// A coordinate of a control point of the example.
    pub(crate) fn coordinate(&self, i: i64, coordinate: i64) -> Option<Node<'t>> {
        Example::of(self.example.as_ref()?).ok()?.coordinate(i, coordinate).cloned()
    }

    /// (knots W 0 t_0 …), which counts as the knots are counted.
    pub(crate) fn window(&self) -> Node<'t> {
        let head = [Node::name_of("W"), Node::whole_of(0)];
        Node::made("knots", head.into_iter().chain(self.knots.iter().cloned()).collect())
    }
}

pub(crate) struct Case<'c, 't> {
    pub(crate) family: Rc<Family<'t>>,
    pub(crate) definitions: &'c [Node<'t>],
    pub(crate) k: i64,
    pub(crate) place: Place,
    pub(crate) facts: Facts,
    /// The window and the parameters.
    pub(crate) section: Section<'t>,
    /// The parameters of the derivation, with what declares them.
    pub(crate) parameters: Vec<(&'static str, Node<'t>)>,
    /// x, and under its index each knot of the window, as far as somebody has asked: in most hypotheses there is one.
    pub(crate) shown_knots: BTreeMap<Option<i64>, Value<'t>>,
    /// The first and the last knot of the window, counted from s.
    pub(crate) shown: (i64, i64),
    /// Gaps that hypotheses close.
    pub(crate) closed: Vec<i64>,
    pub(crate) ints: Vec<(&'t str, Form)>,
    pub(crate) reals: Vec<(&'t str, Bound<'t>)>,
    /// The index of the knot that the point is.
    pub(crate) knot: Option<Form>,
    /// It is known that x is this knot.
    pub(crate) on_knot: bool,
    pub(crate) symmetric: bool,
    /// Integers run around the mirror image of the span.
    pub(crate) mirrored: bool,
    /// Ratios of other indices, as far as they are known.
    pub(crate) ratios: Vec<(&'t str, Node<'t>)>,
    /// Another member of the family: what is replaced.
    pub(crate) member: Option<Node<'t>>,
    pub(crate) numbers: Option<Numbers<'t>>,
    /// Functions are values, where knots are numbers.
    pub(crate) exact: bool,
    /// Something was not decided.
    pub(crate) undecided: bool,
    /// Names of far numbers so far.
    pub(crate) far: usize,
    /// How deep the terms are that are being read, those of definitions in them.
    pub(crate) depth: usize,
}

impl<'c, 't> Case<'c, 't> {
    /// A place of which nothing but itself is known.
    pub(crate) fn new(
        family: &Rc<Family<'t>>,
        definitions: &'c [Node<'t>],
        k: i64,
        place: Place,
    ) -> Result<Self> {
        Ok(Case {
            family: family.clone(),
            definitions,
            k,
            place,
            facts: Facts::at(place, k),
            section: Section::new(&[], Env::new(family.clone()))?,
            parameters: Vec::new(),
            shown_knots: BTreeMap::new(),
            shown: place.shown(k),
            closed: Vec::new(),
            ints: Vec::new(),
            reals: Vec::new(),
            knot: None,
            on_knot: false,
            symmetric: false,
            mirrored: false,
            ratios: Vec::new(),
            member: None,
            numbers: None,
            exact: false,
            undecided: false,
            far: 0,
            depth: 0,
        })
    }

    /// Declares the origin and the windows, and nothing else.
    pub(crate) fn open(&mut self) -> Result<Vec<Node<'t>>> {
        let origin = Node::made("real", vec![Node::name_of("o")]);
        let fixed: Vec<_> = [origin].into_iter().chain(self.windows()).collect();
        self.section = Section::new(&fixed, Env::new(self.family.clone()))?;
        self.parameters.clear();
        self.shown_knots.clear();
        Ok(fixed)
    }

    /// (window W FIRST GAP…), and if the knots are symmetric the reflected one.
    pub(crate) fn windows(&self) -> Vec<Node<'t>> {
        let (first, last) = self.shown;
        let gap = |e| match self.place.gap(e) {
            Gap::Some => Node::name_of("some"),
            Gap::Any if !self.closed.contains(&e) => Node::name_of("any"),
            _ => Node::whole_of(0),
        };
        let turn = self.turn();
        let reflected = |e: i64| match turn - e {
            of if !(first..last).contains(&of) => Node::name_of("any"),
            of if gap(of) == Node::whole_of(0) => gap(of),
            of => Node::made("W", vec![Node::whole_of(of)]),
        };
        let window = |name, first: i64, gaps: Vec<Node<'t>>| {
            let head = [Node::name_of(name), Node::whole_of(first)];
            Node::made("window", head.into_iter().chain(gaps).collect())
        };
        let mirror =
            self.symmetric.then(|| window("M", -self.k, (-self.k..=self.k).map(reflected).collect()));
        [window("W", first, (first..last).map(gap).collect())].into_iter().chain(mirror).collect()
    }

    /// Knot s' + e of the reflected window is s + 1 + turn − e.
    pub(crate) fn turn(&self) -> i64 {
        match self.place {
            Place::Knot(Copies::Exactly(q)) => -q,
            _ => 0,
        }
    }

    /// A parameter, declared once.
    pub(crate) fn parameter(&mut self, sign: &'static str, name: Node<'t>) -> Result<Value<'t>> {
        match self.parameters.iter().find(|(_, known)| *known == name) {
            Some((known, _)) if *known == sign => {}
            Some(_) => return Err(Reason::NoWindow("a parameter would have two signs")),
            None => {
                self.section.declare(&Node::made(sign, vec![name.clone()]))?;
                self.parameters.push((sign, name.clone()));
            }
        }
        self.leaf(name)
    }

    /// A term that the knots and parameters give a value.
    pub(crate) fn leaf(&self, term: Node<'t>) -> Result<Value<'t>> {
        let plain = Some(self.section.term(&term, &self.section.env)?.into());
        Ok(Value { term, plain, knot: None })
    }

    /// Something about a part of a term, if it is not too deep.
    pub(crate) fn deeper<T>(&mut self, of: impl FnOnce(&mut Self) -> Found<T>) -> Found<T> {
        spend(1)?;
        if self.depth == DEPTH {
            return Err(Stop::Undecided);
        }
        self.depth += 1;
        let value = of(self);
        self.depth -= 1;
        value
    }

    /// With values of all functions, and not only their names.
    pub(crate) fn exactly<T>(&mut self, of: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.exact, true);
        let found = of(self);
        self.exact = before;
        found
    }

    pub(crate) fn sign(&self, value: &Fraction) -> Sign {
        value.num.sign(&self.section.signs)
    }
}

/// What is known, if anything is.
pub(crate) fn read<T>(found: Found<T>) -> Result<Option<T>> {
    match found {
        Ok(value) => Ok(Some(value)),
        Err(Stop::Rejected(reason)) => Err(reason),
        Err(_) => Ok(None),
    }
}
