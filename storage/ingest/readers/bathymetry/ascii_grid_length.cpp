#include <algorithm>
#include <fstream>
#include <string>

#include "engine/messages/ingest_depth_messages.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"

namespace floeplan::ingest {
namespace {

/// Whether a word is a number. Some programs write a decimal comma, which GDAL reads as a point.
bool is_number(std::string word) {
  std::ranges::replace(word, ',', '.');
  return parse_number(word).has_value();
}

}  // namespace

Checked<std::uint64_t> ascii_grid_length(const std::filesystem::path& file) {
  constexpr double max_side = 1e6;
  std::ifstream in{file};
  double columns = 0.0;
  double rows = 0.0;
  std::uint64_t values = 0;
  std::string word;
  while (in >> word) {
    if (values > 0 || is_number(word)) {
      ++values;
      continue;
    }
    const std::string key = lower(word);
    if (!(in >> word)) break;
    if (key == "ncols") columns = parse_number(word).value_or(0.0);
    if (key == "nrows") rows = parse_number(word).value_or(0.0);
  }
  if (!(columns >= 1.0 && columns <= max_side && rows >= 1.0 && rows <= max_side))
    return refuse(messages::ingest_depth_message<"grid-header-damaged">());

  const auto needed = static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
  if (values < needed)
    return refuse(messages::ingest_file_message<"file-cut-short">("grid", needed, "values", values));
  return values;
}

}  // namespace floeplan::ingest
