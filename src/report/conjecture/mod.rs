//! The page on Conjecture 3.1: what is known, degree by degree, with pictures.

mod picture;

use std::fmt::Write as _;

use rayon::prelude::*;

use num_traits::ToPrimitive;

use crate::analysis::{Partition, PartitionEnd, RatioCell, settled};
use crate::judge::{Shows, Witness};
use crate::scalar::{BigRational, decimal, integer, rational};
use crate::spline::{Basis, Index, KnotVector};

use super::baseline::Baseline;
use super::record::DegreeFinding;

use picture::Cell;
pub(super) use picture::function;

use super::figures::PictureError;

/// The degrees of the page.
const DEGREES: std::ops::RangeInclusive<usize> = 1..=8;

/// A function that is drawn, on its knots.
struct Example {
    basis: Basis,
    i: usize,
}

/// The page, as `conjecture.md`, and its pictures: names of files and what is in them.
///
/// The table and the first pictures come from the verdicts; the number of local maxima for every α on
/// uniform knots is computed here, and so are the numbers of the other examples.
///
/// # Errors
/// [`PictureError`].
pub fn conjecture_page(verdicts: &Baseline) -> Result<Vec<(String, String)>, PictureError> {
    let mut files = Vec::new();
    let mut page =
        format!("# Conjecture 3.1: one and only one maximum?\n\n{INTRODUCTION}\n\n{}\n", table(verdicts));
    let strong = example(verdicts, "Conj3.1.strong.continuous", 3);
    if let Some((example, witness)) = strong {
        let _ = writeln!(
            page,
            "## Two local maxima\n\n{SMALLEST}\n\nThe smallest one of degree 3: {}.\n",
            words(witness)
        );
        draw(&mut page, &mut files, "two-maxima", "two local maxima", &example)?;
    }
    if let Some((equal, witness)) = example(verdicts, "Conj3.1.weak.continuous", 3)
        && let Shows::Tied(tied) = &witness.shows
    {
        let _ =
            writeln!(page, "## Two equal maxima\n\n{EQUAL}\n\nFor degree 3: {}. {tied}.\n", words(witness));
        let titles = [("left-higher", "at the first α"), ("right-higher", "at the second α")];
        for ((name, title), flanked) in titles.into_iter().zip(&tied.at) {
            if let Ok(index) = flanked.alpha.parse() {
                let example = Example { basis: equal.basis.with_index(index), i: equal.i };
                draw(&mut page, &mut files, name, title, &example)?;
            }
        }
    }
    let _ = writeln!(page, "## Which α\n\n{EVERY_INDEX}\n");
    uniform(&mut page, &mut files)?;
    let _ = writeln!(page, "## How many\n\n{MOST}\n");
    for (gaps, ratio) in SEVERAL {
        if let Some(example) = on_gaps(gaps, *ratio) {
            let title = format!("degree {}, gaps {gaps:?}", gaps.len() - 1);
            draw(&mut page, &mut files, &format!("degree-{}", gaps.len() - 1), &title, &example)?;
        }
    }
    let _ = writeln!(page, "## What follows\n\n{CONSEQUENCES}\n\n## Again\n\n{AGAIN}");
    files.insert(0, ("conjecture.md".to_owned(), page));
    Ok(files)
}

const INTRODUCTION: &str = "The paper leaves open whether every basis function has one and only one maximum. It is meant \
here for functions that are continuous on (t_0, t_m); where a function jumps at a knot of multiplicity k + 1 it fails for \
trivial reasons. *Strong*: there is exactly one local maximum. *Weak*: the largest value is taken at exactly one point. \
Both are true in degrees 1 and 2, on every knot vector and for every α, and false from degree 3 on, for every \
α but ∞: of the strong reading [Coq](../proofs/theory/README.md) has checked that for every degree, of the weak one there are \
certificates for the degrees up to 8. What is *proved (knots)*, for every knot vector and α, or *proved (alpha)*, for every α, and what is *refuted*, is so by \
certificates in `proofs/certs` that the independent checker has read, or by that theory; the function with k − 1 local maxima has one too. \
*Proved (instance)* in the last column means: in all cases that were decided.";

const SMALLEST: &str = "The search goes through all functions of a degree in order of size: the sum of the gaps between \
their own knots (integers) and the height of α. On the left the whole function, on the right the part around its maxima \
(filled), with the minimum between them (open) at a knot, where the derivative jumps from a negative to a positive value.";

const EQUAL: &str = "As α moves, the higher of two maxima becomes the lower one. So for some α in between, irrational as a \
rule, both have the same height: the certificate gives two rational α, a value that is exceeded on one side only for \
either, and the reason why the two maxima do not meet on the way.";

const EVERY_INDEX: &str = "For every α ≠ ∞ there are knots, given by a formula in α, on which the function G_2^k has two \
local maxima, and others on which it has two equal ones: open knot vectors with two simple interior knots (`X.maxima`, one \
certificate for all α). For α = ∞, the classical B-splines, there is one maximum always: they are logarithmically concave (H. B. Curry and \
I. J. Schoenberg, On Pólya frequency functions IV, 1966). Here that is proved for k ≤ 3 only, and decided on instances up to \
k = 6 (`X.maxima.classical`).\n\n\
On a fixed knot vector most α do no harm. For simple uniform knots 0, 1, …, k + 1 here is the complete answer: the number \
of local maxima for every r = α/(α − 1) in (0, ∞), decided for every r, ends of intervals included.";

const MOST: &str = "Inside a span a function rises, or falls, or rises and then falls: proved for every degree, knot vector and α \
(`X.maxima.spans`, and [why that is so](theory.md)). So local \
minima are at knots, and there are at most k − 1 local maxima. There can be so many, for every k ≥ 2 and every α ≠ ∞ \
(`X_maxima_most`, a theorem checked by Coq: [theory](theory.md)); for every k from 2 to 8 one such function is \
certified with its numbers (`X.maxima.most`; its knots lie so far apart that a picture would not show them). Smaller examples:";

const CONSEQUENCES: &str = "A function with two local maxima crosses some horizontal line four times, while the polygon of its control \
values (one 1, all others 0) crosses it twice: so each of these examples, on a full knot vector, is also one against \
variation diminution (`X.variation`), and so against total positivity (`X.totalpositivity`). In degrees 1 and 2, where the \
conjecture holds, both of these hold as well.";

const AGAIN: &str = "```sh\nknotproof explain X.maxima\nknotproof search --degree 3 --find several --limit 9  # exit code 1\n\
knotproof search --degree 3 --find equal --limit 7  # exit code 1\n\
knotproof shape --degree 4 --knots \"0 1 2 3 4 5 5 5 5\" --index 0 --alpha all  # exit code 1\n```";

/// Examples with several local maxima: gaps and r = p/q.
const SEVERAL: &[(&[i64], (i64, i64))] =
    &[(&[86, 27, 1, 225, 226], (5, 1)), (&[59, 53, 2, 1, 320, 3126], (21, 2))];

fn of_degree<'a>(verdicts: &'a Baseline, claim: &str, degree: usize) -> Option<&'a DegreeFinding> {
    let entry = verdicts.claims.iter().find(|entry| entry.id == claim)?;
    entry.by_degree.iter().find(|of| of.degree == degree)
}

/// The verdicts, degree by degree.
fn table(verdicts: &Baseline) -> String {
    const COLUMNS: [(&str, &str); 5] = [
        ("strong", "Conj3.1.strong.continuous"),
        ("weak", "Conj3.1.weak.continuous"),
        ("fails for every α ≠ ∞", "X.maxima"),
        ("k − 1 maxima occur", "X.maxima.most"),
        ("one at most inside a span", "X.maxima.spans"),
    ];
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let head = std::iter::once("k".to_owned()).chain(COLUMNS.map(|(title, _)| title.to_owned())).collect();
    let mut text = row(head) + &row(vec!["---".to_owned(); COLUMNS.len() + 1]);
    for k in DEGREES {
        let cell = |(_, claim): (&str, &str)| {
            let found = of_degree(verdicts, claim, k).map(|of| &of.finding);
            found.map_or_else(String::new, |finding| match &finding.scope {
                Some(scope) => format!("{} ({scope})", finding.status),
                None => finding.status.clone(),
            })
        };
        text += &row(std::iter::once(k.to_string()).chain(COLUMNS.map(cell)).collect());
    }
    text
}

/// The function of a witness.
fn example<'a>(verdicts: &'a Baseline, claim: &str, degree: usize) -> Option<(Example, &'a Witness)> {
    let witness = of_degree(verdicts, claim, degree)?.finding.witness.as_ref()?;
    let i = witness.number("i")?.to_integer().to_usize()?;
    Some((Example { basis: witness.basis()?, i }, witness))
}

/// Where a witness is.
fn words(witness: &Witness) -> String {
    const PLACE: [&str; 4] = ["k", "U", "α", "i"];
    let given = witness.given().into_iter().filter(|(name, _)| PLACE.contains(&name.as_str()));
    given.map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
}

/// The function G_k^k on the knots with these gaps, k + 1 times 0 before them and the last one repeated.
fn on_gaps(gaps: &[i64], (p, q): (i64, i64)) -> Option<Example> {
    let k = gaps.len() - 1;
    let mut knots = vec![integer(0); k + 1];
    for gap in gaps {
        knots.push(&knots[knots.len() - 1] + rational(*gap, 1));
    }
    knots.extend(vec![knots[knots.len() - 1].clone(); k]);
    let index = Index::from_ratio(rational(p, q)).ok()?;
    Some(Example { basis: Basis::new(KnotVector::new(knots).ok()?, k, index).ok()?, i: k })
}

/// Draws a function, and puts it on the page.
fn draw(
    page: &mut String,
    files: &mut Vec<(String, String)>,
    name: &str,
    title: &str,
    example: &Example,
) -> Result<(), PictureError> {
    let Example { basis, i } = example;
    let title = format!("G_{i}, k = {}, α = {}: {title}", basis.degree(), basis.index());
    let file = format!("conjecture-{name}.svg");
    files.push((file.clone(), picture::function(&title, basis, *i)?));
    let _ = writeln!(page, "![{title}]({file})\n");
    Ok(())
}

/// The partition of all r for each degree from 2 on, on the knots 0, 1, …, k + 1.
fn uniform(page: &mut String, files: &mut Vec<(String, String)>) -> Result<(), PictureError> {
    let of_degree = |k: usize| {
        let mut knots: Vec<_> = (0..=k + 1).map(integer).collect();
        knots.extend(vec![integer(k + 1); k - 1]);
        let basis = Basis::new(KnotVector::new(knots).ok()?, k, Index::infinity()).ok()?;
        Some((k, Partition::by_ratio(&basis, 0, &rational(1, 1 << 30))))
    };
    let partitions: Vec<(usize, Partition)> =
        (2..=*DEGREES.end()).collect::<Vec<_>>().into_par_iter().filter_map(of_degree).collect();
    let _ = writeln!(
        page,
        "| k | two local maxima for r in (rounded) | at the ends of these intervals | else |\n|---|---|---|---|"
    );
    for (k, partition) in &partitions {
        let two = partition.cells().iter().filter(|cell| cell.local_maxima == Some(2));
        let cells: Vec<_> = two.map(|cell| interval(partition, cell)).collect();
        let [at_ends, elsewhere] =
            [numbers(partition.ends().iter().map(|end| Some(end.local_maxima))), numbers(others(partition))];
        let cells = if cells.is_empty() { "nowhere".to_owned() } else { cells.join(", ") };
        let _ = writeln!(page, "| {k} | {cells} | {at_ends} | {elsewhere} |");
    }
    let rows: Vec<(usize, Vec<Cell>)> = partitions
        .iter()
        .map(|(k, partition)| (*k, partition.cells().iter().filter_map(drawn).collect()))
        .collect();
    let file = "conjecture-uniform.svg".to_owned();
    let title = "uniform knots: two local maxima (red) or one, by r";
    files.push((file.clone(), picture::partition(title, &rows, 5)?));
    let _ = writeln!(page, "\n![{title}]({file})\n\n{ENDS}\n");
    for (k, partition) in &partitions {
        for end in partition.ends() {
            let _ = writeln!(page, "- k = {k}: {}", described(end));
        }
    }
    page.push('\n');
    Ok(())
}

const ENDS: &str = "The ends are algebraic numbers: each is the only root of a polynomial in an interval. They are where a one-sided derivative \
at a knot is 0.";

/// What is not two.
fn others(partition: &Partition) -> impl Iterator<Item = Option<usize>> {
    partition.cells().iter().map(|cell| cell.local_maxima).filter(|maxima| *maxima != Some(2))
}

/// The different numbers of a list.
fn numbers(list: impl Iterator<Item = Option<usize>>) -> String {
    let different: std::collections::BTreeSet<_> = list.collect();
    let word =
        |number: Option<usize>| number.map_or_else(|| "undecided".to_owned(), |number| number.to_string());
    different.into_iter().map(word).collect::<Vec<_>>().join(" or ")
}

/// A cell by its ends, which are no rational numbers as a rule.
fn interval(partition: &Partition, cell: &RatioCell) -> String {
    const DIGITS: usize = 6;
    let end = |at: &dyn Fn(&PartitionEnd) -> bool| {
        let end = partition.ends().iter().find(|end| at(end));
        end.map(|end| settled(&mut end.number(), DIGITS))
    };
    let from = end(&|end| end.interval.1 == cell.from).unwrap_or_else(|| decimal(&cell.from, DIGITS));
    let to = end(&|end| Some(&end.interval.0) == cell.to.as_ref());
    let bound = || cell.to.as_ref().map_or_else(|| "∞".to_owned(), |to| decimal(to, DIGITS));
    format!("({from}, {})", to.unwrap_or_else(bound))
}

fn drawn(cell: &RatioCell) -> Option<Cell> {
    let to: Option<BigRational> = cell.to.clone();
    Some((cell.from.clone(), to, cell.local_maxima?))
}

fn described(end: &PartitionEnd) -> String {
    let (lo, hi) = &end.interval;
    let polynomials: Vec<_> = end
        .polynomials
        .iter()
        .map(|polynomial| {
            let degree = polynomial.len().saturating_sub(1);
            match degree {
                0..=10 => format!("{polynomial:?}").replace('"', ""),
                _ => format!("of degree {degree} (`shape --alpha all --format json` has its coefficients)"),
            }
        })
        .collect();
    format!("{lo} < r < {hi}, polynomial {}", polynomials.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_have_as_many_maxima_as_is_said() {
        for (gaps, ratio) in SEVERAL {
            let Example { basis, i } = on_gaps(gaps, *ratio).unwrap();
            let function = crate::analysis::LocalKnots::of(&basis, i).unwrap();
            let maxima = crate::analysis::Monotonicity::of(&function).local_maxima();
            assert_eq!(maxima, Some(basis.degree() - 1));
        }
    }

    #[test]
    fn pictures_are_the_same_every_time() {
        let Example { basis, i } = on_gaps(&[2, 1, 1, 0], (3, 5)).unwrap();
        let svg = picture::function("title", &basis, i).unwrap();
        assert!(
            svg.starts_with("<svg") && svg.contains("title") && svg.matches("<circle").count() == 8,
            "{svg}"
        );
        assert_eq!(picture::function("title", &basis, i), Ok(svg));
    }
}
