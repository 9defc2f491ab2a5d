#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "storage/ingest/process/reader_main.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/calibration.hpp"
#include "tests/bench/comparison.hpp"

namespace {

using namespace floeplan::bench;

constexpr const char* usage =
    "usage: floeplan_bench [--json] [--compare FILE] "
    "[search | plan | window | requests | avoidance | flight | store]...\n";

struct Group {
  std::string name;
  std::vector<Row> (*measure)();
};

/// In the order of the table.
const std::vector<Group> groups{{"search", search_rows},       {"plan", plan_rows},
                                {"window", window_rows},       {"requests", request_rows},
                                {"avoidance", avoidance_rows}, {"flight", flight_rows},
                                {"store", store_rows}};

struct Options {
  bool as_json{};
  std::string kept_file;            // empty: nothing to compare with
  std::vector<std::string> groups;  // in the order of the table
};

/// Parses the command line; empty if it is wrong.
std::optional<Options> parse(const std::vector<std::string>& words) {
  Options options;
  std::vector<std::string> wanted;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--json") {
      options.as_json = true;
    } else if (words[i] == "--compare") {
      if (++i == words.size()) return std::nullopt;
      options.kept_file = words[i];
    } else if (std::ranges::find(groups, words[i], &Group::name) != groups.end()) {
      wanted.push_back(words[i]);
    } else {
      return std::nullopt;
    }
  }
  for (const Group& group : groups) {
    if (wanted.empty() || std::ranges::find(wanted, group.name) != wanted.end())
      options.groups.push_back(group.name);
  }
  return options;
}

std::vector<Row> measure(const std::vector<std::string>& wanted) {
  std::vector<Row> rows;
  double before_s = calibration_seconds();
  for (const Group& group : groups) {
    if (std::ranges::find(wanted, group.name) == wanted.end()) continue;
    std::vector<Row> measured = group.measure();
    const double after_s = calibration_seconds();
    for (Row& row : measured) {
      row.group = group.name;
      row.calibration_s = 0.5 * (before_s + after_s);
      rows.push_back(std::move(row));
    }
    before_s = after_s;
  }
  return rows;
}

std::vector<Standing> read_kept(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  if (!in) throw std::runtime_error{"cannot read " + file};
  try {
    return kept_standings(std::string{std::istreambuf_iterator<char>{in}, {}});
  } catch (const std::runtime_error& error) {
    throw std::runtime_error{"cannot compare with " + file + ": " + error.what()};
  }
}

/// Reports regressions. Slower rows are measured once more, because a short disturbance is not a regression.
/// Returns whether there are none.
bool holds(const std::vector<Standing>& kept, const std::vector<Row>& rows, const Options& options) {
  std::vector<Standing> now = standings(rows);
  std::vector<Regression> fallen = regressions(kept, now, options.groups);
  if (!fallen.empty()) {
    std::vector<std::string> again;
    for (const Regression& one : fallen) again.push_back(one.kept.group);
    std::cerr << "slower than in " << options.kept_file << "; measuring these once more:\n";
    for (const Regression& one : fallen) std::cerr << "  " << sentence(one) << '\n';
    now = better_of(std::move(now), standings(measure(again)));
    fallen = regressions(kept, now, options.groups);
  }
  const long percent = std::lround(100.0 * tolerated_slowdown);
  if (fallen.empty()) {
    std::cerr << "nothing is slower than in " << options.kept_file << " by more than " << percent << " %\n";
    return true;
  }
  std::cerr << "floeplan_bench: slower than in " << options.kept_file << " by more than " << percent
            << " %, twice:\n";
  for (const Regression& one : fallen) std::cerr << "  " << sentence(one) << '\n';
  return false;
}

}  // namespace

/// usage: floeplan_bench [--json] [--compare FILE] [GROUP...]      without a group all of them
/// Exit code: 0 measured, and nothing slower than FILE has it; 1 slower, or not measured; 2 wrong usage
int main(int argc, char** argv) {
  const std::vector<std::string> words{argv + 1, argv + argc};
  if (words.size() > 2 && words[0] == "read-files")  // the benchmark of ingest starts this program as reader
    return floeplan::ingest::read_foreign_files(argv[2], {argv + 3, argv + argc});
  const auto options = parse(words);
  if (!options) {
    std::cerr << usage;
    return 2;
  }
  try {
    std::vector<Standing> kept;
    // before the measurements, because these take long
    if (!options->kept_file.empty()) kept = read_kept(options->kept_file);
    const std::vector<Row> rows = measure(options->groups);
    std::cout << (options->as_json ? json_text(rows) : table_text(rows)) << std::flush;
    return kept.empty() || holds(kept, rows, *options) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "floeplan_bench: " << error.what() << '\n';
    return 1;
  }
}
