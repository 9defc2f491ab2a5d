#include "storage/repository/coastline_repository.hpp"

#include <stdexcept>

#include "storage/repository/blob_codec.hpp"
#include "storage/repository/box_index.hpp"
#include "storage/repository/dataset_row.hpp"
#include "storage/sqlite/statement.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::repository {
namespace {

/// The polygon as one array: how many rings (the outer first), the places of each, all longitudes, all
/// latitudes.
std::vector<double> flattened(const geo::Polygon& polygon) {
  std::vector<const geo::Ring*> rings{&polygon.outer};
  for (const geo::Ring& hole : polygon.holes) rings.push_back(&hole);

  std::vector<double> numbers{static_cast<double>(rings.size())};
  for (const geo::Ring* ring : rings) numbers.push_back(static_cast<double>(ring->size()));
  for (const geo::Ring* ring : rings) {
    for (const geo::LonLat place : *ring) numbers.push_back(place.lon_deg);
  }
  for (const geo::Ring* ring : rings) {
    for (const geo::LonLat place : *ring) numbers.push_back(place.lat_deg);
  }
  return numbers;
}

geo::Polygon from_flattened(const std::vector<double>& numbers) {
  const auto rings = static_cast<std::size_t>(numbers.at(0));
  std::size_t places = 0;
  for (std::size_t ring = 0; ring < rings; ++ring) places += static_cast<std::size_t>(numbers.at(1 + ring));
  if (rings < 1 || numbers.size() != 1 + rings + 2 * places)
    throw std::runtime_error{"a stored polygon is damaged"};

  geo::Polygon polygon;
  polygon.holes.resize(rings - 1);
  std::size_t next = 1 + rings;
  for (std::size_t i = 0; i < rings; ++i) {
    geo::Ring& ring = i == 0 ? polygon.outer : polygon.holes[i - 1];
    ring.reserve(static_cast<std::size_t>(numbers[1 + i]));
    for (std::size_t k = 0; k < static_cast<std::size_t>(numbers[1 + i]); ++k, ++next) {
      ring.push_back({numbers[next], numbers[next + places]});
    }
  }
  return polygon;
}

}  // namespace

void CoastlineRepository::insert(const DatasetId& dataset, const std::vector<geo::Polygon>& land) {
  sqlite::Transaction transaction{db_};
  const std::int64_t dataset_number = dataset_row(db_, dataset);
  sqlite::Statement insert{db_, "INSERT INTO land_polygon (dataset_row, rings) VALUES (?1, ?2)"};
  sqlite::Statement insert_box{db_,
                               "INSERT INTO land_polygon_box VALUES (last_insert_rowid(), ?1, ?2, ?3, ?4)"};
  BlobCodec codec;
  for (const geo::Polygon& polygon : land) {
    const std::vector<double> numbers = flattened(polygon);
    insert.bind_all(dataset_number, codec.pack(std::span{numbers}));
    insert.run();

    const geo::BoundingBox box = geo::bounding_box(polygon);
    const UnrolledBox width = unrolled(box);
    insert_box.bind_all(width.west_deg, width.east_deg, box.south_deg, box.north_deg);
    insert_box.run();
  }
  transaction.commit();
}

std::vector<geo::Polygon> CoastlineRepository::load(const DatasetId& dataset,
                                                    const geo::BoundingBox& area) const {
  sqlite::Statement query{
      db_,
      "SELECT rings FROM land_polygon WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1) "
      "AND " +
          box_condition("land_polygon_box", 2) + " ORDER BY row"};
  query.bind(1, dataset.value);
  bind_box(query, 2, area);
  std::vector<geo::Polygon> land;
  BlobCodec codec;
  while (query.step()) {
    const auto blob = query.blob(0);
    const std::size_t numbers = BlobCodec::unpacked_bytes(blob) / sizeof(double);
    geo::Polygon polygon = from_flattened(codec.unpack_doubles(blob, numbers));
    if (geo::intersects(area, geo::bounding_box(polygon))) land.push_back(std::move(polygon));
  }
  return land;
}

}  // namespace floeplan::repository
