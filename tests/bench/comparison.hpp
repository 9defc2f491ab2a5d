#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/report.hpp"

/// This run beside the figures that an earlier release kept.
namespace floeplan::bench {

/// Slower than this share is a regression.
inline constexpr double tolerated_slowdown = 0.15;

/// What a kept file says of a row; group, what and comparator together name it.
struct Standing {
  std::string group;
  std::string what;
  std::string comparator;
  double value{};  // as `standing` gives it: more is better

  [[nodiscard]] bool is_of_same_row(const Standing& other) const {
    return group == other.group && what == other.what && comparator == other.comparator;
  }
};

/// The standings of the rows that have one, in their order.
[[nodiscard]] std::vector<Standing> standings(const std::vector<Row>& rows);

/// The standings in a file that `json_text` wrote.
/// Errors   std::runtime_error when the text is no such file, or has no row to compare with
[[nodiscard]] std::vector<Standing> kept_standings(std::string_view text);

/// Every row's better standing of two runs; the second may hold some of the groups only.
[[nodiscard]] std::vector<Standing> better_of(std::vector<Standing> first,
                                              const std::vector<Standing>& second);

/// A row that is slower than it was by more than is tolerated, or no longer measured.
struct Regression {
  Standing kept;
  std::optional<double> now;
};

/// Kept rows of a measured group that are slower now, in the order in which they were kept. What is new
/// has nothing to fall back from.
[[nodiscard]] std::vector<Regression> regressions(const std::vector<Standing>& kept,
                                                  const std::vector<Standing>& now,
                                                  const std::vector<std::string>& groups);

/// "plan, 23 % slower".
[[nodiscard]] std::string sentence(const Regression& regression);

}  // namespace floeplan::bench
