#include "storage/repository/fields/mesh_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/store_messages.hpp"
#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::repository {
namespace {

using ocean::Mesh;

constexpr std::size_t together = MeshBlocks::points_together;
constexpr std::uint32_t no_point = std::numeric_limits<std::uint32_t>::max();

constexpr std::uint32_t curve_bits = 31;  // for each coordinate; a resolution of a few millimetres

/// Position of a point of a square along Hilbert's curve.
std::uint64_t along_hilbert(std::uint64_t x, std::uint64_t y) {
  std::uint64_t along = 0;
  for (std::uint64_t half = std::uint64_t{1} << (curve_bits - 1); half > 0; half /= 2) {
    const std::uint64_t right = (x & half) != 0 ? 1 : 0;
    const std::uint64_t upper = (y & half) != 0 ? 1 : 0;
    along += half * half * ((3 * right) ^ upper);
    if (upper == 1) continue;
    if (right == 1) {
      x = 2 * half - 1 - (x & (2 * half - 1));
      y = 2 * half - 1 - (y & (2 * half - 1));
    }
    std::swap(x, y);
  }
  return along;
}

/// Position of a place along the curve around the globe.
std::uint64_t along_curve(geo::LonLat place) {
  const geo::UnitVector u = geo::unit_vector(place);
  const double size = std::abs(u.x) + std::abs(u.y) + std::abs(u.z);
  double x = u.x / size;
  double y = u.y / size;
  if (u.z < 0.0) {  // the southern half is folded over the corners of the square
    const double folded_x = std::copysign(1.0 - std::abs(y), x);
    y = std::copysign(1.0 - std::abs(x), y);
    x = folded_x;
  }
  constexpr double steps = static_cast<double>((std::uint64_t{1} << curve_bits) - 1);
  const auto step = [](double v) { return static_cast<std::uint64_t>((v + 1.0) / 2.0 * steps); };
  return along_hilbert(step(x), step(y));
}

/// Cells of one block: those whose first corner is one of its points.
struct Block {
  std::vector<std::uint32_t> corners;
  geo::BoundingBox box;
  double longest_side_m{};
};

std::vector<Block> blocks_of(const Mesh& mesh) {
  std::vector<Block> blocks((mesh.points.size() + together - 1) / together);
  for (const Mesh::Cell& cell : mesh.cells) {
    Block& block = blocks[cell[0] / together];
    block.corners.insert(block.corners.end(), cell.begin(), cell.end());
    block.longest_side_m = std::max(block.longest_side_m, longest_side_m(mesh, cell));
  }
  for (Block& block : blocks) {
    if (block.corners.empty()) continue;
    std::vector<geo::LonLat> places;
    for (const std::uint32_t corner : block.corners) places.push_back(mesh.points[corner]);
    // The box is enlarged, because sides are curved between the corners, and a cell may contain a pole.
    block.box = geo::grown(geo::bounding_box(places), core::Metres{block.longest_side_m});
  }
  return blocks;
}

[[noreturn]] void refuse_numbers() {
  throw sql::Failure{
      messages::store_text<"stored-data-damaged">("a cell of a mesh has a corner that is no point"),
      sql::Trouble::damaged};
}

/// The row of a block without its points and cells.
struct BlockRow {
  std::size_t block{};
  geo::BoundingBox box;
  double longest_side_m{};
  std::size_t cells{};
};

std::vector<BlockRow> block_rows(sql::Connection& db, std::int64_t dataset_row) {
  sql::Statement query{
      db,
      "SELECT block, west_deg, south_deg, east_deg, north_deg, longest_side_m, cell_count FROM "
      "mesh_block WHERE dataset_row = ?1 ORDER BY block"};
  query.bind(1, dataset_row);
  std::vector<BlockRow> rows;
  while (query.step())
    rows.push_back({static_cast<std::size_t>(query.integer(0)),
                    {query.real(1), query.real(2), query.real(3), query.real(4)},
                    query.real(5),
                    static_cast<std::size_t>(query.integer(6))});
  return rows;
}

std::vector<BlockRow> that_meet(const std::vector<BlockRow>& rows, const geo::BoundingBox& area) {
  std::vector<BlockRow> near;
  std::ranges::copy_if(rows, std::back_inserter(near),
                       [&](const BlockRow& row) { return row.cells > 0 && geo::intersects(row.box, area); });
  return near;
}

double longest_side_of(const std::vector<BlockRow>& rows) {
  double longest_m = 0.0;
  for (const BlockRow& row : rows) longest_m = std::max(longest_m, row.longest_side_m);
  return longest_m;
}

/// Corners of cells, as point numbers of the whole mesh, and the blocks of these points.
struct StoredCells {
  std::vector<std::uint32_t> corners;
  std::set<std::size_t> blocks;
};

StoredCells read_cells(sql::Connection& db, std::int64_t dataset_row, const std::vector<BlockRow>& rows,
                       BlobCodec& codec) {
  sql::Statement query{db, "SELECT corners FROM mesh_block WHERE dataset_row = ?1 AND block = ?2"};
  StoredCells cells;
  for (const BlockRow& row : rows) {
    query.reset();
    query.bind_all(dataset_row, static_cast<std::int64_t>(row.block));
    if (!query.step()) continue;
    const auto corners = codec.unpack_numbers(query.blob(0), 4 * row.cells);
    std::size_t last_block = row.block;
    cells.blocks.insert(last_block);
    for (const std::uint32_t corner : corners) {
      if (corner / together == last_block) continue;
      last_block = corner / together;
      cells.blocks.insert(last_block);
    }
    cells.corners.insert(cells.corners.end(), corners.begin(), corners.end());
  }
  return cells;
}

}  // namespace

std::vector<float> MeshInBlocks::in_order(std::span<const float> values) const {
  std::vector<float> ordered;
  ordered.reserve(sources.size());
  for (const std::uint32_t point : sources) ordered.push_back(values[point]);
  return ordered;
}

MeshInBlocks in_blocks(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size());
  for (const Mesh::Cell& cell : mesh.cells)
    for (const std::uint32_t corner : cell) used[corner] = true;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < used.size(); ++i)
    if (used[i]) order.emplace_back(along_curve(mesh.points[i]), i);
  std::ranges::sort(order);

  MeshInBlocks result;
  result.mesh.in_faces = mesh.in_faces;
  std::vector<std::uint32_t> numbers(mesh.points.size(), no_point);
  for (const auto& [place, source] : order) {
    numbers[source] = static_cast<std::uint32_t>(result.sources.size());
    result.sources.push_back(source);
    result.mesh.points.push_back(mesh.points[source]);
  }
  for (Mesh::Cell cell : mesh.cells) {
    for (std::uint32_t& corner : cell) corner = numbers[corner];
    result.mesh.cells.push_back(cell);
  }
  return result;
}

void MeshBlocks::write(std::int64_t dataset_row, const Mesh& mesh) {
  sql::Statement insert{
      db_,
      "INSERT INTO mesh_block (dataset_row, block, west_deg, south_deg, east_deg, north_deg, longest_side_m, "
      "cell_count, lons_deg, lats_deg, corners) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11)"};
  BlobCodec codec;
  const auto packed = [&](const auto& values) {
    const auto blob = codec.pack(std::span{values});
    return std::vector<std::byte>{blob.begin(), blob.end()};
  };
  const std::vector<Block> blocks = blocks_of(mesh);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    std::vector<double> lons;
    std::vector<double> lats;
    for (std::size_t point = i * together; point < std::min((i + 1) * together, mesh.points.size());
         ++point) {
      lons.push_back(mesh.points[point].lon_deg);
      lats.push_back(mesh.points[point].lat_deg);
    }
    insert.reset();
    insert.bind_all(dataset_row, static_cast<std::int64_t>(i), block.box.west_deg, block.box.south_deg,
                    block.box.east_deg, block.box.north_deg, block.longest_side_m,
                    static_cast<std::int64_t>(block.corners.size() / 4), packed(std::as_const(lons)),
                    packed(std::as_const(lats)), packed(std::as_const(block.corners)));
    insert.run();
  }
}

MeshPart MeshBlocks::around(std::int64_t dataset_row, const geo::BoundingBox& area) const {
  sql::Statement whole{db_, "SELECT point_count, in_faces FROM mesh WHERE dataset_row = ?1"};
  whole.bind(1, dataset_row);
  MeshPart part;
  if (!whole.step()) return part;
  const auto point_count = static_cast<std::size_t>(whole.integer(0));
  part.mesh.in_faces = whole.integer(1) != 0;

  const std::vector<BlockRow> rows = block_rows(db_, dataset_row);
  std::vector<BlockRow> near = that_meet(rows, area);
  if (part.mesh.in_faces)  // a node of a cell in the area depends on all faces around it
    near = that_meet(rows, geo::grown(area, core::Metres{longest_side_of(near)}));
  BlobCodec codec;
  const StoredCells cells = read_cells(db_, dataset_row, near, codec);

  std::map<std::size_t, std::uint32_t> first_of;  // first point of each block in the part
  sql::Statement query{db_,
                       "SELECT lons_deg, lats_deg FROM mesh_block WHERE dataset_row = ?1 AND block = ?2"};
  for (const std::size_t block : cells.blocks) {
    query.reset();
    query.bind_all(dataset_row, static_cast<std::int64_t>(block));
    if (block * together >= point_count || !query.step()) refuse_numbers();
    const std::size_t count = std::min(together, point_count - block * together);
    const auto lons = codec.unpack_doubles(query.blob(0), count);
    const auto lats = codec.unpack_doubles(query.blob(1), count);
    first_of[block] = static_cast<std::uint32_t>(part.mesh.points.size());
    part.blocks.push_back(block);
    for (std::size_t i = 0; i < count; ++i) part.mesh.points.push_back({lons[i], lats[i]});
  }
  part.mesh.cells.reserve(cells.corners.size() / 4);
  std::size_t block = point_count;  // no block yet
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < cells.corners.size(); i += 4) {
    Mesh::Cell cell{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::uint32_t number = cells.corners[i + corner];
      if (number >= point_count) refuse_numbers();
      if (number / together != block) {
        block = number / together;
        first = first_of.at(block);
      }
      cell[corner] = first + static_cast<std::uint32_t>(number % together);
    }
    part.mesh.cells.push_back(cell);
  }
  return part;
}

std::size_t MeshBlocks::points_around(std::int64_t dataset_row, const geo::BoundingBox& area) const {
  const std::vector<BlockRow> rows = block_rows(db_, dataset_row);
  const double longest_m = longest_side_of(that_meet(rows, area));
  return together * that_meet(rows, geo::grown(area, core::Metres{longest_m})).size();
}

}  // namespace floeplan::repository
