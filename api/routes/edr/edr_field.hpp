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

/// Part of a dataset in memory, which can be sampled at places, depths and times.
class EdrField {
 public:
  virtual ~EdrField() = default;
  /// Samples all parameters of the collection. Data without depths or times ignore `depth` or `time`.
  virtual void sample(geo::LonLat place, core::Metres depth, core::UtcTime time,
                      std::span<std::optional<double>> values) const = 0;
  /// The nodes in memory.
  [[nodiscard]] virtual const ocean::HorizontalGrid& grid() const = 0;
  /// Distance of neighbouring nodes in memory, counted in nodes of the dataset; more than 1 if the dataset is
  /// too fine to be read completely.
  [[nodiscard]] virtual std::size_t nodes_apart() const { return 1; }
};

/// A kind of data that OGC API - EDR queries can request.
struct EdrCollection {
  std::string id;
  std::string title;
  std::string description;
  repository::DatasetKind kind{};
  bool has_depths{false};  // data of this kind may have several depths
  std::vector<codec::CoverageParameter> parameters;
};

[[nodiscard]] const std::vector<EdrCollection>& edr_collections();

/// The grid, depths and times of a dataset of a collection.
struct EdrShape {
  repository::Dataset dataset;
  ocean::HorizontalGrid grid;
  std::vector<double> depths_m;      // empty: no depth axis
  std::vector<core::UtcTime> times;  // empty: no time
};

/// The datasets of the collection whose bounds intersect the area and the period: newest model run first;
/// bathymetry as in plans, the finest first.
[[nodiscard]] std::vector<repository::Dataset> edr_datasets(sql::Connection& db,
                                                            const EdrCollection& collection,
                                                            const std::optional<geo::BoundingBox>& area,
                                                            const TimeSpan& span);
/// Whether both are runs of one model: the same grid and depths.
[[nodiscard]] bool are_of_one_model(const EdrShape& a, const EdrShape& b);
/// The shape of a dataset; nullopt if it has no field.
[[nodiscard]] std::optional<EdrShape> edr_shape(sql::Connection& db, const repository::Dataset& dataset);

/// Reads the part of a dataset around the area, the period and the requested depths (none: all depths). Null
/// if there are no data.
[[nodiscard]] std::unique_ptr<EdrField> load_edr_field(sql::Connection& db, const EdrShape& shape,
                                                       const geo::BoundingBox& area, core::UtcTime from,
                                                       core::UtcTime to, const std::vector<double>& depths_m);

/// Reads the part of a dataset around one place, for the period and the requested depths (none: all depths).
/// Null if there are no data. `kept`: cache of blocks of currents; null: no cache.
[[nodiscard]] std::unique_ptr<EdrField> load_edr_field_at(sql::Connection& db, const EdrShape& shape,
                                                          geo::LonLat place, core::UtcTime from,
                                                          core::UtcTime to,
                                                          const std::vector<double>& depths_m,
                                                          repository::CurrentBlocks* kept);

}  // namespace floeplan::routes
