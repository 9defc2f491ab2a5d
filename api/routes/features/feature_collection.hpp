#pragma once

#include <map>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/problems/problem.hpp"
#include "api/routes/request/context.hpp"
#include "api/routes/request/parameters.hpp"
#include "engine/core/violation.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/stored_things.hpp"

namespace floeplan::routes {

/// What a client wants of a collection.
struct FeatureQuery {
  std::optional<geo::BoundingBox> area;
  TimeSpan span;
  std::map<std::string, std::string> filters;  // attributes and their values, by the collection's own names
  std::int64_t after{};                        // key of the last feature of the page before
  int limit{};
  core::UtcTime now;
};

/// Features in CRS84, without links.
struct FeaturePage {
  std::vector<nlohmann::json> features;
  std::optional<std::int64_t> matched;             // empty: nobody has counted
  std::optional<std::int64_t> next;                // key to go on after; empty: this is the last page
  std::vector<repository::StoredThing> damaged{};  // cannot be read, and would be between the others
};

/// Where and when the features of a collection are; rather too large than too small.
struct FeatureExtent {
  geo::BoundingBox area{-180.0, -90.0, 180.0, 90.0};
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

/// What can be done to features that were made over the service (OGC API - Features, Part 4).
struct FeatureEditing {
  /// The new feature's id. Errors: every violation, with its JSON pointer inside the feature.
  tl::expected<std::string, core::Violations> (*create)(const Context&, const nlohmann::json& feature,
                                                        core::UtcTime now);
  tl::expected<void, core::Violations> (*replace)(const Context&, const std::string& id,
                                                  const nlohmann::json& feature, core::UtcTime now);
  void (*remove)(const Context&, const std::string& id, core::UtcTime now);
  /// Why the feature cannot be changed; empty: it can.
  std::string (*objection)(const Context&, const std::string& id);
};

/// A collection of features, whatever they are made from. `list` says what is wrong with a filter; one that fits
/// nothing gives an empty page.
struct FeatureCollection {
  std::string id;
  std::string title;
  std::string description;
  std::string schema;     // component of the OpenAPI document that describes a feature
  std::string item_name;  // of the id in the OpenAPI document's path
  std::vector<std::string> filters;
  FeatureExtent (*extent)(sql::Connection&);
  tl::expected<FeaturePage, problems::Problem> (*list)(const Context&, const FeatureQuery&);
  std::optional<nlohmann::json> (*find)(const Context&, const std::string& id);
  std::optional<FeatureEditing> editing{};
};

/// Every collection, in the order of the list.
[[nodiscard]] const std::vector<FeatureCollection>& feature_collections();

[[nodiscard]] FeatureCollection iceberg_collection();
[[nodiscard]] FeatureCollection iceberg_track_collection();
[[nodiscard]] FeatureCollection glider_track_collection();
[[nodiscard]] FeatureCollection isobath_collection();
[[nodiscard]] FeatureCollection zone_collection();
[[nodiscard]] FeatureCollection plan_collection();
[[nodiscard]] FeatureCollection plan_leg_collection();
[[nodiscard]] FeatureCollection waypoint_collection();

/// The text as a key of the store; empty: it is none.
[[nodiscard]] std::optional<std::int64_t> key_of(const std::string& text);

}  // namespace floeplan::routes
