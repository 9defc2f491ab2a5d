#include "engine/planning/search/missing_data.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

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

/// Says of each stop outside the currents where it lies, in the order of the stops.
std::vector<messages::Message> stops_outside_currents(const ocean::Environment& environment,
                                                      const PlanRequest& request) {
  std::vector<messages::Message> outside;
  const auto look_at = [&](geo::LonLat place, const char* name) {
    if (currents_reach(environment, place)) return;
    outside.push_back(
        messages::refusal<"stop-outside-currents">(name, where_from(*environment.currents, place)).at(place));
  };
  look_at(request.from, "the start");
  for (const geo::LonLat via : request.via) look_at(via, "a via point");
  look_at(request.to, "the goal");
  return outside;
}

/// Whether a search may have failed because a stop lies outside the currents. No edge leads to such a stop,
/// but the search may have ended at another obstacle, or at the end of the period of the data.
bool may_be_due_to_a_stop(const Infeasible& why) {
  return !why.at_a_stop && why.binding != Constraint::memory && why.binding != Constraint::battery &&
         why.binding != Constraint::caller;
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
  return messages::refusal<"place-outside-depths-and-currents">(place, from_depths,
                                                                where_from(*environment.currents, where));
}

Infeasible with_missing_data(Infeasible why, const ocean::Environment& environment,
                             const PlanRequest& request) {
  auto outside = may_be_due_to_a_stop(why) ? stops_outside_currents(environment, request)
                                           : std::vector<messages::Message>{};
  if (!outside.empty()) {
    Infeasible unusable{.reason = Reason::outside_data,
                        .at = *outside.front().place,
                        .when = request.depart,
                        .why = std::move(outside.front()),
                        .binding = Constraint::data_area,
                        .at_a_stop = true};
    unusable.besides.assign(std::next(outside.begin()), outside.end());
    // The first stop is to be mended first, and the suggestion is the last hint.
    for (messages::Message& later : unusable.besides) later.hint.clear();
    return unusable;
  }
  constexpr core::Seconds worth_telling{3600.0};
  if (why.binding == Constraint::data_period && environment.currents_begin &&
      *environment.currents_begin <= request.depart - worth_telling)
    why.besides.push_back(messages::refusal<"earlier-departure-possible">(*environment.currents_begin));
  if (why.binding != Constraint::data_area || why.at_a_stop) return why;

  const std::size_t before = why.besides.size();
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
