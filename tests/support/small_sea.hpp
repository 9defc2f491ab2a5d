#pragma once

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

/// Small seas with known answers, around 69 N 53 W.
namespace floeplan::support {

inline constexpr double sea_start_s = 1'800'000'000.0;

inline ocean::Axis steps(double first, double step, int count) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(first + step * i);
  return ocean::Axis{std::move(nodes)};
}

/// The sea's grid: 0.1 x 0.05 degrees, 56 W to 50 W and 67.5 N to 70.5 N.
inline ocean::HorizontalGrid sea_grid() {
  return {geo::GeographicFrame{}, steps(-56.0, 0.1, 61), steps(67.5, 0.05, 61)};
}

/// Hourly currents for `hours` from sea_start_s by a function of place and hour; NaN: no water.
inline std::shared_ptr<const ocean::CurrentGrid> currents_from(
    const std::function<geo::VelocityEn(geo::LonLat, double hour)>& field, int hours) {
  const ocean::HorizontalGrid grid = sea_grid();
  ocean::CurrentGrid::Samples samples{.grid = grid,
                                      .depths_m = std::nullopt,
                                      .times_s = steps(sea_start_s, 3600.0, hours + 1),
                                      .u = {},
                                      .v = {}};
  for (int hour = 0; hour <= hours; ++hour) {
    for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
      for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
        const geo::VelocityEn c = field(grid.place(ix, iy), hour);
        samples.u.push_back(static_cast<float>(c.east.value));
        samples.v.push_back(static_cast<float>(c.north.value));
      }
    }
  }
  return std::make_shared<const ocean::CurrentGrid>(std::move(samples));
}

inline std::shared_ptr<const ocean::Bathymetry> bathymetry_from(
    const std::function<double(geo::LonLat)>& depth_m) {
  const ocean::HorizontalGrid grid = sea_grid();
  std::vector<float> depths;
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
      depths.push_back(static_cast<float>(depth_m(grid.place(ix, iy))));
    }
  }
  return std::make_shared<const ocean::Bathymetry>(grid, std::move(depths));
}

inline constexpr double shear_level_m[] = {0.0, 10.0, 30.0, 75.0, 150.0, 300.0};
inline constexpr double shear_east_m_s[] = {0.5, 0.45, 0.2, -0.1, -0.2, -0.25};

/// The same sheared eastward current everywhere, for `hours`: fast at the surface, reversed at depth.
inline std::shared_ptr<const ocean::CurrentGrid> sheared_currents(int hours = 0) {
  const ocean::HorizontalGrid grid = sea_grid();
  ocean::CurrentGrid::Samples samples{
      .grid = grid,
      .depths_m = ocean::Axis{{std::begin(shear_level_m), std::end(shear_level_m)}},
      .times_s = steps(sea_start_s, 3600.0, hours + 1),
      .u = {},
      .v = {}};
  for (int hour = 0; hour <= hours; ++hour) {
    for (const double east : shear_east_m_s) {
      samples.u.insert(samples.u.end(), grid.size(), static_cast<float>(east));
      samples.v.insert(samples.v.end(), grid.size(), 0.0F);
    }
  }
  return std::make_shared<const ocean::CurrentGrid>(std::move(samples));
}

/// Ice at the given hours from sea_start_s by a function of place and hour; NaN: no data.
inline std::shared_ptr<const ocean::IceField> ice_from(
    const std::function<double(geo::LonLat, double hour)>& concentration, const std::vector<double>& hours,
    std::optional<double> thickness_m = std::nullopt) {
  const ocean::HorizontalGrid grid = sea_grid();
  std::vector<double> times;
  for (const double hour : hours) times.push_back(sea_start_s + 3600.0 * hour);
  ocean::IceField::Samples samples{
      .grid = grid, .times_s = ocean::Axis{times}, .concentration = {}, .thickness_m = {}};
  for (const double hour : hours) {
    for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
      for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
        samples.concentration.push_back(static_cast<float>(concentration(grid.place(ix, iy), hour)));
        if (thickness_m) samples.thickness_m.push_back(static_cast<float>(*thickness_m));
      }
    }
  }
  return std::make_shared<const ocean::IceField>(std::move(samples));
}

inline ocean::Iceberg iceberg_at(geo::LonLat place, double length_m) {
  ocean::Iceberg berg;
  berg.id = "berg";
  berg.place = place;
  berg.length = core::Metres{length_m};
  berg.observed = core::from_unix_seconds(sea_start_s);
  return berg;
}

/// A request for about 40 km eastwards along 69 N, on a 1 km grid.
inline planning::PlanRequest eastward_request() {
  planning::PlanRequest request;
  request.from = {-53.5, 69.0};
  request.to = {-52.5, 69.0};
  request.depart = core::from_unix_seconds(sea_start_s);
  request.vehicle = *vehicle::find_profile("slocum-g3-200");
  request.spacing_along = core::Metres{1000.0};
  return request;
}

}  // namespace floeplan::support
