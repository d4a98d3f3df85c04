//! What is printed, before it is known in which alphabet.

use std::fmt::Display;

/// A piece of print.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Form {
    /// Words of a sentence.
    Words(String),
    /// A name, a number, or a symbol that stands for itself.
    Atom(String),
    /// An operation or relation, with space around it.
    Operator(Operator),
    /// A sign: nothing is before it.
    Prefix(Operator),
    /// Side by side.
    Row(Vec<Form>),
    /// Without spaces: the ends of a range in the source.
    Tight(Box<Form>),
    /// In brackets.
    Fence(&'static str, Box<Form>, &'static str),
    /// With what is below and above behind it.
    Script(Box<Form>, Option<Box<Form>>, Option<Box<Form>>),
    /// With what is above before it.
    Before(Box<Form>, Box<Form>),
    /// Numerator and denominator, each with whether it needs brackets on one line.
    Fraction([(Box<Form>, bool); 2]),
    /// A sum, a product, a least or greatest one, with what is below and above.
    Big(Big, Box<Form>, Option<Box<Form>>),
    /// √.
    Root(Box<Form>),
}

/// What runs over a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Big {
    /// Σ.
    Sum,
    /// Π.
    Product,
    /// min.
    Least,
    /// max.
    Greatest,
}

/// Operations, relations and separators: in the source, in Unicode, in LaTeX.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Operator(pub &'static str, pub &'static str, pub &'static str);

pub(super) const PLUS: Operator = Operator("+", "+", "+");
pub(super) const MINUS: Operator = Operator("-", "−", "-");
pub(super) const TIMES: Operator = Operator("*", "·", r"\cdot");
pub(super) const SLASH: Operator = Operator("/", "/", "/");
pub(super) const EQUAL: Operator = Operator("=", "=", "=");
pub(super) const UNEQUAL: Operator = Operator("!=", "≠", r"\ne");
pub(super) const LESS: Operator = Operator("<", "<", "<");
pub(super) const AT_MOST: Operator = Operator("<=", "≤", r"\le");
pub(super) const GREATER: Operator = Operator(">", ">", ">");
pub(super) const AT_LEAST: Operator = Operator(">=", "≥", r"\ge");
pub(super) const IMPLIES: Operator = Operator("=>", "⇒", r"\Rightarrow");
pub(super) const IFF: Operator = Operator("<=>", "⇔", r"\Leftrightarrow");
pub(super) const MAPS: Operator = Operator("", "↦", r"\mapsto");
pub(super) const COMMA: Operator = Operator(", ", ", ", ", ");

impl Form {
    pub(super) fn words(words: impl Into<String>) -> Self {
        Self::Words(words.into())
    }

    pub(super) fn atom(text: impl Display) -> Self {
        Self::Atom(text.to_string())
    }

    pub(super) fn fenced(open: &'static str, inner: Self, close: &'static str) -> Self {
        Self::Fence(open, Box::new(inner), close)
    }

    /// In round brackets if they are needed.
    pub(super) fn bracketed(self, needed: bool) -> Self {
        if needed { Self::fenced("(", self, ")") } else { self }
    }

    pub(super) fn script(base: Self, below: Option<Self>, above: Option<Self>) -> Self {
        Self::Script(Box::new(base), below.map(Box::new), above.map(Box::new))
    }

    /// With an operator between neighbours.
    pub(super) fn joined(forms: impl IntoIterator<Item = Self>, by: Operator) -> Self {
        Self::between(forms, &Self::Operator(by))
    }

    pub(super) fn between(forms: impl IntoIterator<Item = Self>, what: &Self) -> Self {
        let mut row = Vec::new();
        for form in forms {
            if !row.is_empty() {
                row.push(what.clone());
            }
            row.push(form);
        }
        Self::Row(row)
    }

    /// `a, b and c`.
    pub(super) fn enumerated(mut forms: Vec<Self>) -> Self {
        let Some(last) = forms.pop() else { return Self::Row(Vec::new()) };
        if forms.is_empty() {
            return last;
        }
        Self::Row(vec![Self::between(forms, &Self::words(", ")), Self::words(" and "), last])
    }
}

/// Letters that are written by their names.
pub(super) const GREEK: &[(&str, char)] = &[
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("phi", 'φ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
];
