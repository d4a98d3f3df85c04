//! Floor 4: the paper's claims and their verdicts.

mod instances;

pub use instances::{Instance, instances, instances_named};
