#!/usr/bin/env bash
# What a release consists of, in target/dist: an archive with the program, its manual pages and completions, the Python wheel, both crates,
# and the sums of all of them.
#
# Builds program and wheel optimised, which takes a quarter of an hour; or packs those that are given. The wheel needs Python 3.10 or later.
#
# usage: .ci/release.sh [PROGRAM WHEEL]
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
host=$(rustc -vV | sed -n 's/^host: //p')
dist=$PWD/target/dist
rm -rf "$dist" && mkdir -p "$dist"

if [ $# -eq 2 ]; then
    program=$1
    cp "$2" "$dist"
else
    cargo build --locked --release
    program=$PWD/target/release/knotproof
    python3 -m venv target/maturin
    target/maturin/bin/pip install --quiet --disable-pip-version-check 'maturin>=1.9,<2'
    target/maturin/bin/maturin build --release --locked --manifest-path python/Cargo.toml --out "$dist"
fi
[ "$("$program" --version)" = "knotproof $version" ] || { echo "$program is not knotproof $version" >&2; exit 1; }

# As below /usr/local.
name=knotproof-$version-$host
root=$dist/$name
mkdir -p "$root"/{bin,share/bash-completion/completions,share/zsh/site-functions,share/fish/vendor_completions.d,share/doc/knotproof}
cp "$program" "$root/bin/knotproof"
"$program" man --out "$root/share/man/man1" > /dev/null
"$program" completions bash > "$root/share/bash-completion/completions/knotproof"
"$program" completions zsh > "$root/share/zsh/site-functions/_knotproof"
"$program" completions fish > "$root/share/fish/vendor_completions.d/knotproof.fish"
cp README.md CHANGELOG.md CITATION.cff LICENSE-MIT LICENSE-APACHE "$root/share/doc/knotproof"
tar -C "$dist" -czf "$dist/$name.tar.gz" "$name"
rm -r "$root"

cargo package --quiet --locked --allow-dirty --no-verify --package knotproof --package knotproof-checker
cp target/package/knotproof-"$version".crate target/package/knotproof-checker-"$version".crate "$dist"
cd "$dist"
sha256sum -- * | tee SHA256SUMS
