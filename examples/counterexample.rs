//! The smallest functions of degree 3 with more than one local maximum.

use std::convert::Infallible;

use knotproof::search::{Goal, Limits, Portion, Search, Shard, Space};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let space = Space::Exhaustive(Limits { size: 9, gap: None, height: None });
    let mut portion = Portion::new(Search { degree: 3, find: Goal::Several, space }, Shard::WHOLE)?;
    portion.run(|_| Ok::<_, Infallible>(()))?;
    println!("{} functions, all decided exactly", portion.decided().cases());
    for record in portion.findings().records() {
        println!("{}", record.reproduce);
    }
    Ok(())
}
