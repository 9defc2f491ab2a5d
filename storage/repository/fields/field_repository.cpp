#include "storage/repository/fields/field_repository.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "engine/ocean/grids/bilinear.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/repository/fields/field_chunks.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"
#include "storage/repository/fields/native_currents.hpp"
#include "storage/repository/fields/native_planes.hpp"
#include "storage/repository/fields/point_reader.hpp"
#include "storage/sql/snapshot.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

/// Chosen by measurement on model currents and topography: smaller squares compress worse and unpack more
/// slowly; larger ones gain two per cent, but a small area then reads more.
constexpr std::size_t chunk_side = FieldRepository::rows_together;

/// Sizes of the stored data of a field; its axes are not included.
struct StoredLayout {
  ChunkLayout chunks;
  std::size_t samples{};      // number of samples in a slice
  std::size_t depth_count{};  // 0: no depth axis
  std::size_t time_count{};
  std::optional<NativeLayout> native{};  // empty: the samples are at the nodes of the grid
};

std::optional<StoredLayout> find_layout(sql::Connection& db, const DatasetId& id) {
  sql::Statement query{
      db,
      "SELECT dataset_row, x_count, y_count, chunk_side, depth_count, time_count FROM grid WHERE "
      "dataset_row = (SELECT row FROM dataset WHERE id = ?1)"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  const auto size = [&](int column) { return static_cast<std::size_t>(query.integer(column)); };
  StoredLayout layout{{query.integer(0), size(1), size(2), size(3)}, size(1) * size(2), size(4), size(5)};
  layout.native = find_native_layout(db, query.integer(0));
  if (!layout.native) return layout;
  layout.chunks = layout.native->chunks;
  layout.samples = layout.native->points;
  // one more for the sea bed
  if (layout.native->bed_levels > 0) layout.depth_count = layout.native->bed_levels + 1;
  return layout;
}

StoredLayout layout_to_fill(sql::Connection& db, const DatasetId& id) {
  const auto layout = find_layout(db, id);
  if (!layout) throw std::invalid_argument{"no grid for " + id.value + ": create it before its slices"};
  return *layout;
}

void write(sql::Connection& db, const ChunkLayout& layout, const SliceKey& slice, std::size_t first_row,
           std::span<const float> values, const SampleSteps& steps) {
  sql::Transaction transaction{db};
  ChunkWriter{db, layout}.write(slice, first_row, values, steps);
  transaction.commit();
}

std::vector<std::byte> packed(BlobCodec& codec, const ocean::Axis& axis) {
  const auto blob = codec.pack(std::span{axis.nodes()});
  return {blob.begin(), blob.end()};
}

std::optional<std::vector<std::byte>> packed(BlobCodec& codec, const std::optional<ocean::Axis>& axis) {
  return axis ? std::optional{packed(codec, *axis)} : std::nullopt;
}

std::int64_t stored_size(const std::optional<ocean::Axis>& axis) {
  return axis ? static_cast<std::int64_t>(axis->size()) : 0;
}

/// The levels needed to interpolate at both depths. Without depths: all levels.
AxisWindow levels_between(const ocean::Axis& depths_m, std::optional<core::Metres> shallowest,
                          std::optional<core::Metres> deepest) {
  const auto& nodes = depths_m.nodes();
  std::ptrdiff_t first = 0;
  auto last = std::ssize(nodes) - 1;
  if (deepest) last = std::min(std::ranges::lower_bound(nodes, deepest->value) - nodes.begin(), last);
  if (shallowest)
    first = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(nodes, shallowest->value) - nodes.begin() - 1,
                                       0, last);
  return {{{static_cast<std::size_t>(first), static_cast<std::size_t>(last - first + 1)}},
          ocean::Axis{{nodes.begin() + first, nodes.begin() + last + 1}}};
}

/// The steps from the last at or before the period to the first at or after it. nullopt: no step is in or
/// around the period.
std::optional<AxisWindow> steps_around(const ocean::Axis& times_s, const std::optional<Period>& period) {
  if (!period) return whole(times_s);
  const double from = core::unix_seconds(period->from);
  const double to = core::unix_seconds(period->to);
  if (!(to >= times_s.front() && from <= times_s.back())) return std::nullopt;

  const auto& nodes = times_s.nodes();
  const auto after_from = std::ranges::upper_bound(nodes, from) - nodes.begin();
  const auto not_before_to = std::ranges::lower_bound(nodes, to) - nodes.begin();
  const auto first = std::max<std::ptrdiff_t>(after_from - 1, 0);
  const auto last = std::min(not_before_to, std::ssize(nodes) - 1);
  return AxisWindow{{{static_cast<std::size_t>(first), static_cast<std::size_t>(last - first + 1)}},
                    ocean::Axis{{nodes.begin() + first, nodes.begin() + last + 1}}};
}

bool holds(sql::Connection& db, const ChunkLayout& layout, const std::string& variable) {
  sql::Statement query{db, "SELECT 1 FROM field_chunk WHERE dataset_row = ?1 AND variable = ?2 LIMIT 1"};
  query.bind_all(layout.dataset_row, variable);
  return query.step();
}

/// The window's samples of one variable, [time][depth][y][x].
std::vector<float> read_block(ChunkReader& reader, const std::string& variable, NodeRun times, NodeRun depths,
                              const GridWindow& window, const std::stop_token& stop) {
  const std::size_t slice = window.x.nodes.size() * window.y.nodes.size();
  std::vector<float> samples(times.count * depths.count * slice);
  auto rest = std::span{samples};
  for (std::size_t time = times.first; time < times.first + times.count; ++time) {
    for (std::size_t depth = depths.first; depth < depths.first + depths.count; ++depth) {
      if (stop.stop_requested()) return samples;
      reader.read({variable, time, depth}, window, rest.first(slice));
      rest = rest.subspan(slice);
    }
  }
  return samples;
}

/// The part of a dataset's currents to read.
struct StoredCurrents {
  geo::BoundingBox area;
  ChunkLayout chunks;
  std::optional<NativeLayout> native;
  ocean::HorizontalGrid grid;  // grid of the whole dataset
  GridWindow window;
  bool has_depths{};
  AxisWindow depths;
  AxisWindow times;

  [[nodiscard]] std::size_t bytes() const {
    const std::size_t nodes = window.x.nodes.size() * window.y.nodes.size();
    return 2 * sizeof(float) * nodes * depths.nodes.size() * times.nodes.size();
  }
  [[nodiscard]] CurrentBlock key() const {
    return {chunks.dataset_row, window.x.runs, window.y.runs, depths.runs.front(), times.runs.front()};
  }
};

struct DepthRange {
  std::optional<core::Metres> shallowest;
  std::optional<core::Metres> deepest;
};

std::optional<StoredCurrents> find_currents(sql::Connection& db, const DatasetId& id,
                                            const geo::BoundingBox& area, const std::optional<Period>& period,
                                            const DepthRange& range) {
  const auto layout = find_layout(db, id);
  const auto stored = FieldRepository{db}.shape(id);
  if (!layout || !stored) return std::nullopt;
  auto window = window_around(stored->grid, area);
  if (!window) return std::nullopt;
  auto times = stored->times_s ? steps_around(*stored->times_s, period) : whole(ocean::Axis{{0.0}});
  if (!times) return std::nullopt;
  AxisWindow depths = stored->depths_m ? levels_between(*stored->depths_m, range.shallowest, range.deepest)
                                       : whole(ocean::Axis{{0.0}});
  return StoredCurrents{.area = area,
                        .chunks = layout->chunks,
                        .native = layout->native,
                        .grid = stored->grid,
                        .window = std::move(*window),
                        .has_depths = stored->depths_m.has_value(),
                        .depths = std::move(depths),
                        .times = std::move(*times)};
}

ocean::CurrentGrid read_currents(sql::Connection& db, const StoredCurrents& part,
                                 const std::stop_token& stop) {
  ocean::HorizontalGrid around{part.grid.frame(), part.window.x.nodes, part.window.y.nodes};
  if (part.native)
    return read_native_currents(db, *part.native,
                                {.area = part.area,
                                 .lattice = std::move(around),
                                 .depths = part.has_depths ? std::optional{part.depths} : std::nullopt,
                                 .times = part.times},
                                stop);
  ChunkReader reader{db, part.chunks};
  const auto read = [&](const std::string& variable) {
    return read_block(reader, variable, part.times.runs.front(), part.depths.runs.front(), part.window, stop);
  };
  return ocean::CurrentGrid{{.grid = std::move(around),
                             .depths_m = part.has_depths ? std::optional{part.depths.nodes} : std::nullopt,
                             .times_s = part.times.nodes,
                             .u = read("u_m_s"),
                             .v = read("v_m_s")}};
}

}  // namespace

void FieldRepository::create(const DatasetId& id, const FieldShape& shape) {
  BlobCodec codec;
  sql::Statement insert{
      db_,
      "INSERT INTO grid (dataset_row, frame, x_count, y_count, depth_count, time_count, "
      "chunk_side, x_nodes, y_nodes, depth_nodes_m, time_nodes_s) VALUES (?1, ?2, ?3, ?4, ?5, ?6, "
      "?7, ?8, ?9, ?10, ?11)"};
  insert.bind_all(dataset_row(db_, id), geo::frame_text(shape.grid.frame()), stored_size(shape.grid.x()),
                  stored_size(shape.grid.y()), stored_size(shape.depths_m), stored_size(shape.times_s),
                  static_cast<std::int64_t>(chunk_side), packed(codec, shape.grid.x()),
                  packed(codec, shape.grid.y()), packed(codec, shape.depths_m), packed(codec, shape.times_s));
  insert.run();
}

void FieldRepository::create(const DatasetId& id, const FieldShape& shape, const NativePoints& native) {
  create(id, shape);
  const std::int64_t row = dataset_row(db_, id);
  sql::Statement insert{
      db_, "INSERT INTO mesh (dataset_row, point_count, in_faces, level_count) VALUES (?1, ?2, ?3, ?4)"};
  insert.bind_all(row, static_cast<std::int64_t>(native.mesh.points.size()),
                  static_cast<std::int64_t>(native.mesh.in_faces),
                  static_cast<std::int64_t>(native.bed_levels));
  insert.run();
  MeshBlocks{db_}.write(row, native.mesh);
}

void FieldRepository::write_slice(const DatasetId& id, const std::string& variable, std::size_t time_index,
                                  std::size_t depth_index, std::span<const float> values,
                                  const SampleSteps& steps) {
  const StoredLayout layout = layout_to_fill(db_, id);
  if (values.size() != layout.samples) {
    throw std::invalid_argument{
        "a slice must have as many samples as its grid has nodes, or its mesh points"};
  }
  if (time_index >= std::max<std::size_t>(layout.time_count, 1) ||
      depth_index >= std::max<std::size_t>(layout.depth_count, 1)) {
    throw std::invalid_argument{"a slice must lie within the times and depths of its dataset"};
  }
  if (!layout.native) return write(db_, layout.chunks, {variable, time_index, depth_index}, 0, values, steps);
  std::vector<float> rows{values.begin(), values.end()};  // the last block is padded
  rows.resize(layout.chunks.x_count * layout.chunks.y_count, std::numeric_limits<float>::quiet_NaN());
  write(db_, layout.chunks, {variable, time_index, depth_index}, 0, rows, steps);
}

void FieldRepository::write_rows(const DatasetId& id, const std::string& variable, std::size_t first_row,
                                 std::span<const float> values) {
  const StoredLayout layout = layout_to_fill(db_, id);
  const std::size_t rows = values.size() / layout.chunks.x_count;
  const std::size_t end_row = first_row + rows;
  if (values.size() != rows * layout.chunks.x_count || end_row > layout.chunks.y_count ||
      first_row % chunk_side != 0 || (end_row % chunk_side != 0 && end_row != layout.chunks.y_count)) {
    throw std::invalid_argument{"rows must be whole, and begin and end where those packed together do"};
  }
  write(db_, layout.chunks, {variable, 0, 0}, first_row, values, {});
}

std::optional<FieldShape> FieldRepository::shape(const DatasetId& id) const {
  sql::Statement query{
      db_,
      "SELECT frame, x_nodes, y_nodes, depth_nodes_m, time_nodes_s, x_count, y_count, depth_count, "
      "time_count FROM grid WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1)"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;

  const auto frame = geo::parse_frame(query.text(0));
  if (!frame)
    throw std::runtime_error{messages::store_text<"stored-word-unknown">("a grid's frame", query.text(0))};
  BlobCodec codec;
  const auto axis = [&](int nodes, int count) {
    return ocean::Axis{
        codec.unpack_doubles(query.blob(nodes), static_cast<std::size_t>(query.integer(count)))};
  };
  const auto optional_axis = [&](int nodes, int count) {
    return query.is_null(nodes) ? std::nullopt : std::optional{axis(nodes, count)};
  };
  return FieldShape{{*frame, axis(1, 5), axis(2, 6)}, optional_axis(3, 7), optional_axis(4, 8)};
}

std::size_t FieldRepository::most_nodes(const DatasetId& id, const geo::BoundingBox& area) const {
  const auto layout = find_layout(db_, id);
  const auto stored = shape(id);
  if (!layout || !stored) return 0;
  const auto window = window_around(stored->grid, area);
  if (!window) return 0;
  if (!layout->native) return window->x.nodes.size() * window->y.nodes.size();
  return ocean::most_nodes_refined({stored->grid.frame(), window->x.nodes, window->y.nodes},
                                   MeshBlocks{db_}.points_around(layout->chunks.dataset_row, area));
}

std::optional<ocean::CurrentGrid> FieldRepository::load_currents(
    const DatasetId& id, const geo::BoundingBox& area, std::optional<Period> period,
    std::optional<core::Metres> deepest, std::optional<core::Metres> shallowest) const {
  const sql::Snapshot one_moment{db_};
  const auto part = find_currents(db_, id, area, period, {shallowest, deepest});
  if (!part) return std::nullopt;
  return read_currents(db_, *part, stop_);
}

std::shared_ptr<const ocean::CurrentGrid> FieldRepository::load_currents_at(
    const DatasetId& id, geo::LonLat place, std::optional<Period> period, std::optional<core::Metres> deepest,
    std::optional<core::Metres> shallowest, CurrentBlocks& kept) const {
  const sql::Snapshot one_moment{db_};
  const geo::BoundingBox at_place{place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
  auto part = find_currents(db_, id, at_place, period, {shallowest, deepest});
  if (!part) return nullptr;
  if (part->native) return std::make_shared<const ocean::CurrentGrid>(read_currents(db_, *part, stop_));
  StoredCurrents block = *part;
  block.window = in_whole_blocks(part->window, block.grid, block.chunks.side);
  const bool is_kept_if_read = block.bytes() <= kept.most_bytes() / 4;
  if (!is_kept_if_read) return std::make_shared<const ocean::CurrentGrid>(read_currents(db_, *part, stop_));
  const CurrentBlock key = block.key();
  if (auto known = kept.find(key)) return known;
  auto read = std::make_shared<const ocean::CurrentGrid>(read_currents(db_, block, stop_));
  if (!stop_.stop_requested()) kept.keep(key, read, block.bytes());
  return read;
}

std::optional<ocean::Bathymetry> FieldRepository::load_bathymetry(const DatasetId& id,
                                                                  const geo::BoundingBox& area) const {
  const sql::Snapshot one_moment{db_};
  const auto layout = find_layout(db_, id);
  const auto stored = shape(id);
  if (!layout || !stored) return std::nullopt;
  const auto window = window_around(stored->grid, area);
  if (!window) return std::nullopt;

  ocean::HorizontalGrid around{stored->grid.frame(), window->x.nodes, window->y.nodes};
  const bool has_shoalest = holds(db_, layout->chunks, "shoalest_m");
  if (layout->native) return read_native_depths(db_, *layout->native, area, around, has_shoalest);
  ChunkReader reader{db_, layout->chunks};
  const auto read = [&](const std::string& variable) {
    return read_block(reader, variable, {0, 1}, {0, 1}, *window, stop_);
  };
  return ocean::Bathymetry{std::move(around), read("depth_m"),
                           has_shoalest ? read("shoalest_m") : std::vector<float>{}};
}

std::optional<ocean::IceField> FieldRepository::load_ice(const DatasetId& id, const geo::BoundingBox& area,
                                                         std::optional<Period> period) const {
  const sql::Snapshot one_moment{db_};
  const auto layout = find_layout(db_, id);
  const auto stored = shape(id);
  if (!layout || !stored || !stored->times_s) return std::nullopt;
  const auto window = window_around(stored->grid, area);
  const auto times = steps_around(*stored->times_s, period);
  if (!window || !times) return std::nullopt;

  ocean::HorizontalGrid around{stored->grid.frame(), window->x.nodes, window->y.nodes};
  const bool has_thickness = holds(db_, layout->chunks, "thickness_m");
  if (layout->native)
    return read_native_ice(db_, *layout->native, area, around, *times, has_thickness, stop_);
  ChunkReader reader{db_, layout->chunks};
  const auto read = [&](const std::string& variable) {
    return read_block(reader, variable, times->runs.front(), {0, 1}, *window, stop_);
  };
  return ocean::IceField{{.grid = std::move(around),
                          .times_s = times->nodes,
                          .concentration = read("concentration"),
                          .thickness_m = has_thickness ? read("thickness_m") : std::vector<float>{}}};
}

std::optional<FieldRepository::Series> FieldRepository::load_series(const DatasetId& id,
                                                                    const std::string& variable,
                                                                    geo::LonLat place, Period period) const {
  const sql::Snapshot one_moment{db_};
  const auto layout = find_layout(db_, id);
  const auto stored = shape(id);
  if (!layout || !stored || !stored->times_s) return std::nullopt;
  const auto times = steps_around(*stored->times_s, period);
  if (!times) return std::nullopt;
  // Whether the place lies in a cell of a model's own points, those cells say: the grid, where the values are used,
  // may end a rounding error before them.
  if (layout->native)
    return Series{times->nodes, read_native_series(db_, *layout->native, place, variable, *times)};

  const geo::BoundingBox here{place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
  const auto window = window_around(stored->grid, here);
  if (!window) return std::nullopt;
  const ocean::HorizontalGrid around{stored->grid.frame(), window->x.nodes, window->y.nodes};
  const auto position = around.locate(place);
  if (!position) return std::nullopt;
  ChunkReader reader{db_, layout->chunks};
  const std::vector<float> samples =
      read_block(reader, variable, times->runs.front(), {0, 1}, *window, stop_);
  Series series{times->nodes, {}};
  for (std::size_t first = 0; first < samples.size(); first += around.size()) {
    const auto value =
        ocean::bilinear(std::span{samples}.subspan(first, around.size()), around.x().size(), *position);
    series.values.push_back(value ? static_cast<float>(*value) : std::numeric_limits<float>::quiet_NaN());
  }
  return series;
}

std::vector<std::string> FieldRepository::variables(const DatasetId& id) const {
  sql::Statement query{
      db_,
      "SELECT DISTINCT variable FROM field_chunk WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1) "
      "ORDER BY variable"};
  query.bind(1, id.value);
  std::vector<std::string> names;
  while (query.step()) names.push_back(query.text(0));
  return names;
}

std::optional<FieldRepository::Planes> FieldRepository::load_planes(
    const DatasetId& id, const geo::BoundingBox& area, std::span<const std::string> variables) const {
  const sql::Snapshot one_moment{db_};
  const auto layout = find_layout(db_, id);
  const auto stored = shape(id);
  if (!layout || !stored) return std::nullopt;
  const auto window = window_around(stored->grid, area);
  if (!window) return std::nullopt;

  ChunkReader reader{db_, layout->chunks};
  Planes planes{{stored->grid.frame(), window->x.nodes, window->y.nodes}, {}};
  for (const std::string& variable : variables)
    planes.values.push_back(read_block(reader, variable, {0, 1}, {0, 1}, *window, stop_));
  return planes;
}

}  // namespace floeplan::repository
