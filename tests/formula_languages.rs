//! What `knotproof formula` writes is read back, by readers that follow the rules of each language, and compared with the
//! exact values of the functions.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use knotproof::analysis::FormalBasis;
use knotproof::formula::{Form, Language, Script, expression, formula};
use knotproof::scalar::{BigRational, RationalAlgebra, Ring, integer, parse_rational, rational};
use knotproof::spline::{Basis, Index, KnotVector, Side};
use num_traits::Signed;
use proptest::prelude::*;

const LANGUAGES: [Language; 4] = [Language::Text, Language::Maxima, Language::Sympy, Language::Latex];

/// A value, and whether Python would take it for an `int`, of which a quotient is a float.
struct Value {
    number: BigRational,
    int: bool,
}

impl Value {
    fn exact(number: BigRational) -> Self {
        Self { number, int: false }
    }
}

/// Reads an expression and computes its value. The rules, for all four: a power binds tighter than a minus before it and
/// goes on to the right; products and quotients go from left to right, and so do sums.
///
/// Maxima and Python have a minus as a sign in front of every operand. LaTeX has no sign of multiplication: factors stand side
/// by side, and a minus after a factor begins a new term.
struct Reader<'a> {
    language: Language,
    rest: &'a str,
    x: &'a BigRational,
    alpha: &'a BigRational,
}

impl Reader<'_> {
    fn value(
        text: &str,
        language: Language,
        x: &BigRational,
        alpha: &BigRational,
    ) -> Result<BigRational, String> {
        let mut reader = Reader { language, rest: text, x, alpha };
        let value = reader.sum()?;
        if reader.rest.trim().is_empty() { Ok(value.number) } else { Err(reader.wrong("the end")) }
    }

    fn wrong(&self, expected: &str) -> String {
        format!("{:?}: expected {expected} before `{}`", self.language, self.rest)
    }

    fn takes(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start();
        rest.strip_prefix(token).map(|rest| self.rest = rest).is_some()
    }

    fn expects(&mut self, token: &str) -> Result<(), String> {
        if self.takes(token) { Ok(()) } else { Err(self.wrong(token)) }
    }

    fn begins(&self, token: &str) -> bool {
        self.rest.trim_start().starts_with(token)
    }

    fn sum(&mut self) -> Result<Value, String> {
        let latex = self.language == Language::Latex;
        let negative = latex && self.takes("-");
        let mut value = self.product()?;
        if negative {
            value.number = value.number.negate();
        }
        loop {
            let minus = self.begins("-");
            if !(self.takes("+") || self.takes("-")) {
                return Ok(value);
            }
            let term = self.product()?;
            let number = if minus { value.number - term.number } else { value.number + term.number };
            value = Value { number, int: value.int && term.int };
        }
    }

    fn product(&mut self) -> Result<Value, String> {
        let mut value = self.signed()?;
        loop {
            let language = self.language;
            let factor = match language {
                // Until something comes that is no factor.
                Language::Latex => {
                    let ends = ["+", "-", "}", "\\right", ","].iter().any(|end| self.begins(end));
                    if ends || self.rest.trim().is_empty() {
                        return Ok(value);
                    }
                    if self.rest.trim_start().starts_with(|c: char| c.is_ascii_digit()) {
                        return Err(self.wrong("no digit after a factor: it would read as one number"));
                    }
                    self.power()?
                }
                _ if !self.begins("**") && self.takes("*") => self.signed()?,
                _ if self.takes("/") => {
                    let below = self.signed()?;
                    if self.language == Language::Sympy && value.int && below.int {
                        return Err(self.wrong("no quotient of two numbers in Python: it is rounded,"));
                    }
                    let inverse = integer(1).over(&below.number).ok_or("a denominator is 0")?;
                    Value::exact(inverse)
                }
                _ => return Ok(value),
            };
            value = Value { number: value.number * factor.number, int: value.int && factor.int };
        }
    }

    fn signed(&mut self) -> Result<Value, String> {
        if self.language != Language::Latex && self.takes("-") {
            let value = self.signed()?;
            return Ok(Value { number: value.number.negate(), ..value });
        }
        self.power()
    }

    fn power(&mut self) -> Result<Value, String> {
        let base = self.atom()?;
        let language = self.language;
        let exponent = match language {
            Language::Latex if self.takes("^{") => {
                let exponent = self.sum()?;
                self.expects("}")?;
                exponent
            }
            Language::Sympy if self.takes("**") => self.signed()?,
            Language::Text | Language::Maxima if self.takes("^") => self.signed()?,
            _ => return Ok(base),
        };
        if self.language == Language::Latex && self.begins("^") {
            return Err(self.wrong("no double superscript"));
        }
        let exponent: usize = exponent.number.to_string().parse().map_err(|_| self.wrong("an exponent"))?;
        Ok(Value { number: base.number.power(exponent), int: base.int })
    }

    fn atom(&mut self) -> Result<Value, String> {
        let latex = self.language == Language::Latex;
        let digits: String = self.rest.trim_start().chars().take_while(char::is_ascii_digit).collect();
        if !digits.is_empty() {
            self.expects(&digits)?;
            return Ok(Value { number: parse_rational(&digits).map_err(|e| e.to_string())?, int: true });
        }
        if self.takes(if latex { "\\alpha" } else { "alpha" }) {
            return Ok(Value::exact(self.alpha.clone()));
        }
        if self.takes("x") {
            return Ok(Value::exact(self.x.clone()));
        }
        if self.takes(if latex { "\\left(" } else { "(" }) {
            let value = self.sum()?;
            self.expects(if latex { "\\right)" } else { ")" })?;
            return Ok(value);
        }
        if latex && (self.takes("\\dfrac{") || self.takes("\\tfrac{")) {
            let above = self.sum()?;
            self.expects("}")?;
            self.expects("{")?;
            let below = self.sum()?;
            self.expects("}")?;
            return Ok(Value::exact(above.number.over(&below.number).ok_or("a denominator is 0")?));
        }
        if self.language == Language::Sympy {
            let rational = self.takes("Rational(");
            if rational || self.takes("Integer(") {
                let above = self.sum()?;
                let below = if rational {
                    self.expects(",")?;
                    self.sum()?.number
                } else {
                    integer(1)
                };
                self.expects(")")?;
                return Ok(Value::exact(above.number.over(&below).ok_or("a denominator is 0")?));
            }
        }
        Err(self.wrong("an operand"))
    }
}

/// A line of a program: G_index has the expression between two knots.
struct Line<'a> {
    index: usize,
    expression: &'a str,
    from: &'a str,
    to: &'a str,
    closed: bool,
}

/// The pieces of a program.
fn lines(program: &str, language: Language) -> Vec<Line<'_>> {
    let mut index = 0;
    let mut found = Vec::new();
    for line in program.lines() {
        let named = line.strip_prefix("G_").or_else(|| line.split_once("}G_{").map(|(_, rest)| rest));
        if let Some(named) = named {
            let digits: String = named.chars().take_while(char::is_ascii_digit).collect();
            index = digits.parse().unwrap();
        }
        let parts = match language {
            Language::Text => line.strip_prefix("  [").map(|rest| {
                let (domain, expression) = rest.split_at(rest.find([')', ']']).unwrap() + 1);
                let (from, to) = domain[..domain.len() - 1].split_once(", ").unwrap();
                (expression, from, to, domain.ends_with(']'))
            }),
            Language::Maxima => {
                let rest = line.trim_start();
                let rest = rest.strip_prefix("if ").or_else(|| rest.strip_prefix("elseif "));
                rest.map(|rest| {
                    let (condition, expression) = rest.split_once(" then ").unwrap();
                    let (from, to) = condition.split_once(" <= x and x <").unwrap();
                    (expression, from, to.trim_start_matches('='), to.starts_with('='))
                })
            }
            Language::Sympy => line.strip_prefix("    (").filter(|line| !line.starts_with('0')).map(|rest| {
                let (expression, condition) = rest.split_once(", (x >= ").unwrap();
                let (from, to) = condition.split_once(") & (x <").unwrap();
                let to = to.strip_suffix(")),").unwrap();
                (expression, from, to.trim_start_matches('='), to.starts_with('='))
            }),
            Language::Latex => line.strip_suffix(", \\\\[1ex]").map(|line| {
                let (expression, condition) = line.trim().split_once(", & ").unwrap();
                let (from, to) = condition.split_once(" \\le x ").unwrap();
                let open = to.strip_prefix("<");
                (expression, from, open.or(to.strip_prefix("\\le")).unwrap(), open.is_none())
            }),
        };
        found.extend(parts.map(|(expression, from, to, closed)| Line {
            index,
            expression,
            from,
            to,
            closed,
        }));
    }
    found
}

/// Reads all programs for a basis, and compares them at an inner point of every piece; how many values were compared.
fn read_back(basis: &Basis, formal: &FormalBasis) -> Result<usize, String> {
    let alpha = basis.index().alpha().unwrap_or_else(|| integer(0));
    let mut compared = 0;
    for form in [Form::Factored, Form::Expanded] {
        for language in LANGUAGES {
            let program = formula(formal, None, language, form);
            if language == Language::Maxima {
                equal(&program, formal)?;
            }
            let read = lines(&program, language);
            let pieces: Vec<_> = formal
                .functions()
                .iter()
                .flat_map(|function| function.pieces.iter().map(|piece| (function.index, piece)))
                .collect();
            assert_eq!(read.len(), pieces.len(), "{program}");
            for (line, (index, piece)) in read.iter().zip(pieces) {
                let x = &piece.from + (&piece.to - &piece.from) * rational(3, 7);
                let expected = &basis.values(&x, Side::Right)[index];
                let value = |text: &str| Reader::value(text, language, &x, &alpha);
                let place = || {
                    format!("{language:?} {form:?} {}, {}: {}", basis.knots(), basis.index(), line.expression)
                };
                let found = [value(line.from)?, value(line.to)?, value(line.expression)?];
                if found != [piece.from.clone(), piece.to.clone(), expected.clone()]
                    || (line.index, line.closed) != (index, piece.closed)
                {
                    return Err(format!("{}: {found:?} and not {expected}", place()));
                }
                // The parts, as JSON has them.
                let part = |polynomial| value(&expression(polynomial, language, form));
                let (above, below) = (part(&piece.numerator)?, part(&piece.denominator)?);
                if above.over(&below).as_ref() != Some(expected) {
                    return Err(format!("{}: the parts are {above} and {below}", place()));
                }
                compared += 1;
            }
        }
    }
    Ok(compared)
}

/// What Maxima is given is read by the program itself as equal; a piece that is changed, not.
fn equal(program: &str, formal: &FormalBasis) -> Result<(), String> {
    let script = Script::read(program).map_err(|error| error.to_string())?;
    if script.definitions().len() != formal.functions().len() {
        return Err(format!("not every function: {program}"));
    }
    for (definition, function) in script.definitions().iter().zip(formal.functions()) {
        match script.counterexample(definition, formal, function, None) {
            Ok(None) => {}
            other => return Err(format!("{other:?}: {program}")),
        }
    }
    Ok(())
}

/// An expression that is the function nowhere but at one point: where it is said to differ, it does.
fn different(formal: &FormalBasis) -> Result<(), String> {
    for function in formal.functions() {
        for piece in &function.pieces {
            let inside = &piece.from + (&piece.to - &piece.from) * rational(3, 7);
            let part = |polynomial| expression(polynomial, Language::Maxima, Form::Factored);
            let text = format!(
                "({})/({}) + (x - ({inside}))/1000",
                part(&piece.numerator),
                part(&piece.denominator)
            );
            let script = Script::read(&text).map_err(|error| error.to_string())?;
            let span = formal
                .basis()
                .knots()
                .spans()
                .find(|span| formal.basis().knots().t(span.index()) == &piece.from);
            let found = script.counterexample(&script.definitions()[0], formal, function, span);
            let Ok(Some(found)) = found else { return Err(format!("{text}: {found:?}")) };
            let alpha =
                found.alpha.clone().or(formal.index().and_then(Index::alpha)).unwrap_or_else(|| integer(0));
            let value = Reader::value(&text, Language::Maxima, &found.x, &alpha).ok();
            if value != found.found || function.value(&found.x, &alpha) != Some(found.expected.clone()) {
                return Err(format!("{text}: {found:?} and not {value:?}"));
            }
            if found.found.as_ref() == Some(&found.expected) || !piece.holds_at(&found.x) {
                return Err(format!("{text}: {found:?} is no difference"));
            }
        }
    }
    Ok(())
}

fn formal(basis: &Basis, symbolic: bool) -> FormalBasis {
    let formal = if symbolic { FormalBasis::for_every_index(basis) } else { FormalBasis::of(basis) };
    formal.expect("a low degree")
}

fn basis(degree: usize, knots: &str, alpha: &str) -> Basis {
    let knots = knots.split(' ').map(|t| parse_rational(t).unwrap()).collect();
    Basis::new(KnotVector::new(knots).unwrap(), degree, alpha.parse().unwrap()).unwrap()
}

/// Factors ±x in numerators and denominators, with even and odd powers.
#[test]
fn a_knot_at_zero_keeps_its_sign() {
    for (degree, knots, alpha) in [
        (2, "-1 -1 -1 0 1 1 1", "inf"),
        (2, "-1 -1 -1 0 1 1 1", "-1"),
        (2, "-3 -3 -3 -2.5 0 1/3 1/3 1/3", "-1/7"),
        (4, "-2 -2 -2 -2 -2 -1 -1 -1 -1 -1", "-1"),
        (1, "-3/2 -3/2 -1/2 0 0 1", "-1/3"),
        (3, "-3 -5/2 -3/2 -3/2 -3/2 -1/2 -1/2 0 2 2", "inf"),
        (3, "-2 -2 -2 -2 0 0 0 0 3 3 3 3", "-1"),
        (1, "-1 0 0 1/2", "-1"),
        (0, "-1 -1/2 0 0 2", "5"),
    ] {
        let basis = basis(degree, knots, alpha);
        assert!(read_back(&basis, &formal(&basis, false)).unwrap() > 0);
        if alpha != "inf" {
            assert!(read_back(&basis, &formal(&basis, true)).unwrap() > 0);
        }
    }
}

/// The values that the readers compute are worked out by hand: what each language makes of a minus.
#[test]
fn a_minus_is_read_as_each_language_reads_it() {
    let (x, alpha) = (rational(1, 2), rational(-1, 1));
    for (text, latex, language, expected) in [
        ("-x^2", "-x^{2}", Language::Maxima, Ok(rational(-1, 4))),
        ("-x**2", "-x^{2}", Language::Sympy, Ok(rational(-1, 4))),
        ("(-x)^2", "\\left(-x\\right)^{2}", Language::Text, Ok(rational(1, 4))),
        ("8*x/(1 - 6*x)", "\\dfrac{8 x}{1 - 6 x}", Language::Maxima, Ok(rational(-2, 1))),
        ("8 - x", "8 -x", Language::Maxima, Ok(rational(15, 2))),
        ("2*alpha*(1 - x)", "2 \\alpha \\left(1 - x\\right)", Language::Text, Ok(rational(-1, 1))),
        ("8*-x", "-8 x", Language::Sympy, Ok(rational(-4, 1))),
        ("1/3*x", "8 3 x", Language::Sympy, Err("rounded")),
        ("x/(x - x)", "x^{2}^{3}", Language::Maxima, Err("0")),
    ] {
        let read = |text, language| Reader::value(text, language, &x, &alpha);
        match expected {
            Ok(value) => {
                assert_eq!(read(text, language), Ok(value.clone()), "{text}");
                assert_eq!(read(latex, Language::Latex), Ok(value), "{latex}");
            }
            Err(part) => {
                assert!(read(text, language).unwrap_err().contains(part), "{text}");
                assert!(read(latex, Language::Latex).is_err(), "{latex}");
            }
        }
    }
}

fn index() -> impl Strategy<Value = Index> {
    let ratio = (1_i64..12, 1_i64..12).prop_map(|(p, q)| rational(p, q));
    let finite = (ratio, any::<bool>())
        .prop_map(|(s, negative)| Index::from_alpha(if negative { -s } else { integer(1) + s }).unwrap());
    prop_oneof![1 => Just(Index::infinity()), 5 => finite]
}

/// Knots that are negative, zero, fractional and repeated: most have 0 among them.
fn bases() -> impl Strategy<Value = Basis> {
    let gap = prop_oneof![
        3 => Just(integer(0)),
        4 => (1_i64..5, 1_i64..4).prop_map(|(p, q)| rational(p, q)),
    ];
    let gaps = (0_usize..=4).prop_flat_map(move |k| {
        (Just(k), proptest::collection::vec(gap.clone(), (2 * k).max(k + 1)..2 * k + 4))
    });
    let spread = |gaps: &[BigRational]| gaps.iter().any(Signed::is_positive);
    let gaps = gaps.prop_filter("an interval", move |(_, gaps)| spread(gaps));
    (gaps, any::<prop::sample::Index>(), rational_start(), index()).prop_map(
        |((k, gaps), zero, start, index)| {
            let mut knots = vec![integer(0)];
            for gap in gaps {
                knots.push(knots.last().unwrap() + gap);
            }
            let origin = start.unwrap_or_else(|| knots[zero.index(knots.len())].clone());
            let knots = knots.into_iter().map(|t| t - &origin).collect();
            Basis::new(KnotVector::new(knots).unwrap(), k, index).unwrap()
        },
    )
}

/// Where the first knot is, if not so that another one is 0.
fn rational_start() -> impl Strategy<Value = Option<BigRational>> {
    prop_oneof![3 => Just(None), 1 => (-9_i64..10, 1_i64..5).prop_map(|(p, q)| Some(rational(p, q)))]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_program_reads_back_as_the_functions(basis in bases()) {
        let found = read_back(&basis, &formal(&basis, false));
        prop_assert!(found.as_ref().is_ok_and(|compared| *compared > 0), "{found:?}");
        prop_assert_eq!(different(&formal(&basis, false)), Ok(()));
        if basis.degree() <= 3 && basis.index().alpha().is_some() {
            let found = read_back(&basis, &formal(&basis, true));
            prop_assert!(found.as_ref().is_ok_and(|compared| *compared > 0), "{found:?}");
            prop_assert_eq!(different(&formal(&basis, true)), Ok(()));
        }
    }
}
