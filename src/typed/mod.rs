//! Floor 5: what people type: numbers, lists, points, settings of a family, and the basis and the curve that they make. The
//! command line and the panel of the page read it alike, and complain in the same words.

mod asked;
mod error;
mod lists;
mod member;
mod provenance;
mod whole_number;

pub use asked::{Asked, Case, curve, knot_vector, point};
pub use error::TypedError;
pub use lists::{numbers, points};
pub use member::{ChosenFamily, family_named};
pub use provenance::Provenance;
pub use whole_number::{WholeNumberError, whole_number};
