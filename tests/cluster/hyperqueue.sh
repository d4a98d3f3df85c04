#!/usr/bin/env bash
# The recipe of docs/cluster.md on a real HyperQueue of one machine: a search in shards, merged, and compared byte by byte with the same
# search in one process; then once more, when there is nothing left to do.
#
# Installs HyperQueue's Python package into a temporary folder; needs python3 with venv, which is installed as root if it is missing.
#
# usage: tests/cluster/hyperqueue.sh [PATH OF knotproof]
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$repository/target/release/knotproof}
[ -x "$program" ] || { echo "there is no program $program: run cargo build --release" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/shards"
ln -s "$program" "$work/bin/knotproof"
export PATH="$work/bin:$PATH"
python3 -m venv "$work/venv" > /dev/null 2>&1 || {
    { apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends python3-venv; } > /dev/null
    python3 -m venv "$work/venv"
}
"$work/venv/bin/pip" install --quiet hyperqueue==0.27.0 tqdm cloudpickle

awk '/^```$/ { inside = 0 } inside { print } /^```python$/ { inside = 1 }' "$repository/docs/cluster.md" > "$work/shards/shards.py"
grep -q hyperqueue "$work/shards/shards.py" || { echo "docs/cluster.md has no recipe for HyperQueue" >&2; exit 1; }

export SEARCH="--degree 5 --count 2000 --seed 1" SHARDS=8 HQ_SERVER_DIR="$work/server"
cd "$work/shards"
cat > ../cluster.py << 'PYTHON'
import os, subprocess, sys
from hyperqueue.cluster import LocalCluster

with LocalCluster(server_dir=os.environ["HQ_SERVER_DIR"]) as cluster:
    cluster.start_worker()
    for attempt in range(2):
        subprocess.run([sys.executable, "shards.py"], check=True)
PYTHON
"$work/venv/bin/python" ../cluster.py > ../cluster.log 2>&1 || { cat ../cluster.log shard-*.log >&2; exit 1; }

code=0
# shellcheck disable=SC2086 # SEARCH is several words.
knotproof search $SEARCH --format json > ../whole.jsonl || code=$?
[ "$code" -le 1 ]
knotproof merge shard-*.jsonl --out ../result.jsonl > /dev/null || [ $? -eq 1 ]
cmp ../result.jsonl ../whole.jsonl
echo "HyperQueue: $SHARDS shards, merged, are the result of one process"
