//! How the time of a command grows with the degree, the spans and the length of numbers: `cargo bench --bench growth -- [WORD…]`
//! prints the table of docs/performance.md; with `--svg FILE` it draws the curves as well.
//!
//! Each command is run as a user runs it, in a process of its own, and ended after [`LIMIT`]; then the larger sizes of its row are
//! left out. A command that fails ends the benchmark.

use std::error::Error;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use plotters::prelude::*;

/// Nobody waits longer than this without knowing why.
const LIMIT: Duration = Duration::from_secs(120);

/// A command by its size.
struct Row {
    what: &'static str,
    size: &'static str,
    sizes: &'static [usize],
    arguments: fn(usize) -> Vec<String>,
}

const ROWS: [Row; 8] = [
    Row {
        what: "`shape --index k`, open knots with k + 2 spans",
        size: "k",
        sizes: &[5, 10, 20, 30, 40],
        arguments: |k| command("shape", k, &open(k), &[("--index", k.to_string())]),
    },
    Row {
        what: "`check`, open knots with k + 2 spans",
        size: "k",
        sizes: &[3, 5, 7, 8, 9],
        arguments: |k| command("check", k, &open(k), &[]),
    },
    Row {
        what: "`check --degree 8`, uniform knots",
        size: "spans",
        sizes: &[20, 40],
        arguments: |spans| command("check", 8, &uniform(spans), &[]),
    },
    Row {
        what: "`check --degree 1`, uniform knots",
        size: "knots",
        sizes: &[50, 100, 200, 399],
        arguments: |knots| command("check", 1, &uniform(knots - 1), &[]),
    },
    Row {
        what: "`check --degree 3`, α = 10^n",
        size: "n",
        sizes: &[1, 10, 60, 300],
        arguments: |n| with_index("check", 3, &open(3), &format!("1e{n}"), &[]),
    },
    Row {
        what: "`check --degree 3`, α = 1 + 10^−n",
        size: "n",
        sizes: &[1, 10, 60, 300],
        arguments: |n| with_index("check", 3, &open(3), &format!("1.{}1", "0".repeat(n - 1)), &[]),
    },
    Row {
        what: "`eval`, x = k + 1/3, uniform knots",
        size: "k",
        sizes: &[50, 100, 200, 300, 500],
        arguments: |k| {
            let x = format!("{}/3", 3 * k + 1);
            command("eval", k, &uniform(2 * k + 1), &[("--x", x)])
        },
    },
    Row {
        what: "`eval --degree 3`, x = 10^−n",
        size: "n",
        sizes: &[1_000, 10_000, 100_000],
        arguments: |n| command("eval", 3, &open(3), &[("--x", format!("1/1{}", "0".repeat(n)))]),
    },
];

/// k zeros, 0, 1, …, k + 1, and k times k + 1.
fn open(k: usize) -> String {
    let knots = std::iter::repeat_n(0, k).chain(0..=k + 1).chain(std::iter::repeat_n(k + 1, k));
    knots.map(|t| t.to_string()).collect::<Vec<_>>().join(" ")
}

fn uniform(spans: usize) -> String {
    (0..=spans).map(|t| t.to_string()).collect::<Vec<_>>().join(" ")
}

/// For α = −1.
fn command(name: &str, degree: usize, knots: &str, more: &[(&str, String)]) -> Vec<String> {
    with_index(name, degree, knots, "-1", more)
}

fn with_index(name: &str, degree: usize, knots: &str, alpha: &str, more: &[(&str, String)]) -> Vec<String> {
    let degree = degree.to_string();
    let mut all: Vec<_> =
        [name, "--degree", &degree, "--knots", knots, "--alpha", alpha].map(str::to_owned).to_vec();
    for (option, value) in more {
        all.extend([(*option).to_owned(), value.clone()]);
    }
    all
}

/// Seconds, or nothing after the limit.
fn time(arguments: &[String]) -> Result<Option<f64>, Box<dyn Error>> {
    let begin = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_knotproof"));
    let mut child = child.args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    loop {
        if let Some(status) = child.try_wait()? {
            // 1: something does not hold, which is an answer.
            return match status.code() {
                Some(0 | 1) => Ok(Some(begin.elapsed().as_secs_f64())),
                _ => Err(format!("knotproof {} failed: {status}", arguments.join(" ")).into()),
            };
        }
        if begin.elapsed() > LIMIT {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// A row with its points.
type Curve<'a> = (&'a Row, Vec<(usize, f64)>);

fn draw(file: &str, curves: &[Curve<'_>]) -> Result<(), Box<dyn Error>> {
    let root =
        SVGBackend::new(file, (960, 240 * u32::try_from(curves.len().div_ceil(2))?)).into_drawing_area();
    root.fill(&WHITE)?;
    for ((row, points), area) in curves.iter().zip(root.split_evenly((curves.len().div_ceil(2), 2))) {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { continue };
        let mut chart = ChartBuilder::on(&area)
            .caption(row.what.replace('`', ""), ("sans-serif", 15))
            .margin(10)
            // The last size is written to both sides of its tick.
            .margin_right(28)
            .x_label_area_size(32)
            .y_label_area_size(48)
            .build_cartesian_2d(
                (first.0..last.0 + 1).log_scale(),
                (0.005..LIMIT.as_secs_f64()).log_scale(),
            )?;
        chart.configure_mesh().x_desc(row.size).y_desc("seconds").light_line_style(WHITE).draw()?;
        chart.draw_series(LineSeries::new(points.iter().copied(), BLUE.stroke_width(2)))?;
        chart.draw_series(points.iter().map(|point| Circle::new(*point, 3, BLUE.filled())))?;
    }
    root.present()?;
    Ok(())
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let svg = match words.iter().position(|word| word == "--svg") {
        Some(at) if at + 1 < words.len() => words.drain(at..at + 2).nth(1),
        Some(_) => return Err("--svg needs a file".into()),
        None => None,
    };
    let wanted: Vec<&Row> = ROWS
        .iter()
        .filter(|row| words.is_empty() || words.iter().any(|word| row.what.contains(word.as_str())))
        .collect();
    if wanted.is_empty() {
        return Err(format!("no command has {} in it", words.join(" or ")).into());
    }
    let mut curves = Vec::new();
    println!("| command | size | seconds |\n|---|---|---|");
    for row in wanted {
        let (mut points, mut said) = (Vec::new(), Vec::new());
        for size in row.sizes {
            match time(&(row.arguments)(*size))? {
                Some(seconds) => {
                    points.push((*size, seconds));
                    said.push(format!("{seconds:.2}"));
                }
                None => {
                    said.push(format!("over {}", LIMIT.as_secs()));
                    break;
                }
            }
        }
        let sizes: Vec<_> = row.sizes.iter().take(said.len()).map(ToString::to_string).collect();
        println!("| {} | {} = {} | {} |", row.what, row.size, sizes.join(", "), said.join(", "));
        curves.push((row, points));
    }
    svg.map_or(Ok(()), |file| draw(&file, &curves))
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("growth: {error}");
            ExitCode::FAILURE
        }
    }
}
