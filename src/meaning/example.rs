//! The paper's examples: degrees on knots, with the indices that its figures show and, for a curve, control points.

use std::sync::LazyLock;

use crate::language::{Complaint, Family, Name, Paper, Row, RowPart, paper};
use crate::spline::{Basis, Curve, Index, KnotVector, Point};

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

    /// Its basis for an index; `None` if the degree does not fit the knots, which [`row_faults`] complains of.
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

/// Rows of a file as examples. A row that is none is left out: [`row_faults`] says why.
#[must_use]
pub fn examples_of(rows: &[Row]) -> Vec<Example> {
    rows.iter().filter_map(Example::of).collect()
}

/// What keeps instances and cases of a paper from being examples, each with its place: knots that fall, an index that its family
/// has not, control points that are no curve in the plane, a name twice in one degree.
#[must_use]
pub fn row_faults(paper: &Paper) -> Vec<Complaint> {
    let family = paper.about.family;
    let rows = std::iter::once(&paper.examples).chain(paper.cases.values()).flatten();
    let mut faults: Vec<_> = rows.filter_map(|row| row_fault(row, family)).collect();
    for (at, row) in paper.examples.iter().enumerate() {
        if paper.examples[..at].iter().any(|other| (&other.name, other.degree) == (&row.name, row.degree)) {
            let rule = format!("another instance has this name in degree {}", row.degree);
            faults.push(row.complaint(RowPart::Name, rule, "give one of them another"));
        }
    }
    faults
}

/// The first thing that is wrong with a row.
fn row_fault(row: &Row, family: Family) -> Option<Complaint> {
    let fault = |part, rule: String, advice| Some(row.complaint(part, rule, advice));
    let knots = match KnotVector::new(row.knots.clone()) {
        Ok(knots) => knots,
        Err(error) => return fault(RowPart::Knots, error.to_string(), "write t_0 ≤ … ≤ t_m with t_0 < t_m"),
    };
    if row.indices.is_empty() {
        return fault(RowPart::Indices, "there is no index".into(), "write some, such as `-1 2 inf`");
    }
    for alpha in &row.indices {
        if !family.has(alpha.as_ref()) {
            let rule = "the family `classical` has no index but ∞".into();
            return fault(RowPart::Indices, rule, "write `inf`, or name another family in paper.toml");
        }
    }
    let basis = match Basis::new(knots, row.degree, Index::infinity()) {
        Ok(basis) => basis,
        Err(error) => return fault(RowPart::Knots, error.to_string(), "write more knots, or a lower degree"),
    };
    let points = row.points.as_ref()?;
    if let Some(at) = points.iter().position(|point| point.len() != 2) {
        let rule =
            format!("control point {at} has {} coordinates; curves lie in the plane", points[at].len());
        return fault(RowPart::Points, rule, "write points by spaces, their two coordinates by a comma");
    }
    match Curve::new(basis, points.clone()) {
        Ok(_) => None,
        Err(error) => fault(RowPart::Points, error.to_string(), "write d_0, …, d_n, n = m − k − 1"),
    }
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
    use crate::language::{shipped, shipped_names};

    #[test]
    fn every_row_is_valid() {
        for paper in shipped_names().filter_map(shipped) {
            assert_eq!(row_faults(paper), []);
            for rows in std::iter::once(&paper.examples).chain(paper.cases.values()) {
                assert_eq!(examples_of(rows).len(), rows.len());
            }
        }
    }
}
