//! What the crate has to know of its own sources.

/// Only results of the search say which sources decided them.
#[cfg(feature = "search")]
mod decides;

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed=build");
    #[cfg(feature = "search")]
    decides::tell()?;
    Ok(())
}
