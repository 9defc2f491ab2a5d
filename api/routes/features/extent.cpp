#include "api/routes/features/extent.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/routes/request/feature_crs.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/united_boxes.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr std::size_t most_parts = 16;  // chosen: keeps a page of metadata readable

double outwards(double degrees, bool up) {
  const double scaled = degrees * 1e6;
  return (up ? std::ceil(scaled) : std::floor(scaled)) / 1e6;
}

json box_json(const geo::BoundingBox& box) {
  const bool ends_on_antimeridian = box.east_deg == -180.0 && box.west_deg > box.east_deg;
  const double east_deg = ends_on_antimeridian ? 180.0 : box.east_deg;
  return json::array({outwards(box.west_deg, false), outwards(box.south_deg, false), outwards(east_deg, true),
                      outwards(box.north_deg, true)});
}

/// The boxes without repeated ones and without those inside another.
std::vector<geo::BoundingBox> outermost(std::span<const geo::BoundingBox> boxes) {
  std::vector<geo::BoundingBox> kept;
  for (const geo::BoundingBox& box : boxes) {
    if (std::ranges::any_of(kept, [&](const auto& other) { return geo::holds(other, box); })) continue;
    std::erase_if(kept, [&](const auto& other) { return geo::holds(box, other); });
    kept.push_back(box);
  }
  return kept;
}

json end_json(const std::optional<core::UtcTime>& time) { return time ? json(core::iso8601(*time)) : json(); }

json period_json(const ExtentPeriod& period) {
  return json::array({end_json(period.from), end_json(period.to)});
}

/// The periods in ascending order; those that touch are joined.
std::vector<ExtentPeriod> joined(std::span<const ExtentPeriod> periods) {
  std::vector<ExtentPeriod> sorted{periods.begin(), periods.end()};
  std::ranges::sort(sorted, {}, &ExtentPeriod::from);  // an open begin comes first
  std::vector<ExtentPeriod> result;
  for (const ExtentPeriod& period : sorted) {
    const bool meets =
        !result.empty() && (!result.back().to || !period.from || *period.from <= *result.back().to);
    if (!meets) {
      result.push_back(period);
    } else if (result.back().to) {
      result.back().to = period.to ? std::optional{std::max(*period.to, *result.back().to)} : std::nullopt;
    }
  }
  return result;
}

}  // namespace

json spatial_extent(std::span<const geo::BoundingBox> boxes) {
  json list = json::array({box_json(geo::united(boxes))});
  const auto parts = outermost(boxes);
  if (parts.size() > 1 && parts.size() <= most_parts)
    for (const geo::BoundingBox& part : parts) list.push_back(box_json(part));
  return {{"bbox", std::move(list)}, {"crs", uri_of(FeatureCrs::crs84)}};
}

json temporal_extent(std::span<const ExtentPeriod> periods) {
  const auto parts = joined(periods);
  json list = json::array({period_json({parts.front().from, parts.back().to})});
  if (parts.size() > 1 && parts.size() <= most_parts)
    for (const ExtentPeriod& part : parts) list.push_back(period_json(part));
  return {{"interval", std::move(list)}};
}

}  // namespace floeplan::routes
