#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// What becomes of the gaps between the parts of a route: those of a track are flown, with a warning; nobody knows what
/// is meant by those between drawn lines.
enum class Gaps { refused, flown };

/// One route of a file, in several parts where the file interrupts it.
struct NamedRoute {
  std::string name;  // as the file has it; empty where it has none
  std::vector<std::vector<geo::LonLat>> parts;
  Gaps gaps{Gaps::refused};
  std::string aside{};  // why it counts only where it is named, "hidden"; empty: it counts
};

/// All that a file holds, in its order.
struct FileRoutes {
  std::vector<NamedRoute> routes;
  std::vector<std::string> warnings;
};

/// The places of a route that came as a file.
struct RouteFile {
  std::vector<geo::LonLat> places;    // in the order in which they are flown
  std::vector<std::string> warnings;  // with line and file, for the pilot
};

/// The most places that a route of a file may have; a plan uses far fewer.
inline constexpr std::size_t max_places = 10'000;

/// The route that is meant: the only one, or the one that `wanted` names or counts from 1. Its parts are joined where
/// they touch; where a line is cut at the antimeridian the place there goes unless the line bends in it.
/// Frame    longitudes are brought into [-180, 180), however the file counts them
/// Errors   none or several that could be meant, with their names; no such name; gaps; more than `max_places`
[[nodiscard]] tl::expected<RouteFile, core::Violations> choose_route(
    FileRoutes file, const std::optional<std::string>& wanted);

}  // namespace floeplan::codec
