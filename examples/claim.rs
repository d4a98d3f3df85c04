//! A sentence about all basis functions, judged: true in every case that is tried and for every x there, or false with the smallest
//! counterexample.

use knotproof::judge::{Cases, Verdict, judge};
use knotproof::language::one_line;
use knotproof::meaning::Names;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Cases::new([]).up_to(2);
    for text in [
        "k; U; i in 0..n; x in (t[i], t[i+k+1]) : G[i](x) > 0",
        "k; U; x in [t[0], t[m]] : sum(i in 0..n: G[i](x)) = 1",
    ] {
        let sentence = one_line(text)?;
        match judge(&sentence, Names::empty(), &cases.of(&sentence, None))? {
            Verdict::Proved { reach, .. } => println!("{text}\n  holds in {} cases", reach.small_cases),
            Verdict::Refuted(witness) => println!("{text}\n  is false: {witness}"),
            other => println!("{text}\n  is {}", other.status()),
        }
    }
    Ok(())
}
