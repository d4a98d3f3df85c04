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
        write!(f, ", arXiv {} ({} in the listing). Version read: {}. ", self.arxiv, self.listed, self.read)?;
        write!(f, "Missing from it: {}.", self.missing.join("; "))
    }
}

#[cfg(test)]
mod tests {
    use crate::language::paper;

    #[test]
    fn the_paragraph_says_what_was_read_and_what_is_missing() {
        let about = &paper().about;
        let text = about.to_string();
        for part in [&about.title, &about.arxiv, &about.listed, &about.read] {
            assert!(text.contains(part), "{part}");
        }
        assert!(about.missing.iter().all(|missing| text.contains(missing)) && text.contains("appendix"));
        assert!(!text.contains(" by "), "no authors are made up");
    }
}
