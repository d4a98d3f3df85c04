//! What is to be proved of the claims, read from the paper's file of windows: the prover looks for proofs of its goals, and
//! the checker that reads them knows neither. A claim in words is judged by its conclusion on finitely many cases; here it is
//! said of every knot vector and every α, or of every α, or it is refuted by one witness.

use std::sync::{Arc, Mutex, PoisonError};

use serde::Deserialize;
use thiserror::Error;

use crate::judge::{Scope, Witness};
use crate::language::{Claim, Complaint, Form, Paper};

/// Where the windows are, in the folder of a paper.
const FILE: &str = "windows.toml";

/// The windows and goals of one statement about a claim: an entry of the file.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(try_from = "Entry")]
pub struct Windows {
    /// The claim.
    pub claim: String,
    /// Which of its statements: no single degree, as what is argued of one is of others.
    pub form: Form,
    /// How far they reach.
    pub scope: Scope,
    /// The degrees, rising.
    pub degrees: Vec<usize>,
    /// What can't be derived from the sentence.
    pub argued: Option<Argued>,
    /// Of a refutation: for each degree [`Witness::given`] of the witness that the goals are about.
    pub refutes: Option<Vec<Numbers>>,
    /// The degrees in which that is a counterexample of its own, and not the one that the engine finds.
    pub own: Vec<usize>,
}

/// What is given for a witness, by names.
pub type Numbers = Vec<(String, String)>;

/// As it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    claim: String,
    form: String,
    scope: Scope,
    degrees: Vec<usize>,
    because: Option<String>,
    sections: Option<String>,
    refutes: Option<Vec<Numbers>>,
    #[serde(default)]
    own: Vec<usize>,
}

impl TryFrom<Entry> for Windows {
    type Error = &'static str;

    fn try_from(entry: Entry) -> Result<Self, Self::Error> {
        let Entry { claim, form, scope, degrees, because, sections, refutes, own } = entry;
        let argued = match (because, sections) {
            (Some(because), Some(sections)) => Some(Argued { because, sections }),
            (None, None) => None,
            _ => {
                return Err(
                    "`because` and `sections` stand together: write both, or neither for what is derived",
                );
            }
        };
        let form = [Form::Printed, Form::Amended, Form::Fails, Form::Degrees]
            .into_iter()
            .find(|known| known.name() == form)
            .ok_or("`form` is printed, amended, fails or degrees")?;
        Ok(Self { claim, form, scope, degrees, argued, refutes, own })
    }
}

/// Windows and goals that don't follow from the sentence: it has a word, or says what no rule derives.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Argued {
    /// Why the goals are the claim, or refute it.
    pub because: String,
    /// The sections, as text.
    pub sections: String,
}

/// Why there are no windows to look up.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum WindowsError {
    /// The file is not as it should be.
    #[error("{FILE}: {0}")]
    File(#[from] toml::de::Error),
    /// A refutation that the engine does not find any more.
    #[error(
        "the windows of this refutation are about another witness: {FILE} has {}, and the engine finds {}; write the \
         windows anew for what is found, or remove them, and the refutation is left without a certificate",
        listed(.stated), listed(.found)
    )]
    OtherWitness {
        /// What is given in the file.
        stated: Numbers,
        /// What the engine gives.
        found: Numbers,
    },
}

/// `k = 1, U = (0, 0, 1, 1), α = -1`.
pub(super) fn listed(given: &[(String, String)]) -> String {
    given.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    window: Vec<Windows>,
}

fn parse(text: &str) -> Result<Vec<Windows>, toml::de::Error> {
    toml::from_str(text).map(|File { window }| window)
}

/// All entries of a file, in the order of the register of claims. A long file is parsed once, and not for each claim.
fn all_windows(text: &Arc<str>) -> Result<Arc<Vec<Windows>>, WindowsError> {
    type Read = (Arc<str>, Arc<Vec<Windows>>);
    static LAST: Mutex<Option<Read>> = Mutex::new(None);
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((of, all)) = &*last
        && Arc::ptr_eq(of, text)
    {
        return Ok(Arc::clone(all));
    }
    let all = Arc::new(parse(text)?);
    *last = Some((Arc::clone(text), Arc::clone(&all)));
    Ok(all)
}

/// What keeps the windows of a paper from being read, with its place.
#[must_use]
pub fn window_fault(paper: &Paper) -> Option<Complaint> {
    let error = parse(&paper.windows).err()?;
    let advice = "write `[[window]]` as that of the paper that comes with the program has it";
    Some(Complaint::in_file((FILE, &paper.windows), error.span().unwrap_or(0..0), error.message(), advice))
}

/// The windows of a statement about a claim: that it is true, or, with a witness, that it is false. `None` if it is not
/// stated formally. For one degree those that are for others, too.
///
/// # Errors
/// [`WindowsError`], if the file is not as it should be, or refutes the claim by another witness.
pub fn windows(
    claim: Claim<'_>,
    form: Form,
    witness: Option<&Witness>,
) -> Result<Option<Windows>, WindowsError> {
    let all = all_windows(&claim.paper.windows)?;
    let find = |form, degree: Option<usize>| {
        all.iter().find(|windows| {
            let is_it = windows.form == form && windows.refutes.is_some() == witness.is_some();
            windows.claim == claim.id() && is_it && degree.is_none_or(|k| windows.degrees.contains(&k))
        })
    };
    let found = match form {
        Form::Degree(k) => find(Form::Degrees, Some(k)).or_else(|| find(Form::Printed, Some(k))),
        form => find(form, None),
    };
    if let (Some(Windows { refutes: Some(stated), degrees, own, .. }), Some(witness)) = (found, witness) {
        // A sentence about weights alone has no degree.
        let place = degrees.iter().position(|k| witness.k == Some(*k)).unwrap_or(0);
        let stated = stated.get(place).cloned().unwrap_or_default();
        if !own.contains(&degrees[place]) && stated != witness.given() {
            return Err(WindowsError::OtherWitness { stated, found: witness.given() });
        }
    }
    Ok(found.cloned())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::certificate::Sexp;
    use crate::judge::Shows;
    use crate::language::{claims, paper};

    /// What is wrong with the entries of a file, beyond what keeps it from being read.
    fn faults(all: &[Windows]) -> Vec<String> {
        let claims = claims();
        let claim_of = |windows: &Windows| claims.iter().position(|claim| claim.id() == windows.claim);
        let mut seen = BTreeSet::new();
        let mut faults = Vec::new();
        for windows in all {
            let Windows { claim, form, scope, degrees, argued, refutes, own } = windows;
            let has_amendment = claim_of(windows).is_none_or(|claim| claims[claim].stanza.amended.is_some());
            let is_section = |item: &Sexp| item.as_form().is_some_and(|(head, _)| head == "section");
            let read = argued.as_ref().is_none_or(|argued| {
                Sexp::parse_all(&argued.sections)
                    .is_ok_and(|items| !items.is_empty() && items.iter().all(is_section))
            });
            let wrong = [
                (!seen.insert((claim, form, refutes.is_some())), "stated twice"),
                (claim_of(windows).is_none(), "no claim of the register"),
                (*form == Form::Amended && !has_amendment, "the claim has no amendment"),
                (
                    refutes.as_ref().is_some_and(|of| (*scope, of.len()) != (Scope::Instance, degrees.len())),
                    "a witness is one instance",
                ),
                (degrees.is_empty() || !degrees.is_sorted_by(|a, b| a < b), "the degrees do not rise"),
                (argued.as_ref().is_some_and(|argued| argued.because.trim().is_empty()), "no reason"),
                (!read, "not a list of sections"),
                (
                    !own.iter().all(|k| refutes.is_some() && degrees.contains(k)),
                    "only a refutation has a witness",
                ),
            ];
            let wrong = wrong.iter().filter(|(wrong, _)| *wrong);
            faults.extend(wrong.map(|(_, what)| format!("{claim}, {form}: {what}")));
        }
        if !all.iter().filter_map(claim_of).is_sorted() {
            faults.push("not in the order of the register".into());
        }
        faults
    }

    #[test]
    fn the_file_has_no_faults() {
        let all = all_windows(&paper().windows).unwrap();
        assert!(all.len() > 100, "only {} entries", all.len());
        assert_eq!(faults(&all), Vec::<String>::new());
    }

    const ENTRY: &str = "[[window]]\nclaim = \"T3.5.2\"\nform = \"printed\"\nscope = \"knots\"\ndegrees = [1, 2]\n\
        because = \"so\"\nsections = '''\n(section (goals (> 1 0)))\n'''\n";

    #[test]
    fn faults_of_a_file_are_noticed() {
        let found = |text: &str| faults(&parse(text).unwrap());
        assert!(found(ENTRY).is_empty());
        assert!(
            found(&format!(
                "{ENTRY}{}",
                ENTRY.replace("so\"", "so\"\nrefutes = [[]]").replace("knots", "instance").replace("1, ", "")
            ))
            .is_empty()
        );
        assert_eq!(found(&ENTRY.repeat(2)), ["T3.5.2, printed: stated twice"]);
        let other = ENTRY.replace("T3.5.2", "T3.5.1");
        assert_eq!(found(&format!("{ENTRY}{other}")), ["not in the order of the register"]);
        for (part, instead, fault) in [
            ("T3.5.2", "T3.5.0", "no claim of the register"),
            ("printed", "amended", "the claim has no amendment"),
            ("so\"", "so\"\nrefutes = []", "a witness is one instance"),
            ("1, 2", "2, 1", "the degrees do not rise"),
            ("so", " ", "no reason"),
            ("(section", "(goals", "not a list of sections"),
            ("(> 1 0)", "(> 1 0", "not a list of sections"),
        ] {
            let faults = found(&ENTRY.replace(part, instead));
            assert!(matches!(&faults[..], [only] if only.ends_with(fault)), "{fault}: {faults:?}");
        }
    }

    /// These are no files of windows: the error says where, and what is expected.
    #[test]
    fn what_cannot_be_read_is_refused() {
        for (part, instead, said) in [
            (
                "\"knots\"",
                "\"somewhere\"",
                "unknown variant `somewhere`, expected one of `points`, `instance`",
            ),
            ("because", "why", "unknown field `why`"),
            ("printed", "degree-2", "`form` is printed, amended, fails or degrees"),
            ("because = \"so\"\n", "", "`because` and `sections` stand together"),
            ("[1, 2]", "[-1]", "invalid value: integer `-1`"),
            ("[[window]]", "[[windows]]", "unknown field `windows`"),
        ] {
            let error = WindowsError::from(parse(&ENTRY.replace(part, instead)).unwrap_err()).to_string();
            assert!(error.starts_with(FILE) && error.contains("line ") && error.contains(said), "{error}");
        }
    }

    /// Silence would let a certificate of a refutation vanish.
    #[test]
    fn a_refutation_by_another_witness_is_an_error() {
        let all = all_windows(&paper().windows).unwrap();
        let refuted = all.iter().find(|windows| windows.claim == "abstract.classical").unwrap();
        let claim = *claims().iter().find(|claim| claim.id() == "abstract.classical").unwrap();
        let knots = ["0", "0", "1", "1"].map(str::to_owned).to_vec();
        let mut witness = Witness {
            family: None,
            instance: None,
            k: Some(1),
            knots,
            alpha: "-1".into(),
            given: Vec::new(),
            conclusion: Some(0),
            claimed: String::new(),
            shows: Shows::Fails,
            looked: Vec::new(),
            words: Vec::new(),
        };
        let find = |witness: &Witness| windows(claim, Form::Printed, Some(witness));
        assert_eq!(find(&witness), Ok(Some(refuted.clone())));
        witness.alpha = "2".into();
        let error = find(&witness).unwrap_err().to_string();
        for part in ["α = -1", "α = 2", FILE, "write the windows anew"] {
            assert!(error.contains(part), "{part} in {error}");
        }
        // What is not stated formally is none.
        assert_eq!(windows(claim, Form::Degree(2), Some(&witness)), Ok(None));
        assert_eq!(windows(claim, Form::Printed, None), Ok(None));
    }
}
