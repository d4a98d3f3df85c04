#!/usr/bin/env bash
# What is published: library and program, and the checker, packed as the registry takes them, and compiled from what was packed by the
# oldest compiler that they promise, with every feature.
#
# Installs that compiler, beside the one that is there, if it is missing. Exit code 77: it can't be had.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=0

value() { sed -n "s/^$1 = \"\(.*\)\"$/\1/p" Cargo.toml | head -n 1; }
version=$(value version)
oldest=$(value rust-version).0
packed=$PWD/target/package
built=$PWD/target/packed
# Not below this folder: there it would be taken for a part of the workspace.
unpacked=$(mktemp -d)
trap 'rm -rf "$unpacked"' EXIT

# Everything but the upload. What is not yet committed is packed as well: CI has nothing of that kind.
both=(--quiet --locked --allow-dirty --no-verify --package knotproof --package knotproof-checker)
cargo publish --dry-run "${both[@]}"
rm -f "$packed"/*.crate
cargo package "${both[@]}"

if ! rustup run "$oldest" rustc --version 2> /dev/null && ! rustup toolchain install "$oldest" --profile minimal; then
    echo "SKIPPED: Rust $oldest can't be had" >&2
    exit 77
fi
for package in knotproof knotproof-checker; do
    tar -xzf "$packed/$package-$version.crate" -C "$unpacked"
done
cd "$unpacked/knotproof-$version"
# Those who install it get the versions of Cargo.lock with --locked; the checker comes from beside it, as it is on no registry yet.
rustup run "$oldest" cargo check --quiet --all-features --lib --bins --target-dir "$built" \
    --config "patch.crates-io.knotproof-checker.path = '$unpacked/knotproof-checker-$version'"
echo "knotproof and knotproof-checker $version are packed, and compile with Rust $oldest"
