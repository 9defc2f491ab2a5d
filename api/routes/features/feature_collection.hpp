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

/// A query of a collection.
struct FeatureQuery {
  std::optional<geo::BoundingBox> area;
  TimeSpan span;
  std::map<std::string, std::string> filters;  // names of attributes and their values
  std::int64_t after{};                        // key of the last feature of the page before; 0: first page
  int limit{};
  core::UtcTime now;
};

/// A page of features in CRS84, without links.
struct FeaturePage {
  std::vector<nlohmann::json> features;
  std::optional<std::int64_t> matched;  // empty: not counted
  // value of `after` for the next page; empty: this is the last page
  std::optional<std::int64_t> next;
  std::vector<repository::StoredThing> damaged{};  // features of this page that cannot be read
};

/// Area and period of a collection's features; may be too large, not too small.
struct FeatureExtent {
  geo::BoundingBox area{-180.0, -90.0, 180.0, 90.0};
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

/// Operations on features that users enter over the service (OGC API - Features, Part 4).
struct FeatureEditing {
  /// Returns the new feature's id. Errors: all violations, with their JSON pointers inside the feature.
  tl::expected<std::string, core::Violations> (*create)(const Context&, const nlohmann::json& feature,
                                                        core::UtcTime now);
  tl::expected<void, core::Violations> (*replace)(const Context&, const std::string& id,
                                                  const nlohmann::json& feature, core::UtcTime now);
  void (*remove)(const Context&, const std::string& id, core::UtcTime now);
  /// Why the feature cannot be changed; empty if it can.
  std::string (*objection)(const Context&, const std::string& id);
};

/// A collection of features. `list` returns the fault of an invalid filter; a valid filter that matches
/// nothing gives an empty page.
struct FeatureCollection {
  std::string id;
  std::string title;
  std::string description;
  std::string schema;     // component of the OpenAPI document that describes a feature
  std::string item_name;  // name of the id parameter in the OpenAPI document's path
  std::vector<std::string> filters;
  FeatureExtent (*extent)(sql::Connection&);
  tl::expected<FeaturePage, problems::Problem> (*list)(const Context&, const FeatureQuery&);
  std::optional<nlohmann::json> (*find)(const Context&, const std::string& id);
  std::optional<FeatureEditing> editing{};
};

/// All collections, in the order in which they are listed.
[[nodiscard]] const std::vector<FeatureCollection>& feature_collections();

[[nodiscard]] FeatureCollection iceberg_collection();
[[nodiscard]] FeatureCollection iceberg_track_collection();
[[nodiscard]] FeatureCollection glider_track_collection();
[[nodiscard]] FeatureCollection isobath_collection();
[[nodiscard]] FeatureCollection zone_collection();
[[nodiscard]] FeatureCollection plan_collection();
[[nodiscard]] FeatureCollection plan_leg_collection();
[[nodiscard]] FeatureCollection waypoint_collection();

/// The text as a key of the store; empty if it is not a valid key.
[[nodiscard]] std::optional<std::int64_t> key_of(const std::string& text);

}  // namespace floeplan::routes
