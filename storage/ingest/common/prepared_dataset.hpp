#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::ingest {

/// Where the values of a dataset lie. A file that an older program kept otherwise makes a new dataset with another id.
enum class Keeping { on_a_grid, at_own_points, at_points_of_components };

/// One kind of data in a file, read and checked to its end, and the way to write it once its dataset is in
/// the list.
struct PreparedDataset {
  repository::DatasetKind kind{};
  std::vector<std::string> variables;  // as the file names them
  geo::BoundingBox bounds;
  std::optional<core::UtcTime> time_start;
  std::optional<core::UtcTime> time_end;
  std::optional<core::UtcTime> run{};  // when the model run began; empty: the file does not say
  Keeping keeping{Keeping::on_a_grid};
  std::int64_t rows_accepted{};
  std::int64_t rows_refused{};
  Messages warnings;
  /// Runs inside the file's transaction. Refuses when the file can no longer be read.
  std::function<Checked<void>(sql::Connection&, const repository::DatasetId&)> write;
};

}  // namespace floeplan::ingest
