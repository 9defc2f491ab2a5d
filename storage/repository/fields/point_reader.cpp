#include "storage/repository/fields/point_reader.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::repository {
namespace {

constexpr std::size_t points_in_row = 64;

ocean::Axis counting(std::size_t count) {
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<double>(i);
  return ocean::Axis{std::move(numbers)};
}

}  // namespace

std::optional<NativeLayout> find_native_layout(sql::Connection& db, std::int64_t dataset_row) {
  sql::Statement query{db, "SELECT point_count, level_count FROM mesh WHERE dataset_row = ?1"};
  query.bind(1, dataset_row);
  if (!query.step()) return std::nullopt;
  const auto points = static_cast<std::size_t>(query.integer(0));
  return NativeLayout{
      {dataset_row, points_in_row, (points + points_in_row - 1) / points_in_row, points_in_row},
      points,
      static_cast<std::size_t>(query.integer(1))};
}

bool is_one_place(const geo::BoundingBox& area) {
  return area.west_deg == area.east_deg && area.south_deg == area.north_deg;
}

ocean::HorizontalGrid nodes_of_use(const geo::BoundingBox& area, const ocean::HorizontalGrid& lattice,
                                   const ocean::Mesh& part) {
  if (!is_one_place(area)) return ocean::refined(lattice, part);
  return {geo::GeographicFrame{}, ocean::Axis{{area.west_deg}}, ocean::Axis{{area.south_deg}}};
}

void refuse_overlapping_cells() {
  throw sql::Failure{messages::store_text<"stored-data-damaged">("the cells of a mesh lie over one another"),
                     sql::Trouble::damaged};
}

ocean::MeshSampling sampling_of(const ocean::Mesh& part, const ocean::HorizontalGrid& nodes) {
  auto sampling = ocean::MeshSampling::of(part, nodes);
  if (!sampling) refuse_overlapping_cells();
  return std::move(*sampling);
}

PointReader::PointReader(sql::Connection& db, const NativeLayout& layout, const MeshPart& part)
    : chunks_{db, layout.chunks}, points_{part.mesh.points.size()} {
  const ocean::Axis columns = counting(points_in_row);
  for (const std::size_t block : part.blocks) {
    const NodeRun rows{block * points_in_row,
                       std::min(points_in_row, layout.chunks.y_count - block * points_in_row)};
    blocks_.push_back({{{{0, points_in_row}}, columns}, {{rows}, counting(rows.count)}});
  }
}

std::vector<float> PointReader::read(const SliceKey& slice) {
  std::vector<float> samples;
  samples.reserve(points_ + points_in_row);
  for (const GridWindow& block : blocks_) {
    const std::size_t first = samples.size();
    samples.resize(first + points_in_row * block.y.nodes.size());
    chunks_.read(slice, block, std::span{samples}.subspan(first));
  }
  samples.resize(points_);  // the last block of the mesh may be followed by room
  return samples;
}

}  // namespace floeplan::repository
