#!/usr/bin/env bash
# Runs make targets one after the other, all of them even when one fails, then says what each took and what it counted.
set -uo pipefail
export LC_NUMERIC=C
cd "$(dirname "$0")/.."

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
failed=0 table=

for stage in "$@"; do
  printf '\n== %s\n' "$stage"
  begin=$EPOCHREALTIME
  if make --no-print-directory "$stage" </dev/null 2>&1 | tee -a "$log/all"; then verdict=ok; else verdict=FAILED failed=1; fi
  table+=$(awk -v a="$begin" -v b="$EPOCHREALTIME" -v s="$stage" -v v="$verdict" 'BEGIN { printf "%-14s %8.1f s  %s", s, b - a, v }')$'\n'
done

printf '\n%s' "$table"
# Cargo and wasm-bindgen print "test result: ok. 3 passed; 0 failed;", node "ℹ pass 3" and "ℹ fail 0".
awk '/^test result:/ { for (i = 2; i <= NF; i++) { if ($i ~ /^passed/) p += $(i - 1); if ($i ~ /^failed/) f += $(i - 1) } }
     /^ℹ pass [0-9]/ { p += $3 } /^ℹ fail [0-9]/ { f += $3 }
     END { printf "%d passed, %d failed\n", p, f }' "$log/all"
[ $failed = 0 ] || echo "something above FAILED"
exit $failed
