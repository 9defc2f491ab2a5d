#pragma once

#include <vector>

namespace floeplan::ingest {

/// Rows of depths or elevations as a file has them.
/// Shape    values_m is [y][x], y ascending; NaN where missing. lowest_m and highest_m are alike, or empty where no
///          cell reaches beyond its value: the range of all that is known of a node's cell
struct RawRows {
  std::vector<float> values_m;
  std::vector<float> lowest_m{};
  std::vector<float> highest_m{};
};

}  // namespace floeplan::ingest
