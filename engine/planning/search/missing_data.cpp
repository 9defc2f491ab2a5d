#include "engine/planning/search/missing_data.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/ocean/currents/nearest_water.hpp"

namespace floeplan::planning::search {
namespace {

/// The search stopped where data end nearby. Their end is looked for at these distances in metres around the
/// reached place: from a step of a fine grid to some cells of a coarse model. Judgements.
constexpr std::array distances_beyond{2'500.0, 5'000.0, 10'000.0, 20'000.0};
constexpr int directions = 8;

/// Where a place without a value lies from the data on the grid.
std::string where_from(const ocean::HorizontalGrid& grid, geo::LonLat place, const std::string& data) {
  const geo::BoundingBox bounds = grid.bounds();
  if (grid.locate(place) || geo::contains(bounds, place))
    return messages::phrase<"in-gap-of-data">(data, geo::bounds_text(bounds));
  const geo::GeodesicLine line = geo::geodesic_between(geo::nearest_place(bounds, place), place);
  return messages::phrase<"outside-of-data">(
      line.length.value / 1000.0, geo::compass_point(line.course_at_start), data, geo::bounds_text(bounds));
}

bool currents_reach(const ocean::Environment& environment, geo::LonLat place) {
  return !environment.currents || ocean::has_water_around(*environment.currents, place);
}

/// Where a place without a current lies from the water of the currents. Names the area of the grid only if
/// the water reaches about as far: the water of a bent grid or a mesh fills its box only in part.
std::string where_from(const ocean::CurrentGrid& currents, geo::LonLat place) {
  const ocean::HorizontalGrid& grid = currents.samples().grid;
  const auto water = ocean::nearest_water(currents, place);
  if (!water)
    return messages::phrase<"where-data-have-no-water">("currents", geo::bounds_text(grid.bounds()));
  const geo::GeodesicLine line = geo::geodesic_between(*water, place);
  const geo::LonLat edge = geo::nearest_place(grid.bounds(), place);
  const core::Metres to_box = geo::geodesic_between(edge, place).length;
  if (!geo::contains(grid.bounds(), place) && line.length < to_box + grid.spacing() + grid.spacing())
    return where_from(grid, place, "currents");
  return messages::phrase<"away-from-water-of-data">(line.length.value / 1000.0,
                                                     geo::compass_point(line.course_at_start), "currents",
                                                     water->lon_deg, water->lat_deg);
}

bool depth_is_known(const ocean::Environment& environment, geo::LonLat place) {
  return !environment.bathymetry || environment.bathymetry->depth(place);
}

/// Whether the data have no value somewhere around the place.
template <class IsKnown>
bool end_around(geo::LonLat place, const IsKnown& is_known) {
  for (int i = 0; i < directions; ++i) {
    const auto course = geo::Bearing::degrees(360.0 * i / directions);
    for (const double distance_m : distances_beyond)
      if (!is_known(geo::geodesic_destination(place, course, core::Metres{distance_m}))) return true;
  }
  return false;
}

void add_stop(Infeasible& why, const ocean::Environment& environment, geo::LonLat place,
              const std::string& name) {
  if (currents_reach(environment, place)) return;
  why.besides.push_back(messages::refusal<"stop-outside-currents">(
                            name, where_from(*environment.currents, place))
                            .at(place));
}

void add_end(Infeasible& why, const ocean::HorizontalGrid& grid, const std::string& data) {
  why.besides.push_back(messages::refusal<"data-end-on-the-way">(data, geo::bounds_text(grid.bounds())));
}

}  // namespace

messages::Message explain_missing_depth(const ocean::Environment& environment, geo::LonLat where,
                                        const std::string& place) {
  if (!environment.bathymetry) throw std::invalid_argument{"no bathymetry that could miss a depth"};
  const std::string from_depths = where_from(environment.bathymetry->grid(), where, "bathymetry");
  if (currents_reach(environment, where)) return messages::refusal<"place-outside-data">(place, from_depths);
  return messages::refusal<"place-outside-depths-and-currents">(
      place, from_depths, where_from(*environment.currents, where));
}

Infeasible with_missing_data(Infeasible why, const ocean::Environment& environment,
                             const PlanRequest& request) {
  constexpr core::Seconds worth_telling{3600.0};
  if (why.binding == Constraint::data_period && environment.currents_begin &&
      *environment.currents_begin <= request.depart - worth_telling)
    why.besides.push_back(messages::refusal<"earlier-departure-possible">(*environment.currents_begin));
  if (why.binding != Constraint::data_area || why.at_a_stop) return why;
  const std::size_t before = why.besides.size();
  add_stop(why, environment, request.from, "the start");
  for (const geo::LonLat via : request.via) add_stop(why, environment, via, "a via point");
  add_stop(why, environment, request.to, "the goal");
  if (why.besides.size() > before) return why;

  if (end_around(why.at, [&](geo::LonLat place) { return depth_is_known(environment, place); }))
    add_end(why, environment.bathymetry->grid(), "depths");
  if (!environment.currents) return why;
  const ocean::HorizontalGrid& grid = environment.currents->samples().grid;
  if (end_around(why.at, [&](geo::LonLat place) { return grid.locate(place).has_value(); }))
    add_end(why, grid, "currents");
  if (why.besides.size() == before &&
      end_around(why.at, [&](geo::LonLat place) { return currents_reach(environment, place); }))
    why.besides.push_back(messages::refusal<"water-ends-on-the-way">("currents"));
  return why;
}

}  // namespace floeplan::planning::search
