#include "storage/repository/fields/current_grid_cache.hpp"

namespace floeplan::repository {

void CurrentGridCache::keep(const Key& key, const std::shared_ptr<const ocean::CurrentGrid>& grid) {
  const auto& samples = grid->samples();
  grids_.keep(key, grid, (samples.u.size() + samples.v.size()) * sizeof(float));
}

}  // namespace floeplan::repository
