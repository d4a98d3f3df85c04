//! The paper's examples: degrees on knots, with the indices that its figures show and, for a curve, control points.

use std::sync::LazyLock;

use crate::language::{Name, Row, paper};
use crate::spline::{Basis, Index, KnotVector, Point};

use super::instance::Instance;

/// One of the paper's examples.
#[derive(Debug, Clone, PartialEq)]
pub struct Example {
    /// The name used here, such as `U4`, `C6a` or `S3`. One name can stand for several degrees.
    pub name: Name,
    /// Where the paper shows it.
    pub figure: String,
    /// k.
    pub degree: usize,
    /// U.
    pub knots: KnotVector,
    /// The values of α.
    pub indices: Vec<Index>,
    /// d_0, …, d_n, for a curve.
    pub points: Option<Vec<Point>>,
}

impl Example {
    fn of(row: &Row) -> Option<Self> {
        let index = |alpha: &Option<_>| match alpha {
            Some(alpha) => Index::from_alpha(Clone::clone(alpha)).ok(),
            None => Some(Index::infinity()),
        };
        Some(Self {
            name: row.name.clone().unwrap_or_default(),
            figure: row.figure.clone(),
            degree: row.degree,
            knots: KnotVector::new(row.knots.clone()).ok()?,
            indices: row.indices.iter().map(index).collect::<Option<_>>()?,
            points: row.points.clone(),
        })
    }

    /// Its basis for an index; `None` if the degree does not fit the knots, which a test rules out for the paper's.
    #[must_use]
    pub fn basis(&self, index: &Index) -> Option<Basis> {
        Basis::new(self.knots.clone(), self.degree, index.clone()).ok()
    }

    /// What sentences are read on: one for each index.
    pub fn instances(&self) -> impl Iterator<Item = Instance> {
        let on = self.indices.first().and_then(|index| self.basis(index)).map(Instance::of);
        let on =
            on.map(|on| if self.name.is_empty() { on } else { on.named(&self.name, self.points.clone()) });
        let each = |on: Instance| self.indices.iter().map(move |index| on.with_index(index.clone()));
        on.into_iter().flat_map(each)
    }
}

/// Rows of a file as examples. A row that is none is a bug of the data, which a test would find.
#[must_use]
pub fn examples_of(rows: &[Row]) -> Vec<Example> {
    rows.iter().filter_map(Example::of).collect()
}

/// All examples of the paper, in its order.
#[must_use]
pub fn examples() -> &'static [Example] {
    static ALL: LazyLock<Vec<Example>> = LazyLock::new(|| examples_of(&paper().examples));
    &ALL
}

/// The examples of that name: one for each degree, none if the name is unknown.
#[must_use]
pub fn examples_named(name: &str) -> Vec<Example> {
    examples().iter().filter(|example| &*example.name == name).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::Curve;

    #[test]
    fn every_row_is_valid() {
        let cases = paper().cases.values();
        for rows in std::iter::once(&paper().examples).chain(cases) {
            let all = examples_of(rows);
            assert_eq!(all.len(), rows.len());
            for example in all {
                for index in &example.indices {
                    let basis = example.basis(index).expect("a basis");
                    if let Some(points) = &example.points {
                        Curve::new(basis, points.clone()).expect("a curve");
                    }
                }
            }
        }
    }
}
