#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"
#include "engine/planning/currents/depth_averages.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/plane/fast_axis.hpp"
#include "engine/planning/plane/node_window.hpp"

namespace floeplan::planning::currents {

/// The parts that each cell of a window of currents is cut into along either side, and the depths flown at the nodes of
/// all parts.
struct CellCut {
  int parts{1};
  std::vector<vehicle::DiveBand> bands;  // [y][x]
};

/// Cuts cells so that a bank of the bathymetry inside one of them is felt: as the bathymetry has it up to four parts a
/// side, and up to sixteen where the mean over the flown depths would be more than `most_missed_at_banks` beside the
/// truth between the nodes of fewer.
/// Accuracy  looked at in the first and the middle slice alone, so that a bank may be missed that is felt at other hours
/// `turns`   one for each node of the window, [y][x]
/// `slices`  of time for which the means are kept: many leave room for fewer parts
/// Stops     with fewer parts once `stop` is requested; the means must then not be used
[[nodiscard]] CellCut cut_cells(const ocean::CurrentGrid& currents, const FlownDepths& depths,
                                const plane::NodeWindow& window, const std::vector<NodeTurn>& turns,
                                std::size_t slices, const std::stop_token& stop = {});

/// Five thousandths of a metre a second: over the ground of a narrow bank a glider of 0.35 m/s is then timed to some
/// two hundredths, and where the current there is that near to its speed, it is hardly passed at all. A judgement.
inline constexpr core::MetresPerSecond most_missed_at_banks{0.005};

/// Each step of an axis cut into equal parts.
[[nodiscard]] std::vector<double> cut_axis(const std::vector<double>& nodes, int parts);
/// Where node `i` of a cut axis lies on the axis of `nodes` nodes itself.
[[nodiscard]] plane::CellPosition on_uncut(std::size_t i, int parts, std::size_t nodes);

}  // namespace floeplan::planning::currents
