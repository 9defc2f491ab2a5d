#!/usr/bin/env bash
# What deploy/quickstart.sh prints at its end, with the awk of a bare Debian: the plan with its id, departure, arrival, hours and
# kilometres, and a mission file that is there. Needs a tree that is built; changes build/quickstart alone.
# usage: tests/deploy/quickstart_test.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ln -s "$(command -v mawk)" "$work/awk"

rm -rf "$root/build/quickstart"
PATH=$work:$PATH "$root/deploy/quickstart.sh" --no-serve 2>&1 | tee "$work/printed"

# expect WHAT PATTERN: some line of what was printed matches.
expect() {
  if ! grep -qE "$2" "$work/printed"; then
    echo "FAILED: quickstart prints no $1 (no line matches $2)" >&2
    exit 1
  fi
}

today=$(date -u +%Y-%m-%d)
moment='[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}Z'
expect "route" "^p[0-9a-f]{12}  ${today}T06:00:00Z to $moment, [1-9][0-9]* h [0-9]{2} min, [1-9][0-9]*\.[0-9] km$"
expect "waypoints" "^S +69°12\.000′N +053°12\.000′W +${today}T06:00:00Z"
expect "mission file" "^$root/build/quickstart/mission/goto_l10\.ma$"
if grep -qiE 'runaway|warning: awk|: 0\.0+ h' "$work/printed"; then
  echo "FAILED: quickstart prints a fault of a tool, or no hours" >&2
  exit 1
fi
grep -q 'behavior_name=goto_list' "$root/build/quickstart/mission/goto_l10.ma"
echo "quickstart: as it should be"
