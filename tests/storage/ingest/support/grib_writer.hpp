#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ingest {

/// Templates 3.0, 3.1, 3.10, 3.20 (twice) and 3.30, all on one sphere.
enum class GribPlane { latitude_longitude, turned_pole, mercator, north_polar, south_polar, lambert };

/// One field of a GRIB2 file for tests, in 16-bit simple packing. The positions of its nodes are computed
/// here by independent formulas.
/// Source  Snyder 1987, Map Projections (USGS PP 1395), equations for the sphere
struct GribMessage {
  GribPlane plane{GribPlane::latitude_longitude};
  int number{2};           // of oceanography, currents: 2 eastward, 3 northward; 0 and 1: direction and speed
  bool along_grid{false};  // the component flag
  int scanning{0x40};      // flag table 3.4, its first four bits
  std::optional<int> stated_scanning;  // a scanning mode that the file states but does not follow
  bool states_increments{true};        // of latitude and longitude
  int columns{12};
  int rows{10};
  geo::LonLat first{350.0, 60.0};  // the south-western node of latitude and longitude, and of Mercator
  double step_deg{1.0};            // of latitude and longitude, and round the turned pole
  double spacing_m{50000.0};       // of the planes; the middle of the polar ones is 600 km from the pole
  double depth_m{5.0};
  std::optional<double> wind_height_m;  // then it is wind at this height above the ground
  std::optional<double> layer_ends_m;   // a second surface of the same type, at this depth or height
  std::optional<int> second_type;       // of it; empty: the first one's
  std::optional<int> statistic;  // over the hours until then, code table 4.10; empty: the value at one time
  std::optional<int> period_begins_h;                      // of a statistic; empty: where it ends
  int forecast_h{6};                                       // from 2026-11-20T00:00:00Z on
  std::function<double(double column, double row)> value;  // rows from the south, columns from the west

  [[nodiscard]] geo::LonLat place(double column, double row) const;
  [[nodiscard]] std::string octets() const;
};

}  // namespace floeplan::ingest
