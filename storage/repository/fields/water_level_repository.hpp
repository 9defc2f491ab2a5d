#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The water level at a place and a time.
struct WaterLevel {
  core::Metres height;   // of the sea surface above the datum; below it if negative
  core::UtcTime before;  // steps of the data before and after the time
  core::UtcTime after;
};

/// Water levels at a fixed place.
/// Shape  as many times as heights; times ascend
struct WaterLevelStation {
  std::string name;  // empty: not named in the source
  geo::LonLat place;
  std::vector<double> times_s;   // seconds since 1970-01-01T00:00:00Z
  std::vector<float> heights_m;  // above the datum, upwards; NaN where missing
};

/// Measured or predicted heights of the sea surface above a datum over time: on a grid, on a mesh or at stations.
/// Threads  as the connection: one thread at a time
class WaterLevelRepository {
 public:
  /// The longest time between two steps that is interpolated, linearly. The chord of an hour misses a semidiurnal tide of
  /// amplitude A by at most A (w h)^2 / 8 = 0.03 A.
  static constexpr core::Seconds longest_gap{3600.0};

  explicit WaterLevelRepository(sql::Connection& db) : db_{db} {}

  /// `datum`  in words: "lowest astronomical tide"
  void create(const DatasetId& id, const std::string& datum, const FieldShape& shape);
  void create(const DatasetId& id, const std::string& datum, const FieldShape& shape,
              const NativePoints& native);
  /// Writes the heights of one time, [y][x] or [point], NaN where missing.
  void write(const DatasetId& id, std::size_t time_index, std::span<const float> heights_m);
  void insert(const DatasetId& id, const std::string& datum, const std::vector<WaterLevelStation>& stations);

  /// The words of the datum; empty if the dataset is unknown.
  [[nodiscard]] std::string datum(const DatasetId& id) const;
  /// On the grid or mesh of a dataset. nullopt outside its area and period, where a value is missing, and between steps
  /// further apart than `longest_gap`.
  [[nodiscard]] std::optional<WaterLevel> at(const DatasetId& id, geo::LonLat place,
                                             core::UtcTime time) const;
  /// The stations of a dataset, in the order of insertion.
  [[nodiscard]] std::vector<WaterLevelStation> stations(const DatasetId& id) const;

 private:
  void note_datum(const DatasetId& id, const std::string& datum);

  sql::Connection& db_;  // borrowed
};

/// The level of a station; nullopt as `WaterLevelRepository::at`.
[[nodiscard]] std::optional<WaterLevel> level_at(const WaterLevelStation& station, core::UtcTime time);

}  // namespace floeplan::repository
