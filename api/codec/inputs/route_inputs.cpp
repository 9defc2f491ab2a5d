#include "api/codec/inputs/route_inputs.hpp"

#include "api/codec/route_files/route_choice.hpp"
#include "api/codec/route_files/route_formats.hpp"
#include "engine/geo/geodesic.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t most_named = 20;  // repeated positions listed in a warning
constexpr double same_place_m = 1.0;    // the planner accepts no shorter legs
constexpr double longest_leg_m = 5e6;   // the planner accepts no longer legs

/// Where a route is in its request, and how messages name its positions.
struct Origin {
  std::string pointer;
  bool is_json{true};  // true: JSON; false: a file, whose positions are counted

  [[nodiscard]] std::string rule_pointer(std::size_t place) const {
    return is_json ? pointer + "/" + std::to_string(place) : pointer;
  }
};

/// Drops repeated positions and adds violations for legs that are too long. Positions are counted from 0, as
/// given.
void settle(InputReader& reader, const Origin& origin, GivenRoute& route) {
  std::vector<geo::LonLat> kept;
  std::string repeated;
  std::size_t repeats = 0;
  for (std::size_t i = 0; i < route.places.size(); ++i) {
    const double leg_m =
        kept.empty() ? longest_leg_m : geo::geodesic_between(kept.back(), route.places[i]).length.value;
    if (leg_m < same_place_m) {
      if (++repeats <= most_named) repeated += (repeated.empty() ? "" : ", ") + std::to_string(i);
      continue;
    }
    if (leg_m > longest_leg_m) reader.refuse<"place-too-far">(origin.rule_pointer(i), i);
    kept.push_back(route.places[i]);
  }
  if (kept.size() < 2) {
    reader.refuse<"no-two-places">(origin.pointer);
  } else if (repeats > 0) {
    route.warnings.push_back((repeats == 1 ? "place " : "places ") + repeated +
                             (repeats > most_named ? " and more" : "") +
                             " of the route, counted from 0: within 1 m of the place before, taken once");
  }
  route.places = std::move(kept);
}

/// Reads a file in a request, {"name": ..., "text": ...}. Empty if it cannot be read; its faults are then
/// violations.
std::optional<RouteFile> read_file_member(InputReader& reader, const std::string& key,
                                          std::optional<geo::LonLat> from) {
  const json* file = reader.member(key);
  if (file == nullptr) return std::nullopt;
  const auto text_at = [&](const char* name) {
    return file->is_object() && file->contains(name) && (*file)[name].is_string();
  };
  if (!text_at("name") || !text_at("text") || file->size() != 2) {
    reader.refuse<"wrong-shape">("/" + key, "an object of a file's \"name\" and its \"text\"");
    return std::nullopt;
  }
  const auto wanted = reader.text("route_name");
  auto read = read_route_file((*file)["name"].get<std::string>(),
                              (*file)["text"].get_ref<const std::string&>(), wanted, from);
  if (read) return std::move(*read);
  for (const core::Violation& violation : read.error())
    reader.refuse<"route-file-refused">("/" + key, violation.field, violation.rule);
  return std::nullopt;
}

/// Makes the route begin at the start. Files of this program already contain the start; a vehicle's own list
/// does not.
void begin_at(geo::LonLat start, std::vector<geo::LonLat>& places) {
  const bool is_there =
      !places.empty() && geo::geodesic_between(start, places.front()).length.value < same_place_m;
  if (is_there) {
    places.front() = start;
  } else {
    places.insert(places.begin(), start);
  }
}

/// The route in an array of positions.
GivenRoute read_positions(InputReader& reader, const json& route) {
  auto places = reader.places(route, "/route", 2, max_places);
  if (!places) return {};
  GivenRoute given{std::move(*places), {}, {}};
  settle(reader, {"/route"}, given);
  return given;
}

/// The route in a GeoJSON object.
GivenRoute read_geojson_route(InputReader& reader, const json& route) {
  const auto wanted = reader.text("route_name");
  const std::size_t faults_before = reader.violations().size();
  FileRoutes all = geojson_routes(reader, route, "/route");
  if (reader.violations().size() != faults_before) return {};
  auto chosen = choose_route(std::move(all), wanted);
  if (!chosen) {
    for (core::Violation& violation : chosen.error()) violation.field = "/route";
    reader.refuse_all("", chosen.error());
    return {};
  }
  GivenRoute given{std::move(chosen->places), {}, std::move(chosen->warnings)};
  settle(reader, {"/route", false}, given);
  return given;
}

}  // namespace

GivenRoute read_file_route(InputReader& reader, const std::string& key) {
  const auto from = reader.place("from");
  auto file = read_file_member(reader, key, from);
  if (!file) return {};
  if (from) begin_at(*from, file->places);
  GivenRoute route{std::move(file->places), {}, std::move(file->warnings)};
  if (route.places.size() < 2) {
    std::string warnings;
    for (const std::string& warning : route.warnings) warnings += "; " + warning;
    reader.refuse<"no-route-of-places">("/" + key, warnings);
    return {};
  }
  settle(reader, {"/" + key, false}, route);
  return route;
}

GivenRoute read_route(InputReader& reader) {
  const json* route = reader.member("route");
  GivenRoute given;
  given.plan_id = reader.text("plan_id");
  const bool from_file = reader.member("route_file") != nullptr;
  if ((route != nullptr) + (reader.member("plan_id") != nullptr) + from_file != 1) {
    reader.refuse<"required-or-instead">("/route", "\"plan_id\" or \"route_file\"");
    return given;
  }
  if (from_file) return read_file_route(reader, "route_file");
  if (route != nullptr && route->is_object()) return read_geojson_route(reader, *route);
  if (reader.member("route_name") != nullptr)
    reader.refuse<"no-file-to-choose-in">("/route_name", "a file or of GeoJSON");
  return route == nullptr ? given : read_positions(reader, *route);
}

}  // namespace floeplan::codec
