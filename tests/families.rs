//! Families of splines as data: what is shipped, what it gives, and what is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::sync::Arc;

use knotproof::certificate::{Certificate, certify, certify_for_degree};
use knotproof::judge::{Cases, Verdict, judge};
use knotproof::language::{Claim, Family, Form, Paper, classical, families, paper, shipped};
use knotproof::meaning::{Instance, Values, Weighting};
use knotproof::scalar::{BigRational, integer, parse_rational, rational};
use knotproof::spline::{Basis, Index, KnotVector, Side};

fn family(name: &str) -> Arc<Family> {
    Arc::clone(families().iter().find(|family| family.name == name).unwrap_or_else(|| panic!("{name}")))
}

fn values(text: &str) -> Values {
    let number = |text: &str| parse_rational(text).unwrap();
    let list = |text: &str| text.split(',').map(number).collect::<Vec<_>>();
    match (text.contains(';'), text.contains(',')) {
        (true, _) => Values::Rows(text.split(';').map(list).collect()),
        (_, true) => Values::List(list(text)),
        _ => Values::One(number(text)),
    }
}

fn given(settings: &[(&str, &str)]) -> Vec<(String, Values)> {
    settings.iter().map(|(name, text)| ((*name).to_owned(), values(text))).collect()
}

fn knots(text: &str) -> KnotVector {
    KnotVector::new(text.split(' ').map(|t| parse_rational(t).unwrap()).collect()).unwrap()
}

fn instance(name: &str, settings: &[(&str, &str)], degree: usize, on: &str) -> Instance {
    let weights = Weighting::of(&family(name), &given(settings)).unwrap_or_else(|error| panic!("{error}"));
    let basis = Basis::over(knots(on), degree, weights).unwrap();
    Instance::on(basis).unwrap_or_else(|error| panic!("{error}"))
}

fn value(on: &Instance, i: usize, x: &BigRational) -> BigRational {
    let degree = on.degree().unwrap();
    let value = on.value(&on.weights, (i, degree), x, Side::Right, 0);
    assert_eq!(on.by_definition().value(&on.weights, (i, degree), x, Side::Right, 0), value);
    value
}

#[test]
fn each_family_has_a_source_and_says_what_it_is() {
    assert_eq!(families().len(), 12);
    for family in families() {
        assert!(!family.title.is_empty() && !family.source.is_empty(), "{}", family.name);
    }
    assert!(family("mobius").moebius().is_some() && family("lupas").moebius().is_none());
}

/// A member of Möbius weights is an index, with its fast kernels.
#[test]
fn members_of_mobius_and_classical_are_indices() {
    let index = |name: &str, settings: &[(&str, &str)]| {
        Weighting::of(&family(name), &given(settings)).unwrap().index().cloned()
    };
    assert_eq!(index("mobius", &[("r", "1/2")]), Some("-1".parse().unwrap()));
    assert_eq!(index("mobius", &[("alpha", "-1")]), Some("-1".parse().unwrap()));
    assert_eq!(index("classical", &[]), Some(Index::infinity()));
    assert_eq!(index("lupas", &[("q", "1")]), None);
}

/// The kernels of an index compute what `families/mobius.toml` says: its members as forms are the same functions.
#[test]
fn the_kernels_of_an_index_are_its_family() {
    for alpha in ["-1", "infinity", "100/99", "-1/7"] {
        let index: Index = alpha.parse().unwrap();
        for on in ["0 0 0 0 1 1 1 1", "0 0 1 1 1 3 4 4 4 9", "0 1 2 4 5 7 8 9"] {
            let basis = Basis::new(knots(on), 3, index.clone()).unwrap();
            let family = basis.with(Weighting::Index(index.clone()).table(&knots(on), 3).unwrap());
            for x in [rational(1, 3), rational(3, 4), integer(1)] {
                for side in [Side::Left, Side::Right] {
                    assert_eq!(family.jets(&x, side, 2), basis.jets(&x, side, 2), "{alpha} on {on}");
                }
            }
        }
    }
}

/// What a file calls classical are the polynomial B-splines.
#[test]
fn classical_members_are_polynomial() {
    let mut compared = 0;
    for family in families() {
        let Some(classical) = &family.classical else { continue };
        let numbers = classical.iter().map(|(name, term)| {
            let number = term.literal().unwrap();
            let own = family.parameters.iter().find(|own| own.name == *name).unwrap();
            let list = vec![number.clone(); 12];
            let values = match own.indices.len() {
                0 => Values::One(number),
                1 => Values::List(list),
                _ => Values::Rows(vec![list; 3]),
            };
            (name.to_string(), values)
        });
        let weights = Weighting::of(family, &numbers.collect::<Vec<_>>()).unwrap();
        for on in ["0 0 0 0 1 1 1 1", "0 0 0 0 1 3 4 4 4 4", "0 1 2 4 5 7 8 9"] {
            let Ok(table) = weights.table(&knots(on), 3) else { continue };
            let basis = Basis::new(knots(on), 3, Index::infinity()).unwrap();
            for x in [rational(1, 3), rational(3, 4)] {
                assert_eq!(
                    basis.with(table.clone()).jets(&x, Side::Right, 1),
                    basis.jets(&x, Side::Right, 1),
                    "{}",
                    family.name
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 20, "{compared}");
}

/// Products and sums of the literature on (0, …, 0, 1, …, 1), written out here.
#[test]
fn bernstein_cases_are_the_closed_forms() {
    let one = || integer(1);
    let xs = [rational(1, 5), rational(1, 2), rational(8, 9)];
    let product = |factors: &mut dyn Iterator<Item = BigRational>| factors.fold(one(), |all, f| all * f);
    for k in 1..=4_usize {
        let on = format!("{}{}", "0 ".repeat(k + 1), "1 ".repeat(k + 1));
        let on = on.trim();
        let bracket =
            |n: usize, q: &BigRational| (0..n).map(|e| q.pow(i32::try_from(e).unwrap())).sum::<BigRational>();
        let binomial = |n: usize, i: usize, q: &BigRational| {
            product(&mut (1..=i).map(|l| bracket(n - i + l, q) / bracket(l, q)))
        };
        let power = |q: &BigRational, e: usize| q.pow(i32::try_from(e).unwrap());
        for q in [rational(1, 2), rational(3, 1)] {
            let setting = q.to_string();
            let lupas = instance("lupas", &[("q", &setting)], k, on);
            let phillips = instance("phillips", &[("q", &setting)], k, on);
            let polya = instance("polya", &[("h", &setting)], k, on);
            for x in &xs {
                for i in 0..=k {
                    let over = product(&mut (0..k).map(|j| one() - x + power(&q, j) * x));
                    let expected = binomial(k, i, &q)
                        * power(&q, i * i.saturating_sub(1) / 2)
                        * power(x, i)
                        * power(&(one() - x), k - i)
                        / over;
                    assert_eq!(value(&lupas, i, x), expected, "lupas {k} {i}");
                    let expected = binomial(k, i, &q)
                        * power(x, i)
                        * product(&mut (0..k - i).map(|s| one() - power(&q, s) * x));
                    assert_eq!(value(&phillips, i, x), expected, "phillips {k} {i}");
                    let step = |j: usize| integer(j) * &q;
                    let expected = binomial(k, i, &one())
                        * product(&mut (0..i).map(|j| x + step(j)))
                        * product(&mut (0..k - i).map(|j| one() - x + step(j)))
                        / product(&mut (0..k).map(|j| one() + step(j)));
                    assert_eq!(value(&polya, i, x), expected, "polya {k} {i}");
                }
            }
        }
    }
}

/// R_i = ω_i N_i / Σ ω_j N_j with the polynomial B-splines N_i.
#[test]
fn farins_steps_give_nurbs() {
    let omega = [1, 2, 5, 3, 7, 1, 4];
    let text = omega.map(|w| w.to_string()).join(",");
    for (k, on) in [(1, "0 0 1 2 2"), (2, "0 0 0 1 2 2 4 4 4"), (3, "0 0 0 0 1 1 3 4 4 4 4")] {
        let nurbs = instance("nurbs", &[("omega", &text)], k, on);
        let classical = Basis::new(knots(on), k, Index::infinity()).unwrap();
        for x in [rational(1, 3), rational(1, 1), rational(3, 2), rational(7, 4)] {
            let weighted: Vec<_> = classical
                .values(&x, Side::Right)
                .into_iter()
                .zip(omega)
                .map(|(n, w)| n * integer(w))
                .collect();
            let sum: BigRational = weighted.iter().sum();
            for (i, own) in weighted.iter().enumerate() {
                assert_eq!(value(&nurbs, i, &x), own / &sum, "{k} {i} {x}");
            }
        }
    }
}

/// With s_j = (t_j − x)/ω_j every weight is −s_a/(s_b − s_a): the B-splines on moved knots, taken at 0.
#[test]
fn knot_weights_are_polynomial_splines_on_moved_knots() {
    let omega = [3, 1, 2, 5, 1, 4, 2];
    let text = omega.map(|w| w.to_string()).join(",");
    let on = instance("knot-weights", &[("omega", &text)], 2, "0 1 2 4 5 7 8");
    let t = [0, 1, 2, 4, 5, 7, 8].map(integer);
    for x in [rational(5, 2), rational(9, 2), rational(1, 3)] {
        let s: Vec<_> = t.iter().zip(omega).map(|(t, w)| (t - &x) / integer(w)).collect();
        let j = t.iter().rposition(|t| *t <= x).unwrap();
        let mut g: Vec<BigRational> = (0..6).map(|i| integer(usize::from(i == j))).collect();
        for d in 1..=2 {
            g = (0..6 - d)
                .map(|i| {
                    let part = |i: usize, rising: bool| {
                        let w = -&s[i] / (&s[i + d] - &s[i]);
                        if rising { w } else { integer(1) - w }
                    };
                    let term = |i: usize, rising: bool| {
                        if g[i] == integer(0) { integer(0) } else { &g[i] * part(i, rising) }
                    };
                    term(i, true) + term(i + 1, false)
                })
                .collect();
        }
        for (i, expected) in g.iter().enumerate() {
            assert_eq!(&value(&on, i, &x), expected, "{i} {x}");
        }
    }
}

/// What a property comes to on the small cases of a family.
fn verdict(name: &str, property: &str, degree: usize) -> Verdict {
    let properties = Paper { files: vec![classical().clone()], ..paper().clone() };
    let claim =
        Claim::of(&properties).find(|claim| claim.id() == property).unwrap_or_else(|| panic!("{property}"));
    let sentence = claim.sentence(Form::Printed).unwrap();
    let cases = Cases::of_family(&family(name), &[]).unwrap().up_to(degree);
    judge(sentence, claim.into(), &cases.of(sentence, None)).unwrap()
}

#[test]
fn witnesses_name_the_parameters_and_repeat_them() {
    let Verdict::Refuted(witness) = verdict("lupas", "C1", 2) else {
        panic!("{:?}", verdict("lupas", "C1", 2))
    };
    let again = witness.again("C1", Form::Printed, paper());
    assert!(again.contains("--family lupas --set q="), "{again}");
    let given = witness.given();
    assert!(
        given.contains(&("family".into(), "lupas".into())) && given.iter().any(|(name, _)| name == "q"),
        "{given:?}"
    );
    let json = serde_json::to_string(&witness).unwrap();
    assert_eq!(serde_json::from_str::<knotproof::judge::Witness>(&json).unwrap(), *witness);
}

/// Of each kind one verdict that is known.
#[test]
fn known_verdicts_on_classical_properties() {
    for (name, property, status) in [
        ("knot-weights", "C1", "proved"),
        ("knot-weights", "reflection", "proved"),
        ("lupas", "reflection", "proved"),
        ("lupas", "C1", "refuted"),
        ("free-ratios", "reflection", "proved"),
        ("free-ratios", "C1", "refuted"),
        ("index-per-knot", "reflection", "undecided"),
        ("nurbs", "reflection", "proved"),
        ("phillips", "nonnegative", "refuted"),
        ("phillips", "reflection", "refuted"),
        ("polya", "tangent", "refuted"),
        ("polya", "linear", "proved"),
        ("smoothstep", "linear", "refuted"),
        ("square", "closed-form", "proved"),
        ("square", "variation", "undecided"),
    ] {
        let verdict = verdict(name, property, 2);
        assert_eq!(verdict.status(), status, "{name} {property}: {verdict:?}");
    }
}

/// A file of a family from its parts.
fn file(parameters: &str, weight: &str, more: &str) -> String {
    format!(
        "name = \"mine\"\ntitle = \"T\"\nsource = \"S\"\n[parameters]\n{parameters}\n[weight]\n{weight}\n{more}\n"
    )
}

const PLAIN: &str = "rise = \"x - a\"\nfall = \"b - x\"";

/// Parameters, weight, what else; what is underlined, a part of the rule, a part of the advice.
const WRONG_FILES: &[(&str, &str, &str, &str, &str, &str)] = &[
    ("", "rise = \"y - a\"\nfall = \"b - x\"", "", "y", "nothing is called `y`", "make it a parameter"),
    ("", "rise = \"x - a\"\nfall = \"b - \"", "", "", "expected a term", "complete it"),
    ("", "rise = \"x - a\"", "", "[weight]", "missing field `fall`", "add `fall = …`"),
    (
        "",
        "rise = \"x - a\"\nfall = \"b - x\"\nrize = \"x\"",
        "",
        "rize",
        "unknown field `rize`",
        "did you mean `rise`?",
    ),
    ("\"q\" = \"q > 0\"", PLAIN, "", "\"q\"", "no weight uses `q`", "delete it"),
    ("x = \"x > 0\"", PLAIN, "", "x", "`x` has a meaning already", "another name"),
    ("k = \"k > 0\"", PLAIN, "", "k", "`k` has a meaning already", "another name"),
    ("alpha = \"alpha > 0\"", PLAIN, "", "alpha", "`alpha` has a meaning already", "another name"),
    ("\"q[j]\" = \"q[j] > 0\"", PLAIN, "", "j", "has the index i, d, or i,d", "omega[i]"),
    ("\"q[d,i]\" = \"q[d,i] > 0\"", PLAIN, "", "q", "has the index i, d, or i,d", "rho[i,d]"),
    ("\"q(x)\" = \"q(x) > 0\"", PLAIN, "", "x", "a parameter is a number", "`define`"),
    (
        "q = \"q > p\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "",
        "p",
        "nothing is called `p`",
        "make it a parameter",
    ),
    (
        "q = \"q^2 > 2\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "",
        "q^2 > 2",
        "compares the parameter with numbers",
        "write `q > 0`",
    ),
    ("q = \"q\"", "rise = \"q*(x - a)\"\nfall = \"b - x\"", "", "q", "expected a formula", "compare it"),
    (
        "q = \"q > 0\"",
        "rise = \"q[i]*(x - a)\"\nfall = \"b - x\"",
        "",
        "q[i]",
        "another number of indices",
        "write `q`",
    ),
    (
        "\"q[i]\" = \"q[i] > 0\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "",
        "q",
        "another number of indices",
        "write `q[i]`",
    ),
    ("", "rise = \"alpha*(x - a)\"\nfall = \"b - x\"", "", "alpha", "has no `alpha`", "no parameter"),
    ("", "rise = \"G[i](x)\"\nfall = \"b - x\"", "", "G", "nothing that weights are made of", "parameters"),
    ("", "rise = \"w[i,d](x)\"\nfall = \"b - x\"", "", "w", "nothing that weights are made of", "parameters"),
    (
        "",
        "rise = \"phi(x, a, b)\"\nfall = \"b - x\"",
        "",
        "phi",
        "nothing that weights are made of",
        "parameters",
    ),
    (
        "",
        "rise = \"sqrt(x - a)\"\nfall = \"b - x\"",
        "",
        "sqrt",
        "nothing that weights are made of",
        "parameters",
    ),
    (
        "",
        "rise = \"abs(x - a)\"\nfall = \"b - x\"",
        "",
        "abs",
        "nothing that weights are made of",
        "parameters",
    ),
    (
        "",
        "rise = \"mult(x)\"\nfall = \"b - x\"",
        "",
        "mult",
        "nothing that weights are made of",
        "parameters",
    ),
    (
        "",
        "rise = \"(x - a)/x\"\nfall = \"b - x\"",
        "",
        "\"(x - a)/x\"",
        "divides by what depends on x",
        "multiply `rise`",
    ),
    (
        "",
        "rise = \"x = a\"\nfall = \"b - x\"",
        "",
        "x = a",
        "expected a number, this is a formula",
        "brackets",
    ),
    ("", "rise = \"x^(b-a)\"\nfall = \"b - x\"", "", "(b-a)", "expected an integer", "indices"),
    (
        "",
        "rise = \"c*(x - a)\"\nfall = \"b - x\"",
        "[define]\nc = \"e\"\ne = \"c\"",
        "e",
        "`c` is defined by `e`",
        "without itself",
    ),
    (
        "",
        "rise = \"c[i]*(x - a)\"\nfall = \"b - x\"",
        "[define]\n\"c[i]\" = \"c[i-1]\"",
        "c[i-1]",
        "never ends",
        "literal",
    ),
    ("", PLAIN, "[define]\nc = \"2\"", "c", "nothing uses `c`", "delete it"),
    (
        "q = \"q > 0\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "[define]\nq = \"2\"",
        "q",
        "`q` is a parameter already",
        "none hides another",
    ),
    (
        "",
        "rise = \"c*(x - a)\"\nfall = \"b - x\"",
        "[define]\nc = \"d\"",
        "d",
        "nothing is called `d`",
        "make it a parameter",
    ),
    (
        "q = \"q > 0\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "[dual]\np = \"1\"",
        "p",
        "`p` is no parameter",
        "it has q",
    ),
    (
        "q = \"q > 0\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "[reads]\nbeta = { p = \"beta\" }",
        "p",
        "`p` is no parameter",
        "it has q",
    ),
    (
        "q = \"q > 0\"",
        "rise = \"q*(x - a)\"\nfall = \"b - x\"",
        "[reads]\nq = { q = \"q\" }",
        "q",
        "has a meaning already",
        "another name",
    ),
];

#[test]
fn wrong_files_are_complained_of_at_their_place() {
    let mut wrong = Vec::new();
    for (parameters, weight, more, place, rule, advice) in WRONG_FILES {
        let text = file(parameters, weight, more);
        match Family::read("mine.toml", &text) {
            Ok(_) => wrong.push(format!("no complaint of\n{text}")),
            Err(complaints) => {
                let as_expected = complaints.iter().any(|complaint| {
                    complaint.underlined().trim() == *place
                        && complaint.rule().contains(rule)
                        && complaint.advice().contains(advice)
                });
                if !as_expected {
                    let all: Vec<_> = complaints.iter().map(ToString::to_string).collect();
                    wrong.push(format!("expected {place:?}, {rule:?}, {advice:?}:\n{}", all.join("\n")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    let knots = file("", PLAIN, "").replace("source", "knots = \"bernstien\"\nsource");
    assert!(Family::read("mine.toml", &knots).unwrap_err()[0].advice().contains("`bernstein`"));
    let name = file("", PLAIN, "").replace("mine", "my family");
    assert_eq!(Family::read("mine.toml", &name).unwrap_err()[0].underlined(), "\"my family\"");
}

type Setting = (&'static str, &'static str);
/// Family, settings, degree, knots; a part of the error.
type WrongMember = (&'static str, &'static [Setting], usize, &'static str, &'static str);

const WRONG_MEMBERS: &[WrongMember] = &[
    ("lupas", &[], 1, "0 0 1 1", "needs `q`: give it, such as --set q=1/3"),
    ("lupas", &[("q", "0")], 1, "0 0 1 1", "`q` of the family lupas can't be 0: q > 0"),
    ("lupas", &[("q", "-1/2")], 1, "0 0 1 1", "can't be -1/2"),
    ("lupas", &[("q", "1,2")], 1, "0 0 1 1", "`q` of the family lupas is one number"),
    ("lupas", &[("p", "1")], 1, "0 0 1 1", "has no `p`: it has q"),
    ("knot-weights", &[("omega", "1")], 1, "0 0 1 1", "is a list of numbers"),
    ("knot-weights", &[("omega", "1,2,0,3")], 1, "0 0 1 1", "can't be 0: omega[i] > 0"),
    ("knot-weights", &[("omega", "1,2")], 1, "0 0 1 1", "omega[2] is not given: give more numbers"),
    ("free-ratios", &[("rho", "1,2,3")], 1, "0 0 1 1", "a list of numbers for each d, separated by `;`"),
    ("free-ratios", &[("rho", "1,2,3;1,1")], 3, "0 0 0 0 1 1 1 1", "rho["),
    ("phillips", &[("q", "2")], 1, "0 0 1 1 2", "is for knots that are bernstein"),
    ("nurbs", &[("omega", "1,2,3,4,5")], 1, "0 1 2 3", "is for knots that are clamped"),
    ("nurbs", &[("omega", "1,2")], 1, "0 0 1 2 2", "omega[2] is not given"),
    ("mobius", &[("alpha", "1")], 1, "0 0 1 1", "can't be read from alpha = 1: it divides by 0"),
    ("mobius", &[("alpha", "1/2")], 1, "0 0 1 1", "can't be -1: r > 0"),
    ("index-per-knot", &[("alpha", "1/2,-1,2,3")], 1, "0 0 1 1", "can't be -1: rho[i] > 0"),
];

#[test]
fn wrong_members_say_what_to_do() {
    for (name, settings, degree, on, told) in WRONG_MEMBERS {
        let made = Weighting::of(&family(name), &given(settings)).and_then(|weights| {
            let basis = Basis::over(knots(on), *degree, weights).unwrap();
            Instance::on(basis)
        });
        let error = made.err().unwrap_or_else(|| panic!("{name} {settings:?}")).to_string();
        assert!(error.contains(told), "{error}");
    }
}

/// A member of a family of one's own, on (0, 0, 1, 1) or other knots.
fn own(
    parameters: &str,
    weight: &str,
    settings: &[(&str, &str)],
    degree: usize,
    on: &str,
) -> Result<Instance, String> {
    let family =
        Family::read("mine.toml", &file(parameters, weight, "")).map_err(|all| all[0].to_string())?;
    let weights = Weighting::of(&Arc::new(family), &given(settings)).map_err(|error| error.to_string())?;
    Instance::on(Basis::over(knots(on), degree, weights).unwrap()).map_err(|error| error.to_string())
}

/// Weights that have no value somewhere: no verdict is built on them.
#[test]
fn weights_without_values_are_refused() {
    let any = "q = \"\"";
    for (weight, q, told) in [
        // rise + fall = 1 − x·…: a pole inside, at an irrational place, at an end, and everywhere.
        ("rise = \"x - a\"\nfall = \"q - 3*x\"", "1", "its denominator is 0 at some x"),
        ("rise = \"x^2\"\nfall = \"-q\"", "1/2", "its denominator is 0 at some x"),
        ("rise = \"q*(x - a)\"\nfall = \"(b - x)^2 - (b - a)^2\"", "1", "its denominator is 0 at some x"),
        ("rise = \"q*(x - a)\"\nfall = \"-(x - a)\"", "1", "its denominator is 0 at some x"),
        ("rise = \"x - a\"\nfall = \"b - x\"\nover = \"q - x\"", "1", "its denominator is 0 at some x"),
        ("rise = \"(x - a)/q\"\nfall = \"b - x\"", "0", "it divides by 0"),
        ("rise = \"q^(1-d-d)*(x - a)\"\nfall = \"b - x\"", "0", "it divides by 0"),
        ("rise = \"q*(x - t[i-2])\"\nfall = \"b - x\"", "1", "t[-1] does not exist"),
        ("rise = \"q*(x - a)\"\nfall = \"sum(j in 0..d: t[i+j+3]) - x\"", "1", "does not exist"),
    ] {
        let error = own(any, weight, &[("q", q)], 1, "0 0 1 1").err().unwrap_or_else(|| panic!("{weight}"));
        assert!(error.contains(told) && error.contains("of the family mine"), "{error}");
    }
}

/// Where positivity is not for free, everything is decided by roots, and what can't be is left open.
#[test]
fn weights_that_break_an_obligation_are_decided_exactly_or_left_open() {
    let on = |weight: &str, q: &str| own("q = \"\"", weight, &[("q", q)], 1, "0 0 1 2 2").unwrap();
    // Not negative: (x − a)² − q(x − a)(b − x) + (b − x)² for q < 2, though a coefficient is; 0 at one x for q = 2.
    let bowl = "rise = \"(x - a)*(x - a)\"\nfall = \"(b - x)^2 - q*(x - a)*(b - x)\"\nover = \"(x - a)^2 + (b - x)^2\"";
    // Not 0 at a.
    let lifted = "rise = \"x - a + q*(b - a)\"\nfall = \"b - x\"";
    for (weight, q, sentence, status) in [
        (bowl, "1", "i in 0..n; x in [t[0], t[m]] : G[i](x) >= 0", "refuted"),
        (bowl, "0", "i in 0..n; x in [t[0], t[m]] : G[i](x) >= 0", "proved"),
        (bowl, "1", "x in [t[0], t[m]] : sum(i in 0..n: G[i](x)) = 1", "refuted"),
        (bowl, "0", "x in [t[0], t[m]] : sum(i in 0..n: G[i](x)) = 1", "proved"),
        (bowl, "1", "i in 0..n : maxima(G[i]) = 1", "undecided"),
        (bowl, "0", "i in 0..n : maxima(G[i]) = 1", "proved"),
        (lifted, "1/2", ": G[0](t[0]) = 1", "refuted"),
        (lifted, "1/2", ": G[0](t[0]) = 2/3", "proved"),
        (lifted, "1/2", "x in [t[0], t[m]] : sum(i in 0..n: G[i](x)) = 1", "proved"),
        (lifted, "1/2", ": continuous(G[1])", "refuted"),
        (lifted, "1/2", ": q = 1/2 and w[1,1](t[1]) = 1/3", "proved"),
        (
            "rise = \"x - a\"\nfall = \"q*(b - x)\"",
            "-1/2",
            "i in 0..n; x in [t[0], t[m]] : G[i](x) >= 0",
            "pole",
        ),
    ] {
        if status == "pole" {
            assert!(own("q = \"\"", weight, &[("q", q)], 1, "0 0 1 2 2").is_err());
            continue;
        }
        let on = on(weight, q);
        let known = on.weights.member().unwrap().family().known();
        let read = known.one_line_on_knots(sentence).unwrap_or_else(|complaint| panic!("{complaint}"));
        let verdict =
            judge(&read, knotproof::meaning::Names::empty(), &Cases::only(on).of(&read, None)).unwrap();
        assert_eq!(verdict.status(), status, "{weight} {q} {sentence}: {verdict:?}");
    }
}

/// Sentences may name what the family has, and nothing else.
#[test]
fn sentences_about_a_family_name_its_parameters() {
    for (name, sentence, rule) in [
        ("lupas", "k; U : alpha = infinity", "the family lupas has no `alpha`"),
        ("lupas", "k; U : r > 1", "the family lupas has no `r`"),
        ("lupas", "alpha in {2}; k; U : k = 1", "the family lupas has no index"),
        ("lupas", "k; U; beta index : k = 1", "the family lupas has no index"),
        ("lupas", "k; U; q in 0..n : q = 1", "`q` is bound already"),
        ("lupas", "k; U; i in 0..n; x : G[i](x; alpha = 2) = 1", "the family lupas has no `alpha` here"),
        ("lupas", "a; b; x : phi(x, a, b) = 1", "depends on more than two ends"),
        ("knot-weights", "k; U : omega > 1", "`omega` has another number of indices"),
        ("knot-weights", "k; U; i in 0..n; x : G[i](x; omega = 2) = 1", "has no `omega` here"),
    ] {
        let complaint = family(name).known().one_line(sentence).err().unwrap_or_else(|| panic!("{sentence}"));
        assert!(complaint.rule().contains(rule), "{complaint}");
    }
    for (name, sentence, status) in [
        ("lupas", "k = 2; U clamped : G'[0](t[0]) = -(1+q)/(t[k+1]-t[0])", "proved"),
        ("lupas", "k = 2; U clamped : G'[0](t[0]) = -2*q/(t[k+1]-t[0])", "refuted"),
        ("lupas", "k = 1; U clamped : G'[0](t[0]) = -1/(t[2]-t[0])", "proved"),
        ("lupas", "k <= 2; U; i in 0..n; x in [t[0], t[m]] : G[i](x; q = 1/q) = G[i](x; dual)", "proved"),
        ("square", "a; b; x in [a, b] | a < b : phi(x, a, b) <= 1", "proved"),
        ("square", "x in (0, 1) : phi(x, 0, 1) = x^2/(x^2 + (1-x)^2)", "proved"),
        (
            "knot-weights",
            "k = 1; U; i in 0..n; x in (t[i], t[i+1]) : G[i](x) = omega[i+1]*(x-t[i])/(omega[i+1]*(x-t[i]) + omega[i]*(t[i+1]-x))",
            "proved",
        ),
    ] {
        let read = family(name).known().one_line(sentence).unwrap_or_else(|complaint| panic!("{complaint}"));
        let cases = Cases::of_family(&family(name), &[]).unwrap().up_to(2);
        let verdict = judge(&read, knotproof::meaning::Names::empty(), &cases.of(&read, None)).unwrap();
        assert_eq!(verdict.status(), status, "{name} {sentence}: {verdict:?}");
    }
}

/// What the schema says of a file is what is read: of shipped ones, and of some that are none.
#[test]
fn files_are_as_their_schema_says() {
    let schema = serde_json::to_value(knotproof::language::family_schema()).unwrap();
    let validator = jsonschema::draft202012::options().build(&schema).unwrap();
    let valid = |text: &str| {
        let data: serde_json::Value = toml::from_str(text).unwrap();
        validator.is_valid(&data)
    };
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("families");
    for entry in std::fs::read_dir(folder).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
        assert!(valid(&text), "{text}");
        assert!(!valid(&text.replace("rise", "rize")), "{text}");
        assert!(!valid(&text.replace("title =", "more = 1\ntitle =")), "{text}");
    }
}

/// A certificate says the weights that its claim is about, and the checker reads them.
#[test]
fn claims_about_other_weights_have_certificates() {
    for (name, weights) in [("knot-weights", "omega"), ("pq", "pq-lupas"), ("classical", "classical")] {
        let paper = shipped(name).unwrap();
        let mut found = Vec::new();
        for claim in Claim::of(paper).take(6) {
            found.extend(certify(claim, Form::Printed, None).unwrap());
            found.extend(certify_for_degree(claim, Form::Printed, Some(2)).unwrap());
        }
        let texts: Vec<_> = found.iter().map(Certificate::statement_text).collect();
        // What is asked first of the classical functions holds for any weights.
        let own = name == "classical" || texts.iter().any(|text| text.contains(weights));
        assert!(own && !texts.is_empty(), "{name}: {texts:?}");
        assert!(texts.iter().all(|text| text.contains(weights) || text.contains("(family any)")), "{name}");
        for certificate in &found {
            // What is proved of one family is not said of another one.
            let Ok(checked) = certificate.check() else { panic!("{name}: {}", certificate.name()) };
            assert_eq!(checked.any_weights, certificate.statement_text().contains("(family any)"));
        }
    }
}

/// Of class C^(k−p) at a knot of p copies: knot weights as polynomial B-splines, in the degrees in which the proof is short enough.
#[test]
fn continuity_is_certified_up_to_degree_3() {
    for (paper, id) in [("knot-weights", "KW3.2"), ("classical", "Continuity")] {
        let claim = Claim::of(shipped(paper).unwrap()).find(|claim| claim.id() == id).unwrap();
        let certificate = certify(claim, Form::Printed, None).unwrap().unwrap();
        let checked = certificate.check().unwrap();
        assert_eq!((checked.degrees, checked.goals_are), (vec![1, 2, 3], "derived"), "{id}");
    }
}

/// The command that repeats a witness is about the form that it refutes.
#[test]
fn a_witness_is_repeated_in_its_form() {
    let Verdict::Refuted(mut witness) = verdict("lupas", "C1", 2) else { panic!("C1 fails") };
    witness.looked.clear();
    let of = |form| witness.again("C1", form, paper());
    assert!(of(Form::Amended).ends_with("--property C1 --amended"), "{}", of(Form::Amended));
    assert!(of(Form::Printed).ends_with("--property C1"), "{}", of(Form::Printed));
    assert_eq!(of(Form::Fails), "knotproof report --claim C1");
}
