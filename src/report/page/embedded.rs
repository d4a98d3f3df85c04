//! What the page carries along in `script` elements: the program's modules, and the certificates that one of them reads.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Map, Value, json};

use super::super::Report;

/// A module by its name, compressed and in letters.
pub(super) struct Module {
    pub(super) name: &'static str,
    pub(super) base64: String,
}

/// The modules, as `web/build.sh` makes them.
pub(super) fn modules() -> Vec<Module> {
    const BYTES: [(&str, &[u8]); 3] = [
        ("panel", include_bytes!("modules/panel.wasm.gz")),
        ("judge", include_bytes!("modules/judge.wasm.gz")),
        ("checker", include_bytes!("modules/checker.wasm.gz")),
    ];
    BYTES.iter().map(|(name, bytes)| Module { name, base64: STANDARD.encode(bytes) }).collect()
}

/// The certificates that the checker has accepted, by their names, each a statement and a proof: likewise.
///
/// # Errors
/// None but of the compression, which writes into memory.
pub(super) fn certificates(report: &Report<'_>) -> io::Result<String> {
    let texts = report.certificates.iter().map(|(name, certified)| {
        let of = &certified.certificate;
        (name.clone(), json!([of.statement_text(), of.proof_text()]))
    });
    let all = Value::Object(texts.collect::<Map<_, _>>());
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(all.to_string().as_bytes())?;
    Ok(STANDARD.encode(packed.finish()?))
}
