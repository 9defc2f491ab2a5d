#include <algorithm>
#include <cmath>

#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/dataset_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr const char* crs84 = "http://www.opengis.net/def/crs/OGC/1.3/CRS84";

/// Rounded away from the data, so that a client that prints fewer digits still asks for all of them.
double outwards(double degrees, bool up) {
  const double scaled = degrees * 1e6;
  return (up ? std::ceil(scaled) : std::floor(scaled)) / 1e6;
}

json spatial(double west_deg, double south_deg, double east_deg, double north_deg) {
  return {{"bbox", json::array({json::array({west_deg, south_deg, east_deg, north_deg})})}, {"crs", crs84}};
}

/// Box and period of all sightings; the whole world and an open period when there are none.
json iceberg_extent(sqlite::Connection& db) {
  double west = 180.0, south = 90.0, east = -180.0, north = -90.0;
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
  for (const auto& dataset : repository::DatasetRepository{db}.list()) {
    if (dataset.kind != repository::DatasetKind::icebergs) continue;
    const auto& box = dataset.bounds;
    const bool crosses = box.west_deg > box.east_deg;
    west = std::min(west, crosses ? -180.0 : box.west_deg);
    east = std::max(east, crosses ? 180.0 : box.east_deg);
    south = std::min(south, box.south_deg);
    north = std::max(north, box.north_deg);
    if (dataset.time_start && (!from || *dataset.time_start < *from)) from = dataset.time_start;
    if (dataset.time_end && (!to || *dataset.time_end > *to)) to = dataset.time_end;
  }
  const auto end_json = [](std::optional<core::UtcTime> time) {
    return time ? json(core::iso8601(*time)) : json();
  };
  if (west > east) return {{"spatial", spatial(-180.0, -90.0, 180.0, 90.0)}};
  return {{"spatial", spatial(outwards(west, false), outwards(south, false), outwards(east, true),
                              outwards(north, true))},
          {"temporal", {{"interval", json::array({json::array({end_json(from), end_json(to)})})}}}};
}

json collection(const std::string& id, const std::string& title, const std::string& description, json extent,
                const std::string& public_url) {
  const std::string self = public_url + "/collections/" + id;
  return {{"id", id},
          {"title", title},
          {"description", description},
          {"itemType", "feature"},
          {"crs", json::array({crs84})},
          {"extent", std::move(extent)},
          {"links",
           {link("self", "application/json", self),
            link("items", "application/geo+json", self + "/items", title)}}};
}

json all_collections(const Context& context) {
  const std::string& url = context.service.public_url;
  const json world{{"spatial", spatial(-180.0, -90.0, 180.0, 90.0)}};
  return {collection("icebergs", "Icebergs",
                     "Sightings of icebergs, each with its size as stated and as planned with.",
                     iceberg_extent(context.db), url),
          collection("plans", "Plans", "Planned routes with the times, speeds and depths of their waypoints.",
                     world, url)};
}

Response list_collections(const Context& context, const Request&, const PathParameters&) {
  return json_reply({{"links", json::array({link("self", "application/json",
                                                 context.service.public_url + "/collections")})},
                     {"collections", all_collections(context)}});
}

Response show_collection(const Context& context, const Request& request, const PathParameters& path) {
  for (const auto& entry : all_collections(context)) {
    if (entry.at("id") == path.at("collection_id")) return json_reply(entry);
  }
  return not_found(request, "unknown-collection",
                   "No collection has the id " + path.at("collection_id") + ".");
}

}  // namespace

std::vector<Route> collection_routes() {
  return {{"GET", "/collections", {}, list_collections},
          {"GET", "/collections/{collection_id}", {}, show_collection}};
}

}  // namespace floeplan::routes
