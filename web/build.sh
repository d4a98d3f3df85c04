#!/usr/bin/env bash
# Builds the modules of the page for WebAssembly: panel, judge and checker, each compressed, as the report embeds them.
#
# The bytes depend on the sources, Cargo.lock and the compiler, not on where that stands. Needs the target:
# rustup target add wasm32-unknown-unknown.
#
# usage: web/build.sh [FOLDER]; without one they take the place of those that are committed
set -euo pipefail
repository=$(cd "$(dirname "$0")/.." && pwd)
committed=$repository/src/report/page/modules
folder=${1:-$committed}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$repository"

target=wasm32-unknown-unknown
# No path of this machine in a message of a panic, and a stack as deep as a thread of the program has.
export RUSTFLAGS="--remap-path-prefix=$repository=knotproof --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo --remap-path-prefix=$(rustc --print sysroot)=rust -Clink-arg=-zstack-size=4194304"
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$repository/target}
cargo build --locked --quiet --profile web --target "$target" \
    -p knotproof-web-panel -p knotproof-web-judge -p knotproof-web-checker
for module in panel judge checker; do
    gzip -9 -n -c "$CARGO_TARGET_DIR/$target/web/knotproof_web_$module.wasm" > "$folder/$module.wasm.gz"
    echo "$module: $(stat -c %s "$folder/$module.wasm.gz") bytes compressed"
done
rustc --version > "$folder/rustc"
