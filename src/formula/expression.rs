//! Polynomials and quotients as text.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::analysis::{Factored, FormalBasis, FormalPiece};
use crate::scalar::{Monomial, Multivariate};

use super::tree::Tree;
use super::{Form, Language};

/// A polynomial as an expression in the language: a product, or a sum of terms.
///
/// ```
/// use knotproof::analysis::FormalBasis;
/// use knotproof::formula::{Form, Language, expression};
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
    tree(polynomial, form).text(language)
}

/// numerator/denominator of a piece.
pub(super) fn quotient(piece: &FormalPiece, language: Language, form: Form) -> String {
    Tree::quotient(tree(&piece.numerator, form), tree(&piece.denominator, form)).text(language)
}

fn tree(polynomial: &Factored, form: Form) -> Tree {
    match form {
        Form::Factored => factored(polynomial),
        Form::Expanded => expanded(&polynomial.expanded()),
    }
}

/// The number, then monomials, then sums: 2*x*(1 - x). The signs of monomials go in front of it all.
fn factored(polynomial: &Factored) -> Tree {
    let content = polynomial.content();
    let (mut negative, mut plain, mut sums) = (false, Vec::new(), Vec::new());
    if !content.is_one() {
        plain.push(Tree::Number(content.clone()));
    }
    for (factor, exponent) in polynomial.factors() {
        match factor.terms().collect::<Vec<_>>()[..] {
            // Its coefficients are coprime: this one is 1 or −1.
            [(monomial, c)] => {
                negative ^= c.is_negative() && exponent % 2 == 1;
                plain.extend(powers(monomial, *exponent));
            }
            _ => sums.push(Tree::power(expanded(factor), *exponent)),
        }
    }
    plain.append(&mut sums);
    Tree::product(plain).signed(negative)
}

/// By falling powers if that begins with a positive term, else by rising powers if that does.
fn expanded(polynomial: &Multivariate) -> Tree {
    let mut terms: Vec<_> = polynomial.terms().collect();
    let negative = |term: Option<&(&Monomial, &BigInt)>| term.is_some_and(|(_, c)| c.is_negative());
    if negative(terms.first()) && !negative(terms.last()) {
        terms.reverse();
    }
    let term = |(monomial, c): (&Monomial, &BigInt)| {
        let mut factors: Vec<_> = powers(monomial, 1).collect();
        if !c.magnitude().is_one() || factors.is_empty() {
            factors.insert(0, Tree::Number(c.abs()));
        }
        Tree::product(factors).signed(c.is_negative())
    };
    Tree::sum(terms.into_iter().map(term).collect())
}

/// The powers of α and x in a power of a monomial.
fn powers(monomial: &Monomial, exponent: usize) -> impl Iterator<Item = Tree> {
    [(FormalBasis::ALPHA, Tree::Alpha), (FormalBasis::X, Tree::X)]
        .map(|(variable, symbol)| (symbol, monomial.exponent(variable) * exponent))
        .into_iter()
        .filter(|(_, exponent)| *exponent > 0)
        .map(|(symbol, exponent)| Tree::power(symbol, exponent))
}

impl Language {
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
