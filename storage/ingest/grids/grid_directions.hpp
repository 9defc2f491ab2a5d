#pragma once

#include <vector>

#include "engine/ocean/grids/staggered_sampling.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/true_north.hpp"

namespace floeplan::ingest {

/// For each axis, whether its coordinates decrease with the index.
struct FallingAxes {
  bool first{false};
  bool second{false};
};

/// The axes of a grid at its centres, from the positions of neighbouring points. `stated` is the model's own
/// angle at the centres, radians; it is used where it agrees with the positions, because positions may be
/// rounded.
/// Errors   the stated angle contradicts the positions; the grid is mirrored, so that its second axis is not
///          a quarter turn anticlockwise from the first
[[nodiscard]] Checked<GridDirections> directions_of(const Staggering& staggering, const Positions& first,
                                                    const Positions& second, FallingAxes falling,
                                                    const std::vector<double>& stated);

/// The axis of each component's points: first all points of the first component, then those of the second,
/// whose axis is a quarter turn anticlockwise from the first axis. `stated` is the model's angle at all
/// centres; a point takes the mean of the two beside it, or its direction from the positions if there is no
/// stated angle.
/// Precondition  not collocated, and directions_of has accepted the grid
[[nodiscard]] ocean::ComponentAxes axes_of_components(const Staggering& staggering, const Positions& first,
                                                      const Positions& second, FallingAxes falling,
                                                      const std::vector<double>& stated);
/// The same for components that point east and north.
[[nodiscard]] ocean::ComponentAxes axes_east_and_north(const Positions& first, const Positions& second);

}  // namespace floeplan::ingest
