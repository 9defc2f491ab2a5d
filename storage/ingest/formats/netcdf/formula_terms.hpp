#pragma once

#include <sstream>
#include <string>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The variable that a vertical coordinate names for a term of its formula: "h" for "depth: h". Empty if it
/// names none or `coordinate` is null.
/// Source  CF conventions 1.8, section 4.3.3
[[nodiscard]] inline std::string formula_term(const NetcdfVariable* coordinate, const std::string& wanted) {
  if (coordinate == nullptr) return {};
  std::istringstream words{coordinate->attribute("formula_terms")};
  for (std::string key, value; words >> key >> value;)
    if (key == wanted + ":") return value;
  return {};
}

/// Whether a depth of the sea bed counts from the instantaneous sea surface. The elevation of the surface is
/// then part of it already.
[[nodiscard]] inline bool is_depth_of_the_moment(const NetcdfVariable& bed) {
  return bed.attribute("standard_name") == "sea_floor_depth_below_sea_surface";
}

}  // namespace floeplan::ingest
