//! A refutation as a point: the numbers at which a sentence fails.

use crate::judge::{Bind, Bound, Witness};
use crate::scalar::parse_rational;
use crate::spline::Index;

use super::sexp::Sexp;

/// `(point (k K) (knots …) (ratio r) …)`; `None` if the witness has no knots, or a number that is irrational.
pub(super) fn point(witness: &Witness) -> Option<Sexp> {
    let number = |text: &str| parse_rational(text).ok().map(Sexp::Number);
    let ratio = |alpha: &str| Some(Sexp::Number(alpha.parse::<Index>().ok()?.ratio().clone()));
    let k = i64::try_from(witness.k?).ok()?;
    let knots: Vec<_> = witness.knots.iter().map(|t| number(t)).collect::<Option<_>>()?;
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
    let mut parts = vec![
        Sexp::form("k", [Sexp::int(k)]),
        Sexp::form("knots", knots),
        Sexp::form("ratio", [ratio(&witness.alpha)?]),
    ];
    parts.extend(witness.given.iter().map(bound).collect::<Option<Vec<_>>>()?);
    Some(Sexp::form("point", parts))
}
