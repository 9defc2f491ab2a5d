#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/routes/features/feature_collection.hpp"

namespace floeplan::routes {

/// The operations of OGC API - Features, Part 4, on a collection that has `editing`. Each is one transaction. A change
/// with If-Match is made only to the feature that has this entity tag, else it is answered 412.
[[nodiscard]] Response create_feature(const FeatureCollection& collection, const Context& context,
                                      const Request& request);
[[nodiscard]] Response replace_feature(const FeatureCollection& collection, const Context& context,
                                       const Request& request, const std::string& id);
/// Members of a merge patch (RFC 7396) take the place of the feature's.
[[nodiscard]] Response update_feature(const FeatureCollection& collection, const Context& context,
                                      const Request& request, const std::string& id);
[[nodiscard]] Response remove_feature(const FeatureCollection& collection, const Context& context,
                                      const Request& request, const std::string& id);

/// Entity tag of a feature as its collection gives it, in CRS84 and without links.
[[nodiscard]] std::string feature_tag(const nlohmann::json& feature);

[[nodiscard]] Response no_such_feature(const Request& request, const FeatureCollection& collection,
                                       const std::string& id);

}  // namespace floeplan::routes
