#include "storage/repository/fields/field_chunks.hpp"

#include <algorithm>
#include <limits>

namespace floeplan::repository {
namespace {

std::int64_t whole_number(std::size_t number) { return static_cast<std::int64_t>(number); }

/// The nodes in chunk number `chunk` along an axis of `count` nodes.
NodeRun nodes_of_chunk(std::size_t chunk, std::size_t side, std::size_t count) {
  const std::size_t first = chunk * side;
  return {first, std::min(side, count - first)};
}

NodeRun common(NodeRun a, NodeRun b) {
  const std::size_t first = std::max(a.first, b.first);
  return {first, std::min(a.first + a.count, b.first + b.count) - first};
}

}  // namespace

ChunkWriter::ChunkWriter(sql::Connection& db, const ChunkLayout& layout)
    : layout_{layout},
      upsert_{db,
              "INSERT INTO field_chunk (dataset_row, variable, time_index, depth_index, chunk_y, chunk_x, "
              "samples) "
              "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7) ON CONFLICT (dataset_row, variable, time_index, "
              "depth_index, chunk_y, chunk_x) DO UPDATE SET samples = excluded.samples"} {}

void ChunkWriter::write(const SliceKey& slice, std::size_t first_row, std::span<const float> values,
                        const SampleSteps& steps) {
  std::vector<float> chunk;
  const std::size_t end_row = first_row + values.size() / layout_.x_count;
  for (std::size_t chunk_y = first_row / layout_.side; chunk_y * layout_.side < end_row; ++chunk_y) {
    const NodeRun y = nodes_of_chunk(chunk_y, layout_.side, layout_.y_count);
    for (std::size_t chunk_x = 0; chunk_x * layout_.side < layout_.x_count; ++chunk_x) {
      const NodeRun x = nodes_of_chunk(chunk_x, layout_.side, layout_.x_count);
      chunk.clear();
      for (std::size_t row = y.first; row < y.first + y.count; ++row) {
        const auto part = values.subspan((row - first_row) * layout_.x_count + x.first, x.count);
        chunk.insert(chunk.end(), part.begin(), part.end());
      }
      upsert_.bind_all(layout_.dataset_row, slice.variable, whole_number(slice.time_index),
                       whole_number(slice.depth_index), whole_number(chunk_y), whole_number(chunk_x),
                       codec_.pack(chunk, steps));
      upsert_.run();
    }
  }
}

ChunkReader::ChunkReader(sql::Connection& db, const ChunkLayout& layout)
    : layout_{layout},
      select_{
          db,
          "SELECT chunk_y, chunk_x, samples FROM field_chunk WHERE dataset_row = ?1 AND variable = ?2 AND "
          "time_index = ?3 AND depth_index = ?4 AND chunk_y BETWEEN ?5 AND ?6 AND chunk_x BETWEEN ?7 AND "
          "?8"} {}

void ChunkReader::read(const SliceKey& slice, const GridWindow& window, std::span<float> out) {
  std::ranges::fill(out, std::numeric_limits<float>::quiet_NaN());
  std::size_t out_x = 0;
  for (const NodeRun x : window.x.runs) {
    read_part(slice, x, window.y.runs.front(), out_x, window.x.nodes.size(), out);
    out_x += x.count;
  }
}

void ChunkReader::read_part(const SliceKey& slice, NodeRun x, NodeRun y, std::size_t out_x,
                            std::size_t out_width, std::span<float> out) {
  const std::size_t side = layout_.side;
  select_.reset();
  select_.bind_all(layout_.dataset_row, slice.variable, whole_number(slice.time_index),
                   whole_number(slice.depth_index), whole_number(y.first / side),
                   whole_number((y.first + y.count - 1) / side), whole_number(x.first / side),
                   whole_number((x.first + x.count - 1) / side));
  while (select_.step()) {
    const NodeRun chunk_y =
        nodes_of_chunk(static_cast<std::size_t>(select_.integer(0)), side, layout_.y_count);
    const NodeRun chunk_x =
        nodes_of_chunk(static_cast<std::size_t>(select_.integer(1)), side, layout_.x_count);
    const std::span<const float> samples =
        codec_.unpack_floats(select_.blob(2), chunk_y.count * chunk_x.count);

    const NodeRun rows = common(chunk_y, y);
    const NodeRun columns = common(chunk_x, x);
    for (std::size_t row = rows.first; row < rows.first + rows.count; ++row) {
      const auto from = samples.subspan((row - chunk_y.first) * chunk_x.count + columns.first - chunk_x.first,
                                        columns.count);
      const std::size_t to = (row - y.first) * out_width + out_x + columns.first - x.first;
      std::ranges::copy(from, out.subspan(to).begin());
    }
  }
}

}  // namespace floeplan::repository
