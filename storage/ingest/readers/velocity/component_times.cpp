#include "storage/ingest/readers/velocity/component_times.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::ingest {
namespace {

/// Equal but for the rounding of float32 coordinates.
bool are_alike(const std::optional<AxisNodes>& a, const std::optional<AxisNodes>& b, double tolerance) {
  if (a.has_value() != b.has_value()) return false;
  return !a || std::ranges::equal(a->nodes, b->nodes, [&](double x, double y) {
    return std::abs(x - y) <= tolerance * std::max(1.0, std::abs(x));
  });
}

}  // namespace

std::optional<std::string> times_or_depths_differ(const NetcdfLayout& first, const NetcdfLayout& second) {
  if (!first.times_s || !second.times_s)
    return "the file does not say for which time its currents hold; a plan needs to know; ask the producer "
           "for "
           "a file with a time axis";
  if (first.times_s->nodes != second.times_s->nodes)
    return "the two components of the current hold for different times; they cannot be put together; give "
           "the "
           "two files of the same period";
  if (!are_alike(first.depths_m, second.depths_m, 1e-4))
    return "the two components of the current lie at different depths; they cannot be put together; ask the "
           "producer for files with the same levels";
  return std::nullopt;
}

}  // namespace floeplan::ingest
