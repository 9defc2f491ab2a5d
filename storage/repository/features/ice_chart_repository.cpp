#include "storage/repository/features/ice_chart_repository.hpp"

#include <sstream>
#include <utility>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/repository/encoding/box_index.hpp"
#include "storage/repository/encoding/polygon_blob.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

std::string egg_text(const std::vector<IceCode>& codes) {
  std::string text;
  for (const auto& [name, code] : codes) text += (text.empty() ? "" : " ") + name + "=" + code;
  return text;
}

std::vector<IceCode> egg_codes(const std::string& text) {
  std::vector<IceCode> codes;
  std::istringstream words{text};
  for (std::string word; words >> word;) {
    const std::size_t sign = word.find('=');
    if (sign != std::string::npos) codes.push_back({word.substr(0, sign), word.substr(sign + 1)});
  }
  return codes;
}

}  // namespace

void IceChartRepository::insert(const DatasetId& dataset, const std::vector<ChartPolygon>& polygons) {
  sql::Transaction transaction{db_};
  const std::int64_t dataset_number = dataset_row(db_, dataset);
  sql::Statement insert{
      db_, "INSERT INTO chart_polygon (dataset_row, codes, rings) VALUES (?1, ?2, ?3) RETURNING row"};
  BoxInsert insert_box{db_, "chart_polygon_box"};
  BlobCodec codec;
  for (const ChartPolygon& polygon : polygons) {
    insert.bind_all(dataset_number, egg_text(polygon.codes), pack_polygon(codec, polygon.area));
    insert_box.run(sql::inserted_number(insert), geo::bounding_box(polygon.area));
  }
  transaction.commit();
}

std::vector<ChartPolygon> IceChartRepository::load(const DatasetId& dataset,
                                                   const geo::BoundingBox& area) const {
  sql::Statement query{
      db_,
      "SELECT codes, rings FROM chart_polygon WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1) "
      "AND " +
          box_condition(db_, "chart_polygon_box", 2) + " ORDER BY row"};
  query.bind(1, dataset.value);
  bind_box(query, 2, area);
  std::vector<ChartPolygon> polygons;
  BlobCodec codec;
  while (query.step()) {
    ChartPolygon polygon{egg_codes(query.text(0)), unpack_polygon(codec, query.blob(1))};
    if (geo::intersects(area, geo::bounding_box(polygon.area))) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace floeplan::repository
