#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether the first line names the columns of a table of depths: a place (longitude and latitude, or x and y), and a
/// depth, elevation or z.
[[nodiscard]] bool is_depth_table_header(std::string_view line);

/// A table of depths with named columns, one place a line, fields parted by commas, semicolons, tabs or blanks, as the
/// raster that its places lie on: one band, in memory, called as the column is, NaN where the table has no line.
/// Errors   a line that is no row of numbers (named), a place given twice with two depths, places that are no regular
///          grid, more than 20 million lines
[[nodiscard]] Checked<std::unique_ptr<GDALDataset>> open_depth_table(const std::filesystem::path& file);

}  // namespace floeplan::ingest
