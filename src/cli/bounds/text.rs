//! What `bounds` prints for people.

use std::fmt;

use super::super::on_knots::tuple;
use super::super::table::{HEADING, plain};
use super::{BoundRecord, Bounds, OfFunction};

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on.on)?;
        for of_weights in self.curves.chunk_by(|a, b| a.weights == b.weights) {
            let on = format!("x in [{}, {}]", self.on.from, self.on.to);
            writeln!(f, "\n{HEADING}{}, {on}{HEADING:#}", of_weights[0].weights)?;
            let mut table = plain(["function", "", "value", "≈", "at x", "≈", ""]);
            for OfFunction { normal, lowest, highest, .. } in of_weights {
                for (name, bound) in [("lowest", lowest), ("highest", highest)] {
                    let function =
                        if name == "lowest" { format!("{}·c", tuple(normal)) } else { String::new() };
                    for row in bound.rows(function, name) {
                        table.add_row(row);
                    }
                }
            }
            writeln!(f, "{}", table.trim_fmt())?;
        }
        Ok(())
    }
}

impl BoundRecord {
    /// A row for each place, the value in the first one.
    fn rows(&self, function: String, name: &str) -> Vec<[String; 7]> {
        let mut head = vec![function, name.to_owned(), self.value.fraction(), self.value.decimal.0.clone()];
        let row = |place: &super::BoundPlace| {
            let mut row = std::mem::replace(&mut head, vec![String::new(); 4]).into_iter();
            let mut next = || row.next().unwrap_or_default();
            let taken = if place.taken { "" } else { "limit from the left, not taken" };
            [
                next(),
                next(),
                next(),
                next(),
                place.place.exactly(),
                place.place.nearly().to_owned(),
                taken.to_owned(),
            ]
        };
        self.places.iter().map(row).collect()
    }
}
