#include "engine/planning/plane/ground_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace floeplan::planning::plane {
namespace {

constexpr int cells = 64;  // on each side of the area

std::vector<double> scales_of(const geo::LocalProjection& projection, const PlaneBox& area) {
  std::vector<double> scales;
  scales.reserve((cells + 1) * (cells + 1));
  for (int iy = 0; iy <= cells; ++iy) {
    for (int ix = 0; ix <= cells; ++ix) {
      const geo::PlanePoint point{area.low.x_m + area.width_m() * ix / cells,
                                  area.low.y_m + area.height_m() * iy / cells};
      scales.push_back(projection.at(projection.to_lon_lat(point)).scale);
    }
  }
  return scales;
}

/// Largest change of the scale per metre of the plane, in any direction.
double steepest_of(const std::vector<double>& scales, const PlaneBox& area) {
  constexpr std::size_t row = cells + 1;
  double along_x = 0.0;
  double along_y = 0.0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if ((i + 1) % row != 0) along_x = std::max(along_x, std::abs(scales[i + 1] - scales[i]));
    if (i + row < scales.size()) along_y = std::max(along_y, std::abs(scales[i + row] - scales[i]));
  }
  return std::hypot(along_x * cells / area.width_m(), along_y * cells / area.height_m());
}

}  // namespace

GroundLengths::GroundLengths(const geo::LocalProjection& projection, const PlaneBox& area)
    : area_{area},
      scales_{scales_of(projection, area)},
      largest_{std::ranges::max(scales_)},
      steepest_{steepest_of(scales_, area)} {}

double GroundLengths::scale_at(geo::PlanePoint point) const {
  const double x = std::clamp((point.x_m - area_.low.x_m) / area_.width_m(), 0.0, 1.0) * cells;
  const double y = std::clamp((point.y_m - area_.low.y_m) / area_.height_m(), 0.0, 1.0) * cells;
  const int ix = std::min(static_cast<int>(x), cells - 1);
  const int iy = std::min(static_cast<int>(y), cells - 1);
  const double fx = x - ix;
  const double fy = y - iy;
  const double* row = scales_.data() + static_cast<std::ptrdiff_t>(iy) * (cells + 1) + ix;
  const double south = row[0] + fx * (row[1] - row[0]);
  const double north = row[cells + 1] + fx * (row[cells + 2] - row[cells + 1]);
  return south + fy * (north - south);
}

core::Metres GroundLengths::between(geo::PlanePoint a, geo::PlanePoint b) const {
  // Simpson's rule for the mean of 1/scale along the line.
  const geo::PlanePoint middle{0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m)};
  const double mean = (1.0 / scale_at(a) + 4.0 / scale_at(middle) + 1.0 / scale_at(b)) / 6.0;
  return core::Metres{mean * geo::distance_m(a, b)};
}

double GroundLengths::least_per_plane(geo::PlanePoint from, core::Metres length) const {
  return 1.0 / (scale_at(from) + steepest_ * length.value);
}

}  // namespace floeplan::planning::plane
