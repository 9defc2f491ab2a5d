#pragma once

#include "api/routes/edr/edr_area.hpp"
#include "api/routes/edr/edr_request.hpp"
#include "api/routes/request/context.hpp"

namespace floeplan::routes {

/// The answer with the data at all nodes inside a shape; if there are none, with the data at the middle of
/// the shape. An answer that would be too large is refused, with its size.
[[nodiscard]] Response grid_reply(const EdrCollection& collection, const Context& context,
                                  const Request& request, EdrRequest& query, const Wanted& wanted,
                                  const EdrArea& area);

}  // namespace floeplan::routes
