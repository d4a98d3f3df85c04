//! What `interpolate` prints for people.

use std::fmt;

use super::super::notation::Notation;
use super::super::on_knots::tuple;
use super::super::table::{HEADING, plain, right_aligned};
use super::Interpolation;

impl fmt::Display for Interpolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}, {}", self.on, self.weights)?;
        writeln!(f, "Places {}", tuple(&self.at))?;
        let functions = self.matrix.first().map_or(0, Vec::len);
        writeln!(f, "\n{HEADING}The functions at the places{HEADING:#}")?;
        let names = (0..functions).map(|i| format!("G_{i}"));
        let mut table = plain(std::iter::once("x".to_owned()).chain(names));
        for (x, row) in self.at.iter().zip(&self.matrix) {
            table.add_row(std::iter::once(x).chain(row));
        }
        writeln!(f, "{}", table.trim_fmt())?;
        write!(f, "Rank {} of {functions}", self.rank)?;
        if let Some(determinant) = &self.determinant {
            write!(
                f,
                "; determinant {determinant} ≈ {}",
                Notation::in_force().approximation(&determinant.0)
            )?;
        }
        writeln!(f)?;
        let condition = match self.misplaced.as_slice() {
            [] => "holds: G_i is not 0 at place i, for every i".to_owned(),
            list => {
                let names: Vec<_> = list.iter().map(|i| format!("G_{i}")).collect();
                format!("fails: 0 at the place of its own number is {}", names.join(", "))
            }
        };
        writeln!(f, "The condition of Schoenberg and Whitney {condition}.")?;
        if let Some(relation) = &self.relation {
            writeln!(f, "A curve that is 0 at every place: control points {}.", tuple(relation))?;
        }
        if let Some(reason) = &self.reason {
            writeln!(f, "\nThere is not exactly one curve through the points: {reason}.")?;
        }
        let Some(points) = &self.points else { return Ok(()) };
        writeln!(f, "\n{HEADING}The control points of the curve{HEADING:#}")?;
        let notation = Notation::in_force();
        let mut table = plain(["i", "d_i", "≈"]);
        for (i, point) in points.iter().enumerate() {
            let decimals: Vec<_> = point.iter().map(|c| notation.approximation(&c.0)).collect();
            table.add_row([i.to_string(), tuple(point), tuple(&decimals)]);
        }
        right_aligned(&mut table, 0);
        writeln!(f, "{}", table.trim_fmt())
    }
}
