#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Coarser copies of a large field of one time and depth: every fourth node, every sixteenth, and so on, so
/// that a display of a large area need not read the whole field. For pictures only: values between these
/// nodes are missing.
/// Threads  as the connection: one thread at a time
class FieldOverviews {
 public:
  /// Fields with at most this number of nodes have no overviews. No picture or answer shows more; it is 16 MB
  /// as 4-byte floats, unpacked in some hundredths of a second.
  static constexpr std::size_t plenty = 4'000'000;

  explicit FieldOverviews(sql::Connection& db) : db_{db} {}

  /// Makes the overviews of a variable that is stored completely; none for a small field.
  /// Memory   256 rows of the field
  void make(const DatasetId& id, const std::string& variable);

  /// Depths around the area, from the field or an overview: the finest with at most `most_nodes` nodes there. Depths
  /// at a model's own points have no overviews. They are interpolated as in load_bathymetry.
  /// Outside  nullopt when the dataset is unknown or has no node there
  [[nodiscard]] std::optional<ocean::Bathymetry> bathymetry(const DatasetId& id, const geo::BoundingBox& area,
                                                            std::size_t most_nodes) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
