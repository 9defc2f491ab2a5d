#pragma once

#include <vector>

#include "engine/ocean/grids/staggered_sampling.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/true_north.hpp"

namespace floeplan::ingest {

/// Whether the coordinates along an axis, where it has any, fall while its index grows.
struct FallingAxes {
  bool first{false};
  bool second{false};
};

/// From the positions: the way from one point to the next. `stated` is the model's own angle at the centres, radians;
/// it is used where it agrees with the positions, because they may be rounded.
/// Errors   an angle that contradicts the positions; a grid that is mirrored, so that the second axis does not lie a
///          quarter turn counterclockwise from the first
[[nodiscard]] Checked<GridDirections> directions_of(const Staggering& staggering, const Positions& first,
                                                    const Positions& second, FallingAxes falling,
                                                    const std::vector<double>& stated);

/// The axis of each point's component: those of the first, then those of the second, whose axis lies a quarter turn
/// counterclockwise from the first. `stated` is the model's angle at all its centres, of which the two beside a point
/// count; from the positions where there is none.
/// Precondition  a staggering that is not collocated, and that directions_of does not refuse
[[nodiscard]] ocean::ComponentAxes axes_of_components(const Staggering& staggering, const Positions& first,
                                                      const Positions& second, FallingAxes falling,
                                                      const std::vector<double>& stated);
/// The same of components that point east and north.
[[nodiscard]] ocean::ComponentAxes axes_east_and_north(const Positions& first, const Positions& second);

}  // namespace floeplan::ingest
