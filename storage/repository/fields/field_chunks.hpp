#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/sql/connection.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::repository {

/// How a dataset's slices are divided: squares of `side` nodes; smaller ones at the end of each axis.
struct ChunkLayout {
  std::int64_t dataset_row{};
  std::size_t x_count{};
  std::size_t y_count{};
  std::size_t side{};
};

/// Identifies a slice of a variable.
struct SliceKey {
  std::string variable;
  std::size_t time_index{};
  std::size_t depth_index{};
};

/// Writes slices of one dataset, replacing stored ones.
/// Threads  as the connection: one thread at a time
class ChunkWriter {
 public:
  ChunkWriter(sql::Connection& db, const ChunkLayout& layout);
  /// Shape  values are [y][x], whole rows from `first_row`, the first row of a chunk, to the last row of a
  ///        chunk
  /// `steps`  steps in which the file stores the values, if they are packed
  void write(const SliceKey& slice, std::size_t first_row, std::span<const float> values,
             const SampleSteps& steps = {});

 private:
  ChunkLayout layout_;
  sql::Statement upsert_;
  BlobCodec codec_;
};

/// Reads windows of slices of one dataset.
/// Threads  as the connection: one thread at a time
class ChunkReader {
 public:
  ChunkReader(sql::Connection& db, const ChunkLayout& layout);
  /// Fills `out`, [y][x] of the window; NaN where nothing is stored.
  void read(const SliceKey& slice, const GridWindow& window, std::span<float> out);

 private:
  /// Copies a rectangle of stored nodes to `out`, from column `out_x` on; `out` has rows of `out_width`.
  void read_part(const SliceKey& slice, NodeRun x, NodeRun y, std::size_t out_x, std::size_t out_width,
                 std::span<float> out);

  ChunkLayout layout_;
  sql::Statement select_;
  BlobCodec codec_;
};

}  // namespace floeplan::repository
