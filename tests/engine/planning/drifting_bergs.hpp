#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/problem/plan.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

/// Icebergs that drift, and an independent simulation that checks plans among them.
namespace floeplan::planning {

inline const core::UtcTime start = core::from_unix_seconds(support::sea_start_s);
inline constexpr double hour_s = 3600.0;

/// An iceberg that was seen twice, half a day apart. So its drift is known without currents.
inline ocean::Iceberg drifting_berg(geo::LonLat place, double length_m, double speed_m_s,
                                    double towards_deg) {
  ocean::Iceberg berg = support::iceberg_at(place, length_m);
  const core::Seconds before{12.0 * hour_s};
  berg.earlier = {{geo::geodesic_destination(place, geo::Bearing::degrees(towards_deg + 180.0),
                                             core::Metres{speed_m_s * before.count()}),
                   start - before}};
  return berg;
}

/// Whether the plan says that it passes under the berg then.
inline bool is_under(const Plan& plan, const std::string& berg, core::UtcTime time) {
  constexpr core::Seconds rounding{2.0};
  return std::ranges::any_of(plan.passed_under, [&](const PassedUnder& under) {
    return under.iceberg == berg && under.from - rounding <= time && time <= under.until + rounding;
  });
}

/// Least distance of the plan's vehicle from the rim of any disc, simulated second by second. The vehicle moves evenly between
/// its waypoints and stays there while it holds. Each berg moves evenly along its observed drift. All bergs are seen at the
/// start.
inline double least_gap_m(const Plan& plan, const ocean::Environment& environment,
                          const IcebergRules& rules) {
  const geo::LocalProjection projection{plan.waypoints.front().place};
  struct Disc {
    geo::PlanePoint centre;
    geo::PlaneVelocity drift;
    double hull_m;
    double error_m;
    std::string name;
  };
  std::vector<Disc> discs;
  for (const ocean::Iceberg& berg : environment.icebergs) {
    const geo::PlanePoint now = projection.to_plane(berg.place);
    geo::PlaneVelocity drift{};
    if (!berg.earlier.empty()) {
      const geo::PlanePoint then = projection.to_plane(berg.earlier[0].place);
      const double span_s = (berg.observed - berg.earlier[0].time).count();
      drift = {(now.x_m - then.x_m) / span_s, (now.y_m - then.y_m) / span_s};
    }
    discs.push_back({now, drift, 0.5 * berg.length->value,
                     berg.position_uncertainty.value_or(core::Metres{0.0}).value, berg.id});
  }
  double least_m = INFINITY;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const geo::PlanePoint a = projection.to_plane(plan.waypoints[i - 1].place);
    const geo::PlanePoint b = projection.to_plane(plan.waypoints[i].place);
    const double arrives_s = (plan.waypoints[i - 1].eta - start).count();
    const double t0_s = arrives_s + plan.waypoints[i - 1].wait.count();
    const double t1_s = (plan.waypoints[i].eta - start).count();
    for (double t_s = arrives_s; t_s <= t1_s; t_s += 1.0) {
      const double share = std::max(0.0, t_s - t0_s) / (t1_s - t0_s);
      const double x_m = a.x_m + share * (b.x_m - a.x_m);
      const double y_m = a.y_m + share * (b.y_m - a.y_m);
      for (const Disc& disc : discs) {
        if (is_under(plan, disc.name, start + core::Seconds{t_s})) continue;
        const double radius_m = disc.hull_m + rules.margin.value +
                                std::min(disc.error_m + t_s * 0.75 / 3.6, rules.max_inflation.value);
        least_m = std::min(least_m, std::hypot(x_m - disc.centre.x_m - t_s * disc.drift.x_m_s,
                                               y_m - disc.centre.y_m - t_s * disc.drift.y_m_s) -
                                        radius_m);
      }
    }
  }
  return least_m;
}

/// A constant course is straight in the plane only near the equator. The random scenes lie there.
inline constexpr double tolerance_m = 3.0;

/// A wall of shallow water along 53 W with a gap of about 10 km at 69 N.
inline std::shared_ptr<const ocean::Bathymetry> wall_with_a_gap() {
  return support::bathymetry_from([](geo::LonLat p) {
    const bool in_wall = std::abs(p.lon_deg + 53.0) < 0.15;
    const bool in_gap = std::abs(p.lat_deg - 69.0) < 0.026;
    return in_wall && !in_gap ? 5.0 : 300.0;
  });
}

/// A request and its environment.
struct Scene {
  PlanRequest request;
  ocean::Environment environment;
};

/// A route of about 13 km eastwards near the equator, among one to six bergs.
inline Scene random_scene(std::mt19937_64& rng) {
  using support::uniform;
  PlanRequest request = support::eastward_request();
  request.from = {-40.06, 0.1};
  request.to = {-39.94, 0.1};
  request.optimality_gap = false;
  request.icebergs.margin = core::Metres{uniform(rng, 200.0, 1000.0)};
  request.icebergs.max_inflation = core::Metres{uniform(rng, 0.0, 1500.0)};
  ocean::Environment environment;
  const int bergs = support::uniform_int(rng, 1, 6);
  for (int i = 0; i < bergs; ++i) {
    const geo::LonLat place{uniform(rng, -40.1, -39.9), uniform(rng, 0.04, 0.16)};
    environment.icebergs.push_back(
        drifting_berg(place, uniform(rng, 10.0, 300.0), uniform(rng, 0.0, 0.3), uniform(rng, 0.0, 360.0)));
    environment.icebergs.back().id = "B-" + std::to_string(i);
    if (i % 2 == 0) environment.icebergs.back().position_uncertainty = core::Metres{uniform(rng, 0.0, 500.0)};
  }
  return {request, environment};
}

/// One of four quarters, 0 to 3, of 500 random scenes, so that four tests can run at the same time.
class IcebergScenes : public testing::TestWithParam<int> {
 protected:
  static constexpr int scenes = 125;

  /// Calls `law(rng)` for each scene's seed.
  template <class Law>
  void for_each_scene(const Law& law) const {
    int scene = 0;
    support::for_each_seed(4 * scenes, [&](std::mt19937_64& rng) {
      if (scene++ / scenes == GetParam()) law(rng);
    });
  }
};

}  // namespace floeplan::planning
