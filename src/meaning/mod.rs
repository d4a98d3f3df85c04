//! Floor 4: what a formula says on an instance: exact, for every x.
//!
//! An [`Instance`] has numbers for knots, degree and index; x runs over the cells of the line, on each of which every term is
//! a rational function of one coordinate. [`decide`] reads a sentence on an instance; words have deciders in `words`. No
//! claim is known here.

mod adjectives;
mod cell;
mod example;
mod family;
mod frame;
mod functions;
mod instance;
mod local;
mod points;
mod reading;
mod reals;
mod seen;
mod sentence;
mod tries;
mod truth;
mod value;
mod words;

pub use adjectives::has;
pub use cell::{Cell, Focus, Frame, Signs};
pub use example::{Example, examples, examples_named, examples_of, row_faults};
pub use family::{FamilyMember, MemberError, Values, Weighting, setting};
pub use instance::Instance;
pub use reading::{Bound, Found, Library, Look, Names, Reading};
pub use reals::Part;
pub use sentence::{Decided, Failure, Given, admits, concerns, decide, listed};
pub use truth::{Stop, Truth};
pub use value::{Fraction, Plain, Value};
pub use words::tie;
