#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ingest {

/// One field of a GRIB2 file for tests: 16-bit simple packing on latitude and longitude (template 3.0) or on a polar
/// stereographic plane on a sphere (template 3.20).
struct GribMessage {
  bool polar{false};
  int number{2};           // of oceanography, currents: 2 eastward, 3 northward; 0 and 1: direction and speed
  bool along_grid{false};  // the component flag
  bool rows_from_south{true};
  int columns{12};
  int rows{10};
  geo::LonLat first{350.0, 60.0};  // of latitude and longitude: the south-western node
  double step_deg{1.0};
  double spacing_m{50000.0};  // of the polar plane, whose middle is 600 km from the pole
  double depth_m{5.0};
  std::optional<double> wind_height_m;                     // then it is wind at this height above the ground
  int forecast_h{6};                                       // from 2026-11-20T00:00:00Z on
  std::function<double(double column, double row)> value;  // rows from the south

  [[nodiscard]] geo::LonLat place(double column, double row) const;
  [[nodiscard]] std::string octets() const;
};

}  // namespace floeplan::ingest
