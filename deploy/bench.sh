#!/usr/bin/env bash
# Builds and runs the benchmarks and prints one table: what, ours, the comparator, the ratio, all measured in this run
# on one core, in processor time; but for the batch of flights, which takes all cores and is timed by the clock.
# Takes about a quarter of an hour beside the building, 2 GB of memory and, for the store, 5 GB in the folder of
# temporary files.
# usage: deploy/bench.sh [--json] [--keep | --compare FILE] [GROUP]...
#        GROUP: search, plan, window, requests, avoidance, flight, store; without one all are measured
#
# --json          the table alone goes to standard output, as JSON
# --keep          writes the JSON to deploy/benchmarks/VERSION.json, for later releases to be compared with; wants an
#                 idle machine, and all groups
# --compare FILE  holds this run against a kept file: what is more than 15 % slower, beside its comparator or a
#                 calibration loop that runs in between, is measured once more; if it is so again, it is named, and the
#                 exit code is 1. Other machines may have written the file.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly longest=5400 # seconds
readonly groups='search|plan|window|requests|avoidance|flight|store'

build_bench() {
  "$root/deploy/install-deps"
  say "building the benchmarks"
  run_or_fail "cmake could not configure the build" "run deploy/install-deps; if that is done, read the message above" \
    cmake -S "$root" --preset release
  run_or_fail "the benchmarks do not compile" "read the first error above" \
    cmake --build "$root/build/release" -j "$(build_jobs)" --target floeplan_bench floeplan
}

measure() {
  run_or_fail "the benchmarks failed, or are slower than those kept" \
    "read the message above; they want an idle machine, 2 GB of memory and at most $longest seconds; what is slower for a good reason is kept anew with deploy/bench.sh --keep" \
    timeout "$longest" "$root/build/release/floeplan_bench" "$@"
}

# keep: writes the kept file of this version, all of it or none.
keep() {
  local version file
  version=$(sed -n 's/^project(floeplan VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
  file=$root/deploy/benchmarks/$version.json
  mkdir -p "${file%/*}"
  measure --json >"$file.part"
  mv "$file.part" "$file"
  say "kept in $file" >&2
}

main() {
  local usage="use: deploy/bench.sh [--json] [--keep | --compare FILE] [${groups//|/ | }]..."
  local keeping=no
  local -a arguments=()
  while (($# > 0)); do
    case $1 in
      --json) arguments+=("$1") ;;
      --keep) keeping=yes ;;
      --compare)
        [[ -f ${2-} ]] || fail "--compare needs a file that deploy/bench.sh --keep wrote" "they lie in deploy/benchmarks"
        arguments+=("$1" "$2")
        shift
        ;;
      *)
        [[ $1 =~ ^($groups)$ ]] || fail "unknown option $1" "$usage"
        arguments+=("$1")
        ;;
    esac
    shift
  done
  if [[ $keeping == yes ]] && ((${#arguments[@]} > 0)); then
    fail "--keep measures every group and takes no other option" "$usage"
  fi
  build_bench >&2
  say "measuring" >&2
  if [[ $keeping == yes ]]; then keep; else measure "${arguments[@]}"; fi
}

main "$@"
