#pragma once

#include <functional>

#include "api/codec/coverage.hpp"
#include "api/routes/context.hpp"
#include "api/routes/edr_request.hpp"

namespace floeplan::routes {

/// CoverageJSON, by the older of its two media types when the client asks for that.
[[nodiscard]] Response coverage_reply(const Request& request, const nlohmann::json& coverage);
[[nodiscard]] Response no_data(const Request& request);
/// The refusal of an answer of so many values; empty: it is not too large.
[[nodiscard]] std::optional<Response> refuse_if_too_large(const Request& request, double values);
/// How many values the coverage has at each place.
[[nodiscard]] double layers_of(const codec::CoverageGrid& coverage);

/// A coverage of the wanted parameters without nodes.
[[nodiscard]] codec::CoverageGrid empty_coverage(const EdrCollection& collection, const Wanted& wanted);

/// Asks the field at every node of the coverage that is inside; the others stay empty.
void fill(codec::CoverageGrid& coverage, const EdrField* field, const EdrCollection& collection,
          const Wanted& wanted, const std::function<bool(geo::LonLat)>& is_inside);

/// A grid over a box, empty where `is_inside` is false. One that would be too large is refused with its size.
[[nodiscard]] Response grid_reply(const EdrCollection& collection, const Context& context,
                                  const Request& request, EdrRequest& query, const Wanted& wanted,
                                  const geo::BoundingBox& box,
                                  const std::function<bool(geo::LonLat)>& is_inside);

}  // namespace floeplan::routes
