#include "engine/simulation/world/local_bed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::simulation {
namespace {

constexpr double margin_m = 100.0;  // movement until the grid is made again: some five minutes of a glider
constexpr double beyond_reach_m = 2.0 * LocalBed::spacing_m;  // slopes are needed at the ends of rays, too
constexpr float not_known = std::numeric_limits<float>::quiet_NaN();

std::size_t nodes_for(double reach_m) {
  return 2 * static_cast<std::size_t>(
                 std::ceil((reach_m + margin_m + beyond_reach_m) / LocalBed::spacing_m)) +
         1;
}

double on_grid(double metres) { return LocalBed::spacing_m * std::round(metres / LocalBed::spacing_m); }

}  // namespace

LocalBed::LocalBed(const World& world, core::Metres reach)
    : world_{world}, reach_m_{reach.value}, side_{nodes_for(reach.value)} {}

void LocalBed::look_from(Vector place) {
  const double east_m = place.east - laid_about_.east;
  const double north_m = place.north - laid_about_.north;
  if (!depths_.empty() && east_m * east_m + north_m * north_m <= margin_m * margin_m) return;
  lay(place);
  measure();
}

void LocalBed::lay(Vector about) {
  laid_about_ = {on_grid(about.east), on_grid(about.north), 0.0};
  const double half_m = 0.5 * static_cast<double>(side_ - 1) * spacing_m;
  west_m_ = laid_about_.east - half_m;
  south_m_ = laid_about_.north - half_m;
  depths_.resize(side_ * side_);
  for (std::size_t row = 0; row < side_; ++row) {
    for (std::size_t column = 0; column < side_; ++column) {
      const auto depth_m = world_.bed_depth_m(west_m_ + static_cast<double>(column) * spacing_m,
                                              south_m_ + static_cast<double>(row) * spacing_m);
      depths_[row * side_ + column] = depth_m ? static_cast<float>(*depth_m) : not_known;
    }
  }
}

void LocalBed::measure() {
  shallowest_m_.reset();
  double most_m2 = 0.0;  // largest squared rise from a node to its neighbours
  for (std::size_t row = 0; row < side_; ++row) {
    for (std::size_t column = 0; column < side_; ++column) {
      const std::size_t node = row * side_ + column;
      const double depth_m = depths_[node];
      if (std::isnan(depth_m)) continue;
      if (!shallowest_m_ || depth_m < *shallowest_m_) shallowest_m_ = depth_m;
      if (row + 1 == side_ || column + 1 == side_) continue;
      const double corner_m = depths_[node + side_ + 1];
      const double east_m =
          std::max(std::abs(depths_[node + 1] - depth_m), std::abs(corner_m - depths_[node + side_]));
      const double north_m =
          std::max(std::abs(depths_[node + side_] - depth_m), std::abs(corner_m - depths_[node + 1]));
      const double rise_m2 = east_m * east_m + north_m * north_m;
      if (rise_m2 > most_m2) most_m2 = rise_m2;  // false if a neighbour is unknown (NaN); no cell is there
    }
  }
  steepest_ = std::sqrt(most_m2) / spacing_m;
}

std::optional<double> LocalBed::depth_m(double east_m, double north_m) const {
  const double x = (east_m - west_m_) / spacing_m;
  const double y = (north_m - south_m_) / spacing_m;
  const double last = static_cast<double>(side_ - 1);
  if (!(x >= 0.0 && y >= 0.0 && x < last && y < last)) return std::nullopt;
  const auto column = static_cast<std::size_t>(x);
  const auto row = static_cast<std::size_t>(y);
  const float* south = &depths_[row * side_ + column];
  const float* north = south + side_;
  const double fx = x - static_cast<double>(column);
  const double fy = y - static_cast<double>(row);
  const double along_south = south[0] + fx * static_cast<double>(south[1] - south[0]);
  const double along_north = north[0] + fx * static_cast<double>(north[1] - north[0]);
  const double depth = along_south + fy * (along_north - along_south);
  if (std::isnan(depth)) return std::nullopt;
  return depth;
}

}  // namespace floeplan::simulation
