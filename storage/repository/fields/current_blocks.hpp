#pragma once

#include <cstdint>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/recently_used.hpp"

namespace floeplan::repository {

/// Which samples of a dataset of currents. A row number is never given twice, and what is stored under it never
/// changes.
struct CurrentBlock {
  std::int64_t dataset_row{};
  std::vector<NodeRun> x;
  std::vector<NodeRun> y;
  NodeRun depths;
  NodeRun times;

  friend bool operator==(const CurrentBlock&, const CurrentBlock&) = default;
};

/// Blocks of currents as they were read from the store.
using CurrentBlocks = RecentlyUsed<CurrentBlock, ocean::CurrentGrid>;

}  // namespace floeplan::repository
