//! Where a label may stand: beside what it names, and on no line, dot or other text.

use super::metrics::{Ink, ink};
use super::pen::{Dot, Pen, SMALL};

use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};

/// A point of the sheet, in pixels.
pub(super) type Spot = (f64, f64);

/// A rectangle of the sheet, in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Area {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Area {
    fn around((x, y): Spot, (half_width, half_height): (f64, f64)) -> Self {
        Self { left: x - half_width, top: y - half_height, right: x + half_width, bottom: y + half_height }
    }

    fn grown(self, by: f64) -> Self {
        Self { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    fn meets(self, other: Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn within(self, other: Self) -> bool {
        other.left <= self.left
            && self.right <= other.right
            && other.top <= self.top
            && self.bottom <= other.bottom
    }

    /// Is a point of the segment inside? (Liang and Barsky: the part of it between two lines, and between two others.)
    fn struck(self, (from, to): (Spot, Spot)) -> bool {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for (at, step, low, high) in
            [(from.0, to.0 - from.0, self.left, self.right), (from.1, to.1 - from.1, self.top, self.bottom)]
        {
            if step == 0.0 {
                if at < low || high < at {
                    return false;
                }
                continue;
            }
            let (one, two) = ((low - at) / step, (high - at) / step);
            first = first.max(one.min(two));
            last = last.min(one.max(two));
        }
        first <= last
    }

    /// How far a point is from it.
    fn from(self, (x, y): Spot) -> f64 {
        self.to_box((x, y), (x, y))
    }

    /// How far the rectangle between two points is from it: nothing in there is nearer.
    fn to_box(self, one: Spot, two: Spot) -> f64 {
        let off = |a: f64, b: f64, low: f64, high: f64| (low - a.max(b)).max(a.min(b) - high).max(0.0);
        off(one.0, two.0, self.left, self.right).hypot(off(one.1, two.1, self.top, self.bottom))
    }
}

/// The area that a text takes which is anchored at a point.
pub(super) fn area(text: &str, size: u32, (h, v): (HPos, VPos), (x, y): Spot) -> Area {
    let Ink { width, above, below } = ink(text, size);
    let left = match h {
        HPos::Left => x,
        HPos::Center => x - width / 2.0,
        HPos::Right => x - width,
    };
    let line = y + base_line(v, size);
    Area { left, top: line - above, right: left + width, bottom: line + below }
}

/// How far below its anchor the base line of a text is: as the library that draws writes it into the SVG.
fn base_line(v: VPos, size: u32) -> f64 {
    // Half the height of an x, which is 0.55 em.
    const HALF_X: f64 = 0.27;
    f64::from(size)
        * match v {
            VPos::Top => 0.76,
            VPos::Center => HALF_X,
            VPos::Bottom => -HALF_X,
        }
}

/// All that is on the sheet, for labels to stay away from.
#[derive(Debug, Default)]
pub(super) struct Scene {
    strokes: Vec<(Pen, Vec<Spot>)>,
    dots: Vec<Area>,
    texts: Vec<Area>,
}

/// What a label names.
#[derive(Debug, Clone)]
pub(super) enum Named {
    /// A point. The label is best in this direction from it.
    Point(Spot, (f64, f64)),
    /// A line, drawn by this pen; best near its highest points.
    Line(Vec<Spot>, Pen),
}

/// A text that is to stand beside what it names.
#[derive(Debug, Clone)]
pub(super) struct Label {
    pub(super) text: String,
    pub(super) colour: RGBColor,
    pub(super) named: Named,
}

/// Free pixels around a label.
const AIR: f64 = 2.5;
/// How far from a point or a line a label may be, in pixels.
const REACH: [f64; 8] = [4.0, 6.0, 9.0, 13.0, 18.0, 24.0, 32.0, 42.0];
/// Directions from above, clockwise, in sixteenths of a turn: sines and cosines.
const TURN: [(f64, f64); 16] = {
    const S: f64 = 0.382_683_432_365_089_8;
    const C: f64 = 0.923_879_532_511_286_7;
    const D: f64 = std::f64::consts::FRAC_1_SQRT_2;
    [
        (0.0, -1.0),
        (S, -C),
        (D, -D),
        (C, -S),
        (1.0, 0.0),
        (C, S),
        (D, D),
        (S, C),
        (0.0, 1.0),
        (-S, C),
        (-D, D),
        (-C, S),
        (-1.0, 0.0),
        (-C, -S),
        (-D, -D),
        (-S, -C),
    ]
};

impl Scene {
    /// A line was drawn.
    pub(super) fn stroke(&mut self, pen: Pen, points: Vec<Spot>) {
        self.strokes.push((pen, points));
    }

    /// A dot was drawn.
    pub(super) fn dot(&mut self, at: Spot, dot: Dot) {
        let radius = dot.radius();
        self.dots.push(Area::around(at, (radius, radius)));
    }

    /// A text was written.
    pub(super) fn text(&mut self, area: Area) {
        self.texts.push(area);
    }

    /// The middle of the best place for a label inside of the bounds, which is taken from then on.
    pub(super) fn place(&mut self, label: &Label, bounds: Area) -> Spot {
        let Ink { width, above, below } = ink(&label.text, SMALL);
        let half = (width / 2.0, (above + below) / 2.0);
        let mut candidates = match &label.named {
            Named::Point(at, best) => {
                around(*at, half, |way| 5.0 * (1.0 - (way.0 * best.0 + way.1 * best.1)))
            }
            Named::Line(points, _) => beside(points, half),
        };
        candidates.sort_by(|one, two| one.0.total_cmp(&two.0));
        let (mut least, mut middle) = (usize::MAX, (bounds.left, bounds.top));
        for (_, next) in candidates {
            let faults = self.faults(Area::around(next, half), label, bounds, least);
            if faults < least {
                (least, middle) = (faults, next);
            }
            if least == 0 {
                break;
            }
        }
        self.texts.push(Area::around(middle, half));
        // The anchor of a text that is centred is not the middle of its ink.
        (middle.0, middle.1 + (above - below) / 2.0 - base_line(VPos::Center, SMALL))
    }

    /// What is wrong with a place: how many things are in the way, how far it is outside, and whether it names another line. As soon as
    /// that is so many, nothing more is looked for.
    fn faults(&self, area: Area, label: &Label, bounds: Area, so_many: usize) -> usize {
        let wide = area.grown(AIR);
        let dots = self.dots.iter().filter(|dot| wide.meets(**dot)).count();
        let texts = self.texts.iter().filter(|text| area.grown(2.0 * AIR).meets(**text)).count();
        let outside = usize::from(!wide.within(bounds));
        // A text on a text is the worst, then what is cut off.
        let mut faults = 10 * texts + 8 * outside + 2 * dots;
        let drawn = || self.strokes.iter().filter(|(pen, _)| !pen.is_pale());
        if faults < so_many {
            let struck = |points: &[Spot]| points.windows(2).any(|two| wide.struck((two[0], two[1])));
            faults += 3 * drawn().filter(|(_, points)| struck(points)).count();
        }
        if let Named::Line(_, own) = &label.named
            && faults < so_many
        {
            let near = |of_own: bool| {
                let strokes = drawn().filter(|(pen, _)| (pen == own) == of_own && pen.width == own.width);
                nearest(area, strokes.flat_map(|(_, points)| points.windows(2)))
            };
            faults += 4 * usize::from(near(false) < near(true) + 2.0 * AIR);
        }
        faults
    }
}

/// The distance of the nearest of some segments from an area.
fn nearest<'s>(area: Area, segments: impl Iterator<Item = &'s [Spot]>) -> f64 {
    segments.fold(f64::INFINITY, |least, two| {
        if area.to_box(two[0], two[1]) < least { least.min(gap(area, (two[0], two[1]))) } else { least }
    })
}

/// The distance of a segment from an area that it does not meet.
fn gap(area: Area, (from, to): (Spot, Spot)) -> f64 {
    if area.struck((from, to)) {
        return 0.0;
    }
    let ends = area.from(from).min(area.from(to));
    let corners =
        [(area.left, area.top), (area.right, area.top), (area.left, area.bottom), (area.right, area.bottom)];
    corners.into_iter().map(|corner| off(corner, (from, to))).fold(ends, f64::min)
}

/// The distance of a point from a segment.
fn off((x, y): Spot, ((a, b), (c, d)): (Spot, Spot)) -> f64 {
    let (across, down) = (c - a, d - b);
    let length = across.mul_add(across, down * down);
    let share =
        if length == 0.0 { 0.0 } else { (((x - a) * across + (y - b) * down) / length).clamp(0.0, 1.0) };
    (x - share.mul_add(across, a)).hypot(y - share.mul_add(down, b))
}

/// Places around a point, with their cost: the nearer the better, and what the direction adds.
fn around(at: Spot, half: (f64, f64), cost: impl Fn((f64, f64)) -> f64) -> Vec<(f64, Spot)> {
    let mut places = Vec::with_capacity(REACH.len() * TURN.len());
    for reach in REACH {
        for way in TURN {
            // The nearest point of the rectangle is so far away.
            let middle = (at.0 + way.0 * (reach + half.0), at.1 + way.1 * (reach + half.1));
            places.push((reach + cost(way), middle));
        }
    }
    places
}

/// Places along a line: at its top, or as little below as can be.
fn beside(points: &[Spot], half: (f64, f64)) -> Vec<(f64, Spot)> {
    let top = points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let at = |point: &Spot| around(*point, half, |way| (point.1 - top) + 4.0 * (1.0 + way.1));
    points.iter().flat_map(at).filter(|(cost, _)| cost.is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figures::pen::{BLUE, Dash, GREY, VERMILION};

    const BOUNDS: Area = Area { left: 0.0, top: 0.0, right: 300.0, bottom: 200.0 };

    fn label(text: &str, named: Named) -> Label {
        Label { text: text.to_owned(), colour: GREY, named }
    }

    #[test]
    fn a_segment_strikes_an_area_only_where_it_passes() {
        let area = Area { left: 10.0, top: 10.0, right: 20.0, bottom: 20.0 };
        assert!(area.struck(((0.0, 0.0), (30.0, 30.0))) && area.struck(((15.0, 0.0), (15.0, 30.0))));
        assert!(area.struck(((12.0, 12.0), (13.0, 13.0))), "inside");
        assert!(!area.struck(((0.0, 0.0), (9.0, 9.0))) && !area.struck(((0.0, 25.0), (25.0, 50.0))));
        assert!((gap(area, ((0.0, 0.0), (10.0, 0.0))) - 10.0).abs() < 1e-12);
        assert!((gap(area, ((0.0, 25.0), (30.0, 25.0))) - 5.0).abs() < 1e-12);
    }

    #[test]
    fn a_label_of_a_point_avoids_what_is_there() {
        let mut scene = Scene::default();
        let pen = Pen::thin(GREY, Dash::Solid);
        // Lines in all directions but to the lower right.
        for to in [(100.0, 0.0), (0.0, 0.0), (0.0, 100.0), (200.0, 0.0), (100.0, 200.0), (0.0, 200.0)] {
            scene.stroke(pen, vec![(100.0, 100.0), to]);
        }
        let point = || Named::Point((100.0, 100.0), (0.0, -1.0));
        let (x, y) = scene.place(&label("d₂ = d₃", point()), BOUNDS);
        assert!(x > 100.0 && y > 80.0, "({x}, {y})");
        let area = *scene.texts.last().unwrap();
        assert!(scene.strokes.iter().all(|(_, line)| !area.struck((line[0], line[1]))));
        // Another at the same point does not stand on it.
        scene.place(&label("d₀", point()), BOUNDS);
        assert!(!scene.texts[0].meets(scene.texts[1]));
    }

    #[test]
    fn a_label_of_a_line_is_nearer_to_it_than_to_any_other() {
        let mut scene = Scene::default();
        let (one, two) = (Pen::thick(BLUE, Dash::Solid), Pen::thick(VERMILION, Dash::Solid));
        // Both end at the same highest point.
        let (left, right) = (
            vec![(20.0, 180.0), (90.0, 90.0), (150.0, 20.0)],
            vec![(150.0, 20.0), (210.0, 90.0), (280.0, 180.0)],
        );
        scene.stroke(one, left.clone());
        scene.stroke(two, right.clone());
        scene.place(&label("G₂", Named::Line(left.clone(), one)), BOUNDS);
        scene.place(&label("G₃", Named::Line(right.clone(), two)), BOUNDS);
        // Every segment is measured, without a look at boxes.
        let measured = |area: Area, line: &[Spot]| {
            line.windows(2).map(|two| gap(area, (two[0], two[1]))).fold(f64::INFINITY, f64::min)
        };
        let [first, second] = scene.texts[..] else { panic!("two texts") };
        assert!(
            measured(first, &left) < measured(first, &right)
                && measured(second, &right) < measured(second, &left)
        );
        assert!(!first.meets(second));
        for x in [10.0, 60.0, 150.0, 250.0] {
            let area = Area::around((x, 100.0), (12.0, 6.0));
            for line in [&left, &right, &vec![(400.0, 90.0), (0.0, 150.0), (x, 170.0), (x, 120.0)]] {
                assert_eq!(nearest(area, line.windows(2)).to_bits(), measured(area, line).to_bits());
            }
        }
    }
}
