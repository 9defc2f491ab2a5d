#!/usr/bin/env bash
# Runs the official executable test suites of OGC API - Features, Processes and EDR against a server with the demonstration
# data, each as its maintainers publish it (an all-in-one jar), and counts what they found: the jars themselves report
# success even when tests fail. The last lines are one for each suite, as "features: passed 80 failed 0 skipped 3".
# usage: deploy/conformance.sh [PROGRAM]      PROGRAM: the built floeplan; default build/release/floeplan
#
# ETS_JARS=DIR  take the jars from there: ets-ogcapi-features10-1.9-aio.jar, ets-ogcapi-processes10-1.3-aio.jar,
#               ets-ogcapi-edr10-1.3-aio.jar; else they are fetched from Maven Central into build/ets
# Exit code: 0 no failure, 1 failures, 77 a suite cannot be had (Java 17 or a jar is missing).
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly program=${1:-$root/build/release/floeplan}
readonly jars=${ETS_JARS:-$root/build/ets}
readonly maven_central=https://repo1.maven.org/maven2/org/opengis/cite
readonly suites=(features10:1.9 processes10:1.3 edr10:1.3)
# Methods of the Processes suite that fetch schemas from schemas.opengis.net while they run.
readonly needs_internet=(testLandingPageValidation testValidateConformanceOperationAndResponse testProcessListSuccess
  testJobListSuccess testJobResults testJobCreationInputValidation testJobResultsExceptionResultsNotReady)

cannot_run() {
  printf 'floeplan: the suites were not run: %s\n' "$1" >&2
  exit 77
}

jar_of() { echo "$jars/ets-ogcapi-${1%%:*}-${1##*:}-aio.jar"; }

fetch_jars() {
  mkdir -p "$jars"
  local suite jar name
  for suite in "${suites[@]}"; do
    jar=$(jar_of "$suite")
    if [[ -s $jar ]]; then continue; fi
    name=ets-ogcapi-${suite%%:*}
    curl --fail --silent --show-error --location --max-time 300 --output "$jar.part" \
      "$maven_central/$name/${suite##*:}/$(basename "$jar")" || {
      rm -f "$jar.part"
      cannot_run "org.opengis.cite:$name:${suite##*:}:jar:aio cannot be fetched from Maven Central; set ETS_JARS"
    }
    mv "$jar.part" "$jar"
  done
}

# start_server: serves the demonstration data, with a plan so that no collection is empty; sets `address`.
start_server() {
  "$program" demo "$work/demo" --start 2026-11-22 >/dev/null
  "$program" --data "$work/store" ingest "$work"/demo/*.nc "$work"/demo/*.geojson >/dev/null
  "$program" --data "$work/store" serve --listen 127.0.0.1:0 2>"$work/server.log" &
  server=$!
  local waited=0
  until address=$(grep -om1 'http://127.0.0.1:[0-9]*' "$work/server.log"); do
    if ((++waited > 100)); then fail "the server did not start" "read $work/server.log"; fi
    sleep 0.1
  done
  curl --fail --silent -H 'Content-Type: application/json' --output /dev/null \
    --data '{"inputs": {"from": [-53.0, 69.0], "to": [-52.9, 69.02], "depart": "2026-11-22T06:00:00Z", "spacing_m": 2000}}' \
    "$address/processes/plan-route/execution"
}

# properties KEY VALUE...: the arguments of a suite. No DOCTYPE: the parser would fetch its DTD.
properties() {
  printf '<?xml version="1.0" encoding="UTF-8"?>\n<properties version="1.0">\n'
  while (($# > 0)); do
    printf '  <entry key="%s">%s</entry>\n' "$1" "$2"
    shift 2
  done
  printf '</properties>\n'
}

arguments_of() {
  case $1 in
    features10) properties iut "$address" noofcollections -1 ;;
    processes10) properties iut "$address" echoprocessid echo ;;
    edr10) properties iut "$address/edr" apiDefinition "$address/edr/api" noofcollections 3 ;;
  esac
}

# run_suite NAME:VERSION: prints its line and returns 1 when a test failed.
run_suite() {
  local name=${1%%:*} out=$work/${1%%:*}
  mkdir -p "$out"
  arguments_of "$name" >"$out/arguments.xml"
  java -jar "$(jar_of "$1")" -o "$out" "$out/arguments.xml" >"$out/log.txt" 2>&1 || true
  python3 "$root/deploy/count_tests.py" "$name" "$out" "${offline[@]}"
}

command -v java >/dev/null || cannot_run "Java is not installed (package openjdk-17-jre-headless)"
[[ -x $program ]] || fail "there is no program at $program" "build it with deploy/build.sh"
fetch_jars
offline=()
curl --fail --silent --head --max-time 20 --output /dev/null https://schemas.opengis.net/ || offline=("${needs_internet[@]}")

work=$(mktemp -d)
server=0
# shellcheck disable=SC2317 # called by the trap
finish() {
  if ((server > 0)); then kill "$server" 2>/dev/null || true; fi
  rm -rf "$work"
}
trap finish EXIT
start_server
failed=0
for suite in "${suites[@]}"; do run_suite "$suite" >>"$work/lines" || failed=1; done
grep -v ': passed ' "$work/lines" || true
grep ': passed ' "$work/lines"
exit "$failed"
