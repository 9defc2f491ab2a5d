#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class OGRGeometry;

namespace floeplan::ingest {

/// An object of a chart with a depth: metres below the sounding datum, positive down, negative for drying
/// heights.
struct ChartedDepth {
  std::shared_ptr<const OGRGeometry> geometry;  // longitude and latitude, WGS 84
  double depth_m{};
};

/// The depths in a cell of an electronic chart.
struct ChartCell {
  std::vector<std::shared_ptr<const OGRGeometry>>
      covered;                      // M_COVR; outside of it nothing is known about the depth
  std::vector<ChartedDepth> areas;  // DEPARE and DRGARE at the middle of their depth range, land at 0
  /// Everything that may be as shoal as stated: depth areas at their least depth, soundings, rocks, wrecks,
  /// obstructions, land and structures in the water; 0 if the chart states no depth.
  std::vector<ChartedDepth> shoals;
  int scale{};  // denominator of the scale
  Messages warnings;
};

/// The base cell and the updates beside it, .001, .002, ..., in order.
[[nodiscard]] std::vector<std::filesystem::path> parts_of_s57(const std::filesystem::path& base);

/// Reads a base cell with the updates beside it.
/// Errors   damaged; an update without its base; a gap among the updates; depths in another unit than metres; no
///          coverage or no depth areas
/// Source   IHO S-57 edition 3.1, appendix A (object and attribute catalogue) and appendix B.1 (ENC product
///          specification)
[[nodiscard]] Checked<ChartCell> read_s57_cell(const std::filesystem::path& base);

}  // namespace floeplan::ingest
