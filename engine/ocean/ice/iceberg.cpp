#include "engine/ocean/ice/iceberg.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace floeplan::ocean {
namespace {

using enum IcebergSize;
constexpr std::array<std::pair<IcebergSize, const char*>, 8> names{{{growler, "growler"},
                                                                    {bergy_bit, "bergy_bit"},
                                                                    {small, "small"},
                                                                    {medium, "medium"},
                                                                    {large, "large"},
                                                                    {very_large, "very_large"},
                                                                    {unknown, "unknown"},
                                                                    {radar_target, "radar_target"}}};

}  // namespace

core::Metres safe_length(const Iceberg& iceberg) {
  if (iceberg.length) return *iceberg.length;
  switch (iceberg.size) {
    case growler: return {5.0};
    case bergy_bit: return {15.0};
    case small: return {60.0};
    case medium: return {122.0};  // upper limit of the International Ice Patrol, the larger of the two
    case large:
      return {213.0};  // likewise
    // 1.5 times the lower limit of the class: the longest of the usual bergs off Newfoundland.
    case very_large:
    case unknown:
    case radar_target: return {300.0};
  }
  throw std::logic_error{"IcebergSize without a length"};
}

bool is_too_old(const Iceberg& iceberg, core::UtcTime depart) {
  return iceberg.too_old_from && depart >= *iceberg.too_old_from;
}

std::string size_name(IcebergSize size) {
  for (const auto& [candidate, name] : names) {
    if (candidate == size) return name;
  }
  throw std::logic_error{"IcebergSize without a name"};
}

std::optional<IcebergSize> parse_size(const std::string& name) {
  for (const auto& [size, candidate] : names) {
    if (name == candidate) return size;
  }
  return std::nullopt;
}

}  // namespace floeplan::ocean
