//! The paper's examples: degrees on knots, with the indices that its figures show and, for a curve, control points.

use std::sync::{Arc, LazyLock};

use crate::language::{Complaint, Family, Name, Paper, Row, RowPart, paper};
use crate::spline::{AnyWeights, Basis, Curve, Index, KnotVector, Point};

use super::family::{MemberError, Values, Weighting, setting};
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
    /// Its weights: for each α, or of a member of another family.
    pub weights: Vec<Weighting>,
    /// d_0, …, d_n, for a curve.
    pub points: Option<Vec<Point>>,
}

impl Example {
    fn of(row: &Row, family: &Arc<Family>) -> Option<Self> {
        Some(Self {
            name: row.name.clone().unwrap_or_default(),
            figure: row.figure.clone(),
            degree: row.degree,
            knots: KnotVector::new(row.knots.clone()).ok()?,
            weights: weights(row, family).ok()?,
            points: row.points.clone(),
        })
    }

    /// The values of α; none of a family without an index.
    pub fn indices(&self) -> impl Iterator<Item = &Index> {
        self.weights.iter().filter_map(Weighting::index)
    }

    /// Its basis for an index; `None` if the degree does not fit the knots, which [`row_faults`] complains of.
    #[must_use]
    pub fn basis(&self, index: &Index) -> Option<Basis> {
        Basis::new(self.knots.clone(), self.degree, index.clone()).ok()
    }

    /// Its curve for each of its weights; none if there are no control points, or if the row is none, which [`row_faults`] complains
    /// of.
    pub fn curves(&self) -> impl Iterator<Item = (&Weighting, Curve<AnyWeights>)> {
        let curve = |weights: &Weighting| {
            let on = weights.on_knots(&self.knots, self.degree).ok()?;
            Curve::new(Basis::over(self.knots.clone(), self.degree, on).ok()?, self.points.clone()?).ok()
        };
        self.weights.iter().filter_map(move |weights| Some((weights, curve(weights)?)))
    }

    /// What sentences are read on: one for each of its weights.
    pub fn instances(&self) -> impl Iterator<Item = Instance> {
        let basis = |weights: &Weighting| Basis::over(self.knots.clone(), self.degree, weights.clone()).ok();
        let on = self.weights.first().and_then(basis).and_then(|basis| Instance::on(basis).ok());
        let on =
            on.map(|on| if self.name.is_empty() { on } else { on.named(&self.name, self.points.clone()) });
        let each = |on: Instance| self.weights.iter().map(move |weights| on.with(weights.clone()));
        on.into_iter().flat_map(each)
    }
}

/// The weights that a row names.
fn weights(row: &Row, family: &Arc<Family>) -> Result<Vec<Weighting>, MemberError> {
    let without_index = family.moebius().is_none();
    if !row.set.is_empty() || (without_index || family.parameters.is_empty()) && row.indices.is_empty() {
        let given =
            row.set.iter().map(|(name, rows)| (name.clone(), Values::shaped(rows.clone(), family, name)));
        return Ok(vec![Weighting::of(family, &given.collect::<Vec<_>>())?]);
    }
    let index = |alpha: &Option<_>| match alpha {
        Some(alpha) => Index::from_alpha(Clone::clone(alpha)).ok(),
        None => Some(Index::infinity()),
    };
    Ok(row.indices.iter().filter_map(index).map(Weighting::Index).collect())
}

/// Rows of a file as examples. A row that is none is left out: [`row_faults`] says why.
#[must_use]
pub fn examples_of(rows: &[Row], family: &Arc<Family>) -> Vec<Example> {
    rows.iter().filter_map(|row| Example::of(row, family)).collect()
}

/// What keeps instances and cases of a paper from being examples, each with its place: knots that fall, weights that its family
/// has not, control points that are no curve in the plane, a name twice in one degree.
#[must_use]
pub fn row_faults(paper: &Paper) -> Vec<Complaint> {
    // Of a family that could not be read nothing is known.
    let family = paper.has_family.then_some(&paper.about.family);
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
fn row_fault(row: &Row, family: Option<&Arc<Family>>) -> Option<Complaint> {
    let fault = |part, rule: String, advice: &str| Some(row.complaint(part, rule, advice));
    let knots = match KnotVector::new(row.knots.clone()) {
        Ok(knots) => knots,
        Err(error) => return fault(RowPart::Knots, error.to_string(), "write t_0 ≤ … ≤ t_m with t_0 < t_m"),
    };
    if let Some(fault) = family.and_then(|family| weights_fault(row, family, &knots)) {
        return Some(fault);
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

/// What is wrong with the weights of a row on its knots.
fn weights_fault(row: &Row, family: &Arc<Family>, knots: &KnotVector) -> Option<Complaint> {
    let fault = |rule: String, advice: &str| Some(row.complaint(RowPart::Weights, rule, advice));
    let has_index = family.moebius().is_some();
    if row.set.is_empty() && (has_index || !row.indices.is_empty()) {
        if row.indices.is_empty() && !family.parameters.is_empty() {
            return fault("there is no index".into(), "write some, such as `alpha = \"-1 2 inf\"`");
        }
        if row.indices.iter().any(|alpha| !family.has_index(alpha.as_ref())) {
            let rule = match has_index {
                true => format!("the family `{}` has no index but ∞", family.name),
                false => format!("the family `{}` has no index α", family.name),
            };
            let advice = match family.parameters.first() {
                None => "write `inf`, or name another family in paper.toml".to_owned(),
                Some(own) => format!("write `set` in place of `alpha`, as behind --set {}", setting(own)),
            };
            return fault(rule, &advice);
        }
    }
    if !row.set.is_empty() && !row.indices.is_empty() {
        return fault("there is `alpha`, and `set`, too".into(), "write one of them");
    }
    let weights = match weights(row, family) {
        Ok(weights) => weights,
        Err(error) => return fault(error.to_string(), "write what it says"),
    };
    for weights in weights {
        let basis = Basis::over(knots.clone(), row.degree, weights).ok();
        if let Some(Err(error)) = basis.map(Instance::on) {
            return fault(error.to_string(), "take other numbers");
        }
    }
    None
}

/// All examples of the paper, in its order.
#[must_use]
pub fn examples() -> &'static [Example] {
    static ALL: LazyLock<Vec<Example>> =
        LazyLock::new(|| examples_of(&paper().examples, &paper().about.family));
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
                assert_eq!(examples_of(rows, &paper.about.family).len(), rows.len());
            }
        }
    }
}
