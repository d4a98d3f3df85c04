#[test]
fn parses() {
    let text = std::fs::read_to_string("papers/rational-bsplines/claims/14-questions.toml").unwrap();
    match knotproof::language::stanzas("14-questions.toml", &text) {
        Ok(file) => println!("{} claims", file.claims.len()),
        Err(complaints) => { for c in complaints { println!("{c}"); } panic!() }
    }
}
