//! A claim's sentence in brackets: what may stand where, and which names are bound there.

use crate::error::{Reason, Result};
use crate::family::Family;
use crate::point::check_knots;
use crate::token::{Kind, Node, tree};

/// What may stand at a place of a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sort {
    Int,
    Real,
    Function,
    Argument,
    Member,
    Interval,
    Formula,
    Expression,
    Coefficients,
    Index,
}

use Sort::{Argument, Coefficients, Expression, Formula, Function, Index, Int, Interval, Member, Real};

/// Brackets with a fixed number of fields that bind no name.
const FORMS: [(Sort, &str, &[Sort]); 21] = [
    (Int, "+ - * min max binomial", &[Int, Int]),
    (Real, "int t", &[Int]),
    (Real, "alpha", &[Index]),
    (Real, "+ - * / min max", &[Real, Real]),
    (Real, "neg abs sqrt", &[Real]),
    (Real, "^", &[Real, Int]),
    (Real, "of", &[Function, Argument]),
    (Function, "G", &[Int]),
    (Function, "G w", &[Int, Int]),
    (Function, "phi f", &[Real, Real]),
    (Function, "D", &[Function, Int]),
    (Argument, "at left right", &[Real]),
    (Argument, "at left right", &[Real, Member]),
    (Member, "alpha ratio", &[Real]),
    (Member, "dual", &[]),
    (Formula, "in", &[Real, Interval]),
    (Formula, "among", &[Int, Int, Int]),
    (Formula, "not", &[Formula]),
    (Formula, "=> <=>", &[Formula, Formula]),
    (Expression, "real", &[Real]),
    (Expression, "integer", &[Int]),
];

/// Words: what they are, and how many things they are said of. Most are read and never decided here.
const WORDS: [(Sort, &str, usize); 7] = [
    (Int, "mult maxima minima maximisers changes polygon-changes rank valleys nurbs-degree", 1),
    (Int, "stops", 0),
    (Int, "implicit-degree", 3),
    (Real, "word-sup word-stop", 1),
    (Formula, "tied continuous totally-positive nested elevated free-weights defined rational smooth", 1),
    (Formula, "combination", 2),
    (Formula, "strays", 3),
];

/// What the adjectives of knots say.
const OPEN: &str = "(and (chain (t 0) (= (t k))) (chain (t (- m k)) (= (t m)))
    (chain (int m) (>= (int (* 2 k)))) (chain (t k) (< (t (- m k)))))";
const ADJECTIVES: [(&str, &str); 7] = [
    ("clamped", "(and (chain (t k) (< (t (+ k 1)))) (chain (t n) (< (t (+ n 1)))))"),
    ("bernstein", "(chain (int m) (= (int (+ (* 2 k) 1))))"),
    ("simple", "(all (integers i 0 (- m 1)) (chain (t i) (< (t (+ i 1)))))"),
    ("equidistant", "(all (integers i 1 (- m 1)) (chain (- (t (+ i 1)) (t i)) (= (- (t i) (t (- i 1))))))"),
    ("symmetric", "(all (integers i 0 m) (chain (+ (t i) (t (- m i))) (= (+ (t 0) (t m)))))"),
    // k + 1 knots that coincide are at t_0 or at t_m, or none of them is among t_{k+1}, …, t_n.
    (
        "inner",
        "(all (integers i 0 (- m k)) (or (chain (t i) (< (t (+ i k)))) (chain (t i) (= (t 0)))
            (chain (t (+ i k)) (= (t m)))))",
    ),
    (
        "interior",
        "(all (integers i 0 (- m k)) (or (chain (t i) (< (t (+ i k)))) (chain (int i) (< (int 1)))
            (chain (int i) (> (int n))) (chain (int n) (<= (int k)))))",
    ),
];

/// What an adjective says. A derivation needs the first three only: without the others more is shown.
pub(crate) fn adjective<'t>(node: &Node<'t>, refuting: bool) -> Result<Vec<Node<'t>>> {
    let name = node.name()?;
    let own = ADJECTIVES.iter().position(|(known, _)| *known == name);
    let open = matches!(name, "open" | "clamped" | "bernstein");
    if own.is_none() && !open {
        return node.wrong("an adjective of knots");
    }
    let own = own.filter(|at| refuting || *at < 2).and_then(|at| ADJECTIVES.get(at));
    open.then_some(OPEN).into_iter().chain(own.map(|(_, text)| *text)).map(tree).collect()
}

/// `(instance NAME K (knots …) (points (x y …)…))`: an example of the paper, its points if it is a curve.
pub(crate) struct Example<'n, 't> {
    pub(crate) name: &'t str,
    pub(crate) degree: i64,
    pub(crate) knots: &'n [Node<'t>],
    points: &'n [Node<'t>],
}

impl<'n, 't> Example<'n, 't> {
    pub(crate) fn new(row: &'n Node<'t>) -> Result<Self> {
        let example = Example::of(row)?;
        check_knots(row, example.knots, example.degree)?;
        for point in example.points {
            point.list("a point")?.iter().try_for_each(|number| number.ratio().map(|_| ()))?;
        }
        Ok(example)
    }

    /// The parts of one whose numbers have been looked at.
    pub(crate) fn of(row: &'n Node<'t>) -> Result<Self> {
        let [name, degree, knots, points @ ..] = row.fields("instance")? else {
            return row.wrong("a name, a degree and knots");
        };
        let points = match points {
            [] => &[],
            [points] => points.some("points")?,
            _ => return row.wrong("points behind the knots, and nothing else"),
        };
        Ok(Example {
            name: name.name()?,
            degree: degree.degree()?.into(),
            knots: knots.some("knots")?,
            points,
        })
    }

    /// A coordinate of a control point, counted from 1.
    pub(crate) fn coordinate(&self, i: i64, coordinate: i64) -> Option<&'n Node<'t>> {
        let point = self.points.get(usize::try_from(i).ok()?)?.list("a point").ok()?;
        point.get(usize::try_from(coordinate - 1).ok()?)
    }
}

/// The examples that a sentence is about; none, if it is about all knots.
pub(crate) fn examples<'n, 't>(sentence: &'n Node<'t>) -> Result<Option<&'n [Node<'t>]>> {
    let [given, ..] = sentence.part::<3>("sentence")?;
    Ok(given.fields("for")?.iter().find_map(|binder| binder.fields("instances").ok()))
}

/// Names that are bound, and what they stand for.
pub(crate) struct Reader<'r, 't> {
    family: &'r Family<'t>,
    names: Vec<(&'t str, Sort)>,
    /// With the number of indices, and whether there is a variable.
    definitions: Vec<(&'t str, usize, bool)>,
    /// In a definition control values are those of whoever uses it: their names.
    defining: bool,
    controls: Vec<Node<'t>>,
    /// All that was bound anywhere.
    ever: Vec<(&'t str, Sort)>,
}

/// Reads definitions and the sentence; whatever has no meaning is refused.
pub(crate) fn read<'t>(family: &Family<'t>, definitions: &[Node<'t>], sentence: &Node<'t>) -> Result<()> {
    let mut reader = Reader {
        family,
        names: Vec::new(),
        definitions: Vec::new(),
        defining: true,
        controls: Vec::new(),
        ever: Vec::new(),
    };
    for definition in definitions {
        let [name, patterns, variable, _] = definition.part("define")?;
        let Kind::List(patterns) = &patterns.kind else { return patterns.wrong("patterns") };
        let has_variable = variable.name()? != "none";
        reader.definitions.push((name.name()?, patterns.len(), has_variable));
    }
    for definition in definitions {
        let [_, patterns, variable, body] = definition.part("define")?;
        let Kind::List(patterns) = &patterns.kind else { return patterns.wrong("patterns") };
        for pattern in patterns.iter().filter(|pattern| pattern.whole().is_err()) {
            reader.bind(pattern, Int)?;
        }
        if variable.name()? != "none" {
            reader.bind(variable, Real)?;
        }
        reader.read(Real, body)?;
        reader.names.clear();
    }
    reader.defining = false;
    reader.ever.clear();
    reader.sentence(sentence)?;
    for name in &reader.controls {
        let mut sorts = reader.ever.iter().filter(|(known, _)| name.is_word(known)).map(|(_, sort)| *sort);
        if sorts.next() != Some(Coefficients) || sorts.any(|sort| sort != Coefficients) {
            return name.wrong("the name of control values of the sentence");
        }
    }
    Ok(())
}

impl<'t> Reader<'_, 't> {
    fn bind(&mut self, name: &Node<'t>, sort: Sort) -> Result<()> {
        let word = name.name()?;
        let taken = matches!(word, "k" | "n" | "m" | "none" | "alpha" | "rank");
        if taken || self.names.iter().any(|(known, _)| *known == word) {
            return Err(Reason::Taken(word.to_owned()));
        }
        self.names.push((word, sort));
        self.ever.push((word, sort));
        Ok(())
    }

    fn bound(&self, name: &Node<'t>, sort: Sort) -> Result<()> {
        let word = name.name()?;
        let free = self.defining && sort == Coefficients || sort == Index && word == "alpha";
        if free || self.names.contains(&(word, sort)) {
            Ok(())
        } else {
            Err(Reason::Unknown(word.to_owned()))
        }
    }

    fn all(&mut self, sort: Sort, nodes: &[Node<'t>]) -> Result<()> {
        nodes.iter().try_for_each(|node| self.read(sort, node))
    }

    /// The fields that a binding governs, after which it is forgotten.
    fn inside(&mut self, sort: Sort, body: &Node<'t>, known: usize) -> Result<()> {
        self.read(sort, body)?;
        self.names.truncate(known);
        Ok(())
    }

    fn sentence(&mut self, node: &Node<'t>) -> Result<()> {
        let known = self.names.len();
        let [given, assume, then] = node.part("sentence")?;
        for binder in given.some("for")? {
            self.binder(binder)?;
        }
        self.all(Formula, assume.fields("if")?)?;
        self.all(Formula, then.some("then")?)?;
        self.names.truncate(known);
        Ok(())
    }

    fn binder(&mut self, node: &Node<'t>) -> Result<()> {
        match node.headed("a binder")? {
            ("degree", [low]) => low.degree().map(|_| ()),
            ("degree", [low, high]) => low.degree().and(high.degree()).map(|_| ()),
            ("knots", adjectives) => {
                adjectives.iter().try_for_each(|node| adjective(node, false).map(|_| ()))
            }
            ("gaps", gaps @ [_, ..]) => gaps.iter().try_for_each(|gap| match gap.fields("gap")? {
                [size] => self.read(Real, size),
                [size, range] => {
                    let known = self.names.len();
                    self.over(range)?;
                    self.inside(Real, size, known)
                }
                _ => gap.wrong("a gap"),
            }),
            ("instances", rows @ [_, ..]) => {
                // The control points of an instance have this name.
                self.names.push(("P", Coefficients));
                self.ever.push(("P", Coefficients));
                rows.iter().try_for_each(|row| Example::new(row).map(|_| ()))
            }
            ("alphas", list @ [_, ..]) => {
                list.iter().try_for_each(|alpha| match alpha.word(&["infinity"], "an index") {
                    Ok(_) => Ok(()),
                    Err(_) => alpha.ratio().map(|_| ()),
                })
            }
            ("index", [name]) => self.bind(name, Index),
            ("integer", [name, low, high]) => {
                self.read(Int, low)?;
                self.read(Int, high)?;
                self.bind(name, Int)
            }
            ("point", [name, interval]) => {
                self.read(Interval, interval)?;
                self.bind(name, Real)
            }
            ("real", [name]) => self.bind(name, Real),
            ("real", [name, sign]) => sign.word(&["<", ">"], "a sign").and(self.bind(name, Real)),
            ("points", [name]) => self.bind(name, Coefficients),
            _ => node.wrong("a binder"),
        }
    }

    /// What a quantifier runs over.
    fn over(&mut self, node: &Node<'t>) -> Result<()> {
        match node.headed("a range or an interval")? {
            ("integers", [name, low, high]) => {
                self.read(Int, low)?;
                self.read(Int, high)?;
                self.bind(name, Int)
            }
            ("reals", [name, interval]) => {
                self.read(Interval, interval)?;
                self.bind(name, Real)
            }
            _ => node.wrong("a range or an interval"),
        }
    }

    fn read(&mut self, sort: Sort, node: &Node<'t>) -> Result<()> {
        let known = self.names.len();
        match (sort, &node.kind) {
            (Int, Kind::Number(..)) => return node.whole().map(|_| ()),
            (Int, Kind::Name("k" | "n" | "m")) => return Ok(()),
            (Real, Kind::Number(..)) | (Real, Kind::Name("ratio" | "infinity")) => return Ok(()),
            (Int | Index | Coefficients, Kind::Name(_)) => return self.bound(node, sort),
            (Interval, Kind::List(ends)) => {
                let [from, a, to, b] = &**ends else { return node.wrong("an interval") };
                from.word(&["closed", "open"], "closed or open")?;
                to.word(&["closed", "open"], "closed or open")?;
                return self.read(Real, a).and_then(|()| self.read(Real, b));
            }
            _ => {}
        }
        let expected = match sort {
            Int | Index | Coefficients => "an integer",
            Real => "a real",
            Function => "a function",
            Argument => "an argument",
            Member => "another index",
            Interval => "an interval",
            Formula => "a formula",
            Expression => "what a word is said of",
        };
        let (head, fields) = node.headed(expected)?;
        match (sort, head, fields) {
            (Real, "var", [name]) => self.bound(name, Real),
            (Real, "coefficient", [name, indices @ ..]) if !indices.is_empty() => {
                self.bound(name, Coefficients)?;
                if self.defining {
                    self.controls.push(name.clone());
                }
                self.all(Int, indices)
            }
            (Real, "parameter", [name, indices @ ..]) => {
                let parameter = self.family.parameter(name.name()?);
                if parameter.is_none_or(|own| own.indices.len() != indices.len()) {
                    return Err(Reason::Unknown(name.name()?.to_owned()));
                }
                self.all(Int, indices)
            }
            (Real, "sum" | "product" | "least" | "greatest", [name, low, high, body]) => {
                self.read(Int, low)?;
                self.read(Int, high)?;
                self.bind(name, Int)?;
                self.inside(Real, body, known)
            }
            (Real | Function, "defined", [name, indices @ ..]) => {
                let word = name.name()?;
                let wanted = (word, indices.len(), sort == Function);
                let found = self.definitions.contains(&wanted);
                if found { self.all(Int, indices) } else { Err(Reason::Unknown(word.to_owned())) }
            }
            (Formula, "chain", [first, rest @ ..]) if !rest.is_empty() => {
                self.read(Real, first)?;
                rest.iter().try_for_each(|step| match step.headed("a relation")? {
                    ("=" | "/=" | "<" | "<=" | ">" | ">=", [next]) => self.read(Real, next),
                    _ => step.wrong("a relation"),
                })
            }
            (Formula, "instance", names) => names.iter().try_for_each(|name| name.name().map(|_| ())),
            (Formula, "and" | "or", [_, ..]) => self.all(Formula, fields),
            (Formula, "all" | "some" | "one", [over, body]) => {
                self.over(over)?;
                self.inside(Formula, body, known)
            }
            (Formula, "claim", [id, sentence]) => id.claim().and_then(|_| self.sentence(sentence)),
            (Expression, "function", [of]) => self.read(Function, of),
            (Expression, "function", [of, member]) => self.read(Function, of).and(self.read(Member, member)),
            (Expression, "coefficients", [name]) => self.bound(name, Coefficients),
            (Expression, "expression", [body, name, rest @ ..]) if rest.len() < 2 => {
                self.all(Interval, rest)?;
                self.bind(name, Real)?;
                self.inside(Real, body, known)
            }
            _ => {
                let named = |heads: &str| heads.split(' ').any(|known| known == head);
                let count = fields.len();
                if WORDS.iter().any(|(is, heads, of)| *is == sort && *of == count && named(heads)) {
                    return self.all(Expression, fields);
                }
                let fits =
                    |form: &&(Sort, &str, &[Sort])| form.0 == sort && form.2.len() == count && named(form.1);
                let Some((_, _, sorts)) = FORMS.iter().find(fits) else { return node.wrong(expected) };
                sorts.iter().zip(fields).try_for_each(|(sort, field)| self.read(*sort, field))
            }
        }
    }
}
