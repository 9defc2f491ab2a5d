#pragma once

#include <cstdint>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/recently_used.hpp"

namespace floeplan::repository {

/// Identifies samples of a currents dataset. Row numbers are never reused and the data of a row never change,
/// so a cached block stays valid.
struct CurrentBlock {
  std::int64_t dataset_row{};
  std::vector<NodeRun> x;
  std::vector<NodeRun> y;
  NodeRun depths;
  NodeRun times;

  friend bool operator==(const CurrentBlock&, const CurrentBlock&) = default;
};

/// Cache of blocks of currents read from the store.
using CurrentBlocks = RecentlyUsed<CurrentBlock, ocean::CurrentGrid>;

}  // namespace floeplan::repository
