#!/usr/bin/env bash
# Runs the tests: installs, builds, all C++ tests (release), those that read requests from outside under the address
# sanitizer, the client's unit tests and the browser tests. CONTRIBUTING has a table of what takes how long.
# usage: deploy/test.sh [--quick | --full] [FOLDER...]
#   --quick    the C++ tests (release) alone
#   --full     adds lint, every preset, both sanitizers over everything, kills, attacks, damaged files, benchmarks
#   FOLDER...  the C++ tests (release) of these folders alone, as `deploy/test.sh planning ingest`
# Tests listed in tests/long.txt, and browser journeys tagged @long, run with --full and with FOLDER... alone.
# The last line counts the C++, client and browser tests that passed, failed and were skipped.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# What reads bytes from outside in the server's own process, or computes the indices that it is read by. --full runs all
# folders: also those of the readers of files, which run confined, and take a third of the time of a usual run.
readonly asan_folders=(elementary core geo graph motion ocean tide vehicle mission codec)
readonly reports=$root/build/reports
readonly fuzz_seconds=${FLOEPLAN_FUZZ_SECONDS:-600} # each
readonly long_list=$root/tests/long.txt
failed_steps=()

# step NAME COMMAND...: goes on after a failure, so that one run shows everything that is wrong. The command runs in a
# shell of its own, where `fail` ends the step alone. What it prints is kept, to say its first failure again at the end.
step() {
  local name=$1 began=$SECONDS
  shift
  local log=$reports/${name//[^a-z0-9]/_}.log
  say "$name"
  if ! ("$@") 2>&1 | tee "$log"; then
    failed_steps+=("$name")
    say "FAILED: $name"
  fi
  say "$name: $((SECONDS - began)) s"
}

# first_failure LOG: the first line that tells of one, with what follows it; else how the log ends.
first_failure() {
  grep -m 1 -A 6 -E '\b(error|Error|FAILED|failed|Failure)\b' "$1" || tail -n 6 "$1"
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

# leave_out_long_tests PRESET: from here on. Each name in the list has to be that of a test.
leave_out_long_tests() {
  local program folder name names=() tests=
  for program in "$root/build/$1"/*_test; do
    folder=$(basename "$program" _test)
    tests+=$("$program" --gtest_list_tests | awk -v folder="$folder" '
      /^[^ ]*\./ { suite = $1; next }
      suite != "" { print folder "." suite $1 }')$'\n'
  done
  while read -r name; do
    grep -qE "^${name//./\\.}(/|\$)" <<<"$tests" ||
      fail "tests/long.txt names $name, which is no test" "correct or remove the line"
    names+=("${name#*.}" "${name#*.}/*")
  done < <(grep -v '^#' "$long_list")
  GTEST_FILTER=-$(IFS=: && echo "${names[*]}")
  export GTEST_FILTER
}

# failures_alone: of what test executables print, all but the tests that passed.
failures_alone() {
  awk '/^\[ RUN / { run = $0; next }
    /^\[ +OK |^\[[-=]+\]|^ +Start |Test +#[0-9]+: .* Passed/ { run = ""; next }
    { if (run != "") print run; run = ""; print }'
}

# run_ctest PRESET [CTEST OPTION...]: keeps the reports of all parts in build/reports/PRESET.
run_ctest() {
  local preset=$1 code=0
  shift
  rm -rf "$root/build/$preset/reports" "${reports:?}/$preset"
  mkdir "$reports/$preset"
  ctest --test-dir "$root/build/$preset" -j "$(nproc)" --output-on-failure --no-tests=error \
    --output-junit "$reports/$preset/parts" "$@" | failures_alone || code=$?
  cp "$root/build/$preset/reports"/*.xml "$reports/$preset" || code=$?
  return "$code"
}

# pattern_of FOLDER...: matches the tests of these folders alone.
pattern_of() {
  local IFS='|'
  echo "^($*)\\."
}

# folders_of_preset PRESET FOLDER...: builds and runs the tests of these folders alone.
folders_of_preset() {
  local preset=$1
  shift
  build_preset "$preset" "${@/%/_test}" && run_ctest "$preset" -R "$(pattern_of "$@")"
}

all_of_preset() {
  build_preset "$1" && run_ctest "$1"
}

client_tests() {
  npm --prefix "$root/web" run --silent test -- --reporter=default --reporter=junit "--outputFile.junit=$reports/client.xml"
}

browser_tests() {
  PLAYWRIGHT_JUNIT_OUTPUT_FILE=$reports/browser.xml \
    "$root/tests/browser/run.sh" "$root/build/release/floeplan" --reporter=list,junit
}

sources() {
  find "$root"/{engine,storage,api,server,tests} -name '*.[ch]pp' "$@"
}

lint() {
  local tidy_flags=(-extra-arg=-DBOOST_ASIO_HAS_CO_AWAIT -extra-arg=-DBOOST_ASIO_HAS_STD_COROUTINE
    -extra-arg=-Wno-enum-constexpr-conversion)  # of Boost's MPL, for older compilers
  step "clang-format" xargs -0 clang-format-19 --dry-run -Werror < <(sources -print0)
  step "shellcheck" shellcheck -x -P "$root/deploy" "$root"/deploy/*.sh "$root/deploy/install-deps" \
    "$root"/api/examples/*.sh "$root"/tests/*/*.sh
  step "files of a deployment" "$root/deploy/check_config.sh"
  step "eslint" npm --prefix "$root/web" run --silent lint
  step "clang-tidy" run-clang-tidy-19 -quiet -p "$root/build/dev" -j "$(build_jobs)" "${tidy_flags[@]}" \
    "^$root/(engine|storage|api|server)/"
}

# What a usual run has no time for; see the table in CONTRIBUTING.
long_tests() {
  step "damaged files, 1000 of each format" env FLOEPLAN_DAMAGED_FILES=1000 \
    "$root/build/release/ingest_test" --gtest_filter='*HostileF*:Zarr3.WithBytesChanged*'
  step "200 kills" "$root/tests/faults/faults.py" "$root/build/release/floeplan" --kills 200
  step "200 kills of nodes" "$root/tests/faults/lost_nodes.py" "$root/build/release/floeplan" --jobs 10000 --kills 200 --long
  step "attacks on a server" "$root/tests/attack/attack.py" "$root/build/release/floeplan"
  step "C++ tests, dev" all_of_preset dev
  step "C++ tests, ci" all_of_preset ci
  step "C++ tests, asan" all_of_preset asan
  step "C++ tests, tsan" all_of_preset tsan
  lint
  fuzzers
  step "benchmarks" benchmarks
}

# fuzz NAME: for ten minutes, from the corpus of its own; what it finds stays in build/fuzz.
fuzz() {
  local folder=$root/build/fuzz name=$1 dictionary=()
  if [[ -f $root/tests/fuzz/$name.dict ]]; then dictionary=("-dict=$root/tests/fuzz/$name.dict"); fi
  mkdir -p "$folder/found_$name"
  (cd "$folder" && "./${name}_fuzz" -max_total_time="$fuzz_seconds" -rss_limit_mb=4096 "${dictionary[@]}" "found_$name" "$root/tests/fuzz/corpus_$name")
}

fuzzers() {
  local source name
  step "fuzzers: build" build_preset fuzz
  for source in "$root"/tests/fuzz/*_fuzz.cpp; do
    name=$(basename "$source" _fuzz.cpp)
    step "fuzzer: $name" fuzz "$name"
  done
}

# Holds this tree against the newest figures that were kept.
benchmarks() {
  local kept
  kept=$(find "$root/deploy/benchmarks" -name '*.json' | sort -V | tail -n 1)
  [[ -n $kept ]] || fail "no benchmarks of a release are kept" "keep them with deploy/bench.sh --keep on an idle machine"
  "$root/deploy/bench.sh" --compare "$kept"
}

# Says every failure once more, and the totals. Fails if anything did.
summary() {
  local name
  for name in "${failed_steps[@]}"; do
    say "FAILED: $name"
    first_failure "$reports/${name//[^a-z0-9]/_}.log" | sed 's/^/    /'
  done
  "$root/deploy/test_report.py" "$@" && ((${#failed_steps[@]} == 0))
}

main() {
  local extent=usual needs=(--with-tests --with-browser) folders=() argument
  for argument in "$@"; do
    case $argument in
      --quick | --full) extent=${argument#--} ;;
      -*) fail "unknown option $argument" "use: deploy/test.sh [--quick | --full] [FOLDER...]" ;;
      *) folders+=("$argument") ;;
    esac
  done
  if ((${#folders[@]} > 0)) || [[ $extent == quick ]]; then needs=(--with-tests); fi
  if [[ $extent == full ]]; then needs+=(--with-lint); fi

  rm -rf "$reports"
  mkdir -p "$reports"
  "$root/deploy/install-deps" "${needs[@]}"
  use_node

  if ((${#folders[@]} > 0)); then
    step "C++ tests, release: ${folders[*]}" folders_of_preset release "${folders[@]}"
    summary "$reports/release"
    return
  fi
  step "build" "$root/deploy/build.sh" --with-tests
  if ((${#failed_steps[@]} > 0)); then fail "the program does not build" "read the first error above"; fi
  if [[ $extent == full ]]; then
    export FLOEPLAN_LONG=1  # for the browser tests
  else
    leave_out_long_tests release
  fi
  step "C++ tests, release" run_ctest release
  if [[ $extent == quick ]]; then
    summary "$reports/release"
    return
  fi
  if [[ $extent == full ]]; then
    long_tests
  else
    step "C++ tests, asan: ${asan_folders[*]}" folders_of_preset asan "${asan_folders[@]}"
  fi
  step "quickstart" "$root/tests/deploy/quickstart_test.sh"
  step "list of what is in the program" "$root/tests/deploy/sbom_test.py" "$root/build/release/floeplan"
  step "client unit tests" client_tests
  step "browser tests" browser_tests
  summary "$reports"/*/ "$reports"/*.xml
}

main "$@"
