#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/current_grid.hpp"

namespace floeplan::repository {

/// Grids of currents as they were read from the store, for others who want just the same: whoever tries a departure, a
/// speed or a way after another reads the same tens of millions of samples each time.
/// Memory   at most so many bytes of samples, the grids that were used last; a larger grid is not kept. Whoever uses a
///          grid keeps it alive beyond that
/// Threads  all members may be called from several threads at once
class CurrentGridCache {
 public:
  /// Steps of one dataset. A row number is never given twice, and what is stored under it never changes.
  struct Part {
    std::int64_t dataset_row{};
    std::optional<double> first_s;  // seconds since 1970; empty: all steps
    std::optional<double> last_s;

    friend bool operator==(const Part&, const Part&) = default;
  };
  /// All that a grid follows from.
  struct Key {
    std::vector<Part> parts;
    geo::BoundingBox area;
    std::optional<double> from_s;
    std::optional<double> deepest_m;

    friend bool operator==(const Key&, const Key&) = default;
  };

  explicit CurrentGridCache(std::size_t most_bytes) : most_bytes_{most_bytes} {}

  /// Null where it is not kept.
  [[nodiscard]] std::shared_ptr<const ocean::CurrentGrid> find(const Key& key);
  void keep(const Key& key, const std::shared_ptr<const ocean::CurrentGrid>& grid);

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const ocean::CurrentGrid> grid;
    std::size_t bytes{};
  };

  std::size_t most_bytes_;
  std::mutex mutex_;
  std::list<Entry> entries_;  // the one used last first
  std::size_t bytes_{};
};

}  // namespace floeplan::repository
