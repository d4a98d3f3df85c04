//! What `joins` prints for people.

use std::fmt;

use num_rational::BigRational;
use num_traits::One;

use super::super::notation::Decimal;
use super::super::table::{HEADING, plain, right_aligned};
use super::{AllJoins, BranchRecord, JoinRecord, Joins};

impl fmt::Display for Joins {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.on)?;
        if self.joins.is_empty() {
            return writeln!(f, "There is no knot inside the interval, and the curve is not closed.");
        }
        for joins in self.joins.chunk_by(JoinRecord::on_one_curve) {
            writeln!(f, "\n{HEADING}{}{HEADING:#}", joins[0].weights)?;
            let summary = Summary::of(joins);
            write!(f, "{summary}")?;
            if let Some((join, Decimal(angle))) = summary.sharpest {
                write!(f, "; the tangent turns by up to {angle}°, at {}", join.place())?;
            }
            if let Some((join, Decimal(ratio))) = summary.fastest {
                write!(f, "; the speed changes most at {}, by the factor {ratio}", join.place())?;
            }
            writeln!(f)?;
            let head =
                ["knot", "", "turn, degrees", "speed, after : before", "curvature before", "after", "jump"];
            let mut table = plain(head);
            for join in joins {
                table.add_row(join.row());
            }
            (2..head.len()).for_each(|column| right_aligned(&mut table, column));
            writeln!(f, "{}", table.trim_fmt())?;
            for join in joins.iter().filter(|join| !join.undefined.is_empty()) {
                writeln!(f, "At {}: {}.", join.place(), join.undefined.join("; "))?;
            }
        }
        Ok(())
    }
}

/// A row for each curve.
impl fmt::Display for AllJoins {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.joins.is_empty() {
            return writeln!(f, "The paper shows no curve with a knot inside its interval.");
        }
        let curves: Vec<_> = self.joins.chunk_by(JoinRecord::on_one_curve).collect();
        let noun = if curves.len() == 1 { "curve" } else { "curves" };
        writeln!(f, "{} {noun}: {}", curves.len(), Summary::of(&self.joins))?;
        let smooth = Summary::of(self.joins.iter().filter(|join| join.is_smooth_classically()));
        write!(f, "Where the classical curve is smooth: {smooth}")?;
        let at = |join: &JoinRecord| {
            let of = join.instance.as_ref().map(|of| format!("{}, degree {}, ", of.instance, of.degree));
            format!("{}{}, at {}", of.unwrap_or_default(), join.weights, join.place())
        };
        if let Some((join, Decimal(angle))) = smooth.sharpest {
            write!(f, "; the tangent turns by up to {angle}° ({})", at(join))?;
        }
        if let Some((join, Decimal(ratio))) = smooth.fastest {
            write!(f, "; the speed changes most by the factor {ratio} ({})", at(join))?;
        }
        let mut table = plain(["", "k", "", "joins", "G¹", "G²", "turn, degrees", "at", "speed", "at"]);
        for joins in curves {
            let Some(of) = &joins[0].instance else { continue };
            let Summary { joins: count, g1, g2, sharpest, fastest } = Summary::of(joins);
            let [sharpest, fastest] = [sharpest, fastest].map(|most| match most {
                Some((join, Decimal(value))) => [value.clone(), join.place()],
                None => Default::default(),
            });
            let counts = [count, g1, g2].map(|count| count.to_string());
            let head = [of.instance.clone(), of.degree.to_string(), joins[0].weights.to_string()];
            table.add_row(head.into_iter().chain(counts).chain(sharpest).chain(fastest));
        }
        (3..7).chain([8]).for_each(|column| right_aligned(&mut table, column));
        writeln!(f, "\n\n{}", table.trim_fmt())
    }
}

/// What several joins have in common.
#[derive(Clone, Copy)]
struct Summary<'a> {
    joins: usize,
    g1: usize,
    g2: usize,
    /// The first one with the largest angle, if that is not 0.
    sharpest: Option<(&'a JoinRecord, &'a Decimal)>,
    /// The first one where the ratio of speeds is farthest from 1, if it is not that.
    fastest: Option<(&'a JoinRecord, &'a Decimal)>,
}

impl<'a> Summary<'a> {
    fn of(joins: impl IntoIterator<Item = &'a JoinRecord>) -> Self {
        let joins: Vec<_> = joins.into_iter().collect();
        let number = |has: fn(&JoinRecord) -> Option<bool>| {
            joins.iter().filter(|join| has(join) == Some(true)).count()
        };
        // Of equals `max_by` takes the last: the list is gone through from its end.
        let angles = joins.iter().rev().filter_map(|join| Some((*join, join.angle.as_ref()?)));
        let ratios =
            joins.iter().rev().filter_map(|join| Some((*join, &join.speed_ratio_squared.as_ref()?.0)));
        let change = |ratio: &BigRational| ratio.clone().max(ratio.recip());
        let sharpest = angles.filter(|(_, angle)| !angle.is_zero()).max_by(|(_, a), (_, b)| a.compare(b));
        let fastest =
            ratios.filter(|(_, ratio)| !ratio.is_one()).max_by(|(_, a), (_, b)| change(a).cmp(&change(b)));
        Self {
            joins: joins.len(),
            g1: number(|join| join.g1),
            g2: number(|join| join.g2),
            sharpest: sharpest.and_then(|(join, _)| Some((join, join.angle_degrees.as_ref()?))),
            fastest: fastest.and_then(|(join, _)| Some((join, join.speed_ratio.as_ref()?))),
        }
    }
}

/// How many there are, and how many of them are smooth.
impl fmt::Display for Summary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let noun = if self.joins == 1 { "join" } else { "joins" };
        write!(f, "{} {noun}, {} G¹, {} G²", self.joins, self.g1, self.g2)
    }
}

impl JoinRecord {
    /// Are two records of one curve?
    fn on_one_curve(&self, other: &Self) -> bool {
        self.instance == other.instance && self.weights == other.weights
    }

    /// Has the classical curve a continuous derivative here that is not 0, as far as the knot and the speeds show?
    fn is_smooth_classically(&self) -> bool {
        let simple = self.instance.as_ref().is_some_and(|of| self.multiplicity < of.degree);
        simple && !self.closing && self.speed_ratio.is_some()
    }

    fn place(&self) -> String {
        if self.closing { format!("{}, the end", self.knot) } else { self.knot.to_string() }
    }

    fn row(&self) -> [String; 7] {
        let level = match (self.g0, self.g1, self.g2) {
            (false, ..) => "jump",
            (_, None, _) => "G⁰, G¹ ?",
            (_, Some(false), _) => "G⁰",
            (.., None) => "G¹, G² ?",
            (.., Some(false)) => "G¹",
            (.., Some(true)) => "G²",
        };
        let shown =
            |number: &Option<Decimal>| number.as_ref().map_or("–".to_owned(), |Decimal(text)| text.clone());
        let curvature = |branch: &BranchRecord| match (&branch.order, &branch.curvature) {
            (Some(_), None) => "∞".to_owned(),
            (_, curvature) => shown(curvature),
        };
        let [angle, speed, jump] = [&self.angle_degrees, &self.speed_ratio, &self.curvature_jump].map(shown);
        let [before, after] = [&self.before, &self.after].map(curvature);
        [self.place(), level.to_owned(), angle, speed, before, after, jump]
    }
}
