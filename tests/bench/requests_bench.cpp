#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/benchmarks.hpp"
#include "tests/bench/calibration.hpp"
#include "tests/bench/child_usage.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_runs = 3;
constexpr double long_enough_s = 30.0;  // of all runs of a request together: longer totals vary less

/// A request of the command line; `code` is the expected exit code.
struct BenchRequest {
  std::string what;
  std::vector<std::string> words;
  int code{0};
};

/// The arguments of a request from the open bay to the mouth of the icefjord, followed by those of this
/// request.
std::vector<std::string> across_the_bay(const std::string& command, const std::vector<std::string>& more) {
  std::vector<std::string> words{command, "--from=-53.20,69.20", "--depart", "2026-11-22T06:00:00Z"};
  if (command == "plan") words.emplace_back("--to=-51.35,69.18");
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<BenchRequest> bench_requests() {
  return {
      {"plan", across_the_bay("plan", {})},
      {"plan that may wait for 6 h", across_the_bay("plan", {"--max-loiter", "PT6H"})},
      {"window of 49 departures",
       across_the_bay("plan", {"--depart-until", "2026-11-24T06:00:00Z", "--depart-step", "PT1H"})},
      {"latest departure for an arrival",
       {"plan", "--from=-53.20,69.20", "--to=-51.35,69.18", "--arrive-by", "2026-11-25T18:00:00Z"}},
      {"plan that saves energy", across_the_bay("plan", {"--objective", "energy"})},
      {"robust plan for 16 members",
       across_the_bay("plan", {"--members", "16", "--robust", "mean", "--current-error", "0.05",
                               "--error-length", "20000", "--error-time", "PT24H"})},
      {"what can be reached in 6, 12 and 24 h", across_the_bay("reach", {"--hours", "6,12,24"})},
      {"refusal", across_the_bay("plan", {"--margin", "9000"}), 1},
  };
}

/// The program that users run, and a temporary store with the demonstration data.
class Demonstration {
 public:
  Demonstration() : program_{fs::read_symlink("/proc/self/exe").parent_path() / "floeplan"} {
    if (!fs::exists(program_))
      throw std::runtime_error{"the program is missing at " + program_.string() +
                               "; build the target floeplan"};
    const fs::path files = folder_.path() / "demo";
    (void)run({"demo", files.string(), "--start", "2026-11-22"}, 0);
    std::vector<std::string> words{"ingest"};
    for (const auto& entry : fs::directory_iterator{files})
      if (entry.path().extension() != ".txt") words.push_back(entry.path().string());
    std::ranges::sort(words.begin() + 1, words.end());
    (void)run(words, 0);
  }

  /// Processor time of the whole process, seconds.
  [[nodiscard]] double run(const std::vector<std::string>& request, int code) const {
    std::vector<std::string> words{program_.string(), "--data", (folder_.path() / "store").string()};
    words.insert(words.end(), request.begin(), request.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return usage_of(
               [&] {
                 const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
                 dup2(nowhere, STDOUT_FILENO);
                 dup2(nowhere, STDERR_FILENO);
                 execv(arguments.front(), arguments.data());
                 throw std::runtime_error{"cannot start " + program_.string()};
               },
               code)
        .cpu_s;
  }

 private:
  support::TemporaryFolder folder_;
  fs::path program_;
};

/// The median of up to three runs, each compared with the calibration loop before and after it.
Row row_of_request(const Demonstration& demonstration, const BenchRequest& request) {
  std::vector<Row> runs;
  double taken_s = 0.0;
  double before_s = calibration_seconds();
  while (runs.empty() || (runs.size() < most_runs && taken_s < long_enough_s)) {
    const double ours_s = demonstration.run(request.words, request.code);
    const double after_s = calibration_seconds();
    runs.push_back(less_is_better("request: " + request.what, "CPU s", ours_s, "calibration loop",
                                  0.5 * (before_s + after_s)));
    before_s = after_s;
    taken_s += ours_s;
  }
  std::ranges::sort(runs, {}, &Row::ratio);
  return gauged_by(Gauge::comparator, runs[runs.size() / 2]);
}

}  // namespace

std::vector<Row> request_rows() {
  const Demonstration demonstration;
  std::vector<Row> rows;
  for (const BenchRequest& request : bench_requests()) {
    try {
      rows.push_back(row_of_request(demonstration, request));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error{"request \"" + request.what + "\": " + error.what()};
    }
  }
  return rows;
}

}  // namespace floeplan::bench
