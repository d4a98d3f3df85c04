//! A refutation as a point: the numbers at which a sentence fails.

use crate::judge::{Bind, Bound, Witness};
use crate::scalar::parse_rational;
use crate::spline::Index;

use super::sexp::Sexp;

/// `(point (k K) (knots …) (ratio r) …)`, without k and knots if it is about weights; `None` if it has a number that is
/// irrational.
pub(super) fn point(witness: &Witness) -> Option<Sexp> {
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
    let instance = witness.instance.iter().map(|name| Sexp::form("instance", [Sexp::name(name)]));
    let mut parts: Vec<_> = own.into_iter().chain([Sexp::form("ratio", [ratio(&witness.alpha)?])]).collect();
    parts.extend(instance);
    parts.extend(witness.given.iter().map(bound).collect::<Option<Vec<_>>>()?);
    Some(Sexp::form("point", parts))
}
