//! knotproof
pub mod analysis;
pub mod claims;
pub mod scalar;
pub mod spline;
pub mod cli {
    //! x
    /// x
    pub fn main() -> std::process::ExitCode {
        std::process::ExitCode::SUCCESS
    }
}
