#include "storage/ingest/readers/velocity/component_checks.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

// chosen: some degrees below the 65 degrees where tripolar grids begin
constexpr double bent_above_lat_deg = 60.0;

/// Equal but for the rounding of float32 coordinates.
bool are_alike(const std::optional<AxisNodes>& a, const std::optional<AxisNodes>& b, double tolerance) {
  if (a.has_value() != b.has_value()) return false;
  return !a || std::ranges::equal(a->nodes, b->nodes, [&](double x, double y) {
    return std::abs(x - y) <= tolerance * std::max(1.0, std::abs(x));
  });
}

}  // namespace

std::optional<messages::Message> doubt_in_nominal_axes(const VelocityPair& pair, double northernmost_deg) {
  if (pair.axes != VelocityAxes::grid || northernmost_deg <= bent_above_lat_deg) return std::nullopt;
  return messages::ingest_current_message<"along-bent-axes">(pair.first->name(), pair.second->name(),
                                                             number(northernmost_deg),
                                                             number(bent_above_lat_deg) + " degrees");
}

std::optional<messages::Message> times_or_depths_differ(const NetcdfLayout& first,
                                                        const NetcdfLayout& second) {
  if (!first.times_s || !second.times_s) return messages::ingest_current_message<"current-times-missing">();
  if (first.times_s->nodes != second.times_s->nodes)
    return messages::ingest_current_message<"current-times-differ">();
  if (!are_alike(first.depths_m, second.depths_m, 1e-4))
    return messages::ingest_current_message<"current-depths-differ">();
  return std::nullopt;
}

}  // namespace floeplan::ingest
