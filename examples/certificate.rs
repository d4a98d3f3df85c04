//! A proof of a claim for every knot vector and every index, which the independent checker reads.

use knotproof::certificate::certify;
use knotproof::language::{Form, claims};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The functions add up to 1, as amended: where there are enough of them.
    let claim = claims().into_iter().find(|claim| claim.id() == "T3.5.3").ok_or("no such claim")?;
    let certificate = certify(claim, Form::Amended, None)?.ok_or("nothing is stated formally")?;
    let checked = certificate.check()?;
    println!("{}", claim.text(Form::Amended));
    println!("accepted in degrees {:?}; the statement:", checked.degrees);
    println!("{}", certificate.statement_text());
    Ok(())
}
