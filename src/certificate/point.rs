//! A refutation as a point: the numbers at which a sentence fails.

use crate::judge::{Bind, Bound, Witness};
use crate::language::{Family, Parameter};
use crate::scalar::parse_rational;
use crate::spline::Index;

use super::sexp::Sexp;

/// `(point (k K) (knots …) (parameter NAME …) …)`, without k and knots if it is about weights; `None` if it has a number that is
/// irrational.
pub(super) fn point(witness: &Witness, family: &Family) -> Option<Sexp> {
    let number = |text: &str| parse_rational(text).ok().map(Sexp::Number);
    let ratio = |alpha: &str| Some(Sexp::Number(alpha.parse::<Index>().ok()?.ratio().clone()));
    let knots: Vec<_> = witness.knots.iter().map(|t| number(t)).collect::<Option<_>>()?;
    let own = match witness.k {
        Some(k) => vec![Sexp::form("k", [Sexp::int(i64::try_from(k).ok()?)]), Sexp::form("knots", knots)],
        None => Vec::new(),
    };
    let bound = |Bound { name, value }: &Bound| {
        let (head, values) = match value {
            Bind::Integer(i) => ("integer", vec![Sexp::int(*i)]),
            Bind::Number(x) => ("real", vec![number(x)?]),
            Bind::List(all) => ("points", all.iter().map(|value| number(value)).collect::<Option<_>>()?),
            Bind::Index { alpha } => ("index", vec![ratio(alpha)?]),
            Bind::Between { .. } => return None,
        };
        Some(Sexp::form(head, std::iter::once(Sexp::name(name)).chain(values)))
    };
    let parameter = |own: &Parameter| {
        let values = match &witness.family {
            None => vec![ratio(&witness.alpha)?],
            Some(of) => {
                numbers(of.parameters.get(&*own.name)?, own, witness.knots.len(), witness.k.unwrap_or(1))?
            }
        };
        Some(Sexp::form("parameter", std::iter::once(Sexp::name(&own.name)).chain(values)))
    };
    let mut parts = own;
    parts.extend(witness.instance.iter().map(|name| Sexp::form("instance", [Sexp::name(name)])));
    parts.extend(family.parameters.iter().map(parameter).collect::<Option<Vec<_>>>()?);
    parts.extend(witness.given.iter().map(bound).collect::<Option<Vec<_>>>()?);
    Some(Sexp::form("point", parts))
}

/// The numbers of a parameter as behind `--set`, those that there are on knots t_0, …, t_m: for i from 0, for d from 1, or for each d a
/// row by i. `None` if there are too few.
fn numbers(text: &str, own: &Parameter, knots: usize, k: usize) -> Option<Vec<Sexp>> {
    let has = |which: &str| own.indices.iter().any(|index| **index == *which);
    let rows: Vec<Vec<_>> = text.split(';').map(|row| row.split(',').collect()).collect();
    let wanted = match (has("i"), has("d")) {
        (false, false) => vec![1],
        (true, false) => vec![knots],
        (false, true) => vec![k],
        (true, true) => (1..=k).map(|d| knots.saturating_sub(d)).collect(),
    };
    let mut all = Vec::new();
    for (at, wanted) in wanted.into_iter().enumerate() {
        for text in rows.get(at)?.get(..wanted)? {
            all.push(Sexp::Number(parse_rational(text).ok()?));
        }
    }
    Some(all)
}
