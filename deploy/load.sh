#!/usr/bin/env bash
# Measures how fast a server answers, beside a bare server that sends the same bytes, in one run on one machine; prints a
# line for each target and ends with 1 when one is missed. Wants wrk, curl and gdal-bin, an idle machine and two minutes.
# usage: deploy/load.sh [PROGRAM BARE_SERVER]     default: those of build/release, which it builds
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly seconds=${LOAD_SECONDS:-5}
missed=0

build() {
  run_or_fail "the servers do not compile" "read the first error above" \
    cmake --build "$root/build/release" -j "$(build_jobs)" --target floeplan floeplan_bare_server >&2
}

# serve LOG COMMAND...: starts it and prints its address.
serve() {
  local log=$1 waited=0 address
  shift
  "$@" >"$log" 2>&1 &
  echo $! >>"$work/pids"
  until address=$(grep -om1 'http://127.0.0.1:[0-9]*' "$log"); do
    if ((++waited > 200)); then fail "$1 did not start" "read $log"; fi
    sleep 0.1
  done
  echo "$address"
}

# milliseconds TEXT: of "850.00us", "3.20ms", "1.10s"
milliseconds() {
  awk -v text="$1" 'BEGIN { value = text + 0; print text ~ /us$/ ? value / 1000 : text ~ /ms$/ ? value : value * 1000 }'
}

# rate ADDRESS CONNECTIONS: requests a second, and the 50th and 99th percentile in ms
rate() {
  local report
  report=$(wrk --threads 1 --connections "$2" --duration "${seconds}s" --latency "$1")
  echo "$(awk '/^Requests\/sec/ {print $2}' <<<"$report") $(milliseconds "$(awk '$1 == "50%" {print $2}' <<<"$report")")" \
    "$(milliseconds "$(awk '$1 == "99%" {print $2}' <<<"$report")")"
}

# target NAME FOUND COMPARISON BOUND
target() {
  local verdict=met
  awk -v found="$2" -v bound="$4" "BEGIN { exit !(found $3 bound) }" || {
    verdict=MISSED
    missed=1
  }
  printf '%-58s %12s  %s %s  %s\n' "$1" "$2" "$3" "$4" "$verdict"
}

# against_bare NAME PATH: our rate as a share of that of a bare server that sends the same bytes.
against_bare() {
  local bytes=$work/$1.bytes bare ours theirs
  curl --fail --silent --output "$bytes" "$address$2"
  bare=$(serve "$work/$1.log" "$bare_server" "$bytes")
  ours=$(rate "$address$2" 8)
  theirs=$(rate "$bare/" 8)
  printf '%-58s ours %s; bare %s (%s bytes)\n' "$1 with 8 connections: requests/s, p50, p99 ms" "$ours" "$theirs" \
    "$(stat -c %s "$bytes")"
  target "$1: share of the bare server's rate" \
    "$(awk -v o="${ours%% *}" -v t="${theirs%% *}" 'BEGIN { printf "%.2f", o / t }')" '>=' 0.5
  target "$1: p99 with one connection, ms" "$(rate "$address$2" 1 | cut -d ' ' -f 3)" '<=' 5
}

elapsed_ms() {
  local begin end
  begin=$(date +%s%N)
  "$@" >/dev/null
  end=$(date +%s%N)
  echo $(((end - begin) / 1000000))
}

# least_ms COMMAND...: of five runs, after one that warms up
least_ms() {
  local best=999999 now
  "$@" >/dev/null
  for _ in 1 2 3 4 5; do
    now=$(elapsed_ms "$@")
    if ((now < best)); then best=$now; fi
  done
  echo "$best"
}

bergs() {
  awk 'BEGIN { printf "{\"type\":\"FeatureCollection\",\"features\":[";
    for (i = 0; i < 5000; ++i) printf "%s{\"type\":\"Feature\",\"properties\":{\"id\":\"B-%d\",\"observed\":\"2026-11-21T%02d:%02d:00Z\",\"length_m\":80},\"geometry\":{\"type\":\"Point\",\"coordinates\":[%.3f,%.3f]}}",
      i ? "," : "", i, (i / 60) % 24, i % 60, -60 + (i % 100) / 100, 60 + i / 5000; print "]}" }'
}

# plan REFINE: a new plan of 140 km in hourly currents, corner to corner of 100 by 100 km of water
plan() {
  curl --fail --silent -H 'Content-Type: application/json' --data "{\"force\": true, \"inputs\": {\"from\": [-54.4, 68.45],
    \"to\": [-51.95, 69.3], \"depart\": \"2026-11-22T06:00:00Z\", \"spacing_m\": 1000, \"refine\": $1}}" \
    "$address/processes/plan-route/execution" | grep '"plan_id"'
}

ogr_read() { ogr2ogr -f GeoJSON "$work/bergs-$RANDOM$RANDOM.out" "OAPIF:$address" icebergs -oo PAGE_SIZE=1000; }

main() {
  local program=${1-$root/build/release/floeplan}
  bare_server=${2-$root/build/release/floeplan_bare_server}
  if (($# == 0)); then build; fi
  command -v wrk >/dev/null || fail "wrk is not installed" "run deploy/install-deps --with-load"
  work=$(mktemp -d)
  trap 'xargs -r kill <"$work/pids" 2>/dev/null || true; rm -rf "$work"' EXIT
  "$program" demo "$work/demo" --start 2026-11-22 >/dev/null
  bergs >"$work/bergs.geojson"
  "$program" --data "$work/store" ingest "$work"/demo/*.nc "$work"/demo/*coastline*.geojson "$work/bergs.geojson" >/dev/null
  address=$(serve "$work/server.log" "$program" --data "$work/store" --log-level warning serve --listen 127.0.0.1:0)

  local small job edr
  small=$(curl --fail --silent -H 'Content-Type: application/json' --data '{"inputs": {"from": [-53, 69], "to": [-52.9, 69.02],
    "depart": "2026-11-22T06:00:00Z"}}' "$address/processes/plan-route/execution" |
    grep -o '"plan_id":"[^"]*"' | head -n 1 | cut -d '"' -f 4)
  job=$(curl --fail --silent "$address/jobs?limit=1" | grep -o '"jobID":"[^"]*"' | cut -d '"' -f 4)
  against_bare "job status" "/jobs/$job"
  against_bare "plan" "/collections/plans/items/$small"
  target "5,000 features by ogr2ogr, ms" "$(least_ms ogr_read)" '<' 1000
  edr="$address/edr/collections/currents/position?coords=POINT(-53.5+69)&z=0"
  edr+="&parameter-name=eastward_sea_water_velocity,northward_sea_water_velocity"
  target "EDR position, 2 parameters x 145 times: p50, ms" "$(rate "$edr" 1 | cut -d ' ' -f 2)" '<' 10
  target "100 by 100 km at 1 km, hourly currents, ms" "$(least_ms plan false)" '<' 300
  target "the same, refined, ms" "$(least_ms plan true)" '<' 1300

  for _ in 1 2 3 4; do (for _ in $(seq 40); do plan true >/dev/null 2>&1 || true; done) & done
  local busy bare
  bare=$(serve "$work/busy.log" "$bare_server" "$work/job status.bytes")
  busy=$(rate "$address/jobs/$job" 50)
  printf '%-58s ours %s; bare %s\n' "50 pilots, 4 plans at work: requests/s, p50, p99 ms" "$busy" "$(rate "$bare/" 50)"
  target "50 pilots while 4 plans are made: p99, ms" "$(cut -d ' ' -f 3 <<<"$busy")" '<=' 100
  return "$missed"
}

main "$@"
