#include "storage/repository/features/zone_repository.hpp"

#include <cmath>
#include <stdexcept>

#include "engine/messages/store_messages.hpp"
#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/box_index.hpp"
#include "storage/repository/encoding/polygon_blob.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

const std::string select_of_dataset =
    "SELECT name, kind, from_s, until_s, top_m, bottom_m, rings FROM zone "
    "WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1)";

ocean::Zone read_zone(const sql::Row& row, BlobCodec& codec) {
  const auto kind = ocean::parse_zone_kind(row.text(1));
  if (!kind)
    throw std::runtime_error{messages::store_text<"stored-word-unknown">("a zone's rule", row.text(1))};
  ocean::Zone zone;
  zone.name = row.text(0);
  zone.kind = *kind;
  zone.from = row.optional_time(2);
  zone.until = row.optional_time(3);
  zone.top = {row.real(4)};
  if (const auto bottom_m = row.optional_real(5)) zone.bottom = {*bottom_m};
  zone.area = unpack_polygon(codec, row.blob(6));
  return zone;
}

std::optional<double> bottom_m(const ocean::Zone& zone) {
  return std::isfinite(zone.bottom.value) ? std::optional{zone.bottom.value} : std::nullopt;
}

/// `SELECT <what> FROM zone` with the filter's conditions and values. The area is only a coarse condition:
/// check each outline.
sql::Statement select_zones(sql::Connection& db, const std::string& what, const ZoneFilter& filter,
                            std::int64_t after, const std::string& order = " ORDER BY row") {
  std::string sql = "SELECT " + what + " FROM zone WHERE row > ?1";
  if (filter.from) sql += " AND (until_s IS NULL OR until_s >= ?2)";
  if (filter.to) sql += " AND (from_s IS NULL OR from_s <= ?3)";
  if (filter.dataset) sql += " AND dataset_row = (SELECT row FROM dataset WHERE id = ?4)";
  if (filter.kind) sql += " AND kind = ?5";
  if (filter.name) sql += " AND name = ?6";
  if (filter.area) sql += " AND " + box_condition(db, "zone_box", 7);

  sql::Statement query{db, sql + order};
  query.bind(1, after);
  if (filter.from) query.bind(2, *filter.from);
  if (filter.to) query.bind(3, *filter.to);
  if (filter.dataset) query.bind(4, filter.dataset->value);
  if (filter.kind) query.bind(5, *filter.kind);
  if (filter.name) query.bind(6, *filter.name);
  if (filter.area) bind_box(query, 7, *filter.area);
  return query;
}

// The first seven columns are those that read_zone expects.
const std::string stored_columns =
    "name, kind, from_s, until_s, top_m, bottom_m, rings, row, (SELECT id FROM dataset WHERE dataset.row = "
    "dataset_row)";

bool is_wanted(const ocean::Zone& zone, const ZoneFilter& filter) {
  return !filter.area || geo::intersects(*filter.area, geo::bounding_box(zone.area));
}

}  // namespace

std::int64_t ZoneRepository::add(const DatasetId& dataset, const ocean::Zone& zone) {
  sql::Transaction transaction{db_};
  insert(dataset, {zone});
  sql::Statement query{db_, "SELECT max(row) FROM zone"};
  const std::int64_t row = query.step() ? query.integer(0) : 0;
  transaction.commit();
  return row;
}

bool ZoneRepository::replace(std::int64_t row, const ocean::Zone& zone) {
  sql::Transaction transaction{db_};
  BlobCodec codec;
  sql::Statement update{db_,
                        "UPDATE zone SET name = ?2, kind = ?3, from_s = ?4, until_s = ?5, top_m = ?6, "
                        "bottom_m = ?7, rings = ?8 WHERE row = ?1"};
  update.bind_all(row, zone.name, ocean::zone_kind_name(zone.kind), zone.from, zone.until, zone.top.value,
                  bottom_m(zone), pack_polygon(codec, zone.area));
  const bool found = update.run() > 0;
  const geo::BoundingBox box = geo::bounding_box(zone.area);
  const UnrolledBox width = unrolled(box);
  sql::Statement index{
      db_, "UPDATE zone_box SET west_deg = ?2, east_deg = ?3, south_deg = ?4, north_deg = ?5 WHERE row = ?1"};
  index.bind_all(row, width.west_deg, width.east_deg, box.south_deg, box.north_deg);
  index.run();
  transaction.commit();
  return found;
}

bool ZoneRepository::remove(std::int64_t row) {
  sql::Statement remove{db_, "DELETE FROM zone WHERE row = ?1"};
  remove.bind(1, row);
  return remove.run() > 0;
}

std::optional<StoredZone> ZoneRepository::find(std::int64_t row) const {
  sql::Statement query{db_, "SELECT " + stored_columns + " FROM zone WHERE row = ?1"};
  query.bind(1, row);
  if (!query.step()) return std::nullopt;
  BlobCodec codec;
  return StoredZone{query.integer(7), {query.text(8)}, read_zone(query, codec)};
}

std::vector<StoredZone> ZoneRepository::list(const ZoneFilter& filter, std::int64_t after, int limit) const {
  sql::Statement query = select_zones(db_, stored_columns, filter, after);
  std::vector<StoredZone> zones;
  BlobCodec codec;
  while (std::ssize(zones) < limit && query.step()) {
    ocean::Zone zone = read_zone(query, codec);
    if (is_wanted(zone, filter)) zones.push_back({query.integer(7), {query.text(8)}, std::move(zone)});
  }
  return zones;
}

std::int64_t ZoneRepository::count(const ZoneFilter& filter) const {
  if (!filter.area) {
    sql::Statement query = select_zones(db_, "count(*)", filter, 0, "");
    return query.step() ? query.integer(0) : 0;
  }
  sql::Statement query = select_zones(db_, stored_columns, filter, 0);
  std::int64_t zones = 0;
  BlobCodec codec;
  while (query.step()) zones += is_wanted(read_zone(query, codec), filter) ? 1 : 0;
  return zones;
}

void ZoneRepository::insert(const DatasetId& dataset, const std::vector<ocean::Zone>& zones) {
  sql::Transaction transaction{db_};
  const std::int64_t dataset_number = dataset_row(db_, dataset);
  sql::Statement insert{db_,
                        "INSERT INTO zone (dataset_row, name, kind, from_s, until_s, top_m, bottom_m, rings) "
                        "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8) RETURNING row"};
  BoxInsert insert_box{db_, "zone_box"};
  BlobCodec codec;
  for (const ocean::Zone& zone : zones) {
    insert.bind_all(dataset_number, zone.name, ocean::zone_kind_name(zone.kind), zone.from, zone.until,
                    zone.top.value, bottom_m(zone), pack_polygon(codec, zone.area));
    insert_box.run(sql::inserted_number(insert), geo::bounding_box(zone.area));
  }
  transaction.commit();
}

std::vector<ocean::Zone> ZoneRepository::load(const DatasetId& dataset, const geo::BoundingBox& area,
                                              core::UtcTime from) const {
  constexpr int first_of_box = 4;
  sql::Statement query{db_, select_of_dataset + " AND (until_s IS NULL OR until_s >= ?2) AND (kind = ?3 OR " +
                                box_condition(db_, "zone_box", first_of_box) + ") ORDER BY row"};
  query.bind_all(dataset.value, from, ocean::zone_kind_name(ocean::ZoneKind::stay_in));
  bind_box(query, first_of_box, area);
  std::vector<ocean::Zone> zones;
  BlobCodec codec;
  while (query.step()) {
    ocean::Zone zone = read_zone(query, codec);
    const bool meets = geo::intersects(area, geo::bounding_box(zone.area));
    if (meets || zone.kind == ocean::ZoneKind::stay_in) zones.push_back(std::move(zone));
  }
  return zones;
}

std::vector<ocean::Zone> ZoneRepository::at(const DatasetId& dataset, geo::LonLat place) const {
  sql::Statement query{db_,
                       select_of_dataset + " AND " + box_condition(db_, "zone_box", 2) + " ORDER BY row"};
  query.bind(1, dataset.value);
  bind_box(query, 2, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg});
  std::vector<ocean::Zone> zones;
  BlobCodec codec;
  while (query.step()) {
    ocean::Zone zone = read_zone(query, codec);
    if (geo::contains(zone.area, place)) zones.push_back(std::move(zone));
  }
  return zones;
}

}  // namespace floeplan::repository
