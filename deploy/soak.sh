#!/usr/bin/env bash
# Lets simulated pilots work on a server that is built with a sanitizer, and ends with 1 when a request was answered wrongly,
# the sanitizer reported something, or the server's memory, threads or open files grew.
# usage: deploy/soak.sh [asan | tsan | release] [MINUTES [PILOTS]]     default: asan, for 20 minutes, with 50 pilots
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

main() {
  local preset=${1-asan} minutes=${2-20} pilots=${3-50}
  [[ $preset =~ ^(asan|tsan|release)$ ]] ||
    fail "unknown preset $preset" "use: deploy/soak.sh [asan | tsan | release] [MINUTES [PILOTS]]"
  "$root/deploy/install-deps" --with-tests
  say "building the server, preset $preset"
  run_or_fail "cmake could not configure the build" "run deploy/install-deps; if that is done, read the message above" \
    cmake -S "$root" --preset "$preset"
  run_or_fail "the server does not compile" "read the first error above" \
    cmake --build "$root/build/$preset" -j "$(build_jobs)" --target floeplan
  say "$pilots pilots for $minutes minutes"
  exec python3 "$root/tests/load/soak.py" "$root/build/$preset/floeplan" --minutes "$minutes" --pilots "$pilots"
}

main "$@"
