#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/codec/documents/coverage.hpp"
#include "api/routes/request/parameters.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/fields/current_blocks.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// Part of a dataset in memory, to be asked at places, depths and times.
class EdrField {
 public:
  virtual ~EdrField() = default;
  /// One value for each parameter of the collection; depth and time are left alone by data that have none.
  virtual void sample(geo::LonLat place, core::Metres depth, core::UtcTime time,
                      std::span<std::optional<double>> values) const = 0;
  /// The nodes in memory.
  [[nodiscard]] virtual const ocean::HorizontalGrid& grid() const = 0;
  /// How many nodes of the dataset lie from one of them to the next: more than one where it is too fine to be read
  /// whole.
  [[nodiscard]] virtual std::size_t nodes_apart() const { return 1; }
};

/// A kind of data that can be asked for (OGC API - EDR).
struct EdrCollection {
  std::string id;
  std::string title;
  std::string description;
  repository::DatasetKind kind{};
  bool has_depths{false};  // data of the kind may be known at several depths
  std::vector<codec::CoverageParameter> parameters;
};

[[nodiscard]] const std::vector<EdrCollection>& edr_collections();

/// What a dataset of a collection covers.
struct EdrShape {
  repository::Dataset dataset;
  ocean::HorizontalGrid grid;
  std::vector<double> depths_m;      // empty: no depth axis
  std::vector<core::UtcTime> times;  // empty: no time
};

/// The datasets of the collection that meet the area and the period, by their bounds: the newest model run first, but
/// depths of the sea bed as plans take them, the finest first.
[[nodiscard]] std::vector<repository::Dataset> edr_datasets(sql::Connection& db,
                                                            const EdrCollection& collection,
                                                            const std::optional<geo::BoundingBox>& area,
                                                            const TimeSpan& span);
/// Whether both are runs of one model: on one grid, with the same depths.
[[nodiscard]] bool are_of_one_model(const EdrShape& a, const EdrShape& b);
/// nullopt: the dataset has no field.
[[nodiscard]] std::optional<EdrShape> edr_shape(sql::Connection& db, const repository::Dataset& dataset);

/// What of it lies around the area and the period, and around the depths that are asked for (none: at all depths);
/// null: nothing.
[[nodiscard]] std::unique_ptr<EdrField> load_edr_field(sql::Connection& db, const EdrShape& shape,
                                                       const geo::BoundingBox& area, core::UtcTime from,
                                                       core::UtcTime to, const std::vector<double>& depths_m);

/// The same about one place. `kept`: blocks of currents that were read before; null: none.
[[nodiscard]] std::unique_ptr<EdrField> load_edr_field_at(sql::Connection& db, const EdrShape& shape,
                                                          geo::LonLat place, core::UtcTime from,
                                                          core::UtcTime to,
                                                          const std::vector<double>& depths_m,
                                                          repository::CurrentBlocks* kept);

}  // namespace floeplan::routes
