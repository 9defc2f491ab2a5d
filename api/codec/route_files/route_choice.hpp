#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// Treatment of gaps between the parts of a route. Gaps in a track are flown, with a warning. Gaps between
/// drawn lines are refused, because their meaning is unknown.
enum class Gaps { refused, flown };

/// A route of a file, in several parts if the file interrupts it.
struct NamedRoute {
  std::string name;  // empty: without a name
  std::vector<std::vector<geo::LonLat>> parts;
  Gaps gaps{Gaps::refused};
  std::string aside{};  // why it is only used if it is named, as "hidden"; empty: it is used
};

/// All routes of a file, in their order.
struct FileRoutes {
  std::vector<NamedRoute> routes;
  std::vector<std::string> warnings;
};

/// The positions of a route from a file.
struct RouteFile {
  std::vector<geo::LonLat> places;    // in the order in which they are flown
  std::vector<std::string> warnings;  // with line and file, for the pilot
};

/// Largest number of positions of a route in a file; a plan has far fewer.
inline constexpr std::size_t max_places = 10'000;

/// Chooses a route: the only one, or the one that `wanted` names or gives the number of, from 1. Its parts
/// are joined where they touch. A position where a line was cut at the antimeridian is removed unless the
/// line bends there.
/// Frame    longitudes are converted to [-180, 180)
/// Errors   no route, or several to choose from (listed); no route with this name; gaps; more than
///          `max_places` positions
[[nodiscard]] tl::expected<RouteFile, core::Violations> choose_route(
    FileRoutes file, const std::optional<std::string>& wanted);

}  // namespace floeplan::codec
