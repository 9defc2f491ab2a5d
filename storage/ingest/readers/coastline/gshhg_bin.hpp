#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::ingest {

/// A point inside a bin: steps of bin size / 65535 east and north of its south-west corner.
struct BinPoint {
  std::uint16_t east{};
  std::uint16_t north{};

  friend bool operator==(BinPoint, BinPoint) = default;
};

/// The sides of a bin, in anticlockwise order from the south-west corner.
enum class BinSide { south, east, north, west, none };

/// A stretch of shoreline inside one bin; the dry side is on its left. `none` as its sides: a closed ring
/// that meets no side of the bin.
struct ShoreSegment {
  int level{};  // 1 coast, 2 lake shore, 3 island in a lake, 4 pond on such an island
  BinSide entry{BinSide::none};
  BinSide exit{BinSide::none};
  std::vector<BinPoint> points;
};

/// One cell of the binned shoreline.
struct ShoreBin {
  geo::LonLat south_west;
  double size_deg{1.0};
  std::array<int, 4> corner_levels{};  // SW, SE, NE, NW: 0 ocean, odd dry, even wet
  std::vector<ShoreSegment> segments;
};

/// The land in a bin. Lakes that lie wholly inside are holes; other lakes are bays of the outer ring.
/// Frame    longitudes are continuous from the bin's south-west corner on
/// Source   data layout of Wessel and Smith 1996, J. Geophys. Res. 101, 8741-8743, as GMT stores it
[[nodiscard]] std::vector<geo::Polygon> land_of(const ShoreBin& bin);

}  // namespace floeplan::ingest
