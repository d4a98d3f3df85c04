//! The drawing of what depends on what.

use std::collections::BTreeMap;

use plotters::style::text_anchor::HPos;
use plotters::style::{BLACK, RGBColor};

use super::Report;
use super::dependence::State;
use super::figures::PictureError;
use super::figures::canvas::{
    Canvas, Cell, Dash, Drawn, Frame, GREEN, GREY, LARGE, Panel, Pen, SMALL, VERMILION,
};
use super::record::Record;

/// In pixels: the sheet, and the box of a claim with what is between two of them.
const WIDTH: u32 = 800;
const BOX: (f64, f64) = (158.0, 36.0);
const GAP: f64 = 12.0;
const TITLE: u32 = 64;
const NOTES: u32 = 28;

/// A claim in the drawing.
struct Node<'a> {
    record: &'a Record,
    /// How many steps it is from a premise that rests on nothing here.
    column: usize,
    /// The height of the middle of its box.
    y: f64,
}

/// What rests on what, as SVG, from the data of the report.
///
/// # Errors
/// [`PictureError`], a bug of this program.
pub fn dependence_picture(report: &Report<'_>) -> Result<String, PictureError> {
    let uses: Vec<(&str, &str, State)> = report
        .dependence
        .uses
        .iter()
        .map(|one| (one.claim.as_str(), one.rests_on.as_str(), one.state))
        .collect();
    let (nodes, height) = placed(report, &uses);
    let columns = nodes.values().map(|node| node.column + 1).max().unwrap_or(1);
    let title = "What rests on what that fails as printed";
    let bottom = TITLE + rounded(height);
    Canvas::svg(title, (WIDTH, bottom + NOTES), |canvas| {
        canvas.text(title, (14, 22), LARGE, HPos::Left, BLACK)?;
        let note = "An arrow leads from a premise to what is derived from it. Green: true as printed. Grey: true once amended. Red: the idea fails.";
        canvas.text(note, (14, 43), SMALL, HPos::Left, GREY)?;
        canvas.text("A dashed red arrow: nothing survives.", (14, bottom + 14), SMALL, HPos::Left, GREY)?;
        let frame = Frame { x: (0.0, f64::from(WIDTH)), y: (height, 0.0) };
        let panel = canvas.panel(Cell { left: 0, top: TITLE, right: WIDTH, bottom }, frame);
        let across = |node: &Node<'_>| place(node.column, columns);
        for (claim, premise, state) in &uses {
            if let (Some(from), Some(to)) = (nodes.get(premise), nodes.get(claim)) {
                arrow(
                    &panel,
                    (across(from) + BOX.0 / 2.0, from.y),
                    (across(to) - BOX.0 / 2.0, to.y),
                    *state,
                )?;
            }
        }
        nodes.values().try_for_each(|node| claim(canvas, &panel, node, (across(node), node.y)))
    })
}

/// The middle of a column.
fn place(column: usize, columns: usize) -> f64 {
    let number = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    let share = f64::from(WIDTH) / number(columns);
    share * (number(column) + 0.5)
}

fn rounded(x: f64) -> u32 {
    (0..u32::MAX).find(|pixels| f64::from(*pixels) >= x).unwrap_or_default()
}

/// All claims of the uses with their places, and the height that they take. Claims that are joined, by whatever way, stand in
/// a band of their own, so that no arrow passes through the box of another.
fn placed<'a>(report: &'a Report<'_>, uses: &[(&str, &str, State)]) -> (BTreeMap<&'a str, Node<'a>>, f64) {
    let named = |id: &str| uses.iter().any(|(claim, premise, _)| *claim == id || *premise == id);
    let records: Vec<&Record> = report.claims.iter().filter(|record| named(&record.id)).collect();
    let mut nodes = BTreeMap::new();
    let mut top = GAP;
    let mut left: Vec<&Record> = records.clone();
    while let Some(first) = left.first() {
        // The band of the first: all that it is joined with.
        let mut band = vec![first.id.as_str()];
        loop {
            let joined: Vec<&str> = records
                .iter()
                .map(|record| record.id.as_str())
                .filter(|id| {
                    !band.contains(id)
                        && uses.iter().any(|(claim, premise, _)| {
                            (claim == id && band.contains(premise)) || (premise == id && band.contains(claim))
                        })
                })
                .collect();
            if joined.is_empty() {
                break;
            }
            band.extend(joined);
        }
        let (here, rest): (Vec<_>, Vec<_>) =
            left.into_iter().partition(|record| band.contains(&record.id.as_str()));
        let mut columns: BTreeMap<usize, Vec<&Record>> = BTreeMap::new();
        for record in here {
            columns.entry(depth(&record.id, uses)).or_default().push(record);
        }
        let count = |list: &Vec<&Record>| f64::from(u32::try_from(list.len()).unwrap_or(u32::MAX));
        let most = columns.values().map(count).fold(1.0, f64::max);
        for (column, records) in columns {
            let mut y = top + (most - count(&records)) * (BOX.1 + GAP) / 2.0 + BOX.1 / 2.0;
            for record in records {
                nodes.insert(record.id.as_str(), Node { record, column, y });
                y += BOX.1 + GAP;
            }
        }
        top += most * (BOX.1 + GAP) + GAP;
        left = rest;
    }
    (nodes, top)
}

/// The longest way from a premise; the uses have no circle, which a test of theirs says.
fn depth(id: &str, uses: &[(&str, &str, State)]) -> usize {
    uses.iter()
        .filter(|(claim, ..)| *claim == id)
        .map(|(_, premise, _)| depth(premise, uses) + 1)
        .max()
        .unwrap_or(0)
}

fn arrow(panel: &Panel<'_>, from: (f64, f64), to: (f64, f64), state: State) -> Drawn {
    let pen = match state {
        State::Broken => Pen::thick(VERMILION, Dash::Long),
        State::Intact | State::Survives => Pen::thin(GREY, Dash::Solid),
    };
    panel.line(&[from, to], pen)?;
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    let length = across.hypot(down).max(1.0);
    let (along, aside) = ((across / length, down / length), (-down / length, across / length));
    let back = |side: f64| (to.0 - 8.0 * along.0 + side * aside.0, to.1 - 8.0 * along.1 + side * aside.1);
    panel.area(&[to, back(3.0), back(-3.0)], pen.colour)
}

/// The box of a claim, with its verdict.
fn claim(canvas: &Canvas<'_>, panel: &Panel<'_>, node: &Node<'_>, (x, y): (f64, f64)) -> Drawn {
    let colour: RGBColor = match (node.record.as_printed.finding.is_proved(), node.record.is_serious()) {
        (true, _) => GREEN,
        (false, true) => VERMILION,
        (false, false) => GREY,
    };
    let (half_width, half_height) = (BOX.0 / 2.0, BOX.1 / 2.0);
    let (left, right, above, below) = (x - half_width, x + half_width, y - half_height, y + half_height);
    panel.line(
        &[(left, above), (right, above), (right, below), (left, below), (left, above)],
        Pen::thick(colour, Dash::Solid),
    )?;
    let middle = rounded(x);
    let line = |text: &str, at: f64, colour| {
        canvas.text(text, (middle, TITLE + rounded(at)), SMALL, HPos::Center, colour)
    };
    line(&node.record.id, y - 8.0, BLACK)?;
    let words = match node.record.as_printed.finding.is_proved() {
        true => node.record.as_printed.finding.status.clone(),
        false => node.record.words(),
    };
    line(&words, y + 8.0, GREY)
}
