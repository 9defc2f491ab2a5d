#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

/// Random seas for tests of lower bounds.
namespace floeplan::planning::search {

/// Tides and eddies of random strength, perhaps an island, and data that may end before the route.
inline ocean::Environment random_environment(std::mt19937_64& rng) {
  const double strength_m_s = support::uniform(rng, 0.02, 0.5);
  const double phase = support::uniform(rng, 0.0, 6.28);
  const double eddies = support::uniform(rng, 1.0, 12.0);
  const bool island = support::uniform(rng, 0.0, 1.0) < 0.4;
  const int hours = support::uniform(rng, 0.0, 1.0) < 0.2 ? 24 : 120;
  const auto field = [=](geo::LonLat p, double hour) {
    if (island && std::hypot(3.0 * (p.lat_deg - 69.02), p.lon_deg + 53.0) < 0.15) {
      return geo::VelocityEn{{std::numeric_limits<double>::quiet_NaN()}, {0.0}};
    }
    const double tide = 0.5 * strength_m_s * std::sin(hour / 1.97 + phase + p.lon_deg);
    const double eddy =
        0.5 * strength_m_s * std::sin(eddies * p.lon_deg + 0.02 * hour) * std::cos(2.0 * eddies * p.lat_deg);
    return geo::VelocityEn{{tide + eddy}, {0.7 * tide - eddy}};
  };
  return {.currents = support::currents_from(field, hours), .steady_currents = rng() % 5 == 0};
}

/// A sea and a grid in it, 40 km eastwards.
struct Waters {
  geo::LocalProjection projection{{-53.0, 69.0}};
  ocean::Environment environment;
  PlanRequest request = support::eastward_request();
  cost::RouteGrid grid;
  cost::Sea sea;
  OpenGrid open;

  explicit Waters(ocean::Environment the_environment, double step_m = 2000.0)
      : environment{std::move(the_environment)},
        grid{cost::lay_grid({-20'000.0, 0.0}, {20'000.0, 3000.0},
                            {core::Metres{step_m}, core::Metres{step_m}}, {0.5, 0.25})},
        sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{500.0}},
        open{open_grid(sea.domain(), grid, request.sectors, {})} {}
};

inline graph::Vertex random_vertex(std::mt19937_64& rng, const OpenGrid& open) {
  return static_cast<graph::Vertex>(support::uniform_int(rng, 0, static_cast<int>(open.graph.size()) - 1));
}

}  // namespace floeplan::planning::search
