//! A real variable: the cells of its interval, and their parts where a cell has to be cut.

use crate::analysis::{IsolatedRoot, sign_pattern};
use crate::language::{Interval, Name};
use crate::scalar::{BigRational, Ring, integer};
use crate::spline::{Side, Span};

use super::cell::{Cell, Focus, Frame};
use super::reading::Reading;
use super::truth::{Stop, Truth};
use super::value::Value;

/// A part of an open cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// All of it.
    Whole,
    /// All between two neighbouring cuts, of which this u is one.
    Between(BigRational),
    /// A cut at a rational x.
    Point(BigRational),
    /// A cut at an irrational one.
    Root(IsolatedRoot),
}

impl Frame {
    /// For numbers with roots where no variable runs.
    pub(super) fn anywhere() -> Self {
        Self::new(0, "".into(), Cell::Point(integer(0)), None)
    }
}

impl Reading<'_> {
    /// The cells of an interval from left to right: on each, every function of the language without a moved argument is one.
    pub(super) fn cells(&mut self, interval: &Interval) -> Result<Vec<Cell>, Stop> {
        let mut end = |t| match self.real(t)?.number() {
            Some(end) => Ok(end.clone()),
            None => Err(Stop::Unknown("an interval with an end that is no rational number".into())),
        };
        let (from, to) = (end(&interval.from)?, end(&interval.to)?);
        let closed = (interval.from_closed, interval.to_closed);
        if from >= to {
            let point = from == to && closed == (true, true);
            return Ok(point.then_some(Cell::Point(from)).into_iter().collect());
        }
        let mut cells = self.line(Some(&from), Some(&to));
        if closed.0 {
            cells.insert(0, Cell::Point(from));
        }
        if closed.1 {
            cells.push(Cell::Point(to));
        }
        Ok(cells)
    }

    /// The cells of an open interval, or of the whole line.
    pub(super) fn line(&self, from: Option<&BigRational>, to: Option<&BigRational>) -> Vec<Cell> {
        let knots = self.on.knots().map_or(&[][..], |knots| knots.knots());
        let first = from.map_or(0, |from| knots.partition_point(|t| t <= from));
        let behind = to.map_or(knots.len(), |to| knots.partition_point(|t| t < to));
        let mut stops = knots.get(first..behind).unwrap_or(&[]).to_vec();
        stops.dedup();
        if stops.is_empty() && from.is_none() && to.is_none() {
            stops.push(integer(0));
        }
        let mut cells = Vec::new();
        let mut before = from.cloned();
        for t in stops {
            cells.push(Cell::Open(before, Some(t.clone())));
            cells.push(Cell::Point(t.clone()));
            before = Some(t);
        }
        cells.push(Cell::Open(before, to.cloned()));
        cells
    }

    /// With a name bound to a cell for a while; of an open one, the frame is its.
    pub(super) fn within<T>(&mut self, name: &Name, cell: &Cell, read: impl FnOnce(&mut Self) -> T) -> T {
        let before = self.frame.clone().filter(|_| matches!(cell, Cell::Open(..)));
        if before.as_ref().is_some_and(|frame| frame.focus != Focus::Whole) {
            self.memo.known.clear();
        }
        self.enter(name, cell);
        let result = read(self);
        self.bound.reals.pop();
        if matches!(cell, Cell::Open(..)) {
            self.frame = before;
        }
        if self.frame.as_ref().is_some_and(|frame| frame.focus != Focus::Whole) {
            self.memo.known.clear();
        }
        result
    }

    /// Binds a name to a cell.
    pub(super) fn enter(&mut self, name: &Name, cell: &Cell) {
        match cell {
            Cell::Point(x) => self.bound.reals.push((name.clone(), x.clone().into(), 0)),
            Cell::Open(from, to) => {
                self.frames += 1;
                let ends = from.as_ref().zip(to.as_ref());
                let span = self.on.knots().zip(ends).and_then(|(knots, ends)| {
                    knots
                        .span_at(ends.0, Side::Right)
                        .filter(|span| knots.ends(*span) == Ok(ends))
                        .map(Span::index)
                });
                let frame = Frame::new(self.frames, name.clone(), cell.clone(), span);
                self.bound.reals.push((name.clone(), frame.coordinate.clone().into(), frame.id));
                self.frame = Some(frame);
            }
        }
    }

    /// What is read on the frame; where that is mixed, on each of its parts.
    pub(super) fn by_parts<T>(&mut self, read: &mut dyn FnMut(&mut Self) -> (T, bool)) -> Vec<(Part, T)> {
        /// A part can ask for cuts that the whole did not: each branch of |…| its own.
        const ROUNDS: usize = 12;
        let (whole, mixed) = read(self);
        let mut parts = vec![(Part::Whole, whole)];
        let mut again = mixed;
        for _ in 0..ROUNDS {
            let Some(frame) = self.frame.as_ref().filter(|_| again) else { break };
            let Some(product) = frame.cuts.iter().cloned().reduce(|p, q| p.times(&q)) else { break };
            let (known, pattern) = (frame.cuts.len(), sign_pattern(&product));
            let between = pattern.between().iter().map(|(u, _)| Part::Between(u.clone()));
            let roots: Vec<_> = pattern
                .roots()
                .iter()
                .cloned()
                .map(|mut root| {
                    let x = root.rational().and_then(|u| frame.x(&u));
                    x.map_or_else(|| Part::Root(root), Part::Point)
                })
                .collect();
            let mut roots = roots.into_iter();
            let each: Vec<_> = between.flat_map(|part| std::iter::once(part).chain(roots.next())).collect();
            again = false;
            parts.clear();
            for part in each {
                let (result, mixed) = self.on_part(&part, read);
                parts.push((part, result));
                again |= mixed;
            }
            if self.frame.as_ref().is_some_and(|frame| frame.cuts.len() == known) {
                break;
            }
        }
        parts
    }

    /// What is read on a part of the frame.
    pub(super) fn on_part<T>(&mut self, part: &Part, read: &mut dyn FnMut(&mut Self) -> T) -> T {
        let focus = match part {
            Part::Point(x) => return self.at_point(x, read),
            Part::Whole => Focus::Whole,
            Part::Between(u) => Focus::Between(u.clone()),
            Part::Root(root) => Focus::At(root.clone()),
        };
        self.focus(focus);
        let result = read(self);
        self.focus(Focus::Whole);
        result
    }

    pub(super) fn focus(&mut self, focus: Focus) {
        if let Some(frame) = &mut self.frame {
            frame.focus = focus;
            // A value on a part is not that on the whole.
            self.memo.known.clear();
        }
    }

    /// What is read with the variable of the frame at a number.
    pub(super) fn at_point<T>(&mut self, x: &BigRational, read: &mut dyn FnMut(&mut Self) -> T) -> T {
        let Some(frame) = self.frame.take() else { return read(self) };
        let slot = self.bound.reals.iter().position(|(_, _, id)| *id == frame.id);
        let before =
            slot.map(|slot| std::mem::replace(&mut self.bound.reals[slot].1, Value::from(x.clone())));
        let result = read(self);
        if let (Some(slot), Some(before)) = (slot, before) {
            self.bound.reals[slot].1 = before;
        }
        self.frame = Some(frame);
        result
    }

    /// The truths on all parts of an interval, with whether they are points; ends early at one that settles it.
    pub(super) fn over_reals(
        &mut self,
        name: &Name,
        interval: &Interval,
        mut read: impl FnMut(&mut Self) -> Truth,
        settles: &Truth,
    ) -> Result<Vec<(Truth, bool)>, Stop> {
        let mut all = Vec::new();
        for cell in self.cells(interval)? {
            let point = matches!(cell, Cell::Point(_));
            let mut mixed = |own: &mut Self| {
                let truth = read(own);
                (truth.clone(), truth == Truth::Mixed)
            };
            let parts = self.within(name, &cell, |own| {
                if point { vec![(Part::Whole, mixed(own).0)] } else { own.by_parts(&mut mixed) }
            });
            for (part, truth) in parts {
                // What is mixed after all cuts is so in a variable further out, or beyond this program.
                let settled = truth == *settles;
                all.push((truth, point || matches!(part, Part::Point(_) | Part::Root(_))));
                if settled {
                    return Ok(all);
                }
            }
        }
        Ok(all)
    }
}
