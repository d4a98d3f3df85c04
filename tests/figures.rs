//! The figures: all there, the same bytes every time, well-formed, and with what they are meant to show.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;

use knotproof::language::{claims, paper};
use knotproof::meaning::{Example, Weighting, examples_named};
use knotproof::report::figures::{Plot, all, figure, plot, png};
use knotproof::report::{Baseline, Report, State, conjecture_page, dependence_picture};
use knotproof::scalar::{BigRational, integer, rational};
use knotproof::spline::{Basis, Curve, Index, KnotVector, Side, weight};
use num_traits::ToPrimitive;
use serde_json::Value;

fn svg(name: &str) -> String {
    figure(name).expect("a figure").svg().expect("it can be drawn")
}

fn program(arguments: &[&str]) -> std::process::Output {
    crate::program().args(arguments).output().expect("it runs")
}

#[test]
fn the_paper_has_33_figures_and_every_name_is_its_own() {
    let numbers: Vec<_> = all().iter().filter_map(|figure| figure.number).collect();
    assert_eq!(numbers, (1..=33).collect::<Vec<_>>());
    for one in all() {
        assert!(std::ptr::eq(figure(one.name).unwrap(), one), "{}", one.name);
        if let Some(number) = one.number {
            assert_eq!(one.name, format!("fig{number}"));
            assert!(one.title.starts_with(&format!("Fig. {number}: ")), "{}", one.title);
            assert!(std::ptr::eq(figure(&number.to_string()).unwrap(), one));
        }
    }
    assert!(figure("fig34").is_none() && figure("0").is_none() && figure("").is_none());
}

#[test]
fn the_claims_of_a_figure_are_claims_and_every_illustration_has_one() {
    let ids: Vec<_> = claims().iter().map(|claim| claim.id()).collect();
    for figure in all() {
        assert!(!figure.claims.is_empty());
        for id in figure.claims {
            assert!(ids.contains(id), "{}: there is no claim {id}", figure.name);
        }
    }
    for id in ids.iter().filter(|id| id.starts_with("Ill") || id.starts_with("Rem")) {
        assert!(all().iter().any(|figure| figure.claims.contains(id)), "no figure for {id}");
    }
}

#[test]
fn every_figure_is_well_formed_and_the_same_every_time() {
    for figure in all() {
        let svg = figure.svg().unwrap();
        assert_eq!(figure.svg().unwrap(), svg, "{}", figure.name);
        assert!(
            svg.contains(&format!(
                "<title>{}</title>",
                figure.title.replace('<', "&lt;").replace('>', "&gt;")
            )),
            "{}",
            figure.name
        );
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", figure.name);
        if let Err(error) = resvg::usvg::Tree::from_str(&svg, &resvg::usvg::Options::default()) {
            panic!("{}: {error}", figure.name);
        }
    }
}

#[test]
fn nothing_is_too_fine_for_print() {
    for figure in all() {
        let svg = figure.svg().unwrap();
        // Without what is filled and has no outline.
        let drawn: String = svg.lines().filter(|line| !line.contains("stroke=\"none\"")).collect();
        let values = |name: &str| -> Vec<f64> {
            let pattern = format!(" {name}=\"");
            drawn
                .match_indices(&pattern)
                .map(|(at, _)| drawn[at + pattern.len()..].split('"').next().unwrap().parse().unwrap())
                .collect()
        };
        // A unit is a tenth of a pixel, and a pixel 0.75 pt.
        assert!(values("font-size").iter().all(|size| *size * 0.075 >= 8.0), "{}", figure.name);
        let widths = values("stroke-width");
        assert!(!widths.is_empty() && widths.iter().all(|width| *width * 0.075 >= 0.75), "{}", figure.name);
    }
}

#[test]
fn jumps_have_an_open_and_a_filled_dot() {
    let circles = |svg: &str, open: bool| {
        svg.lines()
            .filter(|line| line.starts_with("<circle") && line.contains("fill=\"none\"") == open)
            .count()
    };
    // U11 has a triple knot, where G_2 falls from 1 to 0 and G_3 rises from 0 to 1: in each of four panels.
    let triple = svg("fig19");
    assert_eq!(circles(&triple, true), 4 * 2);
    // Beside the white inside of each: the two values at the jump, and 1 at both ends.
    assert_eq!(circles(&triple, false), 4 * (2 + 2 + 2));
    // U9 has simple knots only: no jump.
    assert_eq!(circles(&svg("fig17"), true), 0);
    // Degree 0 on U0: six functions, a jump at both ends of each, but not at t_0 and t_m.
    assert_eq!(circles(&svg("fig4"), true), 4 * (6 + 6 - 2));
}

#[test]
fn knots_are_labelled_with_their_multiplicities() {
    let triple = svg("fig19");
    assert_eq!(triple.matches("×3\n").count(), 4 * 3);
    assert!(triple.contains("3/4") && triple.contains("α = ∞") && triple.contains("k = 2"));
    assert_eq!(svg("fig18").matches("×2\n").count(), 4);
}

#[test]
fn png_is_the_same_every_time_and_has_text() {
    let svg = svg("fig12");
    let picture = png(&svg).unwrap();
    assert!(picture.starts_with(b"\x89PNG") && picture == png(&svg).unwrap());
    // Twice as wide as the SVG.
    assert_eq!(picture[16..20], (2 * 800_u32).to_be_bytes());
    let without_text: String = svg.replace("font-size", "data-size");
    assert!(png(&without_text).unwrap() != picture, "the font is not there");
    assert!(png("not an SVG").unwrap_err().to_string().contains("could not be drawn"));
}

#[test]
fn the_command_writes_what_the_library_draws() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new");
    let arguments =
        ["figures", "12", "two-maxima", "fig12", "--format", "json", "--out", out.to_str().unwrap()];
    let output = program(&arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(result["schema"], "knotproof.figures/1");
    let files: Vec<_> =
        result["files"].as_array().unwrap().iter().map(|file| file.as_str().unwrap()).collect();
    let names = ["fig12.svg", "fig12.png", "two-maxima.svg", "two-maxima.png"];
    assert_eq!(files, names.map(|name| out.join(name).to_str().unwrap().to_owned()));
    assert_eq!(fs::read_to_string(files[0]).unwrap(), svg("fig12"));
    assert_eq!(fs::read(files[1]).unwrap(), png(&svg("fig12")).unwrap());
    assert_eq!(result["figures"][1]["claims"][0], "Conj3.1.strong");
}

#[test]
fn an_unknown_figure_is_told_which_there_are() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new");
    let output = program(&["figures", "34", "--out", out.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        message.contains("no figure `34`") && message.contains("1 to 33") && message.contains("two-maxima")
    );
    assert!(output.stdout.is_empty() && !out.exists());
}

/// A rectangle in pixels: left, top, right, bottom.
type Area = [f32; 4];

/// What a figure has on it, as another program reads the SVG: texts with their areas, and lines as segments.
#[derive(Default)]
struct Sheet {
    texts: Vec<Text>,
    /// Colour, width, and the points of each part.
    lines: Vec<(Pen, Vec<[f32; 2]>)>,
}

#[derive(Debug, Clone)]
struct Text {
    words: String,
    ink: Area,
    colour: [u8; 3],
}

impl Text {
    fn middle(&self) -> [f32; 2] {
        [f32::midpoint(self.ink[0], self.ink[2]), f32::midpoint(self.ink[1], self.ink[3])]
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Pen {
    colour: [u8; 3],
    width: f32,
}

impl Pen {
    /// Grids and guides, which text may stand on.
    fn is_pale(self) -> bool {
        self.colour.iter().all(|&part| part > 230)
    }
}

fn sheet(svg: &str) -> Sheet {
    let mut fonts = resvg::usvg::fontdb::Database::new();
    fonts.load_font_data(include_bytes!("../src/report/figures/font/DejaVuSans-subset.ttf").to_vec());
    let options = resvg::usvg::Options { fontdb: std::sync::Arc::new(fonts), ..Default::default() };
    let tree = resvg::usvg::Tree::from_str(svg, &options).expect("it is an SVG");
    let mut sheet = Sheet::default();
    read(tree.root(), &mut sheet);
    sheet
}

fn read(group: &resvg::usvg::Group, sheet: &mut Sheet) {
    use resvg::tiny_skia::PathSegment::{Close, LineTo, MoveTo};
    use resvg::usvg::{Node, Paint};
    for node in group.children() {
        match node {
            Node::Group(inner) => read(inner, sheet),
            Node::Text(text) => {
                let words: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
                // The ink of its letters, not the lines that they stand between.
                let ink = text.flattened().abs_bounding_box();
                let fill = text.chunks().iter().flat_map(|chunk| chunk.spans()).find_map(|span| span.fill());
                let Some(Paint::Color(colour)) = fill.map(|fill| fill.paint()) else { continue };
                sheet.texts.push(Text {
                    words: words.trim().to_owned(),
                    ink: [ink.left(), ink.top(), ink.right(), ink.bottom()],
                    colour: [colour.red, colour.green, colour.blue],
                });
            }
            Node::Path(path) => {
                let Some(stroke) = path.stroke() else { continue };
                let Paint::Color(colour) = stroke.paint() else { continue };
                let transform = path.abs_transform();
                let pen = Pen {
                    colour: [colour.red, colour.green, colour.blue],
                    width: stroke.width().get() * transform.sx,
                };
                let at = |point: resvg::tiny_skia::Point| {
                    let mut point = point;
                    transform.map_point(&mut point);
                    [point.x, point.y]
                };
                let mut points = Vec::new();
                for segment in path.data().segments() {
                    match segment {
                        MoveTo(point) => {
                            sheet.lines.push((pen, std::mem::take(&mut points)));
                            points.push(at(point));
                        }
                        LineTo(point) => points.push(at(point)),
                        Close => points.extend(points.first().copied()),
                        // Circles are dots.
                        _ => {}
                    }
                }
                sheet.lines.push((pen, points));
            }
            Node::Image(_) => {}
        }
    }
    sheet.lines.retain(|(_, points)| points.len() > 1);
}

fn meet(one: Area, two: Area) -> bool {
    one[0] < two[2] && two[0] < one[2] && one[1] < two[3] && two[1] < one[3]
}

/// How far a point is from a line.
fn distance([x, y]: [f32; 2], line: &[[f32; 2]]) -> f32 {
    let of_segment = |two: &[[f32; 2]]| {
        let ([a, b], [c, d]) = (two[0], two[1]);
        let (across, down) = (c - a, d - b);
        let length = across * across + down * down;
        let share =
            if length > 0.0 { (((x - a) * across + (y - b) * down) / length).clamp(0.0, 1.0) } else { 0.0 };
        (x - a - share * across).hypot(y - b - share * down)
    };
    line.windows(2).map(of_segment).fold(f32::INFINITY, f32::min)
}

/// How far a line is from a rectangle; 0 if it strikes it.
fn gap([left, top, right, bottom]: Area, line: &[[f32; 2]]) -> f32 {
    let corners = [[left, top], [right, top], [left, bottom], [right, bottom]];
    let of_segment = |two: &[[f32; 2]]| {
        let [[a, b], [c, d]] = [two[0], two[1]];
        // The part of the segment that is between both pairs of sides (Liang and Barsky).
        let between = |from: f32, to: f32, low: f32, high: f32| match to - from {
            0.0 if from < low || high < from => (1.0, 0.0),
            0.0 => (0.0, 1.0),
            step => {
                let (one, two) = ((low - from) / step, (high - from) / step);
                (one.min(two), one.max(two))
            }
        };
        let (across, down) = (between(a, c, left, right), between(b, d, top, bottom));
        if across.0.max(down.0).max(0.0) <= across.1.min(down.1).min(1.0) {
            return 0.0;
        }
        let of_corners = corners.iter().map(|corner| distance(*corner, two)).fold(f32::INFINITY, f32::min);
        let off =
            |[x, y]: [f32; 2]| (left - x).max(x - right).max(0.0).hypot((top - y).max(y - bottom).max(0.0));
        of_corners.min(off([a, b])).min(off([c, d]))
    };
    line.windows(2).map(of_segment).fold(f32::INFINITY, f32::min)
}

/// A plot of each kind, by its name: bases, curves with corners and jumps in the plane, in space and over x, another family.
fn plots() -> Vec<(String, String)> {
    let knots = |list: &[i64]| KnotVector::new(list.iter().map(|&t| rational(t, 1)).collect()).unwrap();
    let example = |degree, list: &[i64], alphas: &[&str], points: &[&[i64]]| Example {
        name: String::new().into(),
        figure: String::new(),
        degree,
        knots: knots(list),
        weights: alphas.iter().map(|alpha| Weighting::Index(alpha.parse().unwrap())).collect(),
        points: (!points.is_empty())
            .then(|| points.iter().map(|point| point.iter().map(|&c| rational(c, 1)).collect()).collect()),
    };
    let square: [&[i64]; 5] = [&[0, 0], &[0, 4], &[4, 4], &[4, 0], &[2, 0]];
    let torn: [&[i64]; 6] = [&[0, 0], &[1, 3], &[3, 3], &[4, 1], &[6, 0], &[7, 2]];
    let space: [&[i64]; 4] = [&[0, 0, 1], &[1, 2, 0], &[2, 2, 5], &[3, 0, 0]];
    let graph: [&[i64]; 6] = [&[0], &[3], &[-1], &[2], &[0], &[1]];
    let all = [
        ("plot-basis", Plot::Basis, example(2, &[0, 0, 0, 1, 1, 2, 2, 2], &["-1", "2", "inf"], &[])),
        ("plot-curve", Plot::Curve, example(2, &[0, 0, 0, 1, 1, 2, 2, 2], &["-4", "inf"], &square)),
        ("plot-jump", Plot::Curve, example(2, &[0, 0, 0, 1, 1, 1, 2, 2, 2], &["5"], &torn)),
        ("plot-space", Plot::Curve, example(2, &[0, 0, 0, 1, 2, 2, 2], &["5"], &space)),
        ("plot-graph", Plot::Curve, example(3, &[0, 0, 0, 0, 1, 2, 4, 4, 4, 4], &["5", "6/5"], &graph)),
        ("plot-steps", Plot::Curve, example(0, &[0, 1, 2, 3], &["2"], &[&[1], &[3], &[2]])),
    ];
    let svg =
        |what, example: &Example| plot("A plot", example, what).unwrap().expect("something can be seen");
    all.iter().map(|(name, what, example)| (name.to_string(), svg(*what, example))).collect()
}

/// The same bytes as those that somebody has looked at. After a change that is meant, KNOTPROOF_DRAW=1 writes them anew.
#[test]
fn plots_are_as_they_were_when_somebody_looked_at_them() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    for (name, svg) in plots() {
        let path = folder.join(format!("{name}.svg"));
        if std::env::var_os("KNOTPROOF_DRAW").is_some() {
            fs::write(&path, &svg).unwrap();
        }
        assert!(fs::read_to_string(&path).unwrap_or_default() == svg, "{name} has changed");
    }
}

/// Corners have a red ring, jumps an open and a filled dot; what can't be seen is not drawn.
#[test]
fn marks_of_plots() {
    let count = |name: &str, mark: &str| {
        let (_, svg) = plots().into_iter().find(|(own, _)| own == name).unwrap();
        svg.lines().filter(|line| line.starts_with("<circle") && line.contains(mark)).count()
    };
    // The polygon turns at a double knot of degree 2, where the curve does: one ring for each α.
    let ring = "stroke=\"#D55E00\"";
    assert_eq!(count("plot-curve", ring), 2);
    assert_eq!(count("plot-jump", ring), 0);
    assert_eq!(count("plot-jump", "stroke=\"#0072B2\""), 1);
    assert_eq!(count("plot-space", ring), 0);
    // A graph of another α has a corner at each knot inside, and steps have a jump there.
    assert_eq!(count("plot-graph", ring), 2 * 2);
    assert_eq!(count("plot-steps", "stroke=\"#0072B2\""), 2);
}

/// Every figure that people see: the paper's, ours, and those of the page on the conjecture.
fn pictures() -> Vec<(String, String)> {
    let recorded = Baseline::recorded().expect("the recorded verdicts");
    let page = conjecture_page(&recorded).expect("the page on the conjecture");
    let numbered = all().iter().map(|figure| (figure.file(), figure.svg().expect("it can be drawn")));
    let report = Report::recorded(paper(), &claims(), &recorded);
    let dependence = dependence_picture(&report).expect("the drawing of what depends on what");
    let drawing = std::iter::once(("dependence.svg".to_owned(), dependence));
    let plots = plots().into_iter().map(|(name, svg)| (format!("{name}.svg"), svg));
    numbered
        .chain(drawing)
        .chain(plots)
        .chain(page.into_iter().filter(|(name, _)| name.ends_with(".svg")))
        .collect()
}

#[test]
fn no_text_is_struck_by_a_line_or_by_another_text_or_cut_off() {
    let mut faults = Vec::new();
    for (name, svg) in pictures() {
        let sheet = sheet(&svg);
        let size = |name: &str| -> f32 {
            svg.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
        };
        let (width, height) = (size("width"), size("height"));
        assert!(sheet.texts.len() > 5 && sheet.lines.len() > 5, "{name}: it is not read");
        for (i, Text { words: text, ink: area, .. }) in sheet.texts.iter().enumerate() {
            if area[0] < 0.0 || area[1] < 0.0 || area[2] > width || area[3] > height {
                faults.push(format!("{name}: “{text}” is cut off"));
            }
            for other in &sheet.texts[i + 1..] {
                if meet(*area, other.ink) {
                    faults.push(format!(
                        "{name}: “{text}” and “{}” stand on each other at {area:?}",
                        other.words
                    ));
                }
            }
            let dark = sheet.lines.iter().filter(|(pen, _)| !pen.is_pale());
            let struck = dark.into_iter().find(|(pen, line)| gap(*area, line) < pen.width / 2.0);
            if let Some((pen, _)) = struck {
                faults.push(format!("{name}: “{text}” at {area:?} is struck by a line, {pen:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// The colours of the first, second, … curve of a panel.
const COLOURS: [[u8; 3]; 7] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [170, 75, 130], [200, 130, 0], [40, 140, 200], [0; 3]];
/// How far a line may be from an exact point, in pixels: what is between two dashes, and what labels of axes are off.
const NEAR: f32 = 5.5;

/// A panel: what is below a heading, with its two scales as its own labels say them.
struct View<'a> {
    heading: &'a str,
    texts: Vec<&'a Text>,
    lines: Vec<&'a (Pen, Vec<[f32; 2]>)>,
    x: [f32; 2],
    y: [f32; 2],
}

fn number(text: &str) -> Option<f32> {
    let text = text.replace('−', "-");
    let (over, under) = text.split_once('/').unwrap_or((&text, "1"));
    Some(over.parse::<f32>().ok()? / under.parse::<f32>().ok()?)
}

/// Origin and length of a scale, from the two labels that are farthest from each other.
fn scale(labels: &[(f32, f32)]) -> Option<[f32; 2]> {
    let least = labels.iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let most = labels.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    let length = (most.1 - least.1) / (most.0 - least.0);
    length.is_finite().then_some([least.1 - least.0 * length, length])
}

fn views<'a>(sheet: &'a Sheet) -> Vec<View<'a>> {
    // A heading says which α its panel is for; titles and legends do so elsewhere.
    let is_heading = |text: &&Text| {
        let above = text.ink[1] > 55.0 && text.words.contains("α = ");
        above && [40.0_f32, 440.0].iter().any(|left| (text.ink[0] - left).abs() < 2.0)
    };
    let headings = sheet.texts.iter().filter(is_heading);
    let view = |heading: &'a Text| {
        let [left, _, _, top] = heading.ink;
        let next = sheet.texts.iter().filter(is_heading).filter(|other| other.ink[1] > top + 60.0);
        let end = next.map(|other| other.ink[1]).fold(f32::INFINITY, f32::min);
        let inside = |[x, y]: [f32; 2]| left - 42.0 < x && x < left + 358.0 && top < y && y < end;
        let texts: Vec<&Text> = sheet.texts.iter().filter(|text| inside(text.middle())).collect();
        let lines =
            sheet.lines.iter().filter(|(_, points)| points.iter().all(|point| inside(*point))).collect();
        let numbers = texts.iter().filter_map(|text| Some((number(&text.words)?, *text)));
        let (up, along): (Vec<_>, Vec<_>) = numbers.partition(|(_, text)| text.ink[2] < left);
        let x: Vec<_> = along.iter().map(|(value, text)| (*value, text.middle()[0])).collect();
        let y: Vec<_> = up.iter().map(|(value, text)| (*value, text.middle()[1])).collect();
        Some(View { heading: &heading.words, texts, lines, x: scale(&x)?, y: scale(&y)? })
    };
    headings.filter_map(view).collect()
}

impl View<'_> {
    fn spot(&self, x: &BigRational, y: &BigRational) -> [f32; 2] {
        let float = |value: &BigRational| value.to_f32().expect("a number of a figure");
        [self.x[0] + self.x[1] * float(x), self.y[0] + self.y[1] * float(y)]
    }

    /// How far the nearest line of a colour is, or of any other curve.
    fn off(&self, at: [f32; 2], colour: [u8; 3], own: bool) -> f32 {
        let lines = self.lines.iter().filter(|(pen, _)| pen.width > 1.5 && (pen.colour == colour) == own);
        lines.map(|(_, line)| distance(at, line)).fold(f32::INFINITY, f32::min)
    }

    /// The same from a rectangle.
    fn gap(&self, area: Area, colour: [u8; 3], own: bool) -> f32 {
        let lines = self.lines.iter().filter(|(pen, _)| pen.width > 1.5 && (pen.colour == colour) == own);
        lines.map(|(_, line)| gap(area, line)).fold(f32::INFINITY, f32::min)
    }

    fn indices(&self) -> Vec<Index> {
        let (_, list) = self.heading.split_once("α = ").expect("it names α");
        let words = list.split([',', ' ']).map(|word| word.replace('−', "-").replace('∞', "inf"));
        words.filter_map(|word| word.parse().ok()).collect()
    }
}

/// x at the ends, and at some places in each span; the same on both sides of the middle only for symmetric knots.
fn places(knots: &KnotVector) -> Vec<(BigRational, Side)> {
    let mut places = Vec::new();
    for span in knots.spans() {
        let (start, end) = (knots.t(span.index()), knots.t(span.index() + 1));
        for (part, side) in
            [(0, Side::Right), (1, Side::Right), (3, Side::Right), (5, Side::Right), (8, Side::Left)]
        {
            places.push((start + (end - start) * rational(part, 8), side));
        }
    }
    places
}

/// A figure that is mirrored, or has its functions exchanged, is noticed here.
#[test]
fn the_curves_of_a_basis_pass_through_exact_points_and_labels_are_at_their_functions() {
    let mut panels = 0;
    for figure in all().iter().filter(|figure| figure.number.is_some_and(|number| (4..=21).contains(&number)))
    {
        let (name, degree) =
            figure.title.split_once(": ").and_then(|(_, rest)| rest.split_once(", degree ")).unwrap();
        let degree: usize = degree.parse().unwrap();
        let instances = examples_named(name);
        let instance = instances.iter().find(|instance| instance.degree == degree).unwrap();
        let svg = figure.svg().unwrap();
        let sheet = sheet(&svg);
        let views = views(&sheet);
        assert_eq!(views.len(), instance.indices().count(), "{}", figure.name);
        for (view, index) in views.iter().zip(instance.indices()) {
            assert_eq!(view.indices(), std::slice::from_ref(index), "{}", figure.name);
            let basis = Basis::new(instance.knots.clone(), degree, index.clone()).unwrap();
            for (i, colour) in COLOURS.into_iter().enumerate().take(basis.n() + 1) {
                let here = format!("{}, {}, G_{i}", figure.name, view.heading);
                let digit = char::from_u32(0x2080 + u32::try_from(i).unwrap()).unwrap();
                let label = view.texts.iter().find(|text| text.words == format!("G{digit}"));
                let label = label.unwrap_or_else(|| panic!("{here} has no label"));
                assert_eq!(label.colour, colour, "{here}");
                for (x, side) in places(basis.knots()) {
                    let value = basis.values(&x, side)[i].clone();
                    if value > integer(0) {
                        let off = view.off(view.spot(&x, &value), colour, true);
                        assert!(off < NEAR, "{here}: the line is {off} pixels off ({x}, {value})");
                    }
                }
                let (own, other) = (view.gap(label.ink, colour, true), view.gap(label.ink, colour, false));
                assert!(
                    own < other && own < 15.0,
                    "{here}: its label is {own} from it and {other} from another"
                );
            }
            panels += 1;
        }
    }
    assert_eq!(panels, 18 * 4);
}

#[test]
fn curves_pass_through_exact_points_and_labels_are_at_their_control_points() {
    let mut checked = 0;
    for figure in all().iter().filter(|figure| figure.number.is_some_and(|number| number >= 22)) {
        let name = figure.title.split([':', ',']).nth(1).unwrap().trim();
        let instances: Vec<_> = match name {
            "C7" => ["C7a", "C7b", "C7c"].iter().flat_map(|name| examples_named(name)).collect(),
            name => examples_named(name),
        };
        let svg = figure.svg().unwrap();
        let sheet = sheet(&svg);
        for view in views(&sheet) {
            for (i, instance) in instances.iter().enumerate() {
                let polygon = instance.points.clone().unwrap();
                for (j, index) in view.indices().into_iter().enumerate() {
                    let here =
                        format!("{}, {}, k = {}, α = {index}", figure.name, view.heading, instance.degree);
                    let basis = Basis::new(instance.knots.clone(), instance.degree, index).unwrap();
                    let curve = Curve::new(basis, polygon.clone()).unwrap();
                    let colour = COLOURS[i + j];
                    for (x, side) in places(&instance.knots) {
                        let at = curve.point(&x, side);
                        let off = view.off(view.spot(&at[0], &at[1]), colour, true);
                        assert!(off < NEAR, "{here}: the line is {off} pixels off G({x})");
                    }
                    checked += 1;
                }
                // Of several polygons, those that differ in one point, the labels name what all have.
                for label in view.texts.iter().filter(|text| text.words.starts_with('d')) {
                    let digits = label.words.chars().skip(1).map_while(|c| {
                        (0x2080..0x208a).contains(&u32::from(c)).then(|| u32::from(c) - 0x2080)
                    });
                    let named = digits.fold(0, |number, digit| 10 * number + digit as usize);
                    let from = |point: &Vec<BigRational>| {
                        let [a, b] = view.spot(&point[0], &point[1]);
                        gap(label.ink, &[[a, b], [a, b]])
                    };
                    let own = from(&polygon[named]);
                    let others = polygon.iter().filter(|point| **point != polygon[named]).map(from);
                    assert!(
                        own < 45.0 && others.fold(f32::INFINITY, f32::min) > own,
                        "{}: “{}” is {own} off",
                        figure.name,
                        label.words
                    );
                }
            }
        }
    }
    // Each curve of each panel: C5, C6a and C6b by degree, C7 twice three by five, S1 to S7.
    assert_eq!(checked, 9 + 3 * 11 + 5 * 11 + 2 * 15 + 7 * 7);
}

#[test]
fn weights_pass_through_exact_points() {
    for (name, [a, b]) in [("fig1", [0, 1]), ("fig2", [0, 1]), ("fig3", [1, 3])] {
        let svg = svg(name);
        let sheet = sheet(&svg);
        let panels: Vec<_> = views(&sheet);
        assert_eq!(panels.len(), if name == "fig3" { 3 } else { 1 }, "{name}");
        for view in panels {
            let indices = view.indices();
            assert!(indices.len() >= 3);
            for (i, index) in indices.iter().enumerate() {
                for part in 1..8 {
                    let x = integer(a) + (integer(b) - integer(a)) * rational(part, 8);
                    let value = weight(index.ratio(), &x, &integer(a), &integer(b)).0;
                    let off = view.off(view.spot(&x, &value), COLOURS[i], true);
                    assert!(off < NEAR, "{name}, α = {index}: {off} pixels off ({x}, {value})");
                }
            }
        }
    }
}

#[test]
fn what_is_ours_in_a_figure_of_the_paper_is_said_under_it() {
    for name in ["fig1", "fig2", "fig3", "fig23", "fig24"] {
        assert!(svg(name).contains("in the scan"), "{name}");
        assert!(svg(name).contains("ours"), "{name}");
    }
    assert!(!svg("fig22").contains("in the scan"));
}

/// A legend has the lines of its own panel, and no others.
#[test]
fn each_panel_of_weights_has_a_legend_of_its_own() {
    let svg = svg("fig3");
    let sheet = sheet(&svg);
    let beside = |top: f32| {
        let entries = sheet
            .texts
            .iter()
            .filter(|text| text.ink[0] > 480.0 && (top..top + 120.0).contains(&text.ink[1]));
        entries.map(|text| text.words.clone()).collect::<Vec<_>>()
    };
    let expected =
        [["α = −1/3", "α = 4/3", "α = ∞"], ["α = −1", "α = 2", "α = ∞"], ["α = −20", "α = 21", "α = ∞"]];
    let headings: Vec<_> = views(&sheet)
        .iter()
        .map(|view| sheet.texts.iter().find(|text| text.words == view.heading).unwrap().ink[3])
        .collect();
    assert_eq!(headings.into_iter().map(beside).collect::<Vec<_>>(), expected);
}

/// The drawing has what the data have: a box with its verdict for every claim, and an arrow for every use.
#[test]
fn what_depends_on_what_is_drawn_from_the_data() {
    let report = Report::recorded(paper(), &claims(), &Baseline::recorded().expect("the recorded verdicts"));
    let uses = &report.dependence.uses;
    assert!(uses.len() > 10);
    let drawn = sheet(&dependence_picture(&report).expect("it can be drawn"));
    let place = |id: &str| {
        drawn.texts.iter().find(|text| text.words == id).unwrap_or_else(|| panic!("{id}")).middle()
    };
    for one in uses {
        let (from, to) = (place(&one.rests_on), place(&one.claim));
        // From the right side of the one box to the left side of the other.
        let is_arrow = |points: &[[f32; 2]]| match points {
            [a, b] => {
                (a[0] - from[0] - 79.0).abs() < 2.0
                    && (b[0] - to[0] + 79.0).abs() < 2.0
                    && (a[1] - from[1]).abs() < 12.0
                    && (b[1] - to[1]).abs() < 12.0
            }
            _ => false,
        };
        assert!(drawn.lines.iter().any(|(_, points)| is_arrow(points)), "{} to {}", one.rests_on, one.claim);
    }
    let mut broken = report.clone();
    broken.dependence.uses[0].state = State::Broken;
    let red = |report: &Report| {
        sheet(&dependence_picture(report).expect("it can be drawn"))
            .lines
            .iter()
            .filter(|(pen, _)| pen.colour == COLOURS[1])
            .count()
    };
    assert!(red(&broken) > red(&report), "what is broken is red");
}
