//! What `shape` prints for people.

use std::fmt;

use super::super::exact::Exact;
use super::super::table::{HEADING, plain};
use super::{FunctionRecord, Shapes};

impl fmt::Display for Shapes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on)?;
        self.functions.iter().try_for_each(|function| function.fmt(f))
    }
}

impl fmt::Display for FunctionRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = &self.support;
        writeln!(f, "\n{HEADING}G_{}, {}, on [{from}, {to}]{HEADING:#}", self.index, self.weights)?;
        let weak = match self.weak {
            Some(true) => "the supremum is attained at exactly one point",
            Some(false) => "the supremum is not attained at exactly one point",
            None => "whether the supremum is attained at exactly one point is undecided",
        };
        let maxima = if self.local_maxima == 1 { "maximum" } else { "maxima" };
        writeln!(f, "{} local {maxima}; {weak}", self.local_maxima)?;
        let mut extrema = plain(["", "x", "≈", "value ≈", "at"]);
        for turn in &self.extrema {
            let [lo, hi] = &turn.interval;
            let at = match (turn.plateau, turn.at_knot) {
                (true, _) => "plateau",
                (false, true) => "knot",
                (false, false) => "",
            };
            let place = if lo == hi { lo.to_string() } else { format!("[{lo}, {hi}]") };
            // A plateau is no single number.
            let near = if turn.plateau { "" } else { &turn.x.0 };
            extrema.add_row([turn.kind, &place, near, &turn.height.0, at]);
        }
        if !self.extrema.is_empty() {
            writeln!(f, "{}", extrema.trim_fmt())?;
        }
        for jump in &self.jumps {
            writeln!(f, "Jump at {} from {} to {}", jump.at, jump.left, jump.right)?;
        }
        let mut slopes = plain(["knot", "slope from the left", "from the right"]);
        for slope in &self.slopes {
            let side = |side: &Option<Exact>| side.as_ref().map_or("–".to_owned(), ToString::to_string);
            slopes.add_row([slope.at.to_string(), side(&slope.left), side(&slope.right)]);
        }
        writeln!(f, "{}", slopes.trim_fmt())
    }
}
