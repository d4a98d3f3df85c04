//! Expressions as trees, and the one way from a tree to text: what binds looser than its place asks for stands in
//! parentheses, whatever the language.

use num_bigint::BigInt;

use super::Language;

/// An expression. What it means is in its shape, not in how a language would read its text.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Tree {
    /// A number ≥ 0.
    Number(BigInt),
    /// x.
    X,
    /// α.
    Alpha,
    /// The power with an exponent ≥ 2.
    Power(Box<Tree>, usize),
    /// A product of two factors or more. A number is the first of them or none: LaTeX writes no sign between factors.
    Product(Vec<Tree>),
    /// The first over the second.
    Quotient(Box<Tree>, Box<Tree>),
    /// The opposite of a tree that is no negative itself.
    Negative(Box<Tree>),
    /// A sum of two terms or more.
    Sum(Vec<Tree>),
}

/// How tightly a text holds together. A minus in front reaches as far as one in a sum: in every language here −x² is
/// −(x²), and a minus after another sign is read by some and not by others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Atom,
}

impl Tree {
    /// base^exponent.
    pub(super) fn power(base: Self, exponent: usize) -> Self {
        if exponent == 1 { base } else { Self::Power(Box::new(base), exponent) }
    }

    /// The product: 1 without a factor.
    pub(super) fn product(mut factors: Vec<Self>) -> Self {
        match (factors.pop(), factors.is_empty()) {
            (None, _) => Self::Number(BigInt::from(1)),
            (Some(only), true) => only,
            (Some(last), false) => {
                factors.push(last);
                Self::Product(factors)
            }
        }
    }

    /// The sum: 0 without a term.
    pub(super) fn sum(mut terms: Vec<Self>) -> Self {
        match (terms.pop(), terms.is_empty()) {
            (None, _) => Self::Number(BigInt::ZERO),
            (Some(only), true) => only,
            (Some(last), false) => {
                terms.push(last);
                Self::Sum(terms)
            }
        }
    }

    /// The tree, or its opposite if `negative`.
    pub(super) fn signed(self, negative: bool) -> Self {
        match (negative, self) {
            (false, tree) => tree,
            (true, Self::Negative(tree)) => *tree,
            (true, tree) => Self::Negative(Box::new(tree)),
        }
    }

    /// above/below, with at most one sign, in front of it all.
    pub(super) fn quotient(above: Self, below: Self) -> Self {
        if below == Self::product(Vec::new()) {
            return above;
        }
        let split = |tree| match tree {
            Self::Negative(tree) => (*tree, true),
            tree => (tree, false),
        };
        let ((above, up), (below, down)) = (split(above), split(below));
        Self::Quotient(Box::new(above), Box::new(below)).signed(up != down)
    }

    /// The tree as a text of the language.
    pub(super) fn text(&self, language: Language) -> String {
        match self {
            Self::Number(n) => n.to_string(),
            Self::X => "x".to_owned(),
            Self::Alpha if language == Language::Latex => "\\alpha".to_owned(),
            Self::Alpha => "alpha".to_owned(),
            Self::Power(base, exponent) => {
                let base = base.inside(Binding::Atom, language);
                match language {
                    Language::Latex => format!("{base}^{{{exponent}}}"),
                    Language::Sympy => format!("{base}**{exponent}"),
                    Language::Text | Language::Maxima => format!("{base}^{exponent}"),
                }
            }
            Self::Product(factors) => {
                let factors: Vec<_> =
                    factors.iter().map(|factor| factor.inside(Binding::Power, language)).collect();
                factors.join(if language == Language::Latex { " " } else { "*" })
            }
            Self::Quotient(above, below) => match (language, above.as_ref(), below.as_ref()) {
                // A bar and braces group by themselves.
                (Language::Latex, ..) => {
                    format!("\\dfrac{{{}}}{{{}}}", above.text(language), below.text(language))
                }
                // In Python a quotient of two numbers would be rounded.
                (Language::Sympy, Self::Number(above), Self::Number(below)) => {
                    format!("Rational({above}, {below})")
                }
                _ => {
                    let above = above.inside(Binding::Product, language);
                    format!("{above}/{}", below.inside(Binding::Power, language))
                }
            },
            Self::Negative(tree) => format!("-{}", tree.inside(Binding::Product, language)),
            Self::Sum(terms) => {
                let mut text = String::new();
                for (at, term) in terms.iter().enumerate() {
                    let (sign, term) = match term {
                        Self::Negative(term) => (if at == 0 { "-" } else { " - " }, term.as_ref()),
                        term => (if at == 0 { "" } else { " + " }, term),
                    };
                    text.push_str(sign);
                    text.push_str(&term.inside(Binding::Product, language));
                }
                text
            }
        }
    }

    /// The text where nothing looser than `least` may stand.
    fn inside(&self, least: Binding, language: Language) -> String {
        let text = self.text(language);
        match (self.binding(language) >= least, language) {
            (true, _) => text,
            (false, Language::Latex) => format!("\\left({text}\\right)"),
            (false, _) => format!("({text})"),
        }
    }

    fn binding(&self, language: Language) -> Binding {
        match self {
            Self::Number(_) | Self::X | Self::Alpha => Binding::Atom,
            Self::Power(..) => Binding::Power,
            Self::Quotient(above, below) => match (language, above.as_ref(), below.as_ref()) {
                (Language::Latex, ..) => Binding::Power,
                (Language::Sympy, Self::Number(_), Self::Number(_)) => Binding::Atom,
                _ => Binding::Product,
            },
            Self::Product(_) => Binding::Product,
            Self::Negative(_) | Self::Sum(_) => Binding::Sum,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(n: u8) -> Tree {
        Tree::Number(n.into())
    }

    /// Every kind of tree at every place of every other one: what the places ask for.
    #[test]
    fn what_binds_looser_than_its_place_stands_in_parentheses() {
        let minus = || Tree::X.signed(true);
        let sum = || Tree::sum(vec![number(1), minus()]);
        let product = || Tree::product(vec![number(2), Tree::X]);
        let half = || Tree::quotient(Tree::X, number(2));
        for (tree, text, latex) in [
            (Tree::power(minus(), 2), "(-x)^2", r"\left(-x\right)^{2}"),
            (Tree::power(Tree::X, 2).signed(true), "-x^2", "-x^{2}"),
            (Tree::power(sum(), 2), "(1 - x)^2", r"\left(1 - x\right)^{2}"),
            (Tree::power(product(), 2), "(2*x)^2", r"\left(2 x\right)^{2}"),
            (Tree::power(half(), 2), "(x/2)^2", r"\left(\dfrac{x}{2}\right)^{2}"),
            (Tree::power(Tree::power(Tree::X, 2), 3), "(x^2)^3", r"\left(x^{2}\right)^{3}"),
            (Tree::product(vec![number(2), minus()]), "2*(-x)", r"2 \left(-x\right)"),
            (Tree::product(vec![minus(), Tree::Alpha]), "(-x)*alpha", r"\left(-x\right) \alpha"),
            (Tree::product(vec![number(8), sum()]), "8*(1 - x)", r"8 \left(1 - x\right)"),
            (Tree::product(vec![number(8), half()]), "8*(x/2)", r"8 \dfrac{x}{2}"),
            (product().signed(true), "-2*x", "-2 x"),
            (sum().signed(true), "-(1 - x)", r"-\left(1 - x\right)"),
            (minus().signed(true), "x", "x"),
            (Tree::quotient(minus(), sum()), "-x/(1 - x)", r"-\dfrac{x}{1 - x}"),
            (Tree::quotient(minus(), minus()), "x/x", r"\dfrac{x}{x}"),
            (Tree::quotient(sum(), product()), "(1 - x)/(2*x)", r"\dfrac{1 - x}{2 x}"),
            (Tree::quotient(half(), half()), "x/2/(x/2)", r"\dfrac{\dfrac{x}{2}}{\dfrac{x}{2}}"),
            (Tree::quotient(sum(), number(1)), "1 - x", "1 - x"),
            (Tree::sum(vec![minus(), sum()]), "-x + (1 - x)", r"-x + \left(1 - x\right)"),
            (Tree::sum(vec![number(1), sum().signed(true)]), "1 - (1 - x)", r"1 - \left(1 - x\right)"),
        ] {
            assert_eq!(tree.text(Language::Maxima), text);
            assert_eq!(tree.text(Language::Latex), latex);
        }
        let third = Tree::quotient(number(1), number(3));
        assert_eq!(Tree::power(third, 2).text(Language::Sympy), "Rational(1, 3)**2");
    }
}
