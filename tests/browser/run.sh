#!/usr/bin/env bash
# Runs the browser journeys against real servers: tests/browser/run.sh FLOEPLAN_BINARY [--update | playwright arguments]
#
# --update makes the pictures of the guide (web/guide/pictures) anew where today's page differs from them.
# Needs web/dist (npm run build) and Chromium (CHROMIUM_BIN, default /usr/bin/chromium). Makes a store with the demonstration
# data, of which each worker's server has a copy, and removes it afterwards. The exit code is that of the tests.
# Beside a database server (tests/support/at_database_server tests/browser/run.sh ...) the stores of the servers lie there.
# PLAYWRIGHT_WORKERS says how many run beside each other (2). With FLOEPLAN_LOAD=1 and the argument "load" it measures a desk
# with ten days of hourly currents, 300 icebergs and 20 plans, and prints the figures beside their budgets; with the argument
# "frames" the scripts of a frame while the clock plays, also among 450 icebergs, and the time until the map is usable.
set -euo pipefail

if [[ $# -lt 1 ]]; then
  echo "usage: $0 FLOEPLAN_BINARY [--update | playwright arguments]" >&2
  exit 2
fi
floeplan=$(realpath "$1")
shift
here=$(cd "$(dirname "$0")" && pwd)
web=$(cd "$here/../../web" && pwd)

if [[ ! -f $web/dist/index.html ]]; then
  echo "$web/dist is missing: run npm ci and npm run build in $web first" >&2
  exit 1
fi

if [[ ${1:-} == --update ]]; then
  export FLOEPLAN_LONG=1
  set -- guide_pictures --update-snapshots
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$floeplan" --data "$work/store" demo "$work/demo" --start 2026-11-22 >"$work/files"
mapfile -t files <"$work/files"
"$floeplan" --data "$work/store" ingest "${files[@]}"

# The journeys use the packages of web/, the only place in the tree with a package lock.
NODE_PATH=$web/node_modules FLOEPLAN_BIN=$floeplan FLOEPLAN_SEED=$work/store FLOEPLAN_WEB=$web/dist \
  PLAYWRIGHT_OUTPUT=${PLAYWRIGHT_OUTPUT:-/tmp/floeplan-browser-results} \
  "$web/node_modules/.bin/playwright" test --config "$here/playwright.config.ts" "$@"
