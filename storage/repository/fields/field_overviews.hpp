#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Every fourth node of a large field of one time and depth, every sixteenth, and so on: whoever looks at much of it
/// from afar need not read all of it. For pictures; what is between these nodes is not in them.
/// Threads  as the connection: one thread at a time
class FieldOverviews {
 public:
  /// More than any picture or answer shows, and 16 MB as 4-byte floats, unpacked in some hundredths of a second: fields
  /// with no more nodes have no overviews.
  static constexpr std::size_t plenty = 4'000'000;

  explicit FieldOverviews(sql::Connection& db) : db_{db} {}

  /// Makes those of a variable that is stored whole; of a small field there are none.
  /// Memory   256 rows of the field
  void make(const DatasetId& id, const std::string& variable);

  /// Depths around the area, from the finest of the field and its overviews that has no more than `most_nodes` there. Of
  /// depths at a model's own points there are no overviews; they are interpolated as load_bathymetry does it.
  /// Outside  nullopt when the dataset is unknown or has no node there
  [[nodiscard]] std::optional<ocean::Bathymetry> bathymetry(const DatasetId& id, const geo::BoundingBox& area,
                                                            std::size_t most_nodes) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
