#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/report.hpp"

/// Comparison of this run with the stored results of an earlier release.
namespace floeplan::bench {

/// A larger slowdown is a regression.
inline constexpr double tolerated_slowdown = 0.15;

/// The stored value of a row; group, what and comparator together identify it.
struct Standing {
  std::string group;
  std::string what;
  std::string comparator;
  double value{};  // from `standing`: more is better

  [[nodiscard]] bool is_of_same_row(const Standing& other) const {
    return group == other.group && what == other.what && comparator == other.comparator;
  }
};

/// The standings of those rows that have one, in order.
[[nodiscard]] std::vector<Standing> standings(const std::vector<Row>& rows);

/// Reads the standings from a file written by `json_text`.
/// Errors   std::runtime_error when the text is not such a file, or has no row to compare with
[[nodiscard]] std::vector<Standing> kept_standings(std::string_view text);

/// The better standing of each row in two runs; the second run may have only some of the groups.
[[nodiscard]] std::vector<Standing> better_of(std::vector<Standing> first,
                                              const std::vector<Standing>& second);

/// A row that is slower than before by more than `tolerated_slowdown`, or no longer measured.
struct Regression {
  Standing kept;
  std::optional<double> now;
};

/// Stored rows of a measured group that are slower now, in the stored order. New rows cannot be regressions.
[[nodiscard]] std::vector<Regression> regressions(const std::vector<Standing>& kept,
                                                  const std::vector<Standing>& now,
                                                  const std::vector<std::string>& groups);

/// The text for the report: "plan, 23 % slower".
[[nodiscard]] std::string sentence(const Regression& regression);

}  // namespace floeplan::bench
