//! Exact linear algebra: independence and combinations, of vectors and so of functions.

use crate::scalar::{ExactField, Polynomial, RationalFunction, Ring};

/// The dimension of the span of the vectors. A vector stands for the sequence that goes on with zeros, so the
/// lists may differ in length.
///
/// ```
/// # use knotproof::analysis::rank;
/// # use knotproof::scalar::integer;
/// let rows = [[1, 2, 3], [2, 4, 6], [0, 1, 1]].map(|row| row.map(integer).to_vec());
/// assert_eq!(rank(&rows), 2);
/// ```
#[must_use]
pub fn rank<S: ExactField>(vectors: &[Vec<S>]) -> usize {
    Echelon::of(vectors).rows.len()
}

/// Coefficients c_i with Σ c_i v_i = target, one for each vector; `None` if there are none, and they are
/// unique if the vectors are independent. As in [`rank`], missing entries are 0.
///
/// ```
/// # use knotproof::analysis::in_span;
/// # use knotproof::scalar::{integer, rational};
/// let vectors = [[1, 1, 0], [0, 1, 1]].map(|row| row.map(integer).to_vec());
/// let target = [2, 5, 3].map(integer);
/// assert_eq!(in_span(&vectors, &target), Some(vec![integer(2), integer(3)]));
/// assert_eq!(in_span(&vectors, &[1, 0, 1].map(integer)), None);
/// ```
#[must_use]
pub fn in_span<S: ExactField>(vectors: &[Vec<S>], target: &[S]) -> Option<Vec<S>> {
    combinations(vectors, &[target.to_vec()]).pop().flatten()
}

/// [`in_span`] of several targets, for which the vectors are brought to echelon form once.
///
/// ```
/// # use knotproof::analysis::combinations;
/// # use knotproof::scalar::integer;
/// let vectors = [[1, 1], [0, 1]].map(|row| row.map(integer).to_vec());
/// let targets = [[1, 3], [2, 2]].map(|row| row.map(integer).to_vec());
/// assert_eq!(combinations(&vectors, &targets), [[1, 2], [2, 0]].map(|c| Some(c.map(integer).to_vec())));
/// ```
#[must_use]
pub fn combinations<S: ExactField>(vectors: &[Vec<S>], targets: &[Vec<S>]) -> Vec<Option<Vec<S>>> {
    let echelon = Echelon::of(vectors);
    let combination = |target: &Vec<S>| {
        let Some(zero) = target.first().or_else(|| vectors.iter().flatten().next()).map(S::zero) else {
            // No entry anywhere, so there is no 0 to be had: only an empty list of coefficients can be given.
            return vectors.is_empty().then(Vec::new);
        };
        let reduced = echelon.reduce(target);
        if reduced.entries.iter().any(|entry| !entry.is_zero()) {
            return None;
        }
        // 0 = target + Σ (combination), over all vectors.
        let mut coefficients: Vec<S> = reduced.combination.iter().map(S::negate).collect();
        coefficients.resize(vectors.len(), zero);
        Some(coefficients)
    };
    targets.iter().map(combination).collect()
}

/// Is every target a combination of the vectors? As in [`rank`], missing entries are 0.
///
/// ```
/// # use knotproof::analysis::spans;
/// # use knotproof::scalar::integer;
/// let vectors = [[1, 1, 0], [0, 1, 1]].map(|row| row.map(integer).to_vec());
/// let targets = [[2, 5, 3], [1, 0, -1]].map(|row| row.map(integer).to_vec());
/// assert!(spans(&vectors, &targets));
/// assert!(!spans(&vectors, &[[1, 0, 1].map(integer).to_vec()]));
/// ```
#[must_use]
pub fn spans<S: ExactField>(vectors: &[Vec<S>], targets: &[Vec<S>]) -> bool {
    let echelon = Echelon::of(vectors);
    targets.iter().all(|target| echelon.reduce(target).entries.iter().all(S::is_zero))
}

/// Coefficients c_i, not all 0, with Σ c_i v_i = 0, one for each vector; `None` if they are independent. Missing entries are 0.
///
/// ```
/// # use knotproof::analysis::relation;
/// # use knotproof::scalar::integer;
/// let rows = [[1, 2], [0, 1], [1, 0]].map(|row| row.map(integer).to_vec());
/// assert_eq!(relation(&rows), Some(vec![-integer(1), integer(2), integer(1)]));
/// assert_eq!(relation(&rows[..2]), None);
/// ```
#[must_use]
pub fn relation<S: ExactField>(vectors: &[Vec<S>]) -> Option<Vec<S>> {
    let mut echelon = Echelon::default();
    let like = vectors.iter().flatten().next()?;
    vectors.iter().enumerate().find_map(|(at, vector)| {
        let Reduced { mut combination, .. } = echelon.insert(vector).err()?;
        combination.resize(vectors.len(), like.zero());
        combination[at] = like.one();
        Some(combination)
    })
}

/// The determinant of as many rows as columns over a field, by elimination; `None` if there are no rows, or they are not as long as
/// there are many. [`determinant`] is for entries that can't be divided.
///
/// ```
/// # use knotproof::analysis::determinant_by_elimination;
/// # use knotproof::scalar::integer;
/// let rows = [[1, 2, 3], [0, 1, 4], [5, 6, 0]].map(|row| row.map(integer).to_vec());
/// assert_eq!(determinant_by_elimination(&rows), Some(integer(1)));
/// ```
#[must_use]
pub fn determinant_by_elimination<S: ExactField>(rows: &[Vec<S>]) -> Option<S> {
    let one = rows.first()?.first()?.one();
    if rows.iter().any(|row| row.len() != rows.len()) {
        return None;
    }
    let (mut echelon, mut determinant) = (Echelon::default(), one);
    for row in rows {
        match echelon.insert(row) {
            Ok(pivot) => determinant = determinant.times(&pivot),
            Err(_) => return Some(determinant.zero()),
        }
    }
    // With the columns in the order of the pivots what is left is triangular.
    let pivots: Vec<_> = echelon.rows.iter().map(|row| row.pivot).collect();
    let turned = |at: usize| pivots[at + 1..].iter().filter(|later| **later < pivots[at]).count();
    let inversions: usize = (0..pivots.len()).map(turned).sum();
    Some(if inversions.is_multiple_of(2) { determinant } else { determinant.negate() })
}

/// The determinant of as many rows as columns, by the expansion along the first column; `one` for no row at all.
///
/// ```
/// # use knotproof::analysis::determinant;
/// # use knotproof::scalar::integer;
/// let rows = [[1, 2, 3], [0, 1, 4], [5, 6, 0]].map(|row| row.map(integer).to_vec());
/// assert_eq!(determinant(&rows, &integer(1)), integer(1));
/// ```
#[must_use]
pub fn determinant<R: Ring>(rows: &[Vec<R>], one: &R) -> R {
    if rows.is_empty() {
        return one.clone();
    }
    let mut sum = one.zero();
    for (at, entry) in rows.iter().enumerate().filter_map(|(at, row)| Some((at, row.first()?))) {
        let others = rows.iter().enumerate().filter(|(other, _)| *other != at);
        let minor: Vec<Vec<R>> = others.map(|(_, row)| row.iter().skip(1).cloned().collect()).collect();
        let term = entry.times(&determinant(&minor, one));
        sum = if at % 2 == 0 { sum.plus(&term) } else { sum.minus(&term) };
    }
    sum
}

/// Vectors in echelon form, with the way in which they were obtained from the inserted ones.
#[derive(Debug)]
struct Echelon<S> {
    rows: Vec<Row<S>>,
    inserted: usize,
}

impl<S> Default for Echelon<S> {
    fn default() -> Self {
        Self { rows: Vec::new(), inserted: 0 }
    }
}

/// entries = (some vector) + Σ combination_i · (inserted vector i), with a 1 as the first non-zero entry.
#[derive(Debug)]
struct Row<S> {
    pivot: usize,
    entries: Vec<S>,
    combination: Vec<S>,
}

/// A vector after the elimination of the pivots: vector + Σ combination_i · (inserted vector i).
struct Reduced<S> {
    entries: Vec<S>,
    combination: Vec<S>,
}

impl<S: ExactField> Echelon<S> {
    /// A vector that depends on those before is left out.
    fn of(vectors: &[Vec<S>]) -> Self {
        let mut echelon = Self::default();
        vectors.iter().for_each(|vector| _ = echelon.insert(vector));
        echelon
    }

    fn reduce(&self, vector: &[S]) -> Reduced<S> {
        let mut reduced = Reduced { entries: vector.to_vec(), combination: Vec::new() };
        for row in &self.rows {
            let Some(factor) = reduced.entries.get(row.pivot).filter(|c| !c.is_zero()).map(S::negate) else {
                continue;
            };
            add_multiple(&mut reduced.entries, &factor, &row.entries);
            add_multiple(&mut reduced.combination, &factor, &row.combination);
        }
        reduced
    }

    /// Makes the vector a row, if it is independent of those before: its first entry that is left, by which it is divided. If not,
    /// how it depends on them.
    fn insert(&mut self, vector: &[S]) -> Result<S, Reduced<S>> {
        let position = self.inserted;
        self.inserted += 1;
        let mut reduced = self.reduce(vector);
        let first = reduced.entries.iter().position(|entry| !entry.is_zero());
        let pivot =
            first.and_then(|at| Some((at, reduced.entries[at].clone(), reduced.entries[at].reciprocal()?)));
        let Some((pivot, entry, inverse)) = pivot else { return Err(reduced) };
        reduced.combination.resize(position, inverse.zero());
        reduced.combination.push(inverse.one());
        for entry in reduced.entries.iter_mut().chain(&mut reduced.combination) {
            *entry = entry.times(&inverse);
        }
        let Reduced { entries, combination } = reduced;
        self.rows.push(Row { pivot, entries, combination });
        Ok(entry)
    }
}

/// target += factor·vector, the shorter one continued with zeros.
fn add_multiple<S: Ring>(target: &mut Vec<S>, factor: &S, vector: &[S]) {
    if target.len() < vector.len() {
        target.resize(vector.len(), factor.zero());
    }
    for (t, v) in target.iter_mut().zip(vector).filter(|(_, v)| !v.is_zero()) {
        *t = t.plus(&factor.times(v));
    }
}

/// Polynomials P_i with f_i = P_i/Q for one common denominator Q, the least one: a linear relation between the
/// functions is one between the coefficient vectors of the P_i, and the other way round.
///
/// ```
/// # use knotproof::analysis::{common_numerators, rank};
/// # use knotproof::scalar::{Polynomial, RationalAlgebra, RationalFunction, Ring, rational};
/// // 1/(1 + u), u/(1 + u) and 1 are dependent: the first two add up to the third.
/// let u = RationalFunction::variable(&rational(1, 1));
/// let total = u.plus(&u.one());
/// let functions = [u.one().over(&total).unwrap(), u.over(&total).unwrap(), u.one()];
/// let rows: Vec<_> = common_numerators(&functions).iter().map(|p| p.coefficients().to_vec()).collect();
/// assert_eq!(rank(&rows), 2);
/// ```
#[must_use]
pub fn common_numerators<S: ExactField>(functions: &[RationalFunction<S>]) -> Vec<Polynomial<S>> {
    let Some(first) = functions.first() else { return Vec::new() };
    let quotient = |p: &Polynomial<S>, divisor: &Polynomial<S>| match p.divide(divisor) {
        Some((quotient, _)) => quotient,
        None => unreachable!("a denominator is not 0"),
    };
    // Functions on a span have few denominators between them, most of them one.
    let mut denominators: Vec<&Polynomial<S>> = Vec::new();
    let own: Vec<usize> = functions
        .iter()
        .map(|f| {
            let known = denominators.iter().position(|known| *known == f.denominator());
            known.unwrap_or_else(|| {
                denominators.push(f.denominator());
                denominators.len() - 1
            })
        })
        .collect();
    let common = denominators.iter().fold(first.denominator().one(), |common, denominator| {
        let divisor = common.gcd(denominator);
        common.times(&quotient(denominator, &divisor))
    });
    let missing: Vec<_> = denominators.iter().map(|denominator| quotient(&common, denominator)).collect();
    functions.iter().zip(own).map(|(f, at)| f.numerator().times(&missing[at])).collect()
}

/// Q, monic, and with it the P_i of [`common_numerators`]: no polynomial divides Q and all of them. `None` without a function.
#[must_use]
pub fn over_common_denominator<S: ExactField>(
    functions: &[RationalFunction<S>],
) -> Option<(Polynomial<S>, Vec<Polynomial<S>>)> {
    // Of 1 over the common denominator the numerator is that itself.
    let one = functions.first()?.one();
    let mut numerators = common_numerators(&[functions, &[one]].concat());
    let denominator = numerators.pop()?;
    let scale = denominator.leading().reciprocal()?;
    let monic = |p: &Polynomial<S>| p.scaled(&scale);
    Some((monic(&denominator), numerators.iter().map(monic).collect()))
}

/// One row for each function, given as its pieces on one span after the other: the coefficients of the
/// numerators over one denominator for each span. A linear relation between functions is one between rows.
///
/// Every span must list the same functions in the same order.
pub fn coefficient_rows<S: ExactField>(
    spans: impl IntoIterator<Item = Vec<RationalFunction<S>>>,
) -> Vec<Vec<S>> {
    let mut rows: Vec<Vec<S>> = Vec::new();
    for functions in spans {
        let numerators = common_numerators(&functions);
        rows.resize(rows.len().max(numerators.len()), Vec::new());
        let length = numerators.iter().map(|p| p.degree() + 1).max().unwrap_or(0);
        for (row, numerator) in rows.iter_mut().zip(&numerators) {
            let zeros = std::iter::repeat_n(numerator.leading().zero(), length - numerator.degree() - 1);
            row.extend(numerator.coefficients().iter().cloned().chain(zeros));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{BigRational, integer, rational};

    fn row(entries: &[i64]) -> Vec<BigRational> {
        entries.iter().map(|&e| rational(e, 1)).collect()
    }

    #[test]
    fn ranks() {
        assert_eq!(rank::<BigRational>(&[]), 0);
        assert_eq!(rank(&[row(&[0, 0]), row(&[])]), 0);
        assert_eq!(rank(&[row(&[0, 1]), row(&[1]), row(&[3, 4, 0])]), 2);
        assert_eq!(rank(&[row(&[0, 0, 1]), row(&[0, 1, 1]), row(&[1, 1, 1])]), 3);
    }

    #[test]
    fn combinations_are_found_if_and_only_if_there_are_any() {
        // Dependent vectors, a pivot out of order, rows of different lengths.
        let vectors = [row(&[0, 2, 1]), row(&[0, 4, 2]), row(&[3]), row(&[1, 1, 1, 5])];
        for target in [row(&[7, 3, 2, 5]), row(&[0, 0, 0, 0]), row(&[1, 2, 3, 4]), row(&[1]), row(&[])] {
            let with_target: Vec<_> = vectors.iter().cloned().chain([target.clone()]).collect();
            let inside = rank(&with_target) == rank(&vectors);
            let found = in_span(&vectors, &target);
            assert_eq!(found.is_some(), inside, "{target:?}");
            if let Some(coefficients) = found {
                let mut sum = Vec::new();
                for (c, vector) in coefficients.iter().zip(&vectors) {
                    add_multiple(&mut sum, c, vector);
                }
                add_multiple(&mut sum, &rational(-1, 1), &target);
                assert!(sum.iter().all(|entry| *entry == integer(0)), "{target:?}");
            }
        }
        assert_eq!(in_span::<BigRational>(&[], &[]), Some(vec![]));
        assert_eq!(in_span(&[], &row(&[0, 0])), Some(vec![]));
        assert_eq!(in_span(&[], &row(&[0, 1])), None);
    }
}
