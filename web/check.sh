#!/usr/bin/env bash
# The modules of the page: those that are committed are what the sources give, byte for byte where the compiler is the one that they
# were built with, and they say what the program says: web/check.mjs.
#
# Needs Node 18 or later and the target wasm32-unknown-unknown; as root, it installs Debian's package nodejs and the target if they
# are missing. Exit code 77: the target can't be had.
#
# usage: web/check.sh [PATH OF knotproof]
set -euo pipefail
repository=$(cd "$(dirname "$0")/.." && pwd)
program=${1:-$repository/target/debug/knotproof}
committed=$repository/src/report/page/modules
built=$repository/target/modules

if ! command -v node > /dev/null; then
    if [ "$(id -u)" -ne 0 ] || ! command -v apt-get > /dev/null; then
        echo "FAILED  nodejs must be installed first" >&2
        exit 1
    fi
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends nodejs
fi
target=wasm32-unknown-unknown
if [ ! -d "$(rustc --print sysroot)/lib/rustlib/$target" ] && ! rustup target add "$target"; then
    echo "the target $target can't be had" >&2
    exit 77
fi

cd "$repository"
packages=(--package knotproof-abi --package knotproof-web-panel --package knotproof-web-judge --package knotproof-web-checker)
cargo fmt "${packages[@]}" --check
cargo test --locked --quiet --package knotproof-abi
cargo clippy --locked --quiet --target "$target" "${packages[@]}" -- -D warnings

web/build.sh "$built"
if cmp -s "$committed/rustc" "$built/rustc"; then
    for module in panel judge checker; do
        if ! cmp <(gzip -dc "$committed/$module.wasm.gz") <(gzip -dc "$built/$module.wasm.gz"); then
            echo "FAILED  $module is not what the sources give: run web/build.sh, and commit what it writes" >&2
            exit 1
        fi
    done
    echo "what is committed is what the sources give"
else
    echo "another compiler, $(cat "$built/rustc"): its modules are tried as well, and the bytes not compared"
    node web/check.mjs "$built" "$program"
fi
node web/check.mjs "$committed" "$program"
