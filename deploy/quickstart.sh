#!/usr/bin/env bash
# From a fresh source tree to a running server with a planned mission: installs, builds, writes demonstration data,
# reads them in, plans a route in Disko Bay, exports its mission files and serves everything to a browser.
# usage: deploy/quickstart.sh [--no-serve] [--listen ADDR:PORT]      everything it writes lies in build/ and web/
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly floeplan=$root/build/release/floeplan
readonly work=$root/build/quickstart
readonly from=-53.20,69.20 to=-51.35,69.18 # open bay to the mouth of Ilulissat Icefjord
readonly hours_after_start=6               # of the demonstration data
listen=127.0.0.1:8080
serve=yes

read_options() {
  while (($# > 0)); do
    case $1 in
      --no-serve) serve=no ;;
      --listen)
        [[ ${2-} == *:* ]] || fail "--listen needs an address and a port" "for example --listen 127.0.0.1:8081"
        listen=$2
        shift
        ;;
      *) fail "unknown option $1" "use: deploy/quickstart.sh [--no-serve] [--listen ADDR:PORT]" ;;
    esac
    shift
  done
}

# Told before the long work starts, not after it.
refuse_taken_port() {
  local port=${listen##*:} address=${listen%:*}
  if (exec 3<>"/dev/tcp/$address/$port") 2>/dev/null; then
    fail "another program already listens on $listen" "stop it, or choose another port: deploy/quickstart.sh --listen $address:$((port + 1))"
  fi
}

# json_value KEY TEXT: the first value of that name.
json_value() {
  if [[ $2 =~ \"$1\":\ *\"?([^\",}]*) ]]; then echo "${BASH_REMATCH[1]}"; fi
}

load_demo_data() {
  run_or_fail "the demonstration data could not be written to $work/demo" "check the free space of the disk" \
    "$floeplan" demo "$work/demo" >/dev/null
  local report
  report=$("$floeplan" --data "$work/store" ingest "$work"/demo/disko-* --json) ||
    fail "the demonstration data could not be read into $work/store" "remove $work and run this again"
  data_start=$(json_value time_start "$(grep -o '"time_start": *"[^"]*"' <<<"$report" || true)")
  [[ -n $data_start ]] || fail "the demonstration data name no start time" "remove $work and run this again"
}

plan_mission() {
  local depart
  depart=$(date -u -d "$data_start + $hours_after_start hours" +%Y-%m-%dT%H:%M:%SZ)
  plan=$("$floeplan" --data "$work/store" plan --from="$from" --to="$to" --depart "$depart" \
    --max-waypoints 9 --json) ||
    fail "no route was found from $from to $to at $depart" "the line above says why; remove $work and run this again"
}

export_mission() {
  rm -rf "$work/mission"
  run_or_fail "the mission files could not be written to $work/mission" "check the free space of the disk" \
    "$floeplan" --data "$work/store" export "$(json_value plan_id "$plan")" --format gliderdos --out "$work/mission" >/dev/null
}

summarise() {
  local distance_m travel_time_s
  distance_m=$(json_value distance_m "$plan")
  travel_time_s=$(json_value travel_time_s "$plan")
  say "done"
  printf 'route     %s to %s, %.1f km\n' "$from" "$to" "$(awk "BEGIN {print $distance_m / 1000}")"
  printf 'departure %s\narrival   %s (%.1f hours)\n' "$(json_value departure "$plan")" "$(json_value arrival "$plan")" \
    "$(awk "BEGIN {print $travel_time_s / 3600}")"
  printf 'mission   %s\n' "$work"/mission/*
  printf 'The depths, currents and icebergs are invented. No exported file has been tried on a vehicle.\n'
}

main() {
  read_options "$@"
  if [[ $serve == yes ]]; then refuse_taken_port; fi
  "$root/deploy/install-deps"
  "$root/deploy/build.sh"
  mkdir -p "$work"
  say "reading the demonstration data"
  load_demo_data
  say "planning"
  plan_mission
  export_mission
  summarise
  if [[ $serve == no ]]; then return; fi
  say "open http://$listen in a browser; Ctrl-C stops the server"
  exec "$floeplan" --data "$work/store" serve --listen "$listen" --web "$root/web/dist"
}

main "$@"
