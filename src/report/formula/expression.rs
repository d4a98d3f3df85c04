//! Polynomials and quotients as text.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::analysis::{Factored, FormalBasis, FormalPiece};
use crate::scalar::{Monomial, Multivariate};

use super::{Form, Language};

/// A polynomial as an expression in the language: a product, or a sum of terms.
///
/// ```
/// use knotproof::analysis::FormalBasis;
/// use knotproof::report::{Form, Language, expression};
/// use knotproof::scalar::integer;
/// use knotproof::spline::{Basis, KnotVector};
///
/// let basis = Basis::new(KnotVector::bernstein(2, &integer(0), &integer(1))?, 2, "-1".parse()?)?;
/// let formal = FormalBasis::of(&basis).expect("a low degree");
/// let numerator = &formal.functions()[1].pieces[0].numerator;
/// assert_eq!(expression(numerator, Language::Sympy, Form::Factored), "4*x*(1 - x)");
/// assert_eq!(expression(numerator, Language::Latex, Form::Expanded), "4 x - 4 x^{2}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn expression(polynomial: &Factored, language: Language, form: Form) -> String {
    Written::new(polynomial, language, form).text
}

/// An expression, and how tightly it holds together.
struct Written {
    text: String,
    /// Is it a sum of several terms?
    sum: bool,
    /// Is it more than one number, variable, power or sum in parentheses?
    product: bool,
}

impl Written {
    fn new(polynomial: &Factored, language: Language, form: Form) -> Self {
        match form {
            Form::Factored => Self::factored(polynomial, language),
            Form::Expanded => Self::expanded(&polynomial.expanded(), language),
        }
    }

    fn factored(polynomial: &Factored, language: Language) -> Self {
        let content = polynomial.content();
        if let ([(factor, 1)], true) = (polynomial.factors(), content.is_one()) {
            return Self::expanded(factor, language);
        }
        let mut parts = Vec::new();
        if !content.is_one() || polynomial.factors().is_empty() {
            parts.push(content.to_string());
        }
        // Monomials first: x*(1 - x), not (1 - x)*x.
        let (plain, sums): (Vec<_>, Vec<_>) =
            polynomial.factors().iter().partition(|(factor, _)| factor.terms().len() == 1);
        for (factor, exponent) in plain.into_iter().chain(sums) {
            let base = language.grouped(Self::expanded(factor, language));
            parts.push(language.power(&base, *exponent));
        }
        Self { product: parts.len() > 1, sum: false, text: parts.join(language.times()) }
    }

    /// By falling powers if that begins with a positive term, else by rising powers if that does.
    fn expanded(polynomial: &Multivariate, language: Language) -> Self {
        let terms: Vec<_> = polynomial.terms().collect();
        let negative = |term: Option<&(&Monomial, &BigInt)>| term.is_some_and(|(_, c)| c.is_negative());
        let rising = negative(terms.first()) && !negative(terms.last());
        let ordered: Vec<_> = if rising { terms.iter().rev().copied().collect() } else { terms.clone() };
        let mut text = String::new();
        for (at, (monomial, c)) in ordered.iter().enumerate() {
            text.push_str(match (at, c.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            text.push_str(&language.term(monomial, &c.abs()));
        }
        if text.is_empty() {
            text.push('0');
        }
        let several = terms.len() > 1;
        let product = several || text.contains(language.times()) || text.starts_with('-');
        Self { text, sum: several, product }
    }
}

/// numerator/denominator of a piece.
pub(super) fn quotient(piece: &FormalPiece, language: Language, form: Form) -> String {
    let above = Written::new(&piece.numerator, language, form);
    let below = Written::new(&piece.denominator, language, form);
    if below.text == "1" {
        return above.text;
    }
    // In Python a quotient of two numbers would be rounded.
    let number = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    match language {
        Language::Latex => format!("\\dfrac{{{}}}{{{}}}", above.text, below.text),
        Language::Sympy if number(&above.text) && number(&below.text) => {
            format!("Rational({}, {})", above.text, below.text)
        }
        _ => {
            let below = if below.product { format!("({})", below.text) } else { below.text };
            format!("{}/{below}", language.grouped(above))
        }
    }
}

impl Language {
    fn times(self) -> &'static str {
        if self == Self::Latex { " " } else { "*" }
    }

    /// In parentheses where it is a sum.
    fn grouped(self, written: Written) -> String {
        match (written.sum, self) {
            (false, _) => written.text,
            (true, Self::Latex) => format!("\\left({}\\right)", written.text),
            (true, _) => format!("({})", written.text),
        }
    }

    fn power(self, base: &str, exponent: usize) -> String {
        match (exponent, self) {
            (1, _) => base.to_owned(),
            (_, Self::Latex) => format!("{base}^{{{exponent}}}"),
            (_, Self::Sympy) => format!("{base}**{exponent}"),
            (_, Self::Text | Self::Maxima) => format!("{base}^{exponent}"),
        }
    }

    /// c·α^a·x^e for c > 0.
    fn term(self, monomial: &Monomial, c: &BigInt) -> String {
        let alpha = if self == Self::Latex { "\\alpha" } else { "alpha" };
        let mut parts = Vec::new();
        if !c.is_one() || *monomial == Monomial::ONE {
            parts.push(c.to_string());
        }
        for (variable, name) in [(FormalBasis::ALPHA, alpha), (FormalBasis::X, "x")] {
            match monomial.exponent(variable) {
                0 => {}
                exponent => parts.push(self.power(name, exponent)),
            }
        }
        parts.join(self.times())
    }

    /// A rational number.
    pub(super) fn number(self, value: &BigRational) -> String {
        if value.is_integer() && self != Self::Sympy {
            return value.to_string();
        }
        match self {
            Self::Text | Self::Maxima => value.to_string(),
            Self::Latex => {
                let sign = if value.is_negative() { "-" } else { "" };
                format!("{sign}\\tfrac{{{}}}{{{}}}", value.numer().abs(), value.denom())
            }
            Self::Sympy if value.is_integer() => format!("Integer({value})"),
            Self::Sympy => format!("Rational({}, {})", value.numer(), value.denom()),
        }
    }
}
