//! One table of all comparisons with other systems: `cargo bench --bench table -- [JOB…] [--json] [--repetitions N]`.
//!
//! The scripts beside this file compare results first and then take turns on one core; each writes rows of fields separated by
//! tabs: job, size, which of ours, its milliseconds, the peer, and the peer's. A job whose peers are not installed is left out,
//! and that is said on standard error with what to do; if none is left, the exit code is 2. If two results differ, it is 1.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

use comfy_table::presets::NOTHING;
use comfy_table::{CellAlignment, Table};
use serde::Serialize;

/// A job, by whose script it is done, what a unit of it is, and how it is done here.
struct Job {
    name: &'static str,
    script: &'static str,
    method: &'static str,
}

const JOBS: [Job; 6] = [
    Job {
        name: "A",
        script: "benches/peers.sh",
        method: "values at a point: fraction-free triangle, then shared factors cancelled",
    },
    Job {
        name: "B",
        script: "benches/peers.sh",
        method: "pieces on a span: triangle in integers of a fixed width, known factors divided out",
    },
    Job {
        name: "C",
        script: "benches/peers.sh",
        method: "critical points of a function: from knots by floats with a bound first, from polynomials by Descartes' rule in \
                 integers of a fixed width",
    },
    Job {
        name: "E",
        script: "benches/peers.sh",
        method: "pieces on a span for every r: triangle over products of linear factors, not reduced",
    },
    Job {
        name: "F",
        script: "benches/float/compare.sh",
        method: "a million values in f64: pairs of floats in vectors, or one division a place",
    },
    Job {
        name: "S",
        script: "benches/unimodality/compare.sh",
        method: "number of maxima of a random function: signs of slopes by floats with a bound, else by integers",
    },
];

/// What a script writes in a line.
#[derive(Debug, Serialize)]
struct Row {
    job: String,
    size: String,
    ours: String,
    ours_ms: f64,
    peer: String,
    peer_ms: f64,
    /// How many times as long the peer takes.
    ratio: f64,
    method: &'static str,
}

impl Row {
    fn read(line: &str, method: &'static str) -> Option<Self> {
        let fields: Vec<&str> = line.split('\t').collect();
        let [job, size, ours, ours_ms, peer, peer_ms] = fields.as_slice() else { return None };
        let [ours_ms, peer_ms]: [f64; 2] = [ours_ms.parse().ok()?, peer_ms.parse().ok()?];
        let [job, size, ours, peer] = [job, size, ours, peer].map(|field| (*field).to_owned());
        Some(Self { job, size, ours, ours_ms, peer, peer_ms, ratio: peer_ms / ours_ms, method })
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let (mut json, mut repetitions, mut chosen) = (false, "3".to_owned(), Vec::new());
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            // Cargo says so to every benchmark.
            "--bench" => {}
            "--json" => json = true,
            "--repetitions" => repetitions = arguments.next().ok_or("--repetitions N")?,
            name => chosen.push(JOBS.iter().find(|job| job.name == name).ok_or_else(|| {
                let known = JOBS.map(|job| format!("{} ({})", job.name, job.method)).join("\n");
                format!("there is no job {name}; the jobs are\n{known}")
            })?),
        }
    }
    if chosen.is_empty() {
        chosen = JOBS.iter().collect();
    }
    let mut rows = Vec::new();
    for job in chosen {
        let mut script = Command::new(Path::new(env!("CARGO_MANIFEST_DIR")).join(job.script));
        match job.name {
            "F" => script.args([python().as_str(), "rows"]),
            "S" => script.args(["2000", "rows"]),
            name => script.args(["rows", repetitions.as_str(), name]),
        };
        let output = script.stderr(Stdio::inherit()).output()?;
        match output.status.code() {
            Some(0) => {}
            // What is missing the script has said.
            Some(2) => continue,
            _ => return Err(format!("{}: job {}: results differ, or it failed", job.script, job.name).into()),
        }
        for line in String::from_utf8(output.stdout)?.lines() {
            rows.push(Row::read(line, job.method).ok_or_else(|| format!("no row: {line}"))?);
        }
    }
    if json {
        for row in &rows {
            println!("{}", serde_json::to_string(row)?);
        }
    } else {
        print!("{}", text(&rows));
    }
    Ok(ExitCode::from(if rows.is_empty() { 2 } else { 0 }))
}

/// The Python of the peers, if it is there: it has SciPy.
fn python() -> String {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/peers/venv/bin/python");
    if own.exists() { own.display().to_string() } else { "python3".to_owned() }
}

fn text(rows: &[Row]) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING).set_header(["job", "size", "ours", "ms", "peer", "ms", "ratio"]);
    for at in [3, 5, 6] {
        if let Some(column) = table.column_mut(at) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    for row in rows {
        let [own, other] = [row.ours_ms, row.peer_ms].map(|ms| format!("{ms:.3e}"));
        let ratio = format!("{:.2}", row.ratio);
        table.add_row([&row.job, &row.size, &row.ours, &own, &row.peer, &other, &ratio].map(String::as_str));
    }
    let mut text = format!("{table}\n");
    for job in JOBS.iter().filter(|job| rows.iter().any(|row| row.job == job.name)) {
        let _ = writeln!(text, "{}: {}", job.name, job.method);
    }
    text
}
