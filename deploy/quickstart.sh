#!/usr/bin/env bash
# From a fresh source tree to a running server with a planned mission: installs, builds, writes demonstration data that
# begin today, reads them in, plans a route in Disko Bay, exports its mission files and serves everything to a browser.
# usage: deploy/quickstart.sh [--no-serve] [--listen ADDR:PORT]      everything it writes lies in build/ and web/
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly floeplan=$root/build/release/floeplan
readonly work=$root/build/quickstart
readonly from=-53.20,69.20 to=-51.80,69.15 # across Disko Bay to the icebergs before Ilulissat Icefjord
listen=127.0.0.1:8080
serve=yes

read_options() {
  while (($# > 0)); do
    case $1 in
      -h | --help)
        sed -n '2,/^[^#]/s/^# *//p' "${BASH_SOURCE[0]}"
        exit
        ;;
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

# load_demo_data DAY
load_demo_data() {
  rm -rf "$work/demo"
  run_or_fail "the demonstration data could not be written to $work/demo" "check the free space of the disk" \
    "$floeplan" demo "$work/demo" --start "$1" >/dev/null
  run_or_fail "the demonstration data could not be read into $work/store" "remove $work and run this again" \
    "$floeplan" --data "$work/store" ingest "$work"/demo/disko-*
}

# plan_mission DEPARTURE: prints the plan as the program shows it to a pilot; its first word is the plan's id.
plan_mission() {
  "$floeplan" --data "$work/store" plan --from="$from" --to="$to" --depart "$1" --max-waypoints 9 >"$work/plan.txt" ||
    fail "no route was found from $from to $to at $1" "the line above says why; remove $work and run this again"
  cat "$work/plan.txt"
}

export_mission() {
  local plan
  read -r plan _ <"$work/plan.txt"
  rm -rf "$work/mission"
  say "mission files"
  run_or_fail "the mission files could not be written to $work/mission" "check the free space of the disk" \
    "$floeplan" --data "$work/store" export "$plan" --format gliderdos --out "$work/mission"
}

main() {
  read_options "$@"
  if [[ $serve == yes ]]; then refuse_taken_port; fi
  "$root/deploy/install-deps"
  "$root/deploy/build.sh"
  mkdir -p "$work"
  local today
  today=$(date -u +%Y-%m-%d)
  say "reading the demonstration data"
  load_demo_data "$today"
  say "planning from $from to $to"
  plan_mission "${today}T06:00:00Z"
  export_mission
  say "done; the depths, currents and icebergs are invented, and no exported file has been tried on a vehicle"
  if [[ $serve == no ]]; then return; fi
  say "open http://$listen in a browser; Ctrl-C stops the server"
  exec "$floeplan" --data "$work/store" serve --listen "$listen" --web "$root/web/dist"
}

main "$@"
