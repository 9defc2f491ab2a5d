#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/codec/coverage.hpp"
#include "api/routes/parameters.hpp"
#include "engine/geo/bounding_box.hpp"
#include "storage/repository/current_blocks.hpp"
#include "storage/repository/dataset.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::routes {

/// Part of a dataset in memory, to be asked at places, depths and times.
class EdrField {
 public:
  virtual ~EdrField() = default;
  /// One value for each parameter of the collection; depth and time are left alone by data that have none.
  virtual void sample(geo::LonLat place, core::Metres depth, core::UtcTime time,
                      std::span<std::optional<double>> values) const = 0;
};

/// A kind of data that can be asked for (OGC API - EDR).
struct EdrCollection {
  std::string id;
  std::string title;
  std::string description;
  repository::DatasetKind kind{};
  std::vector<codec::CoverageParameter> parameters;
};

[[nodiscard]] const std::vector<EdrCollection>& edr_collections();

/// What a dataset of a collection covers.
struct EdrShape {
  repository::Dataset dataset;
  core::Metres spacing;              // of its nodes
  std::vector<double> depths_m;      // empty: no depth axis
  std::vector<core::UtcTime> times;  // empty: no time
};

/// The newest dataset of the collection that meets the area and the period; empty: there is none.
[[nodiscard]] std::optional<EdrShape> find_edr_data(sqlite::Connection& db, const EdrCollection& collection,
                                                    const std::optional<geo::BoundingBox>& area,
                                                    const TimeSpan& span);

/// What of it lies around the area and the period, and around the depths that are asked for (none: at all depths);
/// null: nothing.
[[nodiscard]] std::unique_ptr<EdrField> load_edr_field(sqlite::Connection& db, const EdrShape& shape,
                                                       const geo::BoundingBox& area, core::UtcTime from,
                                                       core::UtcTime to, const std::vector<double>& depths_m);

/// The same about one place. `kept`: blocks of currents that were read before; null: none.
[[nodiscard]] std::unique_ptr<EdrField> load_edr_field_at(sqlite::Connection& db, const EdrShape& shape,
                                                          geo::LonLat place, core::UtcTime from,
                                                          core::UtcTime to,
                                                          const std::vector<double>& depths_m,
                                                          repository::CurrentBlocks* kept);

}  // namespace floeplan::routes
