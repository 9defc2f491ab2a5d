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

/// The sides of a bin in the order in which they are met going round counter-clockwise from the south-west
/// corner.
enum class BinSide { south, east, north, west, none };

/// A stretch of shoreline inside one bin, with the dry side on its left. `none`: a closed ring that meets no
/// side.
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

/// The dry part of a bin; lakes that lie wholly inside are holes, others are bays of the outer ring.
/// Frame    longitudes run on from the bin's south-west corner without a jump
/// Source   data layout of Wessel and Smith 1996, J. Geophys. Res. 101, 8741-8743, as GMT stores it
[[nodiscard]] std::vector<geo::Polygon> land_of(const ShoreBin& bin);

}  // namespace floeplan::ingest
