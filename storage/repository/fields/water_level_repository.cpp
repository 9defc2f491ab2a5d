#include "storage/repository/fields/water_level_repository.hpp"

#include <cmath>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

constexpr const char* height_variable = "height_m";

/// Linear between the steps around the time; nullopt where one of them that counts is missing.
std::optional<WaterLevel> level_between(const ocean::Axis& times_s, std::span<const float> heights_m,
                                        core::UtcTime time) {
  const auto when = times_s.locate(core::unix_seconds(time));
  if (!when) return std::nullopt;
  const double before_s = times_s[when->lower];
  const double after_s = times_s[when->upper];
  const double before_m = static_cast<double>(heights_m[when->lower]);
  double height_m = before_m;
  if (when->fraction > 0.0) {
    if (core::Seconds{after_s - before_s} > WaterLevelRepository::longest_gap) return std::nullopt;
    height_m += when->fraction * (static_cast<double>(heights_m[when->upper]) - before_m);
  }
  if (std::isnan(height_m)) return std::nullopt;
  return WaterLevel{core::Metres{height_m}, core::from_unix_seconds(before_s),
                    core::from_unix_seconds(after_s)};
}

}  // namespace

std::optional<WaterLevel> level_at(const WaterLevelStation& station, core::UtcTime time) {
  return level_between(ocean::Axis{station.times_s}, station.heights_m, time);
}

void WaterLevelRepository::create(const DatasetId& id, const std::string& datum, const FieldShape& shape) {
  note_datum(id, datum);
  FieldRepository{db_}.create(id, shape);
}

void WaterLevelRepository::create(const DatasetId& id, const std::string& datum, const FieldShape& shape,
                                  const NativePoints& native) {
  note_datum(id, datum);
  FieldRepository{db_}.create(id, shape, native);
}

void WaterLevelRepository::write(const DatasetId& id, std::size_t time_index,
                                 std::span<const float> heights_m) {
  FieldRepository{db_}.write_slice(id, height_variable, time_index, 0, heights_m);
}

void WaterLevelRepository::insert(const DatasetId& id, const std::string& datum,
                                  const std::vector<WaterLevelStation>& stations) {
  sql::Transaction transaction{db_};
  note_datum(id, datum);
  const std::int64_t dataset = dataset_row(db_, id);
  BlobCodec codec;
  const auto packed = [&](const auto& values) {
    const auto blob = codec.pack(std::span{values});
    return std::vector<std::byte>{blob.begin(), blob.end()};
  };
  sql::Statement insert_station{
      db_,
      "INSERT INTO water_level_station (dataset_row, position, name, lon_deg, lat_deg, level_count, times_s, "
      "heights_m) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)"};
  std::int64_t position = 0;
  for (const WaterLevelStation& station : stations) {
    insert_station.bind_all(dataset, position++, station.name, station.place.lon_deg, station.place.lat_deg,
                            std::ssize(station.times_s), packed(station.times_s), packed(station.heights_m));
    insert_station.run();
  }
  transaction.commit();
}

std::string WaterLevelRepository::datum(const DatasetId& id) const {
  sql::Statement query{
      db_, "SELECT datum FROM water_level WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1)"};
  query.bind(1, id.value);
  return query.step() ? query.text(0) : std::string{};
}

std::optional<WaterLevel> WaterLevelRepository::at(const DatasetId& id, geo::LonLat place,
                                                   core::UtcTime time) const {
  const auto series = FieldRepository{db_}.load_series(id, height_variable, place, {time, time});
  if (!series) return std::nullopt;
  return level_between(series->times_s, series->values, time);
}

std::vector<WaterLevelStation> WaterLevelRepository::stations(const DatasetId& id) const {
  sql::Statement query{
      db_,
      "SELECT name, lon_deg, lat_deg, level_count, times_s, heights_m FROM water_level_station WHERE "
      "dataset_row = (SELECT row FROM dataset WHERE id = ?1) ORDER BY position"};
  query.bind(1, id.value);
  BlobCodec codec;
  std::vector<WaterLevelStation> stations;
  while (query.step()) {
    const auto count = static_cast<std::size_t>(query.integer(3));
    const auto heights_m = codec.unpack_floats(query.blob(5), count);
    stations.push_back({query.text(0),
                        {query.real(1), query.real(2)},
                        codec.unpack_doubles(query.blob(4), count),
                        {heights_m.begin(), heights_m.end()}});
  }
  return stations;
}

void WaterLevelRepository::note_datum(const DatasetId& id, const std::string& datum) {
  sql::Statement insert{db_, "INSERT INTO water_level (dataset_row, datum) VALUES (?1, ?2)"};
  insert.bind_all(dataset_row(db_, id), datum);
  insert.run();
}

}  // namespace floeplan::repository
