//! Floor 3: from exact pieces to decisions about every x.

mod pieces;

pub use pieces::{Piece, Pieces, SpanPieces, constant, coordinate_of, positive_coordinate};
