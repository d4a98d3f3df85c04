//! A place on a knot vector, and what is looked at there, as terms of the formal language.

use std::fmt;

/// A place on a span of a knot vector, which is A unless said otherwise: `(in A 3)`, `(from A 3)` or `(to A 3)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    part: &'static str,
    knots: char,
    span: usize,
}

impl Place {
    /// Between the knots of the span, at the coordinate u.
    pub(super) fn inside(span: usize) -> Self {
        Self { part: "in", knots: 'A', span }
    }

    /// At the first knot of the span, as the limit from the right.
    pub(super) fn start(span: usize) -> Self {
        Self { part: "from", ..Self::inside(span) }
    }

    /// At the last knot of the span, as the limit from the left.
    pub(super) fn end(span: usize) -> Self {
        Self { part: "to", ..Self::inside(span) }
    }

    /// All of the closed span.
    pub(super) fn closed(span: usize) -> [Self; 3] {
        [Self::inside(span), Self::start(span), Self::end(span)]
    }

    /// The same place on the knots of this name.
    pub(super) fn on(self, knots: char) -> Self {
        Self { knots, ..self }
    }

    /// The index of the span.
    pub(super) fn span(self) -> usize {
        self.span
    }

    /// x there.
    pub(super) fn x(self) -> String {
        format!("(x {self})")
    }

    /// `(NAME i d PLACE)`: a function `G` of degree d, its derivative `DG`, a weight `w` of d spans, its complement `v`
    /// or its derivative `Dw`.
    pub(super) fn value(self, name: &str, i: impl fmt::Display, d: usize) -> String {
        format!("({name} {i} {d} {self})")
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({} {} {})", self.part, self.knots, self.span)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_of_the_language() {
        assert_eq!(Place::closed(3).map(|place| place.to_string()), ["(in A 3)", "(from A 3)", "(to A 3)"]);
        assert_eq!(Place::end(3).on('B').x(), "(x (to B 3))");
        assert_eq!(Place::start(0).value("DG", -2, 2), "(DG -2 2 (from A 0))");
    }
}
