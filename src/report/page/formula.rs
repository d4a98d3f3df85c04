//! Statements as HTML: the formulas in them, written in plain Unicode, as MathML.
//!
//! The notation is that of the claims: `_` and `^` with one symbol, a number or a group in braces; digits and primes as
//! superscripts; `^α` before a function; `Σ_{…}^{…}`; `/` between neighbours without spaces. All other words stay words. A browser
//! that knows no MathML shows the symbols in a row.

use std::fmt::Write as _;
use std::iter::Peekable;
use std::str::Chars;

use super::escape::escape;

/// What a text is made of.
#[derive(Debug, Clone, PartialEq)]
enum Item {
    /// White space.
    Space,
    /// Words and their punctuation.
    Word(String),
    /// A finished piece of MathML that can stand for itself: a variable, a number, a group.
    Atom(String),
    /// A relation or operation.
    Operator(char),
    /// Whether it belongs to a formula is decided by its neighbours.
    Group { open: char, items: Vec<Item>, close: Option<char> },
}

/// Names that are words although they end in digits: the paper's instances.
const INSTANCES: [char; 3] = ['U', 'S', 'C'];
/// Names that are set upright in formulas.
const FUNCTIONS: [&str; 3] = ["sup", "max", "min"];
const RELATIONS: &str = "=≠<>≤≥→↦⇔∈";
const OPERATIONS: &str = "+−·∪|…";

/// The text as HTML with MathML, everything escaped.
pub(super) fn html(text: &str) -> String {
    let items = parse(&mut text.chars().peekable(), None);
    let mut out = String::with_capacity(4 * text.len());
    render(&items, &mut out);
    out
}

fn parse(chars: &mut Peekable<Chars>, close: Option<&mut Option<char>>) -> Vec<Item> {
    let mut items = Vec::new();
    let nested = close.is_some();
    let mut closed = None;
    while let Some(&c) = chars.peek() {
        match c {
            ')' | ']' | '}' if nested => {
                chars.next();
                closed = Some(c);
                break;
            }
            '(' | '[' | '{' => {
                chars.next();
                items.push(group(c, chars));
            }
            _ if c.is_whitespace() => {
                chars.next();
                items.push(Item::Space);
            }
            '_' | '^' => {
                chars.next();
                script(c, chars, &mut items);
            }
            '⁰'..='⁹' | '²' | '³' | '′' => {
                chars.next();
                raise(&mut items, &superscript(c));
            }
            'Σ' => {
                chars.next();
                items.push(sum(chars));
            }
            '∞' | 'α'..='ω' => {
                chars.next();
                items.push(Item::Atom(identifier(&c.to_string())));
            }
            '√' => {
                chars.next();
                let radicand = one_symbol(chars);
                items.push(Item::Atom(format!("<msqrt>{radicand}</msqrt>")));
            }
            '/' => {
                chars.next();
                fraction(chars, &mut items);
            }
            '-' if chars.clone().nth(1).is_some_and(|next| next.is_ascii_digit()) => {
                chars.next();
                items.push(Item::Operator('−'));
            }
            _ if c.is_ascii_digit() => items.push(Item::Atom(number(chars))),
            _ if c.is_alphabetic() => letters(chars, &mut items),
            _ if RELATIONS.contains(c) || OPERATIONS.contains(c) => {
                chars.next();
                items.push(Item::Operator(c));
            }
            _ => {
                chars.next();
                items.push(Item::Word(c.to_string()));
            }
        }
    }
    if let Some(close) = close {
        *close = closed;
    }
    items
}

fn group(open: char, chars: &mut Peekable<Chars>) -> Item {
    let mut close = None;
    let items = parse(chars, Some(&mut close));
    Item::Group { open, items, close }
}

fn identifier(name: &str) -> String {
    format!("<mi>{}</mi>", escape(name))
}

fn number(chars: &mut Peekable<Chars>) -> String {
    let mut digits = String::new();
    while let Some(c) = chars.next_if(char::is_ascii_digit) {
        digits.push(c);
    }
    // A point between digits, as in the number of an illustration.
    if chars.peek() == Some(&'.') && chars.clone().nth(1).is_some_and(|next| next.is_ascii_digit()) {
        digits.push('.');
        chars.next();
        while let Some(c) = chars.next_if(char::is_ascii_digit) {
            digits.push(c);
        }
    }
    format!("<mn>{digits}</mn>")
}

/// A run of letters: a variable, a derivative `DG` or `Dw`, a known function, the name of an instance, or a word.
fn letters(chars: &mut Peekable<Chars>, items: &mut Vec<Item>) {
    let mut run = String::new();
    while let Some(c) = chars.next_if(|c| c.is_alphabetic() && !('α'..='ω').contains(c)) {
        run.push(c);
    }
    let digit = chars.peek().is_some_and(char::is_ascii_digit);
    let mut symbols = run.chars();
    match (symbols.next(), symbols.next(), symbols.next()) {
        (Some(name), None, _) if digit && INSTANCES.contains(&name) => {
            while let Some(c) = chars.next_if(char::is_ascii_alphanumeric) {
                run.push(c);
            }
            items.push(Item::Word(run));
        }
        (Some(_), None, _) if digit => {
            let index = number(chars);
            items.push(Item::Atom(format!("<msub>{}{index}</msub>", identifier(&run))));
        }
        (Some(_), None, _) => items.push(Item::Atom(identifier(&run))),
        (Some('D'), Some(function @ ('G' | 'w')), None) => {
            items.push(Item::Atom("<mi mathvariant=\"normal\">D</mi>".to_owned()));
            items.push(Item::Atom(identifier(&function.to_string())));
        }
        // kα, and the like: two letters that go on as a formula.
        _ if FUNCTIONS.contains(&run.as_str()) => items.push(Item::Atom(format!("<mi>{run}</mi>"))),
        _ => {
            // A hyphen or an apostrophe inside of a word.
            while matches!(chars.peek(), Some('-' | '\'' | '’'))
                && chars.clone().nth(1).is_some_and(char::is_alphabetic)
            {
                run.extend(chars.next());
                while let Some(c) = chars.next_if(|c| c.is_alphabetic()) {
                    run.push(c);
                }
            }
            items.push(Item::Word(run));
        }
    }
}

fn superscript(c: char) -> String {
    let digit = match c {
        '²' => '2',
        '³' => '3',
        '′' => return "<mo>′</mo>".to_owned(),
        '⁰' => '0',
        '⁴'..='⁹' => char::from_digit(u32::from(c) - u32::from('⁰'), 10).unwrap_or('?'),
        other => other,
    };
    format!("<mn>{digit}</mn>")
}

/// What follows `_`, `^` or `√`: a group in braces or parentheses without them, a number, or a letter.
fn one_symbol(chars: &mut Peekable<Chars>) -> String {
    match chars.peek().copied() {
        Some(open @ ('{' | '(')) => {
            chars.next();
            match group(open, chars) {
                Item::Group { items, .. } => formula(&items),
                _ => String::new(),
            }
        }
        Some(c) if c.is_ascii_digit() => number(chars),
        Some(c) => {
            chars.next();
            identifier(&c.to_string())
        }
        None => String::new(),
    }
}

fn script(kind: char, chars: &mut Peekable<Chars>, items: &mut Vec<Item>) {
    let symbol = one_symbol(chars);
    if kind == '^' {
        raise(items, &symbol);
    } else if let Some(Item::Atom(base)) = items.last_mut() {
        *base = format!("<msub>{base}{symbol}</msub>");
    } else {
        items.push(Item::Word("_".to_owned()));
        items.push(Item::Atom(symbol));
    }
}

/// Puts a superscript on the last item, beside its subscript if it has one; with nothing before it, it stands in front of what comes.
fn raise(items: &mut Vec<Item>, symbol: &str) {
    match items.pop() {
        Some(Item::Atom(base)) => {
            let under = base.strip_prefix("<msub>").and_then(|inner| inner.strip_suffix("</msub>"));
            items.push(Item::Atom(match under {
                Some(inner) => format!("<msubsup>{inner}{symbol}</msubsup>"),
                None => format!("<msup>{base}{symbol}</msup>"),
            }));
        }
        Some(group @ Item::Group { .. }) => {
            items.push(Item::Atom(format!("<msup>{}{symbol}</msup>", formula(&[group]))));
        }
        before => {
            items.extend(before);
            items.push(Item::Atom(format!("<msup><mrow></mrow>{symbol}</msup>")));
        }
    }
}

fn sum(chars: &mut Peekable<Chars>) -> Item {
    const SIGN: &str = "<mo movablelimits=\"true\">∑</mo>";
    let mut limit = |mark| chars.next_if_eq(&mark).map(|_| one_symbol(chars));
    let (under, over) = (limit('_'), limit('^'));
    Item::Atom(match (under, over) {
        (Some(under), Some(over)) => format!("<munderover>{SIGN}{under}{over}</munderover>"),
        (Some(under), None) => format!("<munder>{SIGN}{under}</munder>"),
        _ => SIGN.to_owned(),
    })
}

/// The factors before the bar become the numerator, the one after it the denominator.
fn fraction(chars: &mut Peekable<Chars>, items: &mut Vec<Item>) {
    let starts = items
        .iter()
        .rposition(|item| !matches!(item, Item::Atom(_)) && !is_formula_group(item))
        .map_or(0, |before| before + 1);
    let numerator = items.split_off(starts);
    let denominator = denominator(chars);
    match (numerator.is_empty(), denominator.is_empty()) {
        (false, false) => {
            let (over, under) = (formula(bare(&numerator)), formula(bare(&denominator)));
            items.push(Item::Atom(format!("<mfrac>{over}{under}</mfrac>")));
        }
        _ => {
            items.extend(numerator);
            items.push(Item::Word("/".to_owned()));
            items.extend(denominator);
        }
    }
}

/// One number, or letters and groups without a space between them.
fn denominator(chars: &mut Peekable<Chars>) -> Vec<Item> {
    let mut text = String::new();
    let mut depth = 0_usize;
    while let Some(&c) = chars.peek() {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' if depth == 0 => break,
            ')' | '}' | ']' => depth -= 1,
            _ if depth == 0 && !(c.is_alphanumeric() || matches!(c, '_' | '^' | '²' | '³')) => break,
            _ => {}
        }
        text.push(c);
        chars.next();
    }
    parse(&mut text.chars().peekable(), None)
}

/// A single group in parentheses without them: a fraction bar groups by itself.
fn bare(items: &[Item]) -> &[Item] {
    match items {
        [Item::Group { open: '(', items, .. }] => items,
        other => other,
    }
}

fn is_formula_group(item: &Item) -> bool {
    match item {
        Item::Group { items, .. } => !items.is_empty() && items.iter().all(is_formula),
        _ => false,
    }
}

/// Can it be part of a formula? Inside of a group, separators can.
fn is_formula(item: &Item) -> bool {
    match item {
        Item::Space | Item::Atom(_) | Item::Operator(_) => true,
        Item::Word(word) => matches!(word.as_str(), "," | ";" | "/" | "%"),
        Item::Group { .. } => is_formula_group(item),
    }
}

/// The items as one `mrow`.
fn formula(items: &[Item]) -> String {
    let mut row = String::new();
    for (at, item) in items.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = match item {
            Item::Space => Ok(()),
            Item::Word(word) if word == "," || word == ";" => {
                write!(row, "<mo separator=\"true\">{word}</mo>")
            }
            Item::Word(word) => write!(row, "<mtext>{}</mtext>", escape(word)),
            Item::Atom(atom) => write!(row, "{atom}"),
            Item::Operator('|') => write!(row, "<mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo>"),
            // A sign has nothing before it.
            Item::Operator(c @ ('−' | '+'))
                if items[..at]
                    .iter()
                    .rev()
                    .find(|item| **item != Item::Space)
                    .is_none_or(|item| matches!(item, Item::Operator(_))) =>
            {
                write!(row, "<mo form=\"prefix\">{c}</mo>")
            }
            // After words, whose space is there already.
            Item::Operator(c) if at == 0 && RELATIONS.contains(*c) => {
                write!(row, "<mo lspace=\"0\">{}</mo>", escape(&c.to_string()))
            }
            Item::Operator(c) => write!(row, "<mo>{}</mo>", escape(&c.to_string())),
            Item::Group { open, items, close } => {
                let fence = |c: &char| format!("<mo stretchy=\"false\">{}</mo>", escape(&c.to_string()));
                let (open, inner) = (fence(open), formula(items));
                write!(row, "{open}{inner}{}", close.as_ref().map(fence).unwrap_or_default())
            }
        };
    }
    format!("<mrow>{row}</mrow>")
}

/// The article, or a variable? It is an article between two words.
fn is_article(items: &[Item], at: usize) -> bool {
    let (Item::Atom(atom), word) = (
        &items[at],
        |item: Option<&Item>| matches!(item, Some(Item::Word(word)) if word.chars().next().is_some_and(char::is_alphabetic)),
    ) else {
        return false;
    };
    let before = items[..at].iter().rev().find(|item| **item != Item::Space);
    let after = items[at + 1..].iter().find(|item| **item != Item::Space);
    matches!(atom.as_str(), "<mi>a</mi>" | "<mi>A</mi>")
        && items.get(at + 1) == Some(&Item::Space)
        && (before.is_none() || word(before) || matches!(before, Some(Item::Word(_))))
        && word(after)
}

/// Writes words as words, and runs of everything else as formulas. A line may break after a relation.
fn render(items: &[Item], out: &mut String) {
    let mut run: Vec<Item> = Vec::new();
    let flush = |run: &mut Vec<Item>, out: &mut String| {
        let spaced = run.last() == Some(&Item::Space);
        while run.last() == Some(&Item::Space) {
            run.pop();
        }
        if !run.is_empty() {
            let _ = write!(out, "<math>{}</math>", formula(run));
        }
        if spaced {
            out.push(' ');
        }
        run.clear();
    };
    for (at, item) in items.iter().enumerate() {
        match item {
            _ if is_article(items, at) => {
                flush(&mut run, out);
                out.push_str(if *item == Item::Atom("<mi>A</mi>".to_owned()) { "A" } else { "a" });
            }
            Item::Word(word) => {
                flush(&mut run, out);
                out.push_str(&escape(word));
            }
            Item::Group { open, items, close } if !is_formula_group(item) => {
                flush(&mut run, out);
                out.push(*open);
                render(items, out);
                out.extend(close);
            }
            // The operator before a break brings its own space.
            Item::Space if run.is_empty() && out.ends_with("<wbr>") => {}
            Item::Space if run.is_empty() => out.push(' '),
            // Two terms side by side are two formulas; an operator holds its sides together.
            Item::Space => {
                let operator = |item: Option<&Item>| matches!(item, Some(Item::Operator(_)));
                if operator(run.last()) || operator(items.get(at + 1)) {
                    run.push(Item::Space);
                } else {
                    run.push(Item::Space);
                    flush(&mut run, out);
                }
            }
            Item::Operator(c) if RELATIONS.contains(*c) && run.len() > 4 => {
                run.push(item.clone());
                flush(&mut run, out);
                out.push_str("<wbr>");
            }
            other => run.push(other.clone()),
        }
    }
    flush(&mut run, out);
}

#[cfg(test)]
mod tests {
    use super::html;

    #[test]
    fn formulas_become_mathml_and_words_stay_words() {
        let shown = html("Every G_i^k has a jump at x = t_{i+k+1}/2 < 1.");
        assert!(shown.starts_with("Every <math><mrow><msubsup><mi>G</mi><mi>i</mi><mi>k</mi></msubsup></mrow></math> has a jump at "), "{shown}");
        assert!(shown.contains("<mfrac><mrow><msub><mi>t</mi><mrow><mi>i</mi><mo>+</mo>"), "{shown}");
        assert!(shown.contains("<mo>&lt;</mo>") && shown.ends_with('.'), "{shown}");
    }

    #[test]
    fn scripts_in_front_sums_and_intervals() {
        assert!(html("^{1−α}G_{n−i}").contains("<msup><mrow></mrow><mrow><mn>1</mn>"));
        assert!(html("Σ_{i=0}^n G_i").contains("<munderover>"));
        assert!(html("x in [0,1)").ends_with(
            "<mo separator=\"true\">,</mo><mn>1</mn></mrow><mo stretchy=\"false\">)</mo></mrow></math>"
        ));
        assert_eq!(html("(an interval of constancy)"), "(an interval of constancy)");
        assert_eq!(html("U0, S7"), "U0, S7");
    }

    #[test]
    fn nothing_gets_past_the_escape() {
        for text in ["<script>", "x_<b>", "a^\"&", "(<i>)", "_", "^", "/", "((", "]", "{}"] {
            let shown = html(text);
            assert!(
                !shown.contains("<script") && !shown.contains("<b>") && !shown.contains("<i>"),
                "{shown}"
            );
        }
    }
}
