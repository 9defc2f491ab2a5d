#include <algorithm>

#include "api/codec/route_formats.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/mission/line_words.hpp"

namespace floeplan::codec {
namespace {

std::vector<std::string> cells_of(std::string_view line) {
  const char separator = line.find(';') != std::string_view::npos    ? ';'
                         : line.find('\t') != std::string_view::npos ? '\t'
                                                                     : ',';
  std::vector<std::string> cells;
  while (true) {
    const std::size_t end = line.find(separator);
    std::string_view cell = line.substr(0, end);
    const std::size_t first = cell.find_first_not_of(" \"\r");
    cell =
        first == std::string_view::npos ? "" : cell.substr(first, cell.find_last_not_of(" \"\r") - first + 1);
    cells.push_back(core::lower_case(cell));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::optional<std::size_t> column_of(const std::vector<std::string>& header,
                                     const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::ranges::find(names, header[i]) != names.end()) return i;
  }
  return std::nullopt;
}

}  // namespace

RoutePlaces read_csv(std::string_view bytes) {
  std::vector<geo::LonLat> places;
  core::Violations faults;
  std::optional<std::size_t> lon;
  std::optional<std::size_t> lat;
  int number = 0;
  while (!bytes.empty() && faults.size() < 20) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1);
    const std::string_view line = bytes.substr(0, end + 1);
    bytes.remove_prefix(end + 1);
    ++number;
    if (line.find_first_not_of(" \t\r\n") == std::string_view::npos || line.starts_with('#')) continue;
    const auto cells = cells_of(line.substr(0, line.find_last_not_of("\r\n") + 1));
    if (!lon) {
      lon = column_of(cells, {"lon", "lon_deg", "longitude", "long", "lng", "x"});
      lat = column_of(cells, {"lat", "lat_deg", "latitude", "y"});
      if (!lon || !lat)
        return route_fault(at_line(number),
                           "must name a column lon and a column lat; GliderDOS files end in .ma or .mi");
      continue;
    }
    const auto cell = [&](std::size_t column) {
      return column < cells.size() ? mission::parse_number(cells[column]) : std::nullopt;
    };
    if (const auto place = place_of(cell(*lon), cell(*lat), number, faults)) places.push_back(*place);
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (places.empty()) return route_fault("file", "holds no row with a longitude and a latitude");
  return places;
}

}  // namespace floeplan::codec
