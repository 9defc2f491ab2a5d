#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "storage/ingest/grids/velocity_source.hpp"

namespace floeplan::ingest {

/// Depths at which currents are stored whose levels follow the sea bed: the standard levels of the World Ocean Atlas
/// down to the first one below `deepest_m`.
/// Source  Locarnini et al. 2019, World Ocean Atlas 2018 volume 1, table 2 (102 levels from 0 to 5500 m)
[[nodiscard]] std::vector<double> standard_depths_m(double deepest_m);

/// Reads one level of a source, so that the caller can change what was read.
using LevelReader = std::function<Checked<VelocitySlice>(std::size_t level)>;

/// Currents of one time at some depths, each at all points of a source whose levels follow the bed: linear between the
/// levels, the uppermost level up to the surface, the lowest down to the bed, missing below it. Holds two levels and
/// the result at a time.
[[nodiscard]] Checked<std::vector<VelocitySlice>> currents_at_depths(const VelocitySource& source,
                                                                     const LevelReader& read,
                                                                     std::size_t time,
                                                                     std::span<const double> depths_m);

}  // namespace floeplan::ingest
