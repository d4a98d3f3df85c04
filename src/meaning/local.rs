//! Sums over functions with local support: at an x inside of a span the terms are 0 but for d + 1 of them.

use std::ops::RangeInclusive;

use crate::language::{Argument, Function, Int, Member, Name, Range, Real};

use super::functions::of;
use super::reading::Reading;

/// A factor G_i^d(x), or a derivative of it, where i is the name that runs and the rest is free of it.
struct Local<'t> {
    degree: Option<&'t Int>,
    argument: &'t Argument,
}

impl Reading<'_> {
    /// The part of the range of a sum of products with a factor G_i^d(x) beyond which all terms have a value, 0; all of it where that is
    /// not plain to see. It is not empty if the range is not: what else is in the terms is read once at least.
    pub(super) fn local(
        &mut self,
        range: &Range,
        body: &Real,
        all: RangeInclusive<i64>,
    ) -> RangeInclusive<i64> {
        self.support(range, body, &all).unwrap_or(all)
    }

    fn support(
        &mut self,
        range: &Range,
        body: &Real,
        all: &RangeInclusive<i64>,
    ) -> Option<RangeInclusive<i64>> {
        // What a witness shows was looked at, every term of it; and the reference skips nothing.
        if self.looked.is_some() || self.on.is_reference() || all.is_empty() {
            return None;
        }
        let mut found = None;
        if !self.is_product(&range.name, body, all, &mut found) {
            return None;
        }
        let Local { degree, argument } = found?;
        let (knots, k) = (self.knots().ok()?, self.degree().ok()?);
        let d = match degree {
            Some(d) => usize::try_from(self.int(d).ok()?).ok().filter(|d| *d <= k)?,
            None => k,
        };
        let signed = |n: usize| i64::try_from(n).ok();
        // All functions of the range exist.
        if *all.start() < 0 || *all.end() >= signed(knots.m())? - signed(d)? {
            return None;
        }
        let x = self.real(&argument.at).ok()?;
        let span = match (x.number(), &self.frame) {
            (Some(x), _) => knots.span_at(x, of(argument.side)).map(crate::spline::Span::index),
            (None, Some(frame)) if frame.is_variable(&x) => Some(frame.span?),
            _ => return None,
        };
        let only = *all.start()..=*all.start();
        let Some(j) = span else { return Some(only) };
        let (from, to) = (*all.start().max(&(signed(j)? - signed(d)?)), *all.end().min(&signed(j)?));
        Some(if from <= to { from..=to } else { only })
    }

    /// Is the term a product of factors that have a value for every i of the range, one of them a [`Local`]?
    fn is_product<'t>(
        &self,
        name: &Name,
        t: &'t Real,
        all: &RangeInclusive<i64>,
        found: &mut Option<Local<'t>>,
    ) -> bool {
        let runs = |i: &Int| matches!(i, Int::Bound(bound) if bound == name);
        match t {
            Real::Times(a, b) => self.is_product(name, a, all, found) && self.is_product(name, b, all, found),
            Real::Negated(a) => self.is_product(name, a, all, found),
            Real::Coefficient(of, indices) if indices.len() == 1 && runs(&indices[0]) => {
                let list = self.bound.points.iter().rev().find(|(bound, _)| bound == of);
                let count = list.and_then(|(_, list)| i64::try_from(list.len()).ok());
                *all.start() >= 0 && count.is_some_and(|count| *all.end() < count)
            }
            Real::Value(f, argument) => {
                let mut base = &**f;
                while let Function::Derivative(inner, order) = base {
                    if !is_free_int(name, order) {
                        return false;
                    }
                    base = inner;
                }
                let Function::Basis { i, degree } = base else { return false };
                let fits = runs(i)
                    && degree.as_ref().is_none_or(|d| is_free_int(name, d))
                    && is_free(name, &argument.at)
                    && match &argument.member {
                        None | Some(Member::Dual) => true,
                        Some(Member::Index(t) | Member::Ratio(t) | Member::Parameter(_, t)) => {
                            is_free(name, t)
                        }
                    };
                if fits && found.is_none() {
                    *found = Some(Local { degree: degree.as_ref(), argument });
                }
                // A second one has a support of its own, which would do as well.
                fits
            }
            _ => is_free(name, t),
        }
    }
}

/// Does a term not depend on an integer? Some that do not are taken for such that do.
fn is_free(name: &Name, t: &Real) -> bool {
    match t {
        Real::Number(_) | Real::Bound(_) | Real::Index(_) | Real::Ratio | Real::Infinity => true,
        Real::Whole(i) | Real::Knot(i) => is_free_int(name, i),
        Real::Coefficient(_, of) => of.iter().all(|i| is_free_int(name, i)),
        Real::Negated(a) | Real::Absolute(a) => is_free(name, a),
        Real::Plus(a, b) | Real::Minus(a, b) | Real::Times(a, b) | Real::Over(a, b) => {
            is_free(name, a) && is_free(name, b)
        }
        Real::Power(a, e) => is_free(name, a) && is_free_int(name, e),
        _ => false,
    }
}

fn is_free_int(name: &Name, t: &Int) -> bool {
    match t {
        Int::Number(_) | Int::Degree | Int::Last | Int::M => true,
        Int::Bound(bound) => bound != name,
        Int::Plus(a, b)
        | Int::Minus(a, b)
        | Int::Times(a, b)
        | Int::Least(a, b)
        | Int::Greatest(a, b)
        | Int::Binomial(a, b) => is_free_int(name, a) && is_free_int(name, b),
        Int::Word(_) => false,
    }
}
