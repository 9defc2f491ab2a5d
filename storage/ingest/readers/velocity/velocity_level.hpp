#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "storage/ingest/grids/velocity_source.hpp"

namespace floeplan::ingest {

/// One level of a source, as if it were all there is.
/// `depth_m`  where it lies; nullopt: without a depth
[[nodiscard]] std::shared_ptr<const VelocitySource> one_level(std::shared_ptr<const VelocitySource> source,
                                                              std::size_t level,
                                                              std::optional<double> depth_m);

}  // namespace floeplan::ingest
