#include <algorithm>

#include "api/codec/route_files/route_formats.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/mission/document/line_words.hpp"

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
    cells.emplace_back(cell);
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::vector<std::string> in_lower_case(std::vector<std::string> words) {
  for (std::string& word : words) word = core::lower_case(word);
  return words;
}

std::optional<std::size_t> column_of(const std::vector<std::string>& header,
                                     const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::ranges::find(names, header[i]) != names.end()) return i;
  }
  return std::nullopt;
}

}  // namespace

ReadRoutes read_csv(std::string_view bytes) {
  std::vector<NamedRoute> routes;
  core::Violations faults;
  std::optional<std::size_t> lon;
  std::optional<std::size_t> lat;
  std::optional<std::size_t> of_route;
  int number = 0;
  while (!bytes.empty() && faults.size() < 20) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1);
    const std::string_view line = bytes.substr(0, end + 1);
    bytes.remove_prefix(end + 1);
    ++number;
    if (line.find_first_not_of(" \t\r\n") == std::string_view::npos || line.starts_with('#')) continue;
    const auto cells = cells_of(line.substr(0, line.find_last_not_of("\r\n") + 1));
    if (!lon) {
      const auto names = in_lower_case(cells);
      lon = column_of(names, {"lon", "lon_deg", "longitude", "long", "lng", "x"});
      lat = column_of(names, {"lat", "lat_deg", "latitude", "y"});
      of_route =
          column_of(names, {"route", "route_name", "route_id", "track", "track_name", "track_id", "plan_id"});
      if (!lon || !lat)
        return route_fault<"no-columns-of-places">(at_line(number));
      continue;
    }
    const auto cell = [&](std::size_t column) {
      return column < cells.size() ? mission::parse_number(cells[column]) : std::nullopt;
    };
    const auto place = place_of(cell(*lon), cell(*lat), number, faults);
    if (!place) continue;
    const std::string name = of_route && *of_route < cells.size() ? cells[*of_route] : "";
    auto route = std::ranges::find(routes, name, &NamedRoute::name);
    if (route == routes.end()) route = routes.insert(route, {name, {{}}});
    route->parts.front().push_back(*place);
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (routes.empty()) return route_fault<"holds-no">("file", "row with a longitude and a latitude");
  return FileRoutes{std::move(routes), {}};
}

}  // namespace floeplan::codec
