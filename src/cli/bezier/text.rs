//! What `bezier` prints for people.

use std::fmt;

use comfy_table::Table;

use super::super::exact::Exact;
use super::super::notation::Notation;
use super::super::on_knots::tuple;
use super::super::table::{HEADING, plain, right_aligned};
use super::{Conversion, Piece};

impl fmt::Display for Conversion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}, {}", self.on, self.weights)?;
        let (count, are) = match self.pieces.len() {
            1 => ("1 rational Bézier curve".to_owned(), "It is"),
            more => (format!("{more} rational Bézier curves"), "Each is"),
        };
        let positive = if self.weights.family().is_some() { " with positive weights" } else { "" };
        writeln!(
            f,
            "{count} of least degree{positive}. {are} equal to the curve for every x of its span (checked exactly)."
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
    /// One row a control point: its weight and its coordinates, exact and approximately.
    fn table(&self) -> Table {
        let notation = Notation::in_force();
        let mut table = plain(["m", "weight", "≈", "point", "≈"]);
        for (m, (weight, point)) in self.weights.iter().zip(&self.points).enumerate() {
            let decimals: Vec<_> = point.iter().map(|Exact(c)| notation.approximation(c)).collect();
            table.add_row([
                m.to_string(),
                weight.to_string(),
                notation.approximation(&weight.0),
                tuple(point),
                tuple(&decimals),
            ]);
        }
        right_aligned(&mut table, 0);
        table
    }
}
