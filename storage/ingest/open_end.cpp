#include "storage/ingest/open_end.hpp"

#include <fstream>

namespace floeplan::ingest {
namespace {

bool is_table_of_lines(FileFormat format) {
  return format == FileFormat::xyz || format == FileFormat::depth_table || format == FileFormat::ascii_grid ||
         format == FileFormat::ice_patrol_csv || format == FileFormat::iceberg_table ||
         format == FileFormat::own_iceberg_table || format == FileFormat::tide_table ||
         format == FileFormat::otps_extract;
}

bool ends_with_a_line(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary | std::ios::ate};
  if (!in || in.tellg() <= 0) return true;
  in.seekg(-1, std::ios::end);
  const int last = in.get();
  return last == '\n' || last == '\r';
}

}  // namespace

std::optional<std::string> warning_of_open_end(const std::filesystem::path& file, FileFormat format) {
  if (!is_table_of_lines(format) || ends_with_a_line(file)) return std::nullopt;
  return "the last line has no end: if the file was cut short, the last number of its last row is wrong; "
         "compare its "
         "size with the source's";
}

}  // namespace floeplan::ingest
