#!/usr/bin/env bash
# Runs the browser journeys against a real server: tests/browser/run.sh FLOEPLAN_BINARY
#
# Needs web/dist (npm run build) and Chromium (CHROMIUM_BIN, default /usr/bin/chromium). Makes a store of its own with the
# demonstration data and removes it afterwards. The exit code is that of the tests.
set -euo pipefail

if [[ $# -lt 1 ]]; then
  echo "usage: $0 FLOEPLAN_BINARY [playwright arguments]" >&2
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

work=$(mktemp -d)
server=
stop() {
  if [[ -n $server ]]; then
    kill "$server" 2>/dev/null || true
    wait "$server" 2>/dev/null || true
  fi
  rm -rf "$work"
}
trap stop EXIT

"$floeplan" --data "$work/store" demo "$work/demo" >"$work/files"
mapfile -t files <"$work/files"
"$floeplan" --data "$work/store" ingest "${files[@]}"

"$floeplan" --data "$work/store" serve --listen 127.0.0.1:0 --web "$web/dist" 2>"$work/server.log" &
server=$!

url=
for _ in $(seq 150); do
  url=$(sed -n 's#^floeplan: serving \(http://[^ ]*\).*#\1#p' "$work/server.log" | head -n 1)
  [[ -n $url ]] && break
  if ! kill -0 "$server" 2>/dev/null; then break; fi
  sleep 0.2
done
if [[ -z $url ]]; then
  echo "the server did not start:" >&2
  cat "$work/server.log" >&2
  exit 1
fi

status=0
# The journeys use the packages of web/, the only place in the tree with a package lock.
NODE_PATH=$web/node_modules FLOEPLAN_URL=${url%/} PLAYWRIGHT_OUTPUT=${PLAYWRIGHT_OUTPUT:-/tmp/floeplan-browser-results} \
  "$web/node_modules/.bin/playwright" test --config "$here/playwright.config.ts" "$@" || status=$?
if [[ $status -ne 0 ]]; then
  echo "--- the server's last words" >&2
  tail -n 20 "$work/server.log" >&2
fi
exit "$status"
