#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace floeplan::bench {

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
};

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
