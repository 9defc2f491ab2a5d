#include "api/service/coverage_checks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "engine/core/shown_text.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/messages/fault.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"

namespace floeplan::service {
namespace {

using repository::DatasetChoice;
using repository::DatasetKind;

std::string flag_of(const std::string& field) { return "--" + field.substr(0, field.find('/')); }

}  // namespace

core::Violations swapped_places(sql::Connection& db, const std::vector<GivenPlace>& places,
                                const repository::EnvironmentQuery& data) {
  if (data.currents.how == DatasetChoice::How::none && data.bathymetry.how == DatasetChoice::How::none)
    return {};
  std::vector<geo::BoundingBox> areas;
  for (const DatasetKind kind : {DatasetKind::currents, DatasetKind::bathymetry})
    std::ranges::copy(repository::DatasetRepository{db}.areas(kind), std::back_inserter(areas));
  const auto is_covered = [&](geo::LonLat place) {
    return std::ranges::any_of(areas,
                               [&](const geo::BoundingBox& area) { return geo::contains(area, place); });
  };
  core::Violations found;
  for (const auto& [field, place] : places) {
    const geo::LonLat swapped{place.lat_deg, geo::wrap_longitude(place.lon_deg)};
    if (std::abs(swapped.lat_deg) > 90.0 || is_covered(place) || !is_covered(swapped)) continue;
    core::note(found, messages::fault<"coordinates-swapped">("/" + field, flag_of(field), swapped.lon_deg,
                                                             swapped.lat_deg));
  }
  return found;
}

core::Violations depths_elsewhere(sql::Connection& db, const repository::EnvironmentQuery& data) {
  if (data.bathymetry.how != DatasetChoice::How::newest) return {};
  std::vector<std::string> elsewhere;
  for (const geo::BoundingBox& area : repository::DatasetRepository{db}.areas(DatasetKind::bathymetry)) {
    if (geo::intersects(area, data.area)) return {};
    elsewhere.push_back(geo::bounds_text(area));
  }
  if (elsewhere.empty()) return {};
  return {messages::fault<"no-depths-reach">("/bathymetry", geo::bounds_text(repository::named_area(data)),
                                             core::shortened_list(elsewhere))};
}

}  // namespace floeplan::service
