//! Our side of the comparison that `benches/peers.sh` runs:
//!
//! ```text
//! peers cases FOLDER          writes the cases
//! peers check FOLDER          writes the results, to be compared
//! peers time JOB FOLDER       prints lines `JOB CASE VARIANT SECONDS`, separated by tabs
//! ```
//!
//! `benches/peers/README.md` says what stands in the files.

mod jobs;

use std::error::Error;
use std::fmt::{Display, Write};
use std::fs;
use std::hint::black_box;
use std::time::{Duration, Instant};

use knotproof::analysis::{SpanQuotient, count_roots_between};
use knotproof::scalar::{Polynomial, Ring, integer};
use knotproof::spline::{Active, Basis, Evaluator};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Signed;

use jobs::Gaps;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// The degrees of job A, each with a number of points: enough for no cache to know them all.
const VALUES: [(usize, usize); 4] = [(3, 1000), (5, 500), (10, 100), (20, 25)];
const PIECES: [usize; 11] = [3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16];
const CRITICAL: std::ops::RangeInclusive<usize> = 2..=8;
const SYMBOLIC: [usize; 3] = [3, 4, 5];
/// So many of the points are compared, and timed where growth is shown.
const CHECKED: usize = 25;
/// The time for which a job runs, at least.
const BUDGET: Duration = Duration::from_millis(100);

fn main() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["cases", folder] => write_cases(folder),
        ["check", folder] => write_results(folder),
        ["time", "A", _] => time_values(),
        ["time", "B", _] => time_pieces(),
        ["time", "C", folder] => time_critical_points(folder),
        ["time", "E", _] => time_symbolic(),
        ["time", "growth", _] => time_growth(),
        _ => Err("usage: peers cases|check FOLDER, or peers time JOB FOLDER".into()),
    }
}

fn basis_of(degree: usize) -> Outcome<Basis> {
    Ok(jobs::basis(degree, jobs::inner(degree))?)
}

fn families(degree: usize) -> [(&'static str, Vec<Gaps>); 2] {
    [("uniform", jobs::uniform(degree)), ("non-uniform", jobs::non_uniform(degree))]
}

fn joined<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    items.into_iter().map(|item| item.to_string()).collect::<Vec<_>>().join(" ")
}

fn fraction(x: &BigRational) -> String {
    format!("{}/{}", x.numer(), x.denom())
}

fn write_cases(folder: &str) -> Outcome {
    for (degree, count) in VALUES {
        let basis = basis_of(degree)?;
        let mut text = joined(basis.knots().knots()) + "\n";
        for x in jobs::points(&basis, count) {
            writeln!(text, "{} {}", x.numer(), x.denom())?;
        }
        fs::write(format!("{folder}/A.{degree}"), text)?;
    }
    for (job, degrees) in [("B", &PIECES[..]), ("E", &SYMBOLIC)] {
        for &degree in degrees {
            let basis = basis_of(degree)?;
            let span = jobs::middle(&basis).ok_or("there is a span in the middle")?;
            let knots = joined(basis.knots().knots());
            fs::write(format!("{folder}/{job}.{degree}"), format!("{knots}\n{}\n", span.index()))?;
        }
    }
    for degree in CRITICAL {
        for (family, functions) in families(degree) {
            let line = |(gaps, (p, q)): &Gaps| format!("{p} {q} {}\n", joined(gaps));
            let text: String = functions.iter().map(line).collect();
            fs::write(format!("{folder}/C.{degree}-{family}"), text)?;
        }
    }
    Ok(())
}

fn write_results(folder: &str) -> Outcome {
    let write = |name: String, text: String| fs::write(format!("{folder}/{name}"), text);
    for (degree, _) in VALUES {
        let basis = basis_of(degree)?;
        let points = jobs::points(&basis, CHECKED);
        let mut evaluator = Evaluator::new(&basis);
        let values = points.iter().filter_map(|x| jobs::values(&mut evaluator, x));
        let text = values.map(|values| joined(values.values().iter().map(fraction)) + "\n").collect();
        write(format!("A.{degree}.knotproof-reduced"), text)?;
        let mut text = String::new();
        for x in &points {
            let values = jobs::unreduced(&mut evaluator, x).ok_or("the points are inside")?;
            let quotients = values.numerators().into_iter().zip(values.denominators());
            writeln!(text, "{}", joined(quotients.map(|(p, q)| fraction(&BigRational::new(p, q)))))?;
        }
        write(format!("A.{degree}.knotproof-unreduced"), text)?;
    }
    for degree in PIECES {
        let basis = basis_of(degree)?;
        let span = jobs::middle(&basis).ok_or("there is a span in the middle")?;
        let ends = basis.knots().ends(span)?;
        let text = jobs::pieces(&basis, span).values().iter().map(|piece| quotient(piece, ends)).collect();
        write(format!("B.{degree}.knotproof"), text)?;
    }
    for degree in CRITICAL {
        for (family, functions) in families(degree) {
            let turns: Vec<usize> = functions
                .iter()
                .map(|f| Ok(jobs::turns(&jobs::local_knots(f)?)))
                .collect::<Outcome<Vec<_>>>()?
                .concat();
            write(format!("C.{degree}-{family}.knotproof-from-the-knots"), joined(turns) + "\n")?;
            let roots = slopes(folder, degree, family)?;
            let roots = roots.iter().map(Slope::roots);
            write(format!("C.{degree}-{family}.knotproof-from-polynomials"), joined(roots) + "\n")?;
        }
    }
    for degree in SYMBOLIC {
        let basis = basis_of(degree)?;
        let span = jobs::middle(&basis).ok_or("there is a span in the middle")?;
        let line = |g: &SpanQuotient<_>| format!("{} / {}\n", terms(&g.numerator), terms(&g.denominator));
        let text = jobs::pieces_for_every_ratio(&basis, span).values().iter().map(line).collect();
        write(format!("E.{degree}.knotproof"), text)?;
    }
    Ok(())
}

/// `P / Q` by rising powers of x, with coprime integers, the last of Q positive, from P and Q coprime in the span's positive
/// coordinate u = (x − a)/(b − x).
fn quotient(piece: &SpanQuotient<BigInt>, ends: (&BigRational, &BigRational)) -> String {
    let degree = piece.numerator.degree().max(piece.denominator.degree());
    let [p, q] = [&piece.numerator, &piece.denominator].map(|p| in_x(p, degree, ends));
    let (p, q) = (p.coefficients(), q.coefficients());
    let all = || p.iter().chain(q);
    let denominator = all().fold(BigInt::from(1), |lcm, c| lcm.lcm(c.denom()));
    let numerator = all().fold(BigInt::ZERO, |gcd, c| gcd.gcd(&(c.numer() * (&denominator / c.denom()))));
    let sign = BigInt::from(if q.last().is_some_and(Signed::is_negative) { -1 } else { 1 });
    let unit = BigRational::new(denominator * sign, numerator);
    format!("{} / {}\n", joined(p.iter().map(|c| c * &unit)), joined(q.iter().map(|c| c * &unit)))
}

/// p(u)·(b − x)^degree, for a degree that p has at most: what is coprime as forms stays so.
fn in_x(
    p: &Polynomial<BigInt>,
    degree: usize,
    (a, b): (&BigRational, &BigRational),
) -> Polynomial<BigRational> {
    let (rise, fall) = (Polynomial::new(-a, [integer(1)]), Polynomial::new(b.clone(), [integer(-1)]));
    let (mut sum, mut power) = (Polynomial::constant(integer(0)), Polynomial::constant(integer(1)));
    for i in (0..=degree).rev() {
        let c = p.coefficients().get(i).cloned().unwrap_or_default();
        sum = sum.times(&rise).plus(&power.scaled(&c.into()));
        power = power.times(&fall);
    }
    sum
}

/// The terms c·u^a·r^b of a polynomial as `c:a:b`.
fn terms(p: &Polynomial<Polynomial<BigInt>>) -> String {
    let of_power = |(a, c): (usize, &Polynomial<BigInt>)| -> Vec<String> {
        let terms = c.coefficients().iter().enumerate().filter(|(_, c)| **c != BigInt::ZERO);
        terms.map(|(b, c)| format!("{c}:{a}:{b}")).collect()
    };
    joined(p.coefficients().iter().enumerate().flat_map(of_power))
}

/// The numerators of the derivatives with the ends of their spans, as `python_flint.py` has written them.
struct Slope {
    ends: [BigInt; 2],
    coefficients: Vec<BigInt>,
}

impl Slope {
    /// Job C from a polynomial: its roots between the ends.
    fn roots(&self) -> usize {
        count_roots_between(&self.coefficients, &self.ends[0], &self.ends[1])
    }
}

fn slopes(folder: &str, degree: usize, family: &str) -> Outcome<Vec<Slope>> {
    let text = fs::read_to_string(format!("{folder}/C.{degree}-{family}.slopes"))?;
    let slope = |line: &str| {
        let numbers = line.split(' ').map(str::parse).collect::<Result<Vec<BigInt>, _>>()?;
        match &numbers[..] {
            [a, b, coefficients @ ..] => {
                Ok(Slope { ends: [a.clone(), b.clone()], coefficients: coefficients.to_vec() })
            }
            _ => Err(format!("no slope: {line}").into()),
        }
    };
    text.lines().map(slope).collect()
}

/// Runs the job until the time is over, and prints the seconds for each of its `units`.
fn time<T>(job: &str, case: &str, variant: &str, units: usize, mut run: impl FnMut() -> T) {
    black_box(run());
    let (start, mut runs) = (Instant::now(), 0_u32);
    while start.elapsed() < BUDGET {
        black_box(run());
        runs += 1;
    }
    let seconds = start.elapsed().as_secs_f64() / f64::from(runs) / units as f64;
    println!("{job}\t{case}\t{variant}\t{seconds:e}");
}

fn time_values() -> Outcome {
    for (degree, count) in VALUES {
        let basis = basis_of(degree)?;
        let points = jobs::points(&basis, count);
        let (mut evaluator, case) = (Evaluator::new(&basis), format!("k = {degree}"));
        let run = || points.iter().map(|x| jobs::values(&mut evaluator, x)).collect::<Vec<_>>();
        time("A", &case, "knotproof, reduced", points.len(), run);
        let run =
            || points.iter().filter_map(|x| Some(jobs::unreduced(&mut evaluator, x)?.first())).sum::<usize>();
        time("A", &case, "knotproof, unreduced", points.len(), run);
    }
    Ok(())
}

fn time_pieces() -> Outcome {
    for degree in PIECES {
        let basis = basis_of(degree)?;
        let span = jobs::middle(&basis).ok_or("there is a span in the middle")?;
        time("B", &format!("k = {degree}"), "knotproof", 1, || jobs::pieces(&basis, span));
    }
    Ok(())
}

fn time_critical_points(folder: &str) -> Outcome {
    for degree in CRITICAL {
        for (family, functions) in families(degree) {
            let (case, count) = (format!("k = {degree}, {family}"), functions.len());
            let slopes = slopes(folder, degree, family)?;
            let run = || slopes.iter().map(Slope::roots).sum::<usize>();
            time("C", &case, "knotproof, from polynomials", count, run);
            let run = || -> Outcome<Vec<Vec<usize>>> {
                functions.iter().map(|f| Ok(jobs::turns(&jobs::local_knots(f)?))).collect()
            };
            time("C", &case, "knotproof, from the knots", count, run);
        }
    }
    Ok(())
}

fn time_symbolic() -> Outcome {
    for degree in SYMBOLIC {
        let basis = basis_of(degree)?;
        let span = jobs::middle(&basis).ok_or("there is a span in the middle")?;
        time("E", &format!("k = {degree}"), "knotproof", 1, || jobs::pieces_for_every_ratio(&basis, span));
    }
    Ok(())
}

/// How the time for a point grows with the degree, and with the number of knots.
fn time_growth() -> Outcome {
    let cases = jobs::GROWTH_DEGREES.map(|k| (k, 100)).into_iter().chain(jobs::GROWTH_KNOTS.map(|n| (3, n)));
    for (degree, inner) in cases {
        let basis = jobs::basis(degree, inner)?;
        let points = jobs::points(&basis, CHECKED);
        let mut evaluator = Evaluator::new(&basis);
        let run = || -> Vec<Option<Active<BigRational>>> {
            points.iter().map(|x| jobs::values(&mut evaluator, x)).collect()
        };
        time(
            "growth",
            &format!("k = {degree}, {inner} inner knots"),
            "knotproof, reduced",
            points.len(),
            run,
        );
    }
    Ok(())
}
