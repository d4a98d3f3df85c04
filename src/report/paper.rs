//! What was read: the paper, and the version of it that the claims are taken from.

use std::fmt;

use crate::language::About;

/// One paragraph.
impl fmt::Display for About {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "“{}”", self.title)?;
        if !self.authors.is_empty() {
            write!(f, " by {}", self.authors.join(", "))?;
        }
        if let Some(source) = &self.source {
            write!(f, ", {source}")?;
        }
        if let Some(arxiv) = &self.arxiv {
            write!(f, ", arXiv {arxiv}")?;
        }
        if let Some(listed) = &self.listed {
            write!(f, " ({listed} in the listing)")?;
        }
        f.write_str(".")?;
        if let Some(read) = &self.read {
            write!(f, " Version read: {read}.")?;
        }
        match self.missing.as_slice() {
            [] => Ok(()),
            missing => write!(f, " Missing from it: {}.", missing.join("; ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::language::paper;

    #[test]
    fn the_paragraph_says_what_was_read_and_what_is_missing() {
        let about = &paper().about;
        let text = about.to_string();
        let numbers = [&about.arxiv, &about.listed, &about.read].map(|part| part.as_ref().unwrap());
        for part in numbers.into_iter().chain([&about.title]) {
            assert!(text.contains(part), "{part}");
        }
        assert!(about.missing.iter().all(|missing| text.contains(missing)) && text.contains("appendix"));
        assert!(!text.contains(" by "), "no authors are made up");
    }
}
