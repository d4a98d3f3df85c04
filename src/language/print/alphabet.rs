//! The alphabets: the source and Unicode on one line, LaTeX, HTML with MathML.

use std::fmt::Write as _;

use super::form::{Big, Form, GREEK, Operator};

/// One line, of the source or for people; inside of a script without spaces.
pub(super) fn line_of(form: &Form, source: bool) -> String {
    let mut out = String::new();
    line(form, source, false, &mut out);
    out
}

fn line(form: &Form, source: bool, tight: bool, out: &mut String) {
    match form {
        Form::Words(text) | Form::Atom(text) => out.push_str(text),
        Form::Operator(operator) => {
            let sign = if source { operator.0 } else { operator.1 };
            // Products and fractions stand together; a comma has its space behind it.
            let together = tight || matches!(sign, "*" | "/" | "·" | ", ");
            let (space, sign) = if together { ("", sign) } else { (" ", sign) };
            out.extend([space, if tight { sign.trim_end() } else { sign }, space]);
        }
        Form::Prefix(operator) => out.push_str(if source { operator.0 } else { operator.1 }),
        Form::Row(all) => all.iter().for_each(|form| line(form, source, tight, out)),
        Form::Tight(inner) => line(inner, source, true, out),
        Form::Fence(open, inner, close) => {
            out.push_str(open);
            line(inner, source, tight, out);
            out.push_str(close);
        }
        Form::Script(base, below, above) => {
            line(base, source, tight, out);
            if let Some(below) = below {
                let (open, close) = if source { ("[", "]") } else { ("_{", "}") };
                script(below, [open, close], source, out);
            }
            if let Some(above) = above {
                let braces = if source { ["^", ""] } else { ["^{", "}"] };
                script(above, braces, source, out);
            }
        }
        Form::Before(above, base) => {
            script(above, ["^{", "}"], source, out);
            line(base, source, tight, out);
        }
        Form::Fraction([top, bottom]) => {
            for ((form, brackets), sign) in [(top, "/"), (bottom, "")] {
                let (open, close) = if *brackets { ("(", ")") } else { ("", "") };
                out.push_str(open);
                line(form, source, tight, out);
                out.extend([close, sign]);
            }
        }
        Form::Big(big, below, above) => {
            out.push_str(match big {
                Big::Sum => "Σ",
                Big::Product => "Π",
                Big::Least => "min",
                Big::Greatest => "max",
            });
            script(below, ["_{", "}"], source, out);
            if let Some(above) = above {
                script(above, ["^{", "}"], source, out);
            }
            out.push(' ');
        }
        Form::Root(of) => {
            out.push('√');
            line(of, source, tight, out);
        }
    }
}

/// In braces, but for a single letter or a number.
fn script(form: &Form, [open, close]: [&str; 2], source: bool, out: &mut String) {
    let mut inner = String::new();
    line(form, source, true, &mut inner);
    let plain = !source && inner.chars().count() == 1;
    match open.strip_suffix('{').filter(|_| plain) {
        Some(mark) => out.extend([mark, &inner]),
        None => out.extend([open, &inner, close]),
    }
}

/// Words, and formulas between dollars.
pub(super) fn latex_of(form: &Form) -> String {
    let math = |run: &[&Form], out: &mut String| {
        out.push('$');
        run.iter().for_each(|form| latex(form, out));
        out.push('$');
    };
    let plain = |words: &str, out: &mut String| out.push_str(&escaped_latex(words));
    runs(form, math, plain)
}

fn escaped_latex(words: &str) -> String {
    words.replace('_', r"\_").replace('&', r"\&").replace('%', r"\%").replace('#', r"\#")
}

fn latex(form: &Form, out: &mut String) {
    let group = |mark: &str, form: &Form, out: &mut String| {
        out.extend([mark, "{"]);
        latex(form, out);
        out.push('}');
    };
    match form {
        Form::Words(text) => out.extend([r"\text{", &escaped_latex(text), "}"]),
        Form::Atom(text) => out.push_str(&atom_in_latex(text)),
        Form::Operator(operator) => out.extend([" ", operator.2, " "]),
        Form::Prefix(operator) => out.push_str(operator.2),
        Form::Row(all) => all.iter().for_each(|form| latex(form, out)),
        Form::Tight(inner) => latex(inner, out),
        Form::Fence(open, inner, close) => {
            let brace = |fence: &str| {
                if matches!(fence, "{" | "}") { format!(r"\{fence}") } else { fence.to_owned() }
            };
            let _ = write!(out, r"\left{}", brace(open));
            latex(inner, out);
            let _ = write!(out, r"\right{}", brace(close));
        }
        Form::Script(base, below, above) => {
            match **base {
                Form::Atom(_) => latex(base, out),
                _ => group("", base, out),
            }
            below.iter().for_each(|form| group("_", form, out));
            above.iter().for_each(|form| group("^", form, out));
        }
        Form::Before(above, base) => {
            group("{}^", above, out);
            latex(base, out);
        }
        Form::Fraction([(top, _), (bottom, _)]) => {
            group(r"\frac", top, out);
            group("", bottom, out);
        }
        Form::Big(big, below, above) => {
            let sign = match big {
                Big::Sum => r"\sum",
                Big::Product => r"\prod",
                Big::Least => r"\min",
                Big::Greatest => r"\max",
            };
            group(&format!("{sign}_"), below, out);
            above.iter().for_each(|form| group("^", form, out));
            out.push(' ');
        }
        Form::Root(of) => group(r"\sqrt", of, out),
    }
}

fn atom_in_latex(text: &str) -> String {
    const SYMBOLS: &[(&str, &str)] =
        &[("∞", r"\infty"), ("…", r"\dots"), ("′", "'"), ("⁺", "^+"), ("⁻", "^-")];
    let written = SYMBOLS.iter().fold(text.to_owned(), |text, (sign, latex)| text.replace(sign, latex));
    let written = GREEK.iter().fold(written, |text, (name, sign)| text.replace(*sign, &format!(r"\{name}")));
    let below = written.find(|c| ('₀'..='₉').contains(&c));
    let (stem, digits) = written.split_at(below.unwrap_or(written.len()));
    let digits: String = digits.chars().filter_map(|c| char::from_digit(c as u32 - '₀' as u32, 10)).collect();
    let word = stem.len() > 1
        && stem.chars().all(|c| c.is_ascii_alphanumeric())
        && !stem.starts_with(|c: char| c.is_ascii_digit());
    let stem = if word { format!(r"\mathrm{{{stem}}}") } else { stem.to_owned() };
    if digits.is_empty() { stem } else { format!("{stem}_{{{digits}}}") }
}

/// Words as words, and each run of anything else as a formula.
fn runs(form: &Form, math: impl Fn(&[&Form], &mut String), plain: impl Fn(&str, &mut String)) -> String {
    let mut flat = Vec::new();
    flatten(form, &mut flat);
    let mut out = String::new();
    for run in flat.chunk_by(|a, b| matches!(a, Form::Words(_)) == matches!(b, Form::Words(_))) {
        match run {
            [Form::Words(_), ..] => run.iter().for_each(|form| {
                if let Form::Words(text) = form {
                    plain(text, &mut out);
                }
            }),
            _ => math(run, &mut out),
        }
    }
    out
}

fn flatten<'a>(form: &'a Form, out: &mut Vec<&'a Form>) {
    match form {
        Form::Row(all) => all.iter().for_each(|form| flatten(form, out)),
        other => out.push(other),
    }
}

/// Words, and formulas in MathML; the first one is annotated with the source of the whole.
pub(super) fn html(form: &Form, source: &str) -> String {
    let annotated = std::cell::Cell::new(false);
    let math = |run: &[&Form], out: &mut String| {
        let mut row = String::new();
        run.iter().for_each(|form| mathml(form, &mut row));
        let _ = match annotated.replace(true) {
            true => write!(out, "<math><mrow>{row}</mrow></math>"),
            false => write!(
                out,
                "<math><semantics><mrow>{row}</mrow><annotation encoding=\"application/x-knotproof\">{}</annotation></semantics></math>",
                escaped(source)
            ),
        };
    };
    runs(form, math, |words, out| out.push_str(&escaped(words)))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn mathml(form: &Form, out: &mut String) {
    // Writing to a string cannot fail.
    let element = |name: &str, parts: &[&Form], out: &mut String| {
        let _ = write!(out, "<{name}>");
        for part in parts {
            out.push_str("<mrow>");
            mathml(part, out);
            out.push_str("</mrow>");
        }
        let _ = write!(out, "</{name}>");
    };
    match form {
        Form::Words(text) => {
            let _ = write!(out, "<mtext>{}</mtext>", escaped(&text.replace(' ', "\u{a0}")));
        }
        Form::Atom(text) => {
            let tag = match text.chars().next() {
                Some(c) if c.is_ascii_digit() => "mn",
                Some('′' | '⁺' | '⁻' | '…' | ',') => "mo",
                _ => "mi",
            };
            let _ = write!(out, "<{tag}>{}</{tag}>", escaped(text));
        }
        Form::Operator(Operator(_, ", ", _)) => out.push_str("<mo separator=\"true\">,</mo>"),
        Form::Operator(operator) => {
            let _ = write!(out, "<mo>{}</mo>", escaped(operator.1));
        }
        Form::Prefix(operator) => {
            let _ = write!(out, "<mo form=\"prefix\">{}</mo>", operator.1);
        }
        Form::Row(all) => all.iter().for_each(|form| mathml(form, out)),
        Form::Tight(inner) => mathml(inner, out),
        Form::Fence(open, inner, close) => {
            let fence = |fence: &str| format!("<mo stretchy=\"false\">{fence}</mo>");
            let _ = write!(out, "<mrow>{}", fence(open));
            mathml(inner, out);
            let _ = write!(out, "{}</mrow>", fence(close));
        }
        Form::Script(base, Some(below), Some(above)) => element("msubsup", &[base, below, above], out),
        Form::Script(base, Some(below), None) => element("msub", &[base, below], out),
        Form::Script(base, None, Some(above)) => element("msup", &[base, above], out),
        Form::Script(base, None, None) => mathml(base, out),
        Form::Before(above, base) => {
            element("msup", &[&Form::Row(Vec::new()), above], out);
            mathml(base, out);
        }
        Form::Fraction([(top, _), (bottom, _)]) => element("mfrac", &[top, bottom], out),
        Form::Big(big, below, above) => {
            let sign = Form::Prefix(match big {
                Big::Sum => Operator("", "∑", ""),
                Big::Product => Operator("", "∏", ""),
                Big::Least => Operator("", "min", ""),
                Big::Greatest => Operator("", "max", ""),
            });
            match above {
                Some(above) => element("munderover", &[&sign, below, above], out),
                None => element("munder", &[&sign, below], out),
            }
        }
        Form::Root(of) => element("msqrt", &[of], out),
    }
}
