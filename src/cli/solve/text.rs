//! What `solve` prints for people.

use std::fmt;

use super::super::on_knots::tuple;
use super::super::table::{HEADING, plain};
use super::{OfValue, SolutionRecord, Solved};

impl fmt::Display for Solved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on.on)?;
        let function = format!("{}·c(x)", tuple(&self.normal));
        for of_value in &self.curves {
            let OfValue { weights, value, solutions } = of_value;
            let on = format!("x in [{}, {}]", self.on.from, self.on.to);
            writeln!(f, "\n{HEADING}{function} = {value}, {weights}, {on}{HEADING:#}")?;
            if solutions.is_empty() {
                writeln!(f, "No solution.")?;
                continue;
            }
            let mut table = plain(["x", "≈", "", "sign before, after", "point ≈"]);
            for solution in solutions {
                table.add_row(solution.row());
            }
            writeln!(f, "{}", table.trim_fmt())?;
        }
        Ok(())
    }
}

impl SolutionRecord {
    fn row(&self) -> [String; 5] {
        let sign = |sign: Option<i8>| match sign {
            Some(-1) => "−",
            Some(0) => "0",
            Some(_) => "+",
            None => "end",
        };
        let how = match (self.kind, self.place.until.is_some()) {
            ("passed", _) => "jumps past it",
            ("limit_from_left", _) => "limit from the left",
            (_, true) => "throughout",
            _ if self.before.is_some() && self.before == self.after => "touches it",
            _ => "",
        };
        let point = self.point.as_ref().map(|point| point.iter().map(|c| &c.decimal.0).collect::<Vec<_>>());
        [
            self.place.exactly(),
            self.place.nearly().to_owned(),
            how.to_owned(),
            format!("{}, {}", sign(self.before), sign(self.after)),
            point.map(|point| tuple(&point)).unwrap_or_default(),
        ]
    }
}
