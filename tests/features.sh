#!/usr/bin/env bash
# What users of the library get: each feature alone, the examples, and a project of their own.
set -euo pipefail
cd "$(dirname "$0")/.."
repository=$PWD

for feature in "" float claims prove search study report; do
    echo "${feature:-no feature}"
    cargo clippy --locked --quiet --package knotproof --lib --no-default-features --features "$feature" -- -D warnings
done

# Each program that an engineer would write runs, and says something.
mkdir -p target/examples-say
for program in examples/*.rs; do
    name=$(basename "$program" .rs)
    echo "example $name"
    cargo run --locked --quiet --example "$name" > "target/examples-say/$name"
    test -s "target/examples-say/$name"
done

# A new project takes the library without features, and with floats alone: so many crates, and the same results.
project=$repository/target/project
rm -rf "$project/src" && mkdir -p "$project/src/bin"
cp Cargo.lock "$project"
cat > "$project/Cargo.toml" << TOML
[package]
name = "project"
edition = "2024"

[dependencies]
knotproof = { path = "../..", default-features = false }

[features]
float = ["knotproof/float"]

[workspace]
TOML
cd "$project"
export CARGO_TARGET_DIR=$project/target
crates() {
    cargo tree --quiet --edges normal,build --prefix none --no-dedupe --format "{p}" "$@" |
        sort --unique | grep --count --invert-match --extended-regexp '^(project|knotproof) '
}
run() {
    local feature=$1 most=$2 programs=("${@:3}") name
    for name in "${programs[@]}"; do
        cp "$repository/examples/$name.rs" src/bin
    done
    for name in "${programs[@]}"; do
        cargo run --quiet --features "$feature" --bin "$name" | cmp - "$repository/target/examples-say/$name"
    done
    echo "a project with ${feature:-no feature}: $(crates --features "$feature") crates, at most $most"
    test "$(crates --features "$feature")" -le "$most"
}
run "" 11 tangents critical_points measure bezier
run float 22 values
