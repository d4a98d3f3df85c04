//! What `bezier` prints for people.

use std::fmt;

use comfy_table::Table;

use crate::scalar::integer;

use super::super::exact::Exact;
use super::super::notation::Notation;
use super::super::on_knots::tuple;
use super::super::table::{HEADING, plain, right_aligned};
use super::nurbs::{Change, Joined, Run};
use super::{Conversion, Piece};

/// A longer fraction says nothing to people, and would leave no room for the rest of a line.
const LENGTH_LIMIT: usize = 40;

impl fmt::Display for Conversion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}, {}", self.on, self.weights)?;
        let (count, are) = match self.pieces.len() {
            1 => ("1 rational Bézier curve".to_owned(), "It is"),
            more => (format!("{more} rational Bézier curves"), "Each is"),
        };
        let positive = if self.weights.family().is_some() { " with positive weights" } else { "" };
        let of = if self.order == 0 { "the curve" } else { "the derivative of the curve" };
        let checked =
            if self.order == 0 { "checked exactly" } else { "from the pieces, which are checked exactly" };
        writeln!(
            f,
            "{count} of least degree{positive}. {are} equal to {of} for every x of its span ({checked})."
        )?;
        if self.pieces.iter().any(|piece| !piece.base) {
            let note = "outside of [t_k, t_(n+1)], where the basis functions add up to less than 1";
            writeln!(f, "Note: spans marked * lie {note}.")?;
        }
        for piece in &self.pieces {
            let mark = if piece.base { "" } else { " *" };
            let heading = format!("[{}, {}]{mark}, degree {}", piece.from, piece.to, piece.degree);
            writeln!(f, "\n{HEADING}{heading}{HEADING:#}")?;
            writeln!(f, "{}", piece.table().trim_fmt())?;
        }
        Ok(())
    }
}

impl Piece {
    fn table(&self) -> Table {
        controls("m", &self.weights, &self.points, ToString::to_string)
    }
}

/// One row a control point: its weight and its coordinates, exact and approximately.
fn controls(name: &str, weights: &[Exact], points: &[Vec<Exact>], exact: fn(&Exact) -> String) -> Table {
    let notation = Notation::in_force();
    let mut table = plain([name, "weight", "≈", "point", "≈"]);
    for (m, (weight, point)) in weights.iter().zip(points).enumerate() {
        let decimals: Vec<_> = point.iter().map(|Exact(c)| notation.approximation(c)).collect();
        table.add_row([
            m.to_string(),
            exact(weight),
            notation.approximation(&weight.0),
            tuple(&point.iter().map(exact).collect::<Vec<_>>()),
            tuple(&decimals),
        ]);
    }
    right_aligned(&mut table, 0);
    table
}

/// The fraction, or only that there is one.
fn short(number: &Exact) -> String {
    Some(number.to_string()).filter(|text| text.len() <= LENGTH_LIMIT).unwrap_or_else(|| "…".to_owned())
}

fn list(items: &[impl ToString]) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

impl Joined {
    /// What a reader has to know of any form of the result.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if !self.jumps.is_empty() {
            let (count, jumps) = (self.curves.len(), list(&self.jumps));
            notes.push(format!(
                "the curve jumps at {jumps}: {count} NURBS curves, one for each connected run"
            ));
        }
        let [from, to] = &self.base;
        let ends = |run: &Run| run.knots.first().cloned().zip(run.knots.last().cloned());
        if self.curves.iter().filter_map(ends).any(|(first, last)| first.0 < from.0 || last.0 > to.0) {
            notes.push(format!(
                "outside of [{from}, {to}] the basis functions add up to less than 1; --from {from} --to {to} leaves that out"
            ));
        }
        notes
    }
}

impl fmt::Display for Joined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(source) = &self.source {
            return f.write_str(source);
        }
        writeln!(f, "{}, {}", self.on, self.weights)?;
        let (count, are) = match self.curves.len() {
            1 => ("1 NURBS curve".to_owned(), "It is"),
            more => (format!("{more} NURBS curves"), "Together they are"),
        };
        let equal = if self.standard_form {
            "the same points in another parameter y"
        } else {
            "equal to the curve for every x"
        };
        writeln!(f, "{count}. {are} {equal} (checked exactly).")?;
        if self.curves.iter().any(Run::is_long) {
            writeln!(f, "Note: … is a long fraction; --format json has them.")?;
        }
        self.notes().iter().try_for_each(|note| writeln!(f, "Note: {note}."))?;
        self.warnings.iter().try_for_each(|warning| writeln!(f, "Warning: {warning}."))?;
        self.curves.iter().try_for_each(|run| run.fmt(f))
    }
}

impl Run {
    /// Is there a fraction that is too long for people?
    fn is_long(&self) -> bool {
        let mut numbers = self.weights.iter().chain(self.points.iter().flatten());
        numbers.any(|number| number.to_string().len() > LENGTH_LIMIT)
    }
}

impl fmt::Display for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stops: Vec<_> = self.knots.chunk_by(|a, b| a == b).collect();
        let [first, .., last] = &stops[..] else { return Ok(()) };
        let heading = format!("[{}, {}], degree {}", first[0], last[0], self.degree);
        writeln!(f, "\n{HEADING}{heading}{HEADING:#}")?;
        let knots: Vec<_> = stops.iter().map(|stop| format!("{} ({}×)", stop[0], stop.len())).collect();
        writeln!(f, "Knots {}", list(&knots))?;
        writeln!(f, "{}", controls("i", &self.weights, &self.points, short).trim_fmt())?;
        let Some(changes) = &self.parameter else { return Ok(()) };
        writeln!(f, "The parameter y on [a, b]: (x − a)/(b − x) = λ (y − a)/(b − y)")?;
        writeln!(f, "{}", parameters(changes).trim_fmt())
    }
}

fn parameters(changes: &[Change]) -> Table {
    let notation = Notation::in_force();
    let mut table = plain(["[a, b]", "λ", "≈", "weight at b", "difference from 1"]);
    for Change { from, to, ratio, weight } in changes {
        let difference = &weight.0 - integer(1);
        table.add_row([
            format!("[{from}, {to}]"),
            short(ratio),
            notation.approximation(&ratio.0),
            short(weight),
            notation.approximation(&difference),
        ]);
    }
    table
}
