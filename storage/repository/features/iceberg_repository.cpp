#include "storage/repository/features/iceberg_repository.hpp"

#include <cmath>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/box_index.hpp"
#include "storage/repository/features/iceberg_fixes.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

const std::string sighting_columns =
    "row, lon_deg, lat_deg, (SELECT id FROM dataset WHERE dataset.row = dataset_row), berg_id, observed_s, "
    "size, "
    "length_m, draft_m, position_uncertainty_m, shape, method ";

std::optional<core::Metres> metres(std::optional<double> value) {
  return value ? std::optional{core::Metres{*value}} : std::nullopt;
}

std::optional<double> in_metres(std::optional<core::Metres> length) {
  return length ? std::optional{length->value} : std::nullopt;
}

/// A position with its longitude in [-180, 180].
geo::LonLat read_place(const sql::Row& row, int first_column = 1) {
  const double lon_deg = row.real(first_column);
  return {std::abs(lon_deg) > 180.0 ? geo::wrap_longitude(lon_deg) : lon_deg, row.real(first_column + 1)};
}

StoredSighting read_sighting(const sql::Row& row) {
  return {.row = row.integer(0),
          .dataset = {row.text(3)},
          .iceberg = {.id = row.text(4),
                      .place = read_place(row),
                      .observed = row.time(5),
                      .size = ocean::parse_size(row.text(6)).value_or(ocean::IcebergSize::unknown),
                      .length = metres(row.optional_real(7)),
                      .draft = metres(row.optional_real(8)),
                      .position_uncertainty = metres(row.optional_real(9)),
                      .shape = row.text(10),
                      .method = row.text(11)}};
}

/// `SELECT <what> FROM sighting` with the filter's conditions and values. The area is only a coarse
/// condition: check each position.
sql::Statement select_sightings(sql::Connection& db, const std::string& what, const SightingFilter& filter,
                                std::int64_t after, const std::string& order = " ORDER BY row") {
  std::string sql = "SELECT " + what + " FROM sighting WHERE row > ?1";
  if (filter.from) sql += " AND observed_s >= ?2";
  if (filter.to) sql += " AND observed_s <= ?3";
  if (filter.dataset) sql += " AND dataset_row = (SELECT row FROM dataset WHERE id = ?4)";
  if (filter.berg_id) sql += " AND berg_id = ?5";
  if (filter.area) sql += " AND " + box_condition(db, "sighting_box", 6);

  sql::Statement query{db, sql + order};
  query.bind(1, after);
  if (filter.from) query.bind(2, *filter.from);
  if (filter.to) query.bind(3, *filter.to);
  if (filter.dataset) query.bind(4, filter.dataset->value);
  if (filter.berg_id) query.bind(5, *filter.berg_id);
  if (filter.area) bind_box(query, 6, *filter.area);
  return query;
}

}  // namespace

void IcebergRepository::insert(const DatasetId& dataset, const std::vector<ocean::Iceberg>& sightings) {
  sql::Transaction transaction{db_};
  const std::int64_t dataset_number = dataset_row(db_, dataset);
  sql::Statement insert{
      db_,
      "INSERT INTO sighting (dataset_row, berg_id, lon_deg, lat_deg, observed_s, size, length_m, "
      "draft_m, position_uncertainty_m, shape, method) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, "
      "?9, ?10, ?11)"};
  for (const ocean::Iceberg& berg : sightings) {
    insert.bind_all(dataset_number, berg.id, berg.place.lon_deg, berg.place.lat_deg, berg.observed,
                    ocean::size_name(berg.size), in_metres(berg.length), in_metres(berg.draft),
                    in_metres(berg.position_uncertainty), berg.shape, berg.method);
    insert.run();
  }
  transaction.commit();
}

std::int64_t IcebergRepository::add(const DatasetId& dataset, const ocean::Iceberg& sighting) {
  sql::Transaction transaction{db_};
  insert(dataset, {sighting});
  sql::Statement query{db_, "SELECT max(row) FROM sighting"};
  const std::int64_t row = query.step() ? query.integer(0) : 0;
  transaction.commit();
  return row;
}

bool IcebergRepository::replace(std::int64_t row, const ocean::Iceberg& berg) {
  sql::Transaction transaction{db_};
  sql::Statement update{
      db_,
      "UPDATE sighting SET berg_id = ?2, lon_deg = ?3, lat_deg = ?4, observed_s = ?5, size = ?6, length_m = "
      "?7, draft_m = ?8, position_uncertainty_m = ?9, shape = ?10, method = ?11 WHERE row = ?1"};
  update.bind_all(row, berg.id, berg.place.lon_deg, berg.place.lat_deg, berg.observed,
                  ocean::size_name(berg.size), in_metres(berg.length), in_metres(berg.draft),
                  in_metres(berg.position_uncertainty), berg.shape, berg.method);
  const bool found = update.run() > 0;
  sql::Statement index{
      db_,
      "UPDATE sighting_box SET (west_deg, east_deg, south_deg, north_deg) = (SELECT wrapped_lon_deg, "
      "wrapped_lon_deg, lat_deg, lat_deg FROM sighting WHERE row = ?1) WHERE row = ?1"};
  index.bind(1, row);
  index.run();
  transaction.commit();
  return found;
}

bool IcebergRepository::remove(std::int64_t row) {
  sql::Statement remove{db_, "DELETE FROM sighting WHERE row = ?1"};
  remove.bind(1, row);
  return remove.run() > 0;
}

std::optional<StoredSighting> IcebergRepository::find(std::int64_t row) const {
  sql::Statement query{db_, "SELECT " + sighting_columns + "FROM sighting WHERE row = ?1"};
  query.bind(1, row);
  if (!query.step()) return std::nullopt;
  return read_sighting(query);
}

std::vector<StoredSighting> IcebergRepository::list(const SightingFilter& filter, std::int64_t after,
                                                    int limit) const {
  sql::Statement query = select_sightings(db_, sighting_columns, filter, after);
  std::vector<StoredSighting> sightings;
  while (std::ssize(sightings) < limit && query.step()) {
    if (filter.area && !geo::contains(*filter.area, read_place(query))) continue;
    sightings.push_back(read_sighting(query));
  }
  return sightings;
}

std::int64_t IcebergRepository::count(const SightingFilter& filter) const {
  if (!filter.area) {
    sql::Statement query = select_sightings(db_, "count(*)", filter, 0, "");
    return query.step() ? query.integer(0) : 0;
  }
  sql::Statement query = select_sightings(db_, "row, lon_deg, lat_deg", filter, 0);
  std::int64_t sightings = 0;
  while (query.step()) {
    if (geo::contains(*filter.area, read_place(query))) ++sightings;
  }
  return sightings;
}

std::vector<ocean::IcebergFix> IcebergRepository::earlier(const StoredSighting& sighting,
                                                          core::Seconds max_age) const {
  if (sighting.iceberg.id.empty()) return {};
  const core::UtcTime observed = sighting.iceberg.observed;
  return iceberg_fixes(db_, sighting.dataset, sighting.iceberg.id, observed - max_age, observed);
}

std::vector<StoredSighting> IcebergRepository::latest(const DatasetId& dataset, const geo::BoundingBox& area,
                                                      core::UtcTime as_of, core::Seconds max_age) const {
  // The area is checked last, so that a berg that has left it is not found at its earlier position. A
  // sighting without a name is a berg of its own.
  sql::Statement query{
      db_, "SELECT " + sighting_columns +
               "FROM sighting AS own WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1) "
               "AND observed_s BETWEEN ?3 AND ?2 AND (berg_id = '' OR row = (SELECT row FROM "
               "sighting AS same WHERE same.dataset_row = own.dataset_row AND same.berg_id = "
               "own.berg_id AND same.observed_s <= ?2 ORDER BY same.observed_s DESC, same.row DESC "
               "LIMIT 1)) ORDER BY row"};
  query.bind_all(dataset.value, as_of, as_of - max_age);
  std::vector<StoredSighting> sightings;
  while (query.step()) {
    if (geo::contains(area, read_place(query))) sightings.push_back(read_sighting(query));
  }
  return sightings;
}

}  // namespace floeplan::repository
