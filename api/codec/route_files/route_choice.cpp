#include "api/codec/route_files/route_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/shown_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::codec {
namespace {

constexpr std::size_t most_named = 8;      // routes listed in a message
constexpr std::size_t longest_name = 60;   // bytes of a name in a message
constexpr double rounding = 1e-9;          // tolerance of a share of a line
constexpr double same_place_deg = 1.5e-7;  // places are printed to 1e-7 degrees, 1 cm
constexpr double beside_antimeridian_deg =
    // a cut at 179.99999, 1 m from the antimeridian at the equator, is common
    1.5e-5;
constexpr core::Metres cut_at_antimeridian{2.5};  // largest distance between the two ends of a cut

template <messages::Code code, class... Given>
tl::unexpected<core::Violations> refused(const Given&... values) {
  return tl::unexpected(core::Violations{messages::fault<code>("file", values...)});
}

std::string title(const std::vector<NamedRoute>& routes, std::size_t index) {
  const std::string& name = routes[index].name;
  return std::to_string(index + 1) +
         (name.empty() ? " without a name" : " \"" + core::cut_short(name, longest_name) + "\"");
}

std::string titles(const std::vector<NamedRoute>& routes) {
  std::string list;
  const std::size_t shown = std::min(routes.size(), most_named);
  for (std::size_t i = 0; i < shown; ++i) list += (i == 0 ? "" : ", ") + title(routes, i);
  return list + (routes.size() > shown ? ", ..." : "");
}

/// The index of the route with this name, or, if there is none, with this number.
tl::expected<std::size_t, core::Violations> named(const std::vector<NamedRoute>& routes,
                                                  const std::string& wanted) {
  const auto count = std::ranges::count(routes, wanted, &NamedRoute::name);
  if (count > 1)
    return refused<"routes-of-one-name">(count, core::cut_short(wanted, longest_name), titles(routes));
  std::optional<std::size_t> by_name;
  std::optional<std::size_t> by_number;
  for (std::size_t i = 0; i < routes.size(); ++i) {
    if (routes[i].name == wanted) by_name = i;
    if (std::to_string(i + 1) == wanted) by_number = i;
  }
  if (by_name && by_number && by_name != by_number)
    return refused<"route-name-and-number">(wanted, title(routes, *by_name), title(routes, *by_number));
  if (by_name) return *by_name;
  if (by_number) return *by_number;
  return refused<"no-such-route">(core::cut_short(wanted, longest_name), titles(routes));
}

/// The index of the file's only route, apart from those set aside. With several, the caller must name one.
tl::expected<std::size_t, core::Violations> only_one(const std::vector<NamedRoute>& routes) {
  const auto counts = [](const NamedRoute& route) { return route.aside.empty(); };
  const auto count = std::ranges::count_if(routes, counts);
  if (count == 1) return static_cast<std::size_t>(std::ranges::find_if(routes, counts) - routes.begin());
  if (count == 0) return refused<"no-route-shown">(titles(routes), routes.front().aside);
  return refused<"several-routes">(count, titles(routes));
}

/// Whether a position is on the antimeridian; programs that cut a line there may leave a small distance.
bool is_on_antimeridian(geo::LonLat place) {
  return std::abs(std::abs(place.lon_deg) - 180.0) <= beside_antimeridian_deg;
}

bool touch(geo::LonLat a, geo::LonLat b) {
  if (is_on_antimeridian(a) && is_on_antimeridian(b) &&
      geo::geodesic_between(a, b).length <= cut_at_antimeridian)
    return true;
  return std::abs(a.lat_deg - b.lat_deg) <= same_place_deg &&
         std::abs(geo::longitude_difference(a.lon_deg, b.lon_deg)) <= same_place_deg;
}

/// Whether `place` lies on the line from `from` to `to` that is straight in longitude and latitude.
bool lies_between(geo::LonLat from, geo::LonLat place, geo::LonLat to) {
  const double before_deg = geo::longitude_difference(from.lon_deg, place.lon_deg);
  const double whole_deg = geo::longitude_difference(from.lon_deg, to.lon_deg);
  const double share = whole_deg == 0.0 ? 0.0 : before_deg / whole_deg;
  return share >= -rounding && share <= 1.0 + rounding &&
         std::abs(std::lerp(from.lat_deg, to.lat_deg, share) - place.lat_deg) <= same_place_deg;
}

std::string distance_between(geo::LonLat a, geo::LonLat b) {
  return core::distance_text(geo::geodesic_between(a, b).length);
}

/// Joins all parts of a route; a gap is a violation or a warning, by `Gaps`.
RouteFile joined(const NamedRoute& route, core::Violations& faults) {
  RouteFile line;
  const std::string subject =
      route.name.empty() ? "the route" : "\"" + core::cut_short(route.name, longest_name) + "\"";
  std::size_t number = 0;
  for (const auto& part : route.parts) {
    ++number;
    auto rest = part.begin();
    if (!line.places.empty() && touch(line.places.back(), part.front())) {
      const geo::LonLat end = line.places.back();
      ++rest;
      const bool has_both_sides = line.places.size() > 1 && rest != part.end();
      if (has_both_sides && is_on_antimeridian(end) && lies_between(*(line.places.end() - 2), end, *rest))
        line.places.pop_back();
    } else if (!line.places.empty()) {
      const std::string between = "between parts " + std::to_string(number - 1) + " and " +
                                  std::to_string(number) + " of " + subject + " lies a gap of " +
                                  distance_between(line.places.back(), part.front());
      if (route.gaps == Gaps::refused) {
        core::note(faults, messages::fault<"route-with-a-gap">("file", between));
      } else {
        line.warnings.push_back(between + "; the straight line across it is taken as part of the route");
      }
    }
    line.places.insert(line.places.end(), rest, part.end());
  }
  return line;
}

}  // namespace

tl::expected<RouteFile, core::Violations> choose_route(FileRoutes file,
                                                       const std::optional<std::string>& wanted) {
  const auto chosen = wanted ? named(file.routes, *wanted) : only_one(file.routes);
  if (!chosen) return tl::unexpected(chosen.error());

  core::Violations faults;
  RouteFile route = joined(file.routes[*chosen], faults);
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (route.places.size() > max_places) return refused<"too-many-places-in-route">(max_places);
  for (geo::LonLat& place : route.places) place.lon_deg = geo::wrap_longitude(place.lon_deg);
  route.warnings.insert(route.warnings.begin(), file.warnings.begin(), file.warnings.end());
  if (!wanted)
    for (std::size_t i = 0; i < std::min(file.routes.size(), most_named); ++i)
      if (!file.routes[i].aside.empty())
        route.warnings.push_back("of the file's routes " + title(file.routes, i) + " is left out (" +
                                 file.routes[i].aside + ")");
  return route;
}

}  // namespace floeplan::codec
