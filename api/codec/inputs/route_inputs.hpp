#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/codec/reading/input_reader.hpp"
#include "api/codec/route_files/route_file.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// A route to evaluate, as a request gives it.
struct GivenRoute {
  std::vector<geo::LonLat> places;     // two or more, no two in a row the same; empty with `plan_id`
  std::optional<std::string> plan_id;  // of the plan whose waypoints are the route
  std::vector<std::string> warnings;   // lines of its file, places that were given twice
};

/// Reads the file in the member `key`, {"name": ..., "text": ...}, of several routes the one in `route_name`, from `from`, where that is given: a file that begins
/// there is taken as it is. Empty where it cannot be read.
/// Edges    as for `read_route`
/// Errors   noted: what is wrong with the file, fewer than two different places, legs of more than 5000 km
[[nodiscard]] GivenRoute read_file_route(InputReader& reader, const std::string& key);

/// Reads `route` (GeoJSON or a bare array of positions), `route_file` (from `from`, where that is given) or `plan_id`.
/// Edges    a place within a metre of the one before it is taken once, and a warning names it
/// Errors   noted: none or several of the three, fewer than two different places, legs of more than 5000 km
[[nodiscard]] GivenRoute read_route(InputReader& reader);

}  // namespace floeplan::codec
