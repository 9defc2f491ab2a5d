#pragma once

#include <string>

namespace floeplan::ocean {

/// A dataset that a plan was computed from, named so that anybody can find it again.
struct DatasetRef {
  std::string id;
  std::string kind;  // "currents", "wind", "bathymetry", "ice", "icebergs", "coastline"
  std::string name;
  std::string sha256;  // of the file it came from, lower-case hexadecimal

  friend bool operator==(const DatasetRef&, const DatasetRef&) = default;
};

}  // namespace floeplan::ocean
