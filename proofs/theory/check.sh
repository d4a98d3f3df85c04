#!/usr/bin/env bash
# Compiles the theorems for every degree and asks Coq what each one rests on. Exits 1 unless every row of theorems.toml, and
# every theorem about a printed stanza, is "Closed under the global context", and unless wrong numbers are refused;
# `check.sh table` prints the table of README.md from the rows.
set -eu
cd "$(dirname "$0")"

# One line a row: the values of the keys in this order, separated by tabs.
rows() {
  awk '
    function flush() { if (seen) { for (i = 1; i <= n; i++) printf "%s%s", row[key[i]], i < n ? "\t" : "\n" } seen = 0; delete row }
    BEGIN { n = split("claim form verdict name file degrees weights covers says lacks", key, " ") }
    /^\[\[theorem\]\]/ { flush(); seen = 1; next }
    /^[a-z]+ = "/ { k = $1; v = $0; sub(/^[a-z]+ = "/, "", v); sub(/"$/, "", v); row[k] = v }
    END { flush() }' theorems.toml
}

table() {
  echo "| claim | form | verdict | theorem | what it says | degrees | weights | covers |"
  echo "|---|---|---|---|---|---|---|---|"
  rows | awk -F'\t' '{ gsub(/\|/, "\\|"); printf "| %s | %s | %s | [`%s`](%s) | %s | %s | %s | %s |\n", $1, $2, $3, $4, $5, $9, $6, $7, ($10 == "" ? $8 : $8 ": " $10) }'
}

if [ "${1:-}" = table ]; then table; exit; fi
fail() { echo "$*" >&2; exit 1; }

rows | while IFS=$'\t' read -r claim form verdict name file degrees weights covers rest; do
  [ -n "$claim" ] && [ -n "$name" ] && [ -n "$degrees" ] && [ -n "$weights" ] || fail "theorems.toml: a key is missing at $claim $name"
  case $form in printed|amended|fails|lemma) ;; *) fail "theorems.toml: form of $name";; esac
  case $verdict in proved|refuted) ;; *) fail "theorems.toml: verdict of $name";; esac
  case $covers in all|part) ;; *) fail "theorems.toml: covers of $name";; esac
  [ -e "$file" ] || fail "theorems.toml: no file $file"
  grep -qE "^(Theorem|Lemma|Corollary) $name( |:)" "$file" || fail "theorems.toml: no theorem $name in $file"
done
diff <(table) <(sed -n '/^| claim | form/,/^$/p' README.md | sed '/^$/d') || fail "README.md: its table is not that of theorems.toml (check.sh table)"
diff <(ls ./*.v | sed 's|^\./||' | sort) <(grep '\.v$' _CoqProject | sort) || fail "_CoqProject: not the files that there are"
if grep -nE '\b(Admitted|admit|Axioms?|Parameters?)\b|^ *((Local|Global) )?Conjectures?\b|bypass_check|Unset (Guard|Positivity|Universe) Checking|type-in-type|-noinit' ./*.v _CoqProject; then
  fail "a proof is missing, or something is assumed"
fi

if ! command -v coqc >/dev/null; then
  if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null; then
    echo "skipped: coqc is not installed, and installing it takes root and apt"; exit 0
  fi
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends make coq libcoq-mathcomp-ssreflect libcoq-mathcomp-algebra \
    libcoq-mathcomp-algebra-tactics libcoq-mathcomp-zify libcoq-mathcomp-real-closed >/dev/null
fi
start=$(date +%s)
make -s -j"$(nproc)" >/dev/null

work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
ask() { coqc -w none -R . Bsplines "$work/$1.v" > "$work/$1" || fail "theorems.toml names a theorem that is not there"; }
# The theorems of the rows, and those about the printed stanzas.
names=$({
  rows | awk -F'\t' '{ sub(/\.v$/, "", $5); print $5 "." $4 }'
  sed -nE 's/^Theorem (stanza_[A-Za-z0-9_]+) .*/Bridge.\1/p' Bridge.v
} | sort -u)
files=$(echo "$names" | cut -d. -f1 | sort -u | tr '\n' ' ')
# All theorems at once, as a tuple: what it rests on is what any of them rests on. Each by itself only if that is not nothing.
{
  echo "From Bsplines Require $files."
  echo "Definition all_theorems := ("
  echo "$names" | sed 's/.*/@Bsplines.&,/'
  echo "I). Print Assumptions all_theorems."
} > "$work/all.v"
ask all
if grep -qvx 'Closed under the global context' "$work/all"; then
  { echo "From Bsplines Require $files."; echo "$names" | sed 's/.*/Print Assumptions Bsplines.&./'; } > "$work/each.v"
  ask each
  cat "$work/each" >&2; fail "a theorem rests on an axiom"
fi
wanted=$(echo "$names" | wc -l)
[ "$(cat "$work/all")" = 'Closed under the global context' ] && [ "$wanted" -gt 100 ] || fail "Coq did not say what the theorems rest on"

# A wrong number is no number of the functions: of each kind of example one is changed, and Coq has to refuse it.
for kind in value wt Gleft DGleft DGright; do
  awk -v kind=" : $kind " '
    !changed && index($0, kind) && / = q \(-?[0-9]+#/ { changed = 1; sub(/ = q \(/, "&1") ; sub(/ = q \(1-/, " = q (-1") }
    { print } END { exit !changed }' Examples.v > "$work/Wrong.v" || fail "Examples.v: no example of $kind"
  if coqc -w none -R . Bsplines "$work/Wrong.v" >"$work/out" 2>&1; then fail "Examples.v: a wrong number of $kind is accepted"; fi
  grep -q 'Unable to unify' "$work/out" || fail "Examples.v: refused for another reason: $(cat "$work/out")"
done
echo "$wanted theorems, $(grep -c '^Example ' Examples.v) numbers, $(ls ./*.v | wc -l) files, closed under the global context, $(( $(date +%s) - start )) s"
