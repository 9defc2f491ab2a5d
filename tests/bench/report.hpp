#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace floeplan::bench {

/// What `ours` is held against when it is compared with an earlier release, perhaps on another machine.
enum class Gauge {
  nothing,     // varies by itself, or with the number of cores
  comparator,  // the ratio: the comparator is another's code, or the calibration loop
  time,        // a time: beside the calibration loop that ran around its group
  rate,        // work for each unit of time: the same
};

/// One line of the table: ours beside what it is compared with, both measured in this run.
struct Row {
  std::string what;
  std::string unit;
  double ours{};
  std::string comparator;  // empty: nothing to compare with
  double comparator_value{};
  double ratio{};  // how many times better ours is; 0 without a comparator
  std::optional<bool> meets_target{};
  std::string target{};
  Gauge gauge{Gauge::nothing};
  std::string group{};     // set by the program, for all rows of a group
  double calibration_s{};  // the same
};

/// How good a row is, the speed of the machine left out: more is better, and twice as much is twice as fast. It compares
/// with that of the same row in another run. Empty for a row without a gauge.
std::optional<double> standing(const Row& row);

/// The same row, to be held against this when releases are compared.
Row gauged_by(Gauge gauge, Row row);

/// More is better: ours / comparator.
Row more_is_better(std::string what, std::string unit, double ours, std::string comparator, double value);
/// Less is better: comparator / ours.
Row less_is_better(std::string what, std::string unit, double ours, std::string comparator, double value);

std::string table_text(const std::vector<Row>& rows);
std::string json_text(const std::vector<Row>& rows);

/// Processor time of this thread: other programs on the machine do not count.
double thread_seconds();

/// The least of the thread seconds that `work` takes, over several tries.
template <class Work>
double least_seconds(int tries, const Work& work) {
  double least = 1e300;
  for (int i = 0; i < tries; ++i) {
    const double start = thread_seconds();
    work();
    const double taken = thread_seconds() - start;
    if (taken < least) least = taken;
  }
  return least;
}

/// Most bytes of the heap in use at once since the last call of `reset_peak`, beyond those in use then.
std::size_t peak_bytes();
void reset_peak();

}  // namespace floeplan::bench
