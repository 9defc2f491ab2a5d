#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::ocean {

/// A dataset that a plan was computed from, with what is needed to find it again.
struct DatasetRef {
  std::string id;
  std::string kind;  // "currents", "wind", "bathymetry", "ice", "icebergs", "coastline"
  std::string name;
  std::string sha256;                    // of its file, lower-case hexadecimal
  std::optional<core::UtcTime> run{};    // begin of the model run; empty: not in the file
  std::optional<core::UtcTime> from{};   // if several runs were joined: first and last step that was used;
  std::optional<core::UtcTime> until{};  // empty: used alone

  friend bool operator==(const DatasetRef&, const DatasetRef&) = default;
};

}  // namespace floeplan::ocean
