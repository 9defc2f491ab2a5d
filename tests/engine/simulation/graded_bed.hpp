#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/simulation/world/sea_bed.hpp"
#include "tests/engine/simulation/flown.hpp"

namespace floeplan::support {

/// A sea bed about `flight_origin` from its depth as a function of metres east and north, on nodes 25 m apart.
template <class Depth>
simulation::SeaBed graded_bed(const Depth& depth_m,
                              planning::plane::PlaneBox area = {{-600.0, -1500.0}, {2600.0, 1500.0}}) {
  constexpr double spacing_m = 25.0;
  const geo::LocalProjection projection{flight_origin};
  std::vector<double> lon;
  std::vector<double> lat;
  for (double x = area.low.x_m; x <= area.high.x_m; x += spacing_m)
    lon.push_back(projection.to_lon_lat({x, 0.0}).lon_deg);
  for (double y = area.low.y_m; y <= area.high.y_m; y += spacing_m)
    lat.push_back(projection.to_lon_lat({0.0, y}).lat_deg);
  std::vector<float> depths;
  for (const double lat_deg : lat) {
    for (const double lon_deg : lon) {
      const geo::PlanePoint place = projection.to_plane({lon_deg, lat_deg});
      depths.push_back(static_cast<float>(depth_m(place.x_m, place.y_m)));
    }
  }
  ocean::HorizontalGrid grid{geo::GridFrame{}, ocean::Axis{std::move(lon)}, ocean::Axis{std::move(lat)}};
  return simulation::SeaBed{std::make_shared<const ocean::Bathymetry>(std::move(grid), std::move(depths)),
                            projection, area.grown(-spacing_m)};
}

/// A depth that changes evenly from one place to another.
inline double ramp(double at_m, double from_m, double to_m, double first_depth_m, double last_depth_m) {
  const double share = (at_m - from_m) / (to_m - from_m);
  if (share <= 0.0) return first_depth_m;
  if (share >= 1.0) return last_depth_m;
  return first_depth_m + share * (last_depth_m - first_depth_m);
}

}  // namespace floeplan::support
