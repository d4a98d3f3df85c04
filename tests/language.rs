//! The claim language: what is read, and that printing is read back.

use knotproof::language::{Known, one_line, sentence};

/// One sentence of every kind that the page of the language shows.
const LINES: &[&str] = &[
    "k; U; j in 0..m-1; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = sum(i in j-k..j: G[i](x)) = 1",
    "k; U symmetric; i in 0..n; x in [t[0], t[m]] : G[i](t[0]+t[m]-x) = G[n-i](x; alpha = 1-alpha)",
    "k >= 1; U open : G'[1](t[0]+) = -G'[0](t[0]+) = k*alpha/((alpha-1)*(t[k+1]-t[0])); all(i in 2..n: G'[i](t[0]+) = 0)",
    "k >= 1; U; i in 0..n | t[i] < t[i+k+1]; continuous(G[i]) : maxima(G[i]) = 1",
    "a; b; x | a < b : 0 <= phi(x, a, b) < 1; phi(x, a, b; alpha = infinity) = max(0, (x-a)/(b-a)) or x >= b",
    "s < 0; h; a; b; x : phi(s*x+h, s*b+h, s*a+h) = 1 - phi(x, a, b; alpha = 1-alpha)",
    "U in {C5, C7a}; alpha in {-1/2, 6/5, infinity}; beta index; x in (t[0], t[m]) | alpha != infinity : abs(P[0,1]) >= 0 and G[0](x-; alpha = beta) = 1",
    "k in 1..3; U; d points; i in 0..n : changes(sum(j in 0..n: d[j]*G[j](x)), x in [t[0], t[m]]) <= polygon_changes(d)",
    "k = 2; U; x in (t[0], t[m]) : not some(i in 0..n: G[i](x) < 0) => one(i in 0..n: x in [t[i], t[i+1])) <=> claim(X.linear, printed)",
    "k; U; q in 0..k; x in (t[0], t[m]); r1 > 0 : D(G[0], q)(x+; r = r1) = -x^2 + binomial(k, q)*x^(k-q) - 2/3*x^-1",
    "k >= 3; q in 0..2; U gaps (each(j in 1..k: 0), 1, (k-2)*r - q, 1/8, each(j in 1..k: 0)) : m = 2*k+3",
    "k = 2; U in {U0, S3} : U in {S3} => t[4] = t[5]",
];

#[test]
fn every_form_is_read() {
    for line in LINES {
        if let Err(complaint) = one_line(line) {
            panic!("{complaint}");
        }
    }
}

#[test]
fn definitions_are_known_where_they_are_defined() {
    let known = Known::defining(&[
        ("C(x)", "sum(i in 0..n: d[i]*G[i](x))"),
        ("b[i,0](x)", "d[i]"),
        ("b[i,q](x)", "w[i,k-q+1](x)*b[i,q-1](x) + (1 - w[i,k-q+1](x))*b[i-1,q-1](x)"),
    ])
    .unwrap();
    let read = sentence("k; U; d points; j in k..n; x in [t[j], t[j+1])", &[], &["b[j,k](x) = C(x)"], &known);
    assert!(read.is_ok(), "{}", read.unwrap_err());
    let missing = sentence("k; U; x in [t[0], t[m]]", &[], &["C(x) = 0"], &known).unwrap_err();
    assert_eq!((missing.place(), missing.advice()), ((1, 1), "bind it in `for`: `d points`"), "{missing}");
}
