#!/usr/bin/env bash
# Runs make targets one after the other, all of them even when one fails, then prints the time and the counts of each. A target with an `&`
# behind it runs beside those that follow, up to `wait`.
set -uo pipefail
export LC_NUMERIC=C
cd "$(dirname "$0")/.."

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
failed=0 table= beside=

# Runs a target and leaves its row of the table in a file.
stage() {
  local begin=$EPOCHREALTIME verdict=ok
  printf '\n== %s\n' "$1"
  make --no-print-directory "$1" </dev/null 2>&1 || verdict=FAILED
  awk -v a="$begin" -v b="$EPOCHREALTIME" -v s="$1" -v v="$verdict" 'BEGIN { printf "%-14s %8.1f s  %s\n", s, b - a, v }' >"$log/$1.row"
  [ $verdict = ok ]
}

for name in "$@"; do
  case $name in
    *'&')
      beside=${name%&}
      stage "$beside" >"$log/beside" &
      continue
      ;;
    wait)
      name=$beside
      wait $! || failed=1
      tee -a "$log/all" <"$log/beside"
      ;;
    *) stage "$name" | tee -a "$log/all" || failed=1 ;;
  esac
  table+=$(<"$log/$name.row")$'\n'
done

printf '\n%s' "$table"
# Cargo and wasm-bindgen print "test result: ok. 3 passed; 0 failed;", node "ℹ pass 3" and "ℹ fail 0".
awk '/^test result:/ { for (i = 2; i <= NF; i++) { if ($i ~ /^passed/) p += $(i - 1); if ($i ~ /^failed/) f += $(i - 1) } }
     /^ℹ pass [0-9]/ { p += $3 } /^ℹ fail [0-9]/ { f += $3 }
     END { printf "%d passed, %d failed\n", p, f }' "$log/all"
[ $failed = 0 ] || echo "something above FAILED"
exit $failed
