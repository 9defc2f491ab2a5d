#!/usr/bin/env bash
# Runs every test: installs, builds, all C++ tests (release), the risky parts under the sanitizers, the client's unit
# tests and the browser tests. --full adds lint and every preset. The last line holds the totals of the C++ tests.
# usage: deploy/test.sh [--full]
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# What reads data from outside or computes with indices runs under the address sanitizer, what has threads under tsan.
readonly asan_folders=(elementary core geo graph motion ocean tide vehicle planning avoidance simulation mission ingest codec routes)
readonly tsan_folders=(jobs http)
failed_steps=()

# Three of the four quarters of each law over random scenes, which lead through the same code as the first.
readonly further_scenes='^planning\.Quarter/.*/[123]$'

# step NAME COMMAND...: goes on after a failure, so that one run shows everything that is wrong. The command runs in a
# shell of its own, where `fail` ends the step alone.
step() {
  local name=$1
  shift
  say "$name"
  if ! ("$@"); then
    failed_steps+=("$name")
    say "FAILED: $name"
  fi
}

# build_preset PRESET [TARGET...]
build_preset() {
  local preset=$1
  shift
  local targets=()
  if (($# > 0)); then targets=(--target "$@"); fi
  cmake -S "$root" --preset "$preset" >"$root/build/$preset-configure.log" ||
    fail "cmake could not configure preset $preset" "read build/$preset-configure.log"
  cmake --build "$root/build/$preset" -j "$(build_jobs)" "${targets[@]}"
}

# run_ctest PRESET [CTEST OPTION...]
run_ctest() {
  local preset=$1
  shift
  ctest --test-dir "$root/build/$preset" -j "$(nproc)" --output-on-failure --no-tests=error \
    --output-junit "$root/build/$preset/test-report.xml" "$@" | grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed|^ +Start '
}

all_of_preset() {
  build_preset "$1" && run_ctest "$1"
}

# folders_of_preset PRESET FOLDER...: builds and runs the tests of these folders alone, of random scenes a quarter.
folders_of_preset() {
  local preset=$1
  shift
  local pattern
  pattern=$(IFS='|' && echo "^($*)\\.")
  build_preset "$preset" "${@/%/_test}" && run_ctest "$preset" -R "$pattern" -E "$further_scenes"
}

sources() {
  find "$root"/{engine,storage,api,server,tests} -name '*.[ch]pp' "$@"
}

lint() {
  local tidy_flags=(-extra-arg=-DBOOST_ASIO_HAS_CO_AWAIT -extra-arg=-DBOOST_ASIO_HAS_STD_COROUTINE
    -extra-arg=-Wno-enum-constexpr-conversion)  # of Boost's MPL, for older compilers
  step "clang-format" xargs -0 clang-format-19 --dry-run -Werror < <(sources -print0)
  step "shellcheck" shellcheck -x -P "$root/deploy" "$root"/deploy/*.sh "$root/deploy/install-deps" \
    "$root"/api/examples/*.sh
  step "files for nginx, Caddy and systemd" "$root/deploy/check_config.sh"
  step "eslint" npm --prefix "$root/web" run --silent lint
  step "clang-tidy" run-clang-tidy-19 -quiet -p "$root/build/dev" -j "$(build_jobs)" "${tidy_flags[@]}" \
    "^$root/(engine|storage|api|server)/"
}

# Sums one count of the reports that ctest wrote.
total() {
  sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\"$/\1/p" "$root"/build/*/test-report.xml | awk '{sum += $1} END {print sum + 0}'
}

# The tests that failed, each with its preset: what a long log buries is said once more at its end.
failed_tests() {
  local report
  for report in "$root"/build/*/test-report.xml; do
    sed -n "s/^[[:space:]]*<testcase name=\"\([^\"]*\)\".*status=\"fail\".*/$(basename "$(dirname "$report")"): \1/p" \
      "$report"
  done
}

main() {
  local full=no needs=(--with-tests --with-browser)
  case ${1-} in
    '') ;;
    --full)
      full=yes
      needs+=(--with-lint)
      ;;
    *) fail "unknown option $1" "use: deploy/test.sh [--full]" ;;
  esac

  rm -f "$root"/build/*/test-report.xml
  "$root/deploy/install-deps" "${needs[@]}"
  use_node
  "$root/deploy/build.sh" --with-tests

  step "C++ tests, release" run_ctest release
  if [[ $full == yes ]]; then
    step "damaged files, 1000 of each format" env FLOEPLAN_DAMAGED_FILES=1000 \
      "$root/build/release/ingest_test" --gtest_filter='*HostileF*:Zarr3.WithBytesChanged*'
    step "200 kills" "$root/tests/faults/faults.py" "$root/build/release/floeplan" --kills 200
    step "attacks on a server" "$root/tests/attack/attack.py" "$root/build/release/floeplan"
    step "C++ tests, dev" all_of_preset dev
    step "C++ tests, ci" all_of_preset ci
    step "C++ tests, asan" all_of_preset asan
    step "C++ tests, tsan" all_of_preset tsan
    lint
  else
    step "C++ tests, asan: ${asan_folders[*]}" folders_of_preset asan "${asan_folders[@]}"
    step "C++ tests, tsan: ${tsan_folders[*]}" folders_of_preset tsan "${tsan_folders[@]}"
  fi
  step "client unit tests" npm --prefix "$root/web" run --silent test
  step "browser tests" "$root/tests/browser/run.sh" "$root/build/release/floeplan"

  local failed skipped
  failed=$(total failures)
  skipped=$(($(total skipped) + $(total disabled)))
  local name
  for name in "${failed_steps[@]}"; do say "FAILED: $name"; done
  while read -r name; do say "FAILED: $name"; done < <(failed_tests)
  printf '%d passed, %d failed, %d skipped (C++ tests); %d step(s) failed\n' \
    $(($(total tests) - failed - skipped)) "$failed" "$skipped" "${#failed_steps[@]}"
  ((${#failed_steps[@]} == 0))
}

main "$@"
