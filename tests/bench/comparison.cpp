#include "tests/bench/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace floeplan::bench {
namespace {

const Standing* find(const std::vector<Standing>& all, const Standing& wanted) {
  const auto found =
      std::ranges::find_if(all, [&](const Standing& one) { return one.is_of_same_row(wanted); });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Standing> standings(const std::vector<Row>& rows) {
  std::vector<Standing> result;
  for (const Row& row : rows) {
    if (const auto value = standing(row)) result.push_back({row.group, row.what, row.comparator, *value});
  }
  return result;
}

std::vector<Standing> kept_standings(std::string_view text) {
  const auto document = nlohmann::json::parse(text, nullptr, false);
  std::vector<Standing> result;
  try {
    for (const auto& entry : document) {
      if (!entry.contains("standing")) continue;
      const Standing kept{entry.at("group"), entry.at("what"), entry.value("comparator", ""),
                          entry.at("standing")};
      if (!(kept.value > 0.0) || !std::isfinite(kept.value))
        throw std::runtime_error{"it has a bad standing"};
      result.push_back(kept);
    }
  } catch (const nlohmann::json::exception&) {
    result.clear();
  }
  if (result.empty()) throw std::runtime_error{"it is no file that deploy/bench.sh --keep wrote"};
  return result;
}

std::vector<Standing> better_of(std::vector<Standing> first, const std::vector<Standing>& second) {
  for (Standing& one : first) {
    if (const Standing* const again = find(second, one)) one.value = std::max(one.value, again->value);
  }
  return first;
}

std::vector<Regression> regressions(const std::vector<Standing>& kept, const std::vector<Standing>& now,
                                    const std::vector<std::string>& groups) {
  std::vector<Regression> result;
  for (const Standing& before : kept) {
    if (std::ranges::find(groups, before.group) == groups.end()) continue;
    const Standing* const after = find(now, before);
    if (after == nullptr) {
      result.push_back({before, std::nullopt});
    } else if (before.value / after->value > 1.0 + tolerated_slowdown) {
      result.push_back({before, after->value});
    }
  }
  return result;
}

std::string sentence(const Regression& regression) {
  const Standing& kept = regression.kept;
  const std::string beside = kept.comparator.empty() ? "" : " (beside " + kept.comparator + ")";
  if (!regression.now) return kept.what + beside + ": is no longer measured";
  const auto percent = std::lround(100.0 * (kept.value / *regression.now - 1.0));
  return kept.what + beside + ": " + std::to_string(percent) + " % slower";
}

}  // namespace floeplan::bench
