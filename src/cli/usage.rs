//! What the argument parser has to say: help, the version, and errors of usage.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::exit::Exit;
use super::output::{Format, Output};

/// The format that the raw arguments ask for: errors are written in it, also when the arguments are wrong.
pub(super) fn asked_format(arguments: &[OsString]) -> Format {
    let separate = arguments.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json");
    let joined = arguments.iter().any(|argument| argument == "--format=json");
    if separate || joined { Format::Json } else { Format::Text }
}

/// Writes help and version to standard output, and errors to standard error.
pub(super) fn answer(error: &clap::Error, errors: Output) -> Exit {
    if !error.use_stderr() {
        return match errors.text(&error.render().ansi().to_string()) {
            Ok(()) => Exit::Holds,
            Err(failed) => {
                errors.error(&failed.to_string(), failed.argument());
                failed.exit()
            }
        };
    }
    let help_wanted = error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand;
    if help_wanted && errors.format() == Format::Text {
        // Nobody is left to be told that standard error is closed.
        let _ = error.print();
    } else {
        errors.error(&message(error), argument(error).as_deref());
    }
    Exit::Usage
}

/// The message on one line, without the pointers to the help.
fn message(error: &clap::Error) -> String {
    let text = error.to_string();
    let lines = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with("Usage:") && !line.starts_with("For more info"));
    let line = lines.collect::<Vec<_>>().join(" ");
    line.strip_prefix("error: ").map_or(line.clone(), str::to_owned)
}

/// The options to blame, without the names of their values.
fn argument(error: &clap::Error) -> Option<String> {
    let name = |text: &str| text.split([' ', '=']).next().unwrap_or(text).to_owned();
    match error.get(ContextKind::InvalidArg)? {
        ContextValue::String(text) => Some(name(text)),
        ContextValue::Strings(texts) => {
            Some(texts.iter().map(|text| name(text)).collect::<Vec<_>>().join(" "))
        }
        _ => None,
    }
}
