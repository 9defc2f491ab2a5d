#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "storage/repository/fields/recently_used.hpp"

namespace floeplan::repository {

/// Cache of grids of currents read from the store. Callers that try several departures, speeds or routes need
/// the same tens of millions of samples each time.
/// Memory   as in RecentlyUsed, counted in bytes of samples
/// Threads  all members may be called from several threads at once
class CurrentGridCache {
 public:
  /// Steps of one dataset. Row numbers are never reused and the data of a row never change, so a cached grid
  /// stays valid.
  struct Part {
    std::int64_t dataset_row{};
    std::optional<double> first_s;  // seconds since 1970; empty: all steps
    std::optional<double> last_s;

    friend bool operator==(const Part&, const Part&) = default;
  };
  /// Everything that determines a grid.
  struct Key {
    std::vector<Part> parts;
    geo::BoundingBox area;
    std::optional<double> from_s;
    std::optional<double> deepest_m;

    friend bool operator==(const Key&, const Key&) = default;
  };

  explicit CurrentGridCache(std::size_t most_bytes) : grids_{most_bytes} {}

  /// The cached grid; null if there is none.
  [[nodiscard]] std::shared_ptr<const ocean::CurrentGrid> find(const Key& key) { return grids_.find(key); }
  void keep(const Key& key, const std::shared_ptr<const ocean::CurrentGrid>& grid);

 private:
  RecentlyUsed<Key, ocean::CurrentGrid> grids_;
};

}  // namespace floeplan::repository
