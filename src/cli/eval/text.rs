//! What `eval` prints for people.

use std::fmt;

use comfy_table::Table;

use super::super::exact::Exact;
use super::super::notation::Notation;
use super::super::on_knots::tuple;
use super::super::table::{HEADING, plain, right_aligned};
use super::{Evaluation, Level, OneSide};

impl fmt::Display for Evaluation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}, {}", self.head.on, self.head.weights)?;
        writeln!(f, "x = {}, {}", self.at.x, self.limit())?;
        if let Some(note) = self.note() {
            writeln!(f, "Note: {note}")?;
        }
        heading(f, "Values")?;
        writeln!(f, "{}", self.table(&self.at.values, "G_i(x)").trim_fmt())?;
        for (order, values) in (1..).zip(&self.at.derivatives) {
            heading(f, &format!("Derivative {order}"))?;
            writeln!(f, "{}", self.table(values, &derivative("G_i", order)).trim_fmt())?;
        }
        let Some(curve) = &self.at.curve else { return Ok(()) };
        heading(f, "Curve")?;
        writeln!(f, "{}", self.curve_table(curve).trim_fmt())?;
        heading(f, "De Boor's points d_i^r")?;
        match &self.de_boor {
            Some(levels) => writeln!(f, "{}", triangle(levels).trim_fmt()),
            None => writeln!(f, "None: the algorithm needs an x in [t_k, t_(n+1)] (T4.1)."),
        }
    }
}

impl Evaluation {
    /// What the numbers are; at t_m the values are the limits from the left (D3.3).
    fn limit(&self) -> &'static str {
        let at_last = self.head.on.knots.last().is_some_and(|last| last.0 == self.at.x.0);
        match self.at.side {
            OneSide::Left => "limits from the left",
            OneSide::Right if at_last => "values (limits from the left)",
            OneSide::Right => "values (limits from the right)",
        }
    }

    /// What is special about x.
    fn note(&self) -> Option<String> {
        let (first, last) = (self.head.on.knots.first()?, self.head.on.knots.last()?);
        let x = &self.at.x.0;
        if *x < first.0 || *x > last.0 {
            Some(format!("x lies outside of [t_0, t_m] = [{first}, {last}], where every function is 0."))
        } else if *x == first.0 && matches!(self.at.side, OneSide::Left) {
            Some(format!("x is t_0 = {first}, and left of it every function is 0."))
        } else if *x == last.0 {
            Some(format!("x is t_m = {last}, where all limits are taken from the left (D3.3)."))
        } else {
            None
        }
    }

    /// One row a function: i, the support, the exact value and an approximation.
    fn table(&self, values: &[Exact], heading: &str) -> Table {
        let mut table = plain(["i", "support", heading, "≈"]);
        for (i, value) in (self.head.index.unwrap_or(0)..).zip(values) {
            let support =
                format!("[{}, {}]", self.head.on.knots[i], self.head.on.knots[i + self.head.on.degree + 1]);
            table.add_row([
                i.to_string(),
                support,
                value.to_string(),
                Notation::in_force().approximation(&value.0),
            ]);
        }
        right_aligned(&mut table, 0);
        table
    }

    /// One row for the point, one for each derivative.
    fn curve_table(&self, curve: &[Exact]) -> Table {
        let mut table = plain(["", "exact", "≈"]);
        for (order, coordinates) in
            std::iter::once(curve).chain(self.at.curve_derivatives.iter().map(Vec::as_slice)).enumerate()
        {
            let name = if order == 0 { "G(x)".to_owned() } else { derivative("G", order) };
            let decimals: Vec<_> =
                coordinates.iter().map(|c| Notation::in_force().approximation(&c.0)).collect();
            table.add_row([name, tuple(coordinates), tuple(&decimals)]);
        }
        table
    }
}

fn heading(f: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
    writeln!(f, "\n{HEADING}{text}{HEADING:#}")
}

fn derivative(function: &str, order: usize) -> String {
    match order {
        1..=3 => format!("{function}{}(x)", "′".repeat(order)),
        _ => format!("{function}^({order})(x)"),
    }
}

/// De Boor's triangle: one row for each i, one column for each level r.
fn triangle(levels: &[Level]) -> Table {
    let names = levels.iter().map(|level| format!("r = {}", level.level));
    let mut table = plain(std::iter::once("i".to_owned()).chain(names));
    let first = levels.first().map_or(0, |level| level.first);
    let count = levels.first().map_or(0, |level| level.points.len());
    for i in first..first + count {
        let points = levels.iter().map_while(|level| level.points.get(i.checked_sub(level.first)?));
        table.add_row(std::iter::once(i.to_string()).chain(points.map(|at| tuple(at))));
    }
    right_aligned(&mut table, 0);
    table
}
