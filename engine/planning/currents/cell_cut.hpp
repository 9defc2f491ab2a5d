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

/// The number of parts into which each cell side of a window of currents is cut, and the flown depths at all
/// nodes of the finer lattice.
struct CellCut {
  int parts{1};
  std::vector<vehicle::DiveBand> bands;  // [y][x]
};

/// Cuts cells so that a bank inside a cell of the currents changes the mean over the flown depths. The cells
/// are cut as finely as the bathymetry has them, up to four parts a side. They are cut up to sixteen if fewer
/// parts would err by more than `most_missed_at_banks` between the nodes.
/// Accuracy  Tested in the first and the middle time slice only: a bank that matters only at other times may
///           be missed
/// `turns`   rotation from east-north to the plane, one for each node of the window, [y][x]
/// `slices`  number of time slices that are stored: the more slices, the fewer parts fit into memory
/// Stops     with fewer parts once `stop` is requested; the result must then not be used
[[nodiscard]] CellCut cut_cells(const ocean::CurrentGrid& currents, const FlownDepths& depths,
                                const plane::NodeWindow& window, const std::vector<NodeTurn>& turns,
                                std::size_t slices, const std::stop_token& stop = {});

/// 0.005 m/s: over a narrow bank a glider of 0.35 m/s is then timed to about 2 %. Where the current nearly
/// equals its speed the error is larger, but the glider hardly passes there. A judgement.
inline constexpr core::MetresPerSecond most_missed_at_banks{0.005};

/// The nodes of an axis, with each step cut into equal parts.
[[nodiscard]] std::vector<double> cut_axis(const std::vector<double>& nodes, int parts);
/// The position of node `i` of the cut axis on the original axis, which has `nodes` nodes.
[[nodiscard]] plane::CellPosition on_uncut(std::size_t i, int parts, std::size_t nodes);

}  // namespace floeplan::planning::currents
