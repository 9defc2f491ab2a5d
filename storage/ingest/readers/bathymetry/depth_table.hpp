#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a first line names the columns of a table of depths: a position (longitude and latitude, or x and
/// y), and a depth, elevation or z, but no measurement of the water.
[[nodiscard]] bool is_depth_table_header(std::string_view line);

/// Reads a table of depths with named columns, one position per line, fields separated by commas, semicolons,
/// tabs or blanks. The result is a raster in memory with one band, which has the column's name; NaN at nodes
/// without a line.
/// Errors   a line that is not a row of numbers; a position with two different depths; positions that do not
///          form a regular grid; more than 20 million lines
[[nodiscard]] Checked<std::unique_ptr<GDALDataset>> open_depth_table(const std::filesystem::path& file);

}  // namespace floeplan::ingest
