#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace floeplan::bench {

/// How `ours` is made comparable with an earlier release, perhaps measured on another machine.
enum class Gauge {
  nothing,     // not compared: the value varies from run to run, or with the number of cores
  comparator,  // by the ratio to the comparator, which is foreign code or the calibration loop
  time,        // a time, relative to the calibration loop that ran before and after its group
  rate,        // work per unit of time, relative to the same loop
};

/// One row of the table: our value and its comparator, both measured in this run.
struct Row {
  std::string what;
  std::string unit;
  double ours{};
  std::string comparator;  // empty: nothing to compare with
  double comparator_value{};
  double ratio{};  // factor by which ours is better; 0 without a comparator
  std::optional<bool> meets_target{};
  std::string target{};
  Gauge gauge{Gauge::nothing};
  std::string group{};     // set by the program, for all rows of a group
  double calibration_s{};  // set by the program, for all rows of a group
};

/// The quality of a row, independent of the speed of the machine: more is better, and twice as much is twice
/// as fast. It is compared with that of the same row in another run. Empty for a row without a gauge.
std::optional<double> standing(const Row& row);

/// The row with this gauge.
Row gauged_by(Gauge gauge, Row row);

/// A row whose ratio is ours / comparator, because more is better.
Row more_is_better(std::string what, std::string unit, double ours, std::string comparator, double value);
/// A row whose ratio is comparator / ours, because less is better.
Row less_is_better(std::string what, std::string unit, double ours, std::string comparator, double value);

std::string table_text(const std::vector<Row>& rows);
std::string json_text(const std::vector<Row>& rows);

/// Processor time of this thread; other programs on the machine do not count.
double thread_seconds();

/// Shortest processor time of `work` over several tries, seconds.
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

/// Largest heap use since the last call of `reset_peak`, in bytes beyond the use at that call.
std::size_t peak_bytes();
void reset_peak();

}  // namespace floeplan::bench
