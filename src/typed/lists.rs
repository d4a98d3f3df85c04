//! Lists of numbers and of points, as people write them.

use num_rational::BigRational;

use crate::json::{self, Number};
use crate::scalar::parse_rational;
use crate::spline::Point;

use super::error::TypedError;
use super::provenance::Provenance;

/// A list of exact numbers, separated by commas or by white space.
///
/// # Errors
/// [`TypedError::Number`], with the position of the first entry that is not a number; [`TypedError::DecimalComma`] where a
/// comma may be a separator or a decimal point.
pub fn numbers(text: &str, place: &Provenance) -> Result<Vec<BigRational>, TypedError> {
    if let Some((position, entry)) = decimal_comma(text) {
        return Err(TypedError::DecimalComma { place: place.clone().at(position), entry: entry.to_owned() });
    }
    let numbered = entries(text).into_iter().enumerate();
    numbered.map(|(position, entry)| number(entry, || place.clone().at(position))).collect()
}

/// A list of points: `0,2 3/2,5`, `0,2; 3/2,5`, `(0,2),(3/2,5)` or JSON. With commas only, or with none, it is
/// a list of points of one coordinate: `0,1,2` or `0 1 2`.
///
/// # Errors
/// [`TypedError`], with the position of the first point that cannot be read.
pub fn points(text: &str) -> Result<Vec<Point>, TypedError> {
    let text = text.trim();
    if text.starts_with('[') {
        let points: Vec<Vec<Number>> = json::read(text).map_err(TypedError::PointsJson)?;
        return Ok(points.into_iter().map(|point| point.into_iter().map(|Number(c)| c).collect()).collect());
    }
    let place = Provenance::option("--points");
    let tight = text.split(',').map(str::trim).collect::<Vec<_>>().join(",");
    let groups: Vec<&str> = if text.contains(['(', ')']) {
        parenthesised(text)?
    } else if text.contains(';') {
        text.strip_suffix(';').unwrap_or(text).split(';').collect()
    } else if tight.contains(',') && tight.contains(char::is_whitespace) {
        tight.split_whitespace().collect()
    } else {
        let coordinates = numbers(text, &place)?;
        return Ok(coordinates.into_iter().map(|coordinate| vec![coordinate]).collect());
    };
    let numbered = groups.into_iter().enumerate();
    numbered.map(|(position, group)| numbers(group, &place.clone().at(position))).collect()
}

fn number(entry: &str, place: impl Fn() -> Provenance) -> Result<BigRational, TypedError> {
    parse_rational(entry).map_err(|error| TypedError::Number { place: place(), error })
}

/// In a list that has white space between its entries, the first entry with a comma and more behind it: `1,5` in
/// `0 1,5 6` and in `0, 1,5, 6`. The position is that of its first part.
fn decimal_comma(text: &str) -> Option<(usize, &str)> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let inner = |word: &&str| word.trim_matches(',').contains(',');
    let at = words.iter().position(|word| inner(word) || (word.starts_with(',') && *word != ","))?;
    let before = entries(words[..at].join(" ").trim_end_matches(',')).len();
    (words.len() > 1).then_some((before, words[at]))
}

/// The entries of a list; empty ones between two commas are kept, to be complained about.
fn entries(text: &str) -> Vec<&str> {
    if text.trim().is_empty() {
        return Vec::new();
    }
    let between_commas = |part| match str::trim(part) {
        "" => vec![""],
        part => part.split_whitespace().collect(),
    };
    text.split(',').flat_map(between_commas).collect()
}

/// What stands inside each pair of parentheses; between them commas, semicolons and white space.
fn parenthesised(text: &str) -> Result<Vec<&str>, TypedError> {
    let mut groups = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',' || c == ';');
        if rest.is_empty() {
            return Ok(groups);
        }
        let group = rest.strip_prefix('(').and_then(|rest| rest.split_once(')'));
        match group {
            Some((group, after)) if !group.contains('(') => {
                groups.push(group);
                rest = after;
            }
            _ => return Err(TypedError::Parentheses { position: groups.len(), found: rest.to_owned() }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{integer, rational};

    #[test]
    fn a_list_is_separated_by_commas_or_space() {
        let expected = [rational(-1, 1), rational(0, 1), rational(2, 5)];
        for text in ["-1,0,0.4", "-1 0 2/5", " -1, 0 , 2/5 ", "-1\t0\n2/5", "-1, 0 2/5"] {
            assert_eq!(numbers(text, &Provenance::option("--knots")).unwrap(), expected, "{text}");
        }
        assert!(numbers(" ", &Provenance::option("--knots")).unwrap().is_empty());
    }

    #[test]
    fn an_error_in_a_list_says_where() {
        for (text, expected) in [
            ("1,,2", "--knots, position 1: a number is missing here"),
            ("1, , 2", "--knots, position 1: a number is missing here"),
            ("1,2,", "--knots, position 2: a number is missing here"),
            ("1 1/0", "--knots, position 1: `1/0` divides by zero"),
        ] {
            let error = numbers(text, &Provenance::option("--knots")).unwrap_err();
            assert_eq!(error.to_string(), expected);
        }
    }

    #[test]
    fn a_decimal_comma_is_no_separator() {
        for (text, position, entry) in [
            ("0 0 0 1,5 6 6 6", 3, "1,5"),
            ("1,5 2", 0, "1,5"),
            ("0, 0, 1,5, 6", 2, "1,5,"),
            ("0 -0,5", 1, "-0,5"),
            ("0\t1\n2,25", 2, "2,25"),
            ("0,0,0 1 2", 0, "0,0,0"),
            ("0 ,5 1", 1, ",5"),
        ] {
            let error = numbers(text, &Provenance::option("--knots")).unwrap_err();
            let TypedError::DecimalComma { place, entry: found } = &error else { panic!("{text}: {error}") };
            assert_eq!(
                (place, found.as_str()),
                (&Provenance::option("--knots").at(position), entry),
                "{text}"
            );
            assert!(error.to_string().contains("decimal point"), "{error}");
        }
        for text in ["0,0,0,1,2", "0, 0, 1", "0 , 0 , 1", "0 0 1", "1,5", " 1,5 "] {
            assert!(numbers(text, &Provenance::option("--knots")).is_ok(), "{text}");
        }
        // Points are pairs; but in a point that is separated by spaces it is the same again.
        assert_eq!(points("0,0 1,2").unwrap().len(), 2);
        assert!(matches!(points("0 1,5; 2 3"), Err(TypedError::DecimalComma { .. })));
        assert!(matches!(points("(0 1,5 2)"), Err(TypedError::DecimalComma { .. })));
    }

    #[test]
    fn points_can_be_written_in_several_ways() {
        let expected = [vec![integer(0), integer(2)], vec![rational(3, 2), integer(5)]];
        for text in [
            "0,2 3/2,5",
            "0, 2  1.5 , 5",
            "0,2;3/2,5",
            "0 2; 3/2 5;",
            "(0,2),(3/2,5)",
            "(0, 2) (3/2 5)",
            "(0,2); (3/2,5)",
            r#"[["0","2"],["3/2","5"]]"#,
            "[[0, 2.0], [1.5, 5]]",
        ] {
            assert_eq!(points(text).unwrap(), expected, "{text}");
        }
        for text in ["0,1,2", "0 1 2", "0, 1, 2", "0;1;2", "(0),(1),(2)"] {
            assert_eq!(points(text).unwrap(), [[integer(0)], [integer(1)], [integer(2)]], "{text}");
        }
        assert_eq!(points("0,2;").unwrap(), [[integer(0), integer(2)]]);
    }

    #[test]
    fn an_error_in_points_says_where() {
        for (text, expected) in [
            ("0,2 x,5", "--points, position 1, coordinate 0: `x` is not a number"),
            ("0,2;3,", "--points, position 1, coordinate 1: a number is missing here"),
            ("0 x", "--points, position 1: `x` is not a number"),
            ("(0,2),(3", "--points, position 1: expected `(…)` and found `(3`"),
            ("(0,2)3,4", "--points, position 1: expected `(…)` and found `3,4`"),
            ("((0,2))", "--points, position 0: expected `(…)`"),
            (
                "[[0,1],[true]]",
                "--points: expected a number or a string with a number, and found a truth value",
            ),
        ] {
            let error = points(text).unwrap_err().to_string();
            assert!(error.starts_with(expected), "{text}: {error}");
        }
    }
}
