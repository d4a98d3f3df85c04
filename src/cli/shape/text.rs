//! What `shape` prints for people.

use std::fmt;

use super::super::exact::Exact;
use super::super::table::{HEADING, plain};
use super::coordinates::{CoordinateRecord, CurveShapes};
use super::{FunctionRecord, Shapes, Step, Turn};

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
        turns(f, &self.extrema, &self.jumps)?;
        let mut slopes = plain(["knot", "slope from the left", "from the right"]);
        for slope in &self.slopes {
            let side = |side: &Option<Exact>| side.as_ref().map_or("–".to_owned(), ToString::to_string);
            slopes.add_row([slope.at.to_string(), side(&slope.left), side(&slope.right)]);
        }
        writeln!(f, "{}", slopes.trim_fmt())
    }
}

impl fmt::Display for CurveShapes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on)?;
        for CoordinateRecord { coordinate, weights, local_maxima, local_minima, extrema, jumps } in
            &self.curves
        {
            writeln!(f, "\n{HEADING}Coordinate {coordinate} of the curve, {weights}{HEADING:#}")?;
            let noun = |count, one, more| if count == 1 { one } else { more };
            let (maxima, minima) =
                (noun(*local_maxima, "maximum", "maxima"), noun(*local_minima, "minimum", "minima"));
            writeln!(f, "{local_maxima} local {maxima}, {local_minima} local {minima}")?;
            turns(f, extrema, jumps)?;
        }
        Ok(())
    }
}

/// A table of extrema, and a line for each jump.
fn turns(f: &mut fmt::Formatter<'_>, turns: &[Turn], jumps: &[Step]) -> fmt::Result {
    let mut extrema = plain(["", "x", "≈", "value ≈", "at"]);
    for turn in turns {
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
    if !turns.is_empty() {
        writeln!(f, "{}", extrema.trim_fmt())?;
    }
    for jump in jumps {
        writeln!(f, "Jump at {} from {} to {}", jump.at, jump.left, jump.right)?;
    }
    Ok(())
}
