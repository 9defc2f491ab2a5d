#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/codec/reading/input_reader.hpp"
#include "api/codec/route_files/route_file.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// A route to evaluate, from a request.
struct GivenRoute {
  std::vector<geo::LonLat> places;     // at least two, consecutive ones different; empty with `plan_id`
  std::optional<std::string> plan_id;  // the route is the waypoints of this plan
  std::vector<std::string> warnings;   // lines of its file, repeated positions
};

/// Reads the file in the member `key`, {"name": ..., "text": ...}; of several routes in it the one named in
/// `route_name`. If `from` is given, the route starts there; a file that begins there is unchanged. Empty if
/// the file cannot be read.
/// Edges    as for `read_route`
/// Errors   are added to the reader: faults of the file, fewer than two different positions, legs of more
///          than 5000 km
[[nodiscard]] GivenRoute read_file_route(InputReader& reader, const std::string& key);

/// Reads the route from `route` (GeoJSON or an array of positions), `route_file` (starting at `from` if
/// given) or `plan_id`.
/// Edges    a position within a metre of the one before is dropped, with a warning
/// Errors   are added to the reader: none or several of the three, fewer than two different positions, legs
///          of more than 5000 km
[[nodiscard]] GivenRoute read_route(InputReader& reader);

}  // namespace floeplan::codec
