#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::ocean {

/// A dataset that a plan was computed from, named so that anybody can find it again.
struct DatasetRef {
  std::string id;
  std::string kind;  // "currents", "wind", "bathymetry", "ice", "icebergs", "coastline"
  std::string name;
  std::string sha256;                   // of the file it came from, lower-case hexadecimal
  std::optional<core::UtcTime> run{};   // when the model run began that made it; empty: the file does not say
  std::optional<core::UtcTime> from{};  // first and last step that was used where several runs were joined;
  std::optional<core::UtcTime> until{};  // empty: it served alone

  friend bool operator==(const DatasetRef&, const DatasetRef&) = default;
};

}  // namespace floeplan::ocean
