#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/routes/features/feature_collection.hpp"

namespace floeplan::routes {

/// The operations of OGC API - Features, Part 4, on a collection that has `editing`. Each is one transaction.
/// With If-Match, a feature is changed only if it has this entity tag; otherwise the answer is 412.
[[nodiscard]] Response create_feature(const FeatureCollection& collection, const Context& context,
                                      const Request& request);
[[nodiscard]] Response replace_feature(const FeatureCollection& collection, const Context& context,
                                       const Request& request, const std::string& id);
/// Applies a merge patch (RFC 7396) to the feature: each member of the patch replaces that of the feature.
[[nodiscard]] Response update_feature(const FeatureCollection& collection, const Context& context,
                                      const Request& request, const std::string& id);
[[nodiscard]] Response remove_feature(const FeatureCollection& collection, const Context& context,
                                      const Request& request, const std::string& id);

/// Entity tag of a feature from its collection, in CRS84 and without links.
[[nodiscard]] std::string feature_tag(const nlohmann::json& feature);

[[nodiscard]] Response no_such_feature(const Request& request, const FeatureCollection& collection,
                                       const std::string& id);

}  // namespace floeplan::routes
