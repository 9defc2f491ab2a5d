#!/usr/bin/env bash
# Builds and runs the benchmarks and prints one table: what, ours, the comparator, the ratio, all measured in this run
# on one core, in processor time; but for the batch of flights, which takes all cores and is timed by the clock.
# Takes about four minutes beside the building, 2 GB of memory and, for the store, 5 GB in the folder of temporary files.
# usage: deploy/bench.sh [--json] [search | plan | window | avoidance | flight | store]...
# With --json the table alone goes to standard output, as JSON; without a group everything is measured.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly longest=1200 # seconds

build_bench() {
  "$root/deploy/install-deps"
  say "building the benchmarks"
  run_or_fail "cmake could not configure the build" "run deploy/install-deps; if that is done, read the message above" \
    cmake -S "$root" --preset release
  run_or_fail "the benchmarks do not compile" "read the first error above" \
    cmake --build "$root/build/release" -j "$(build_jobs)" --target floeplan_bench
}

main() {
  local usage="use: deploy/bench.sh [--json] [search | plan | window | avoidance | flight | store]..."
  local argument
  for argument in "$@"; do
    [[ $argument =~ ^(--json|search|plan|window|avoidance|flight|store)$ ]] || fail "unknown option $argument" "$usage"
  done
  build_bench >&2
  say "measuring" >&2
  run_or_fail "the benchmarks failed" "read the message above; they take 2 GB of memory and at most $longest seconds" \
    timeout "$longest" "$root/build/release/floeplan_bench" "$@"
}

main "$@"
