#include "api/service/low_water.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/service/probe_tide.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/plan_messages.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/water_level_repository.hpp"

namespace floeplan::service {
namespace {

using repository::Dataset;

/// Datasets of water levels that may say something of the plan.
std::vector<Dataset> levels_on(sql::Connection& db, const planning::Plan& plan) {
  std::vector<geo::LonLat> places;
  for (const planning::Waypoint& waypoint : plan.waypoints) places.push_back(waypoint.place);
  const geo::BoundingBox along = geo::grown(geo::bounding_box(places), probe_station_range);
  std::vector<Dataset> levels;
  for (Dataset& dataset : repository::DatasetRepository{db}.list())
    if (dataset.kind == repository::DatasetKind::water_levels && geo::intersects(dataset.bounds, along) &&
        dataset.time_start <= plan.arrival && dataset.time_end >= plan.departure)
      levels.push_back(std::move(dataset));
  return levels;
}

/// Calls `visit(place, time)` along the route at steps of at most 250 m, about the cells of the finest bathymetry in use,
/// and during holds at steps of at most the time over which water levels are interpolated.
template <class Visit>
void for_each_passage(const planning::Plan& plan, const Visit& visit) {
  constexpr double step_m = 250.0;
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const planning::Waypoint& here = plan.waypoints[i];
    const core::UtcTime leaves = here.eta + here.wait;
    for (core::UtcTime time = here.eta; time < leaves; time += repository::WaterLevelRepository::longest_gap)
      visit(here.place, time);
    visit(here.place, leaves);
    if (i + 1 == plan.waypoints.size()) return;
    const planning::Waypoint& next = plan.waypoints[i + 1];
    const geo::GeodesicLine leg = geo::geodesic_between(here.place, next.place);
    const int pieces = std::max(1, static_cast<int>(std::ceil(leg.length.value / step_m)));
    for (int piece = 1; piece < pieces; ++piece) {
      const double share = static_cast<double>(piece) / pieces;
      visit(geo::geodesic_destination(here.place, leg.course_at_start, {share * leg.length.value}),
            leaves + share * (next.eta - leaves));
    }
  }
}

}  // namespace

std::optional<messages::Message> low_water_caution(sql::Connection& db, const ocean::Environment& environment,
                                                   const vehicle::GliderProfile& vehicle,
                                                   const planning::Plan& plan) {
  // The greatest fall that S-104 can state (edition 2.0.0, table 10-3): above a deeper bed no level has to be read.
  constexpr core::Metres greatest_fall{99.99};
  if (!environment.bathymetry || plan.waypoints.empty()) return std::nullopt;
  const std::vector<Dataset> levels = levels_on(db, plan);
  if (levels.empty()) return std::nullopt;

  std::optional<messages::Message> caution;
  core::Metres most_below{0.0};
  for_each_passage(plan, [&](geo::LonLat place, core::UtcTime time) {
    const auto bed = environment.bathymetry->shoalest(place);
    if (!bed) return;
    const core::Metres clear = *bed - std::min(vehicle.dive_depth, *bed - vehicle.altimeter_margin);
    if (clear > greatest_fall) return;
    const codec::Probe::WaterLevel level = probe_water_level(db, levels, place, time);
    if (!level.height) return;
    const core::Metres below = core::Metres{0.0} - clear - *level.height;
    if (below <= most_below) return;
    most_below = below;
    const double fall_m = -level.height->value;
    caution = messages::plan_message<"low-water-at-bed">(time, fall_m, level.datum, level.dataset_name,
                                                         below.value, std::ceil(fall_m))
                  .at(place);
  });
  return caution;
}

}  // namespace floeplan::service
