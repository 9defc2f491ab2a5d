#pragma once

#include <optional>
#include <vector>

#include "api/codec/probe_document.hpp"
#include "api/routes/probe_service.hpp"
#include "storage/repository/dataset.hpp"

namespace floeplan::routes {

/// The tide at a place and a time, from all models on a grid that cover the place (of two that have a line the newer
/// counts) or, where none does, from the nearest station within `probe_station_range`; from one dataset if it is named.
[[nodiscard]] codec::Probe::Tide probe_tide(sqlite::Connection& db,
                                            const std::vector<repository::Dataset>& datasets,
                                            const std::optional<repository::Dataset>& named,
                                            const ProbeQuery& query);

}  // namespace floeplan::routes
