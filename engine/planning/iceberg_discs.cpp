#include "engine/planning/iceberg_discs.hpp"

#include <algorithm>
#include <cmath>

#include "engine/planning/plane_distance.hpp"

namespace floeplan::planning {
namespace {

constexpr double smallest_bucket_m = 1000.0;  // about a grid step, so that an edge meets few buckets

}  // namespace

IcebergDiscs::IcebergDiscs(const std::vector<ocean::Iceberg>& icebergs, core::Metres margin,
                           const geo::LocalProjection& projection) {
  double largest = smallest_bucket_m;
  for (const ocean::Iceberg& berg : icebergs) {
    const double scale = projection.at(berg.place).scale;
    const double hull = 0.5 * ocean::safe_length(berg).value;
    const double uncertainty = berg.position_uncertainty.value_or(core::Metres{0.0}).value;
    discs_.push_back(
        {projection.to_plane(berg.place), scale * (hull + uncertainty + margin.value), scale * hull, scale});
    largest = std::max(largest, discs_.back().radius_m);
  }
  bucket_m_ = 2.0 * largest;
  for (std::uint32_t i = 0; i < discs_.size(); ++i) {
    const Disc& disc = discs_[i];
    for (auto row = bucket_of(disc.centre.y_m - disc.radius_m);
         row <= bucket_of(disc.centre.y_m + disc.radius_m); ++row) {
      for (auto column = bucket_of(disc.centre.x_m - disc.radius_m);
           column <= bucket_of(disc.centre.x_m + disc.radius_m); ++column) {
        buckets_[bucket_key(column, row)].push_back(i);
      }
    }
  }
}

std::int64_t IcebergDiscs::bucket_of(double coordinate_m) const {
  return static_cast<std::int64_t>(std::floor(coordinate_m / bucket_m_));
}

bool IcebergDiscs::contains(geo::PlanePoint point) const { return crosses(point, point); }

bool IcebergDiscs::crosses(geo::PlanePoint a, geo::PlanePoint b) const {
  if (discs_.empty()) return false;
  const auto [low_x, high_x] = std::minmax(a.x_m, b.x_m);
  const auto [low_y, high_y] = std::minmax(a.y_m, b.y_m);
  const auto touches = [&](std::uint32_t i) {
    return distance_to_line(discs_[i].centre, a, b) <= discs_[i].radius_m;
  };
  for (auto row = bucket_of(low_y); row <= bucket_of(high_y); ++row) {
    for (auto column = bucket_of(low_x); column <= bucket_of(high_x); ++column) {
      const auto bucket = buckets_.find(bucket_key(column, row));
      if (bucket != buckets_.end() && std::ranges::any_of(bucket->second, touches)) return true;
    }
  }
  return false;
}

std::optional<core::Metres> IcebergDiscs::distance_from_hulls(geo::PlanePoint a, geo::PlanePoint b) const {
  std::optional<core::Metres> least;
  for (const Disc& disc : discs_) {
    const core::Metres distance{(distance_to_line(disc.centre, a, b) - disc.hull_radius_m) / disc.scale};
    if (!least || distance < *least) least = distance;
  }
  return least;
}

}  // namespace floeplan::planning
