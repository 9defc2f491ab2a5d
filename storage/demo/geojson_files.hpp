#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/ocean/ice/iceberg.hpp"

namespace floeplan::demo {

/// The statements of a file about its origin; the source may be empty.
struct Origin {
  std::string name;
  std::string description;
  std::string source;
  std::string license{"CC0-1.0"};
};

/// Writes icebergs as GeoJSON points: id, observed (UTC), size, length_m, draft_m, position_uncertainty_m, method.
/// Errors   std::runtime_error when the file cannot be written
void write_icebergs(const std::filesystem::path& file, const std::vector<ocean::Iceberg>& icebergs,
                    const Origin& origin);

/// Writes the land within an area as GeoJSON polygons, joined where pieces meet and cut at the area's edges.
/// Coordinates have five decimals.
/// Errors   std::runtime_error when the file cannot be written
void write_coastline(const std::filesystem::path& file, const std::vector<geo::Polygon>& land,
                     const geo::BoundingBox& area, const Origin& origin);

}  // namespace floeplan::demo
