#pragma once

#include <vector>

namespace floeplan::ingest {

/// Rows of depths or elevations, in metres, with the sign of the file.
/// Shape    values_m is [y][x], y ascending; NaN where missing. lowest_m and highest_m have the same shape
///          and are the range of all values known in a node's cell; they are empty if each cell has only its
///          one value
struct RawRows {
  std::vector<float> values_m;
  std::vector<float> lowest_m{};
  std::vector<float> highest_m{};
};

}  // namespace floeplan::ingest
