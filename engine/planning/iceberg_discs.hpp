#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/ocean/iceberg.hpp"

namespace floeplan::planning {

/// Standing icebergs as discs to keep out of: half the length, the stated uncertainty of the position, and
/// the margin.
/// Threads  const members may be called from several threads at once
class IcebergDiscs {
 public:
  IcebergDiscs(const std::vector<ocean::Iceberg>& icebergs, core::Metres margin,
               const geo::LocalProjection& projection);

  [[nodiscard]] bool contains(geo::PlanePoint point) const;
  /// Whether the straight line from a to b touches a disc.
  [[nodiscard]] bool crosses(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Least distance on the ground of the line from any hull (half the length, without margin and uncertainty),
  /// negative inside; empty without icebergs.
  [[nodiscard]] std::optional<core::Metres> distance_from_hulls(geo::PlanePoint a, geo::PlanePoint b) const;

 private:
  struct Disc {
    geo::PlanePoint centre;
    double radius_m;       // of the plane, all included
    double hull_radius_m;  // of the plane, half the length
    double scale;
  };
  [[nodiscard]] std::int64_t bucket_key(std::int64_t column, std::int64_t row) const {
    return row * (std::int64_t{1} << 32) + column;
  }
  [[nodiscard]] std::int64_t bucket_of(double coordinate_m) const;

  std::vector<Disc> discs_;
  double bucket_m_{1.0};
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> buckets_;  // looked up, never iterated
};

}  // namespace floeplan::planning
