#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class OGRGeometry;

namespace floeplan::ingest {

/// A thing on a chart with a depth, metres below the sounding datum, positive down; what dries is negative.
struct ChartedDepth {
  std::shared_ptr<const OGRGeometry> geometry;  // longitude and latitude, WGS 84
  double depth_m{};
};

/// What a cell of an electronic chart says of depths.
struct ChartCell {
  std::vector<std::shared_ptr<const OGRGeometry>>
      covered;                      // M_COVR; outside nothing is known, not even that it is deep
  std::vector<ChartedDepth> areas;  // DEPARE and DRGARE at the middle of their range, land at 0
  /// Everything that may be as shoal as said: depth areas at their least depth, soundings, rocks, wrecks, obstructions,
  /// land and what is built into the water; at 0 where the chart gives no depth.
  std::vector<ChartedDepth> shoals;
  int scale{};  // the denominator
  Messages warnings;
};

/// The base cell and, beside it, its updates .001, .002, ... in order.
[[nodiscard]] std::vector<std::filesystem::path> parts_of_s57(const std::filesystem::path& base);

/// Reads a base cell with the updates beside it.
/// Errors   damaged; an update without its base; a gap among the updates; depths in another unit than metres; no
///          coverage or no depth areas
/// Source   IHO S-57 edition 3.1, appendix A (object and attribute catalogue) and appendix B.1 (ENC product
///          specification)
[[nodiscard]] Checked<ChartCell> read_s57_cell(const std::filesystem::path& base);

}  // namespace floeplan::ingest
