//! Wrong sentences and stanzas: `‸` stands before the place that is underlined, and is not part of the text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use knotproof::language::{Complaint, Known, one_line, stanzas};

/// The text without its mark, and line and column of that.
fn marked(text: &str) -> (String, (usize, usize)) {
    let (before, after) = text.split_once('‸').unwrap_or_else(|| panic!("no mark in {text}"));
    let line = before.rsplit('\n').next().unwrap();
    (format!("{before}{after}"), (before.matches('\n').count() + 1, line.chars().count() + 1))
}

/// What is not as expected of the first complaint.
fn wrong(
    found: Result<(), Complaint>,
    text: &str,
    place: (usize, usize),
    rule: &str,
    advice: &str,
) -> Option<String> {
    let Err(complaint) = found else { return Some(format!("no complaint of {text}")) };
    let as_expected =
        complaint.place() == place && complaint.rule().contains(rule) && complaint.advice().contains(advice);
    (!as_expected).then(|| format!("expected {place:?}, {rule:?}, {advice:?}:\n{complaint}\n"))
}

/// A sentence, a part of the rule, a part of the advice.
const SENTENCES: &[(&str, &str, &str)] = &[
    // What is typed from habit.
    ("k; U; i in 0..n : ‸≤ 0", "`≤` is not in the language", "write `<=`"),
    ("k; U; x ‸∈ [t[0], t[m]] : x = 0", "`∈`", "write `in`"),
    ("k; U; i in 0..n : t[i] ‸== t[0]", "`==`", "write `=`"),
    ("k; U : k = 1 ‸&& n = 2", "`&&`", "write `and`"),
    ("k; U : k = 1 ‸|| n = 2", "`||`", "write `or`"),
    ("k; U; i in 0‸...n : t[i] >= 0", "`...`", "write `..`"),
    ("k; U; x : x‸² = 1", "`²`", "write `^2`"),
    ("k; U : ‸! k = 1", "`!`", "write `not`"),
    ("k; U : k ‸# 1", "`#`", "see the page"),
    // Brackets and operators.
    ("k; U; i in 0..n; x : G[i](x = 0‸", "expected `)`, found the end", "opened at character 26"),
    ("k; U : (k = 1‸", "expected `)`, found the end", "opened at character 8"),
    ("k; U : k = 1‸)", "found `)`", "no bracket is open"),
    ("k; U; i in 0..n : t[i > 0‸", "expected `]`, found the end", "opened at character 20"),
    ("k; U : 2‸k = 1", "expected the end, or an operator, found `k`", "written with `*`"),
    ("k; U : k = ‸", "expected a term", "complete it"),
    ("k; U : k = 1 and ‸and n = 1", "expected a term", ""),
    ("k; U : k = 1 <=> n = 1 ‸<=> m = 1", "joins two", "in brackets"),
    ("k; U : all(i ‸: t[i] = 0)", "expected `)`, found `:`", "opened at character 11"),
    ("k; U : all(i in 0..n‸) ", "expected `:`", ""),
    ("k; U : all(i in [0‸]: t[i] = 0)", "expected `,` and the other end", ""),
    ("k; U; i in 0 ‸: k = 1", "expected `..`", "integers run in `0..n`, reals in `[a, b]`"),
    ("k; U‸", "expected `;` and another binder", "complete it"),
    ("k; U; ‸: k = 1", "expected a name", ""),
    // Names.
    ("k; U; x in [t[0], t[m]] : ‸mutl(x) = 1", "nothing is called `mutl`", "did you mean `mult`?"),
    ("k; U; x : ‸y = 1", "nothing is called `y`", "bind it in `for`"),
    ("k; U; i in 0..n : ‸U[i] = 0", "`U` has no indices", "a knot is `t[i]`"),
    ("k; U : ‸U = 0", "without what belongs to it", "write `t[i]`"),
    ("k; U : ‸t = 0", "without what belongs to it", "write `t[i]`"),
    ("x : ‸t[0] = x", "`t` needs knots", "`k; U`"),
    ("x : ‸k = 1", "`k` is not bound", "begin `for` with `k`"),
    ("‸U : n = 1", "knots belong to a degree", "write `k; U`"),
    ("k; U; i in 0..n; ‸i in 0..m : t[i] = 0", "bound already", "take another name"),
    ("k; U; i in 0..n : all(‸i in 0..m: t[i] = 0)", "bound already", "none hides another"),
    ("k; U; ‸n in 0..3 : k = n", "`n` has a meaning already", "take another name"),
    ("k; U : all(‸k in 0..3: t[k] = 0)", "`k` has a meaning already", "take another name"),
    ("k; U; ‸mult : k = 1", "`mult` has a meaning already", "take another name"),
    ("k; ‸k : k = 1", "`k` is bound already", "once"),
    ("k; U; ‸U open : k = 1", "`U` is bound already", "once"),
    ("k; U ‸opne : k = 1", "knots are not `opne`", "did you mean `open`?"),
    ("k; U ‸periodic : k = 1", "knots are not `periodic`", "open, clamped"),
    ("k; U open ‸open : k = 1", "said twice", "once"),
    ("k; U; d ‸pionts : d[0] = 1", "`pionts`", "write `points`"),
    ("k; U; i in 0..n : ‸P[i,1] = 0", "needs an instance", "`U in {…}`"),
    ("k; U : ‸U in {S1} => k = 1", "needs an instance", "`U in {…}`"),
    // Types.
    ("k; U; x : G[‸x](0) > 0", "expected an integer, this is a real number", "indices"),
    ("k; U; i in 0..n : ‸G[i] > 0", "expected a number, this is a function", "give it a point"),
    ("k; U; i in 0..n; x : ‸G[i](x)", "expected a formula, this is a real number", "compare it"),
    ("k; U; i in 0..n; x : continuous(‸x)", "expected a function, this is a real number", "`G[i]`"),
    ("k; U; x : polygon_changes(‸x) = 1", "said of control values, this is a real number", "`d points`"),
    ("k; U; x : ‸mult(x, 1) = 1", "another number of things", "`mult(x)`"),
    ("k; U; x; i in 0..n : ‸changes(G[i](x)) = 1", "another number of things", "changes(C(x), x in [a, b])"),
    ("k; U; x : ‸x(3) = 1", "expected a function, this is a real number", "written with `*`"),
    ("k; U; x : ‸x[3] = 1", "it has no indices", "`*`"),
    ("k; U; d points : ‸d = 1", "expected a number", "write `d[i]`"),
    ("k; U; i in 0..n; x : ‸w[i](x) = 1", "another number of indices", "`w[i,d]`"),
    ("k; U; i in 0..n; x : ‸t'[i] = 1", "no derivative", "`G'[i](x)`"),
    ("k; U; i in 0..n; x : ‸G[i](x, 1) = 1", "at one point", "write `(x)`"),
    ("x : ‸phi(x, 1) = 1", "a point and two ends", "`phi(x, a, b)`"),
    ("k; U; x : abs(‸x-) = 1", "a limit is taken at the point", "`G[i](x-)`"),
    ("k; U; i in 0..n; x : G[i](x; ‸beta = 2) = 1", "the family has no `beta`", "`; alpha = …`"),
    ("k; U; i in 0..n; x : ‸(k = 1) = 1", "expected a number, this is a formula", "brackets"),
    ("k; U : ‸infinity > 1", "infinity", "beside an index"),
    ("k; U : r = ‸infinity", "`infinity` is no number", "`alpha = infinity`"),
    ("‸alpha > 1 : 1 = 1", "every sentence runs over `alpha`", "`if`"),
    ("alpha in {2, ‸1/2} : 1 = 1", "less than 0 or greater than 1", ""),
    ("x in ‸{1, 2} : x = 1", "range or an interval", "`0..n`"),
    ("x > ‸1 : x = 1", "compared with 0 only", "`if`"),
    ("k in ‸3..1; U : k = 1", "this range is empty", "write `1..3`"),
    ("k >= ‸m; U : k = 1", "bounded by a number", "`k >= 1`"),
    // What can be seen without any knots.
    ("k; U; x : G[‸-1](x) = 0", "no index is below 0", "begin at 0"),
    ("k; U; i in ‸3..1 : t[i] = 0", "this range is empty", "write `1..3`"),
    ("x in ‸[1, 0] : x = 0", "this interval is empty", "left end"),
    ("x in ‸[1, 1) : x = 0", "this interval is empty", "left end"),
    ("k; U in {C5}; i in 0..n : P[i,‸3] = 0", "coordinates 1 and 2", "`P[i,1]`"),
    ("k; U : 1/‸0 = k", "divided by 0", "denominator"),
    ("x : x^‸1001 = 0", "an exponent has at most", ""),
    ("k; U; i in 0..n : t[‸99999999999999999999] = 0", "expected an integer", "indices"),
    ("k; U : sum(x in ‸[t[0], t[m]]: x) = 1", "only integers", "sup("),
];

#[test]
fn sentences() {
    let check = |(text, rule, advice): &(&str, &str, &str)| {
        let (text, place) = marked(text);
        wrong(one_line(&text).map(drop), &text, place, rule, advice)
    };
    let all: Vec<_> = SENTENCES.iter().filter_map(check).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// Definitions with their bodies, the place that is underlined, and the advice.
type WrongDefinitions = (&'static [(&'static str, &'static str)], &'static str, &'static str);

const DEFINITIONS: &[WrongDefinitions] = &[
    (&[("C(x)", "‸C(x) + 1")], "the recursion of `C` never ends", "fall to a literal"),
    (&[("b[i,q](x)", "‸b[i,q-1](x)")], "the recursion of `b` never ends", "`b[q-1]` and `b[0]`"),
    (&[("b[0]", "1"), ("b[q]", "2*‸b[q-2]")], "the recursion of `b` never ends", "fall to a literal"),
    (&[("b[0]", "1"), ("b[q]", "2*‸b[q+1]")], "the recursion of `b` never ends", "fall to a literal"),
    (&[("A(x)", "‸B(x)"), ("B(x)", "A(x)")], "`A` is defined by `B`, and that by `A`", "without itself"),
    (&[("A", "1"), ("‸A", "2")], "`A` comes first and always fits", "literals before names"),
    (&[("b[q]", "1"), ("‸b[0]", "2")], "`b[q]` comes first", "literals before names"),
    (&[("b[q]", "1"), ("‸b[q](x)", "x")], "defined in two shapes", "write it like `b[q]`"),
    (&[("‸mult(x)", "x")], "has a meaning already", "another name"),
    (&[("‸C(k)", "1")], "has a meaning already", "another name"),
    (&[("b[‸i+1]", "1")], "an index of a definition", "`b[i,q](x)`"),
    (&[("C(x) ‸+ 1", "x")], "expected the end", "too much"),
    (&[("c[i]", "1"), ("e", "‸c")], "defined with 1 indices, here are 0", "write `c[i]`"),
];

#[test]
fn definitions() {
    let check = |(texts, rule, advice): &(&[(&str, &str)], &str, &str)| {
        let mut found = None;
        let plain: Vec<_> = texts
            .iter()
            .map(|(head, body)| {
                [head, body].map(|text| match text.contains('‸') {
                    true => {
                        let (text, place) = marked(text);
                        found = Some(place);
                        text
                    }
                    false => (*text).to_owned(),
                })
            })
            .collect();
        let borrowed: Vec<_> = plain.iter().map(|[head, body]| (head.as_str(), body.as_str())).collect();
        wrong(Known::defining(&borrowed).map(drop), &format!("{texts:?}"), found.unwrap(), rule, advice)
    };
    let all: Vec<_> = DEFINITIONS.iter().filter_map(check).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

const CLAIM: &str = "[[claim]]\nid = \"A\"\nat = \"1\"\ntitle = \"a\"\n";

/// What follows the head of a claim.
const STANZAS: &[(&str, &str, &str)] = &[
    ("for = \"k; U; i in 0..n\"\nthen = [\"k = 1\", \"t[i] ‸≤ 0\"]", "`≤`", "write `<=`"),
    ("for = \"k; U ‸opne\"\nthen = [\"k = 1\"]", "knots are not `opne`", "`open`"),
    ("if = ['‸s = 1']\nthen = ['1 = 1']", "nothing is called `s`", "`for`"),
    ("for = \"x\"\nthen = [\"\"\"\nx =\n  ‸q\"\"\"]", "nothing is called `q`", "`for`"),
    ("for = \"x\"\nthen = [‸\"\\u0078 = q\"]", "nothing is called `q`", "`for`"),
    ("then = ‸[]", "nothing follows", "conclusion"),
    ("‸thne = [\"1 = 1\"]", "unknown field `thne`", "did you mean `then`?"),
    ("then = [\"1 = 1\"]\ncause = ‸\"end-point\"", "no cause is called `end-point`", "`end-points`"),
    ("then = [\"1 = 1\"]\nseverity = ‸\"bad\"", "no severity is called `bad`", "slip"),
    ("then = [\"1 = 1\"]\ndegrees = ‸\"all\"", "unknown variant `all`", "each"),
    ("then = ‸\"1 = 1\"", "invalid type", ""),
    ("then = [\"1 = 1\"]\n[claim.amended]\nthen = [\"1 ‸== 1\"]", "`==`", "write `=`"),
    ("for = \"x\"\nthen = [\"‸x = 1\"]\n[claim.amended]\nfor = \"y\"", "nothing is called `x`", "`for`"),
    (
        "then = [\"1 = 1\"]\n[[claim]]\nid = ‸\"A\"\nat = \"2\"\ntitle = \"b\"\nthen = [\"1 = 1\"]",
        "two claims have this identifier",
        "another",
    ),
    (
        "then = [\"1 = 1\"]\n‸[[claim]]\nat = \"2\"\ntitle = \"b\"\nthen = [\"1 = 1\"]",
        "missing field `id`",
        "add `id = …`",
    ),
    (
        "then = [\"1 = 1\"]\n[[claim]]\nid = ‸\"a b\"\nat = \"2\"\ntitle = \"b\"\nthen = [\"1 = 1\"]",
        "an identifier is made of",
        "`T3.5.3`",
    ),
    ("then = [\"1 = 1\"]\n‸then = [\"2 = 2\"]", "duplicate key", ""),
    ("then = [\"1 = 1\"]\n[define]\n‸\"C(x)\" = \"x\"", "nothing uses `C`", "delete it"),
    ("then = [\"1 = 1\"]\n[define]\n\"C(x)\" = \"x + ‸C(x)\"", "never ends", "literal"),
    ("then = [\"1 = 1\"]\n[define]\n\"‸k(x)\" = \"x\"", "has a meaning already", "another name"),
];

#[test]
fn files() {
    let check = |(text, rule, advice): &(&str, &str, &str)| {
        let (text, place) = marked(&format!("{CLAIM}{text}"));
        wrong(
            stanzas("claims.toml", &text).map(drop).map_err(|mut all| all.swap_remove(0)),
            &text,
            place,
            rule,
            advice,
        )
    };
    let all: Vec<_> = STANZAS.iter().filter_map(check).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
    // Another format is complained of first, and alone: who knows what else it has.
    let (text, place) = marked(&format!("format = ‸2\nnovelty = true\n{CLAIM}then = [\"1 = 1\"]"));
    let complaints = stanzas("claims.toml", &text).unwrap_err();
    assert_eq!((complaints.len(), complaints[0].place()), (1, place));
    let complaint = complaints[0].to_string();
    assert!(complaint.contains("this is format 2") && complaint.contains("reads format 1"), "{complaint}");
    assert!(stanzas("claims.toml", &format!("format = 1\n{CLAIM}then = [\"1 = 1\"]")).is_ok());
    // These have no place of their own in the stanza.
    for (text, rule) in [("words = \"so\"", "words need a reason"), ("for = \"k\"", "nothing is said")] {
        let complaint = stanzas("claims.toml", &format!("{CLAIM}{text}")).unwrap_err().swap_remove(0);
        assert_eq!((complaint.rule(), complaint.place()), (rule, (1, 1)), "{complaint}");
    }
}

#[test]
fn nothing_is_too_deep_to_be_told() {
    let deep = |open: &str, middle: &str, close: &str, times: usize| {
        format!("x : {}{middle}{}", open.repeat(times), close.repeat(times))
    };
    for (open, middle, close) in [
        ("(", "x = 1", ")"),
        ("not ", "x = 1", ""),
        ("- ", "x = 1", ""),
        ("x^", "x = 1", ""),
        ("x + ", "x = 1", ""),
        ("x*(", "x", ") = 1"),
        ("x = 1 => ", "x = 1", ""),
        ("abs(", "x", ") = 1"),
        ("all(y in [0,1]: ", "x = 1", ")"),
        ("t[", "0", "] = 1"),
        ("x", "", "(x)"),
        ("", "x", "[1]"),
    ] {
        let complaint = one_line(&deep(open, middle, close, 1000)).unwrap_err();
        assert!(complaint.rule().contains("nested deeper than 64"), "{open}: {}", complaint.rule());
    }
    assert!(one_line(&deep("(", "x = 1", ")", 60)).is_ok());
    let long = one_line(&deep("x = 1 and ", "x = 1", "", 3000)).unwrap_err();
    assert!(long.rule().contains("at most 20000 bytes"));
}
