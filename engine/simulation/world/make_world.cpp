#include "engine/simulation/world/make_world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/random.hpp"
#include "engine/messages/fault.hpp"
#include "engine/ocean/iceberg_drift.hpp"
#include "engine/simulation/world/iceberg_shape.hpp"

namespace floeplan::simulation {
namespace {

planning::plane::PlaneBox box_about(std::span<const geo::LonLat> route,
                                    const geo::LocalProjection& projection, core::Metres margin) {
  const geo::PlanePoint first = projection.to_plane(route.front());
  planning::plane::PlaneBox box{first, first};
  for (const geo::LonLat place : route) box.include(projection.to_plane(place));
  return box.grown(margin.value);
}

/// The forecast track plus the displacement by the current's error, averaged over the keel and integrated
/// along the track.
std::vector<Body::Fix> true_track(const std::vector<ocean::IcebergFix>& forecast,
                                  const geo::LocalProjection& projection, const CurrentErrorField& error,
                                  core::Metres draft, core::UtcTime begin) {
  std::vector<Body::Fix> track;
  Vector strayed{};
  for (std::size_t i = 0; i < forecast.size(); ++i) {
    const geo::PlanePoint point = projection.to_plane(forecast[i].place);
    const Vector place{point.x_m + strayed.east, point.y_m + strayed.north, 0.5 * draft.value};
    track.push_back({.time = forecast[i].time, .east_m = place.east, .north_m = place.north});
    const bool lasts = i + 1 < forecast.size() && forecast[i + 1].time > begin;
    if (!lasts) continue;
    const core::Seconds span = forecast[i + 1].time - std::max(forecast[i].time, begin);
    strayed = strayed + span.count() * error.at(place, forecast[i].time);
  }
  return track;
}

bool comes_near(const std::vector<Body::Fix>& track, core::UtcTime begin, core::UtcTime end,
                const planning::plane::PlaneBox& area) {
  const auto in_time = [&](std::size_t i) {
    const bool over = i + 1 < track.size() && track[i + 1].time < begin;
    return !over && (track[i].time <= end || i == 0);
  };
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (in_time(i) && area.contains({track[i].east_m, track[i].north_m})) return true;
  }
  return false;
}

}  // namespace

core::Violations WorldSettings::violations() const {
  messages::Faults faults;
  faults.take(current_error.violations());
  faults.within(most_spin_deg_h, 0.0, 3600.0, "/icebergs/most_spin_deg_h", "0", "3600 degrees an hour");
  faults.within(margin.value, 1000.0, 1e6, "/margin_m", "1", "1000 km");
  return faults.found();
}

World make_world(const ocean::Environment& environment, std::span<const geo::LonLat> route,
                 core::UtcTime begin, core::UtcTime end, const WorldSettings& settings, std::uint64_t seed,
                 const std::stop_token& stop) {
  if (route.empty()) throw std::invalid_argument{"a world lies about a route"};
  if (const auto found = settings.violations(); !found.empty())
    throw std::invalid_argument{found.front().field + " " + found.front().rule};

  const geo::LocalProjection projection{route.front()};
  const planning::plane::PlaneBox area = box_about(route, projection, settings.margin);
  const CurrentErrorField error{settings.current_error, begin, seed};
  WorldParts parts{.origin = route.front()};
  if (environment.bathymetry) parts.bed = SeaBed{environment.bathymetry, projection, area};
  if (environment.ice) parts.ice = IceLayer{environment, settings.ice, projection, area, begin};
  parts.current = environment.currents
                      ? TrueCurrent{{environment.currents, environment.steady_currents}, projection, error}
                      : TrueCurrent{Vector{}, error};
  for (const ocean::Iceberg& berg : environment.icebergs) {
    if (stop.stop_requested()) break;
    auto rng = core::random_stream(seed, "iceberg " + berg.id);
    const IcebergForm form = iceberg_form(berg.shape, rng);
    const core::Metres length = ocean::safe_length(berg);
    const core::Metres likely = likely_draft(length, rng);
    const core::Metres draft = berg.draft.value_or(likely);
    Shape shape = iceberg_shape(form, length, draft, rng);
    Body::Motion motion{.track = true_track(ocean::forecast_drift(berg, environment, end, stop), projection,
                                            error, draft, begin),
                        .heading_rad = 2.0 * std::numbers::pi * core::uniform(rng),
                        .spin_rad_s = core::degrees_to_radians(settings.most_spin_deg_h) / 3600.0 *
                                      (2.0 * core::uniform(rng) - 1.0)};
    if (comes_near(motion.track, begin, end, area))
      parts.bodies.emplace_back(berg.id, std::move(shape), std::move(motion));
  }
  return World{std::move(parts)};
}

}  // namespace floeplan::simulation
