#include "storage/repository/features/coastline_repository.hpp"

#include <utility>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/repository/encoding/box_index.hpp"
#include "storage/repository/encoding/polygon_blob.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {

void keep_newest_coastline(std::vector<Dataset>& datasets) {
  bool found = false;
  std::erase_if(datasets, [&](const Dataset& dataset) {
    if (dataset.variables == std::vector<std::string>{ice_shelves_alone}) return false;
    return std::exchange(found, true);
  });
}

void CoastlineRepository::insert(const DatasetId& dataset, const std::vector<geo::Polygon>& land) {
  sql::Transaction transaction{db_};
  const std::int64_t dataset_number = dataset_row(db_, dataset);
  sql::Statement insert{db_, "INSERT INTO land_polygon (dataset_row, rings) VALUES (?1, ?2) RETURNING row"};
  BoxInsert insert_box{db_, "land_polygon_box"};
  BlobCodec codec;
  for (const geo::Polygon& polygon : land) {
    insert.bind_all(dataset_number, pack_polygon(codec, polygon));
    insert_box.run(sql::inserted_number(insert), geo::bounding_box(polygon));
  }
  transaction.commit();
}

std::vector<geo::Polygon> CoastlineRepository::load(const DatasetId& dataset,
                                                    const geo::BoundingBox& area) const {
  sql::Statement query{
      db_,
      "SELECT rings FROM land_polygon WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1) "
      "AND " +
          box_condition(db_, "land_polygon_box", 2) + " ORDER BY row"};
  query.bind(1, dataset.value);
  bind_box(query, 2, area);
  std::vector<geo::Polygon> land;
  BlobCodec codec;
  while (query.step()) {
    geo::Polygon polygon = unpack_polygon(codec, query.blob(0));
    if (geo::intersects(area, geo::bounding_box(polygon))) land.push_back(std::move(polygon));
  }
  return land;
}

}  // namespace floeplan::repository
