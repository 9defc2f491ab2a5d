#include "storage/repository/zone_repository.hpp"

#include <cmath>
#include <stdexcept>

#include "storage/repository/box_index.hpp"
#include "storage/repository/dataset_row.hpp"
#include "storage/repository/polygon_blob.hpp"
#include "storage/sqlite/statement.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::repository {
namespace {

const std::string select_of_dataset =
    "SELECT name, kind, from_s, until_s, top_m, bottom_m, rings FROM zone "
    "WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1)";

ocean::Zone read_zone(const sqlite::Statement& row, BlobCodec& codec) {
  const auto kind = ocean::parse_zone_kind(row.text(1));
  if (!kind) throw std::runtime_error{"a stored zone has a rule that is not known"};
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

}  // namespace

void ZoneRepository::insert(const DatasetId& dataset, const std::vector<ocean::Zone>& zones) {
  sqlite::Transaction transaction{db_};
  const std::int64_t dataset_number = dataset_row(db_, dataset);
  sqlite::Statement insert{
      db_,
      "INSERT INTO zone (dataset_row, name, kind, from_s, until_s, top_m, bottom_m, rings) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)"};
  sqlite::Statement insert_box{db_, "INSERT INTO zone_box VALUES (last_insert_rowid(), ?1, ?2, ?3, ?4)"};
  BlobCodec codec;
  for (const ocean::Zone& zone : zones) {
    insert.bind_all(dataset_number, zone.name, ocean::zone_kind_name(zone.kind), zone.from, zone.until,
                    zone.top.value, bottom_m(zone), pack_polygon(codec, zone.area));
    insert.run();

    const geo::BoundingBox box = geo::bounding_box(zone.area);
    const UnrolledBox width = unrolled(box);
    insert_box.bind_all(width.west_deg, width.east_deg, box.south_deg, box.north_deg);
    insert_box.run();
  }
  transaction.commit();
}

std::vector<ocean::Zone> ZoneRepository::load(const DatasetId& dataset, const geo::BoundingBox& area,
                                              core::UtcTime from) const {
  constexpr int first_of_box = 4;
  sqlite::Statement query{db_, select_of_dataset +
                                   " AND (until_s IS NULL OR until_s >= ?2) AND (kind = ?3 OR " +
                                   box_condition("zone_box", first_of_box) + ") ORDER BY row"};
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
  sqlite::Statement query{db_, select_of_dataset + " AND " + box_condition("zone_box", 2) + " ORDER BY row"};
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
