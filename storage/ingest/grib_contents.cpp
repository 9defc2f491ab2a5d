#include "storage/ingest/grib_contents.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr int oceanography = 10;
constexpr int currents_category = 1;
constexpr int meteorology = 0;
constexpr int momentum_category = 2;
constexpr int east_number = 2;  // of both: direction and speed are 0 and 1, u and v 2 and 3
constexpr int north_number = 3;
constexpr int depth_surface = 160;
constexpr int sea_surface = 1;
constexpr int pressure_surface = 100;
constexpr int height_surface = 103;
constexpr double pascals_per_hectopascal = 100.0;
constexpr double wind_height_m = 10.0;
constexpr double same_height_m = 0.5;

bool is_current(const GribField& field) {
  return field.discipline == oceanography && field.category == currents_category;
}

bool is_wind_anywhere(const GribField& field) {
  return field.discipline == meteorology && field.category == momentum_category &&
         (field.number == east_number || field.number == north_number);
}

bool is_wind(const GribField& field) {
  return is_wind_anywhere(field) && field.surface_type == height_surface &&
         std::abs(field.surface_value - wind_height_m) <= same_height_m;
}

/// Source  WMO code table 4.5
std::string words_of_level(const GribField& field) {
  const std::string value = number(field.surface_value);
  if (field.surface_type == height_surface) return value + " m above the ground";
  if (field.surface_type == pressure_surface)
    return "a pressure of " + number(field.surface_value / pascals_per_hectopascal) + " hPa";
  return "a surface of type " + std::to_string(field.surface_type) + " (code table 4.5)";
}

/// "the wind at 100 m above the ground and a pressure of 850 hPa", of all wind in a file; empty: it has none.
std::string wind_in_words(const std::vector<GribField>& fields) {
  std::vector<std::string> levels;
  for (const GribField& field : fields) {
    if (!is_wind_anywhere(field)) continue;
    std::string words = words_of_level(field);
    if (std::ranges::find(levels, words) == levels.end()) levels.push_back(std::move(words));
  }
  return levels.empty() ? std::string{} : "the wind at " + enumeration(levels);
}

/// Extremes, sums and deviations over a period are no state of the sea or the air.
bool is_state(const GribField& field) { return field.statistic == 0; }

std::string nothing_in_grib(Moving what, const std::vector<GribField>& fields, bool direction,
                            bool statistic) {
  if (statistic)
    return std::string{"the GRIB file holds extremes, sums or deviations of the "} +
           (what == Moving::sea ? "current" : "wind") +
           " over a period, which is nothing that a vehicle or an iceberg meets; give a file with its values "
           "or its means";
  const std::string elsewhere = wind_in_words(fields);
  const std::string beside = elsewhere.empty() ? "" : elsewhere + ", but ";
  if (what == Moving::air)
    return "the GRIB file holds " + beside +
           "no wind 10 m above the ground (discipline 0, category 2, surface 103), which is the wind that "
           "moves icebergs; there is nothing to store; give a file with both components of that wind";
  if (direction)
    return "the GRIB file gives the current as speed and direction, which this program does not read; give a "
           "file with its components towards east and north";
  return "the GRIB file holds " + beside +
         "no currents of the sea (discipline 10, category 1) and no wind 10 m above the ground; there is "
         "nothing to store; give a file with both components of the current or of that wind";
}

}  // namespace

Checked<GribContents> grib_contents(const std::vector<GribField>& fields, Moving what) {
  const std::string name = what == Moving::sea ? "current" : "wind";
  std::map<std::pair<double, double>, GribBands> found;
  std::set<double> times;
  std::set<double> depths;
  const GribField* first = nullptr;
  bool direction = false;
  bool statistic = false;
  bool one_run = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const GribField& field = fields[i];
    if (!(what == Moving::sea ? is_current(field) : is_wind(field))) continue;
    direction = direction || field.number <= 1;
    statistic = statistic || !is_state(field);
    if (!is_state(field)) continue;
    if (field.number != east_number && field.number != north_number) continue;
    if (what == Moving::sea && field.surface_type != depth_surface && field.surface_type != sea_surface)
      return refuse("the GRIB file has currents on a surface of type " + std::to_string(field.surface_type) +
                    ", which is no depth; they cannot be placed in the water; ask for depths in metres");
    if (first == nullptr) first = &field;
    if (field.grid != first->grid)
      return refuse(
          "the fields of the GRIB file lie on different grids; they cannot be put together; give one grid a "
          "file");
    const double depth_m = field.surface_type == depth_surface ? field.surface_value : 0.0;
    GribBands& bands = found[{field.valid_s, depth_m}];
    int& band = field.number == east_number ? bands.east : bands.north;
    if (band != 0)
      return refuse("the GRIB file holds a component of the " + name +
                    " twice for one time and place; which of them holds is unknown; remove one of them");
    band = static_cast<int>(i) + 1;
    one_run = one_run && field.run_s == first->run_s;
    times.insert(field.valid_s);
    depths.insert(depth_m);
  }
  if (first == nullptr) return refuse(nothing_in_grib(what, fields, direction, statistic));

  GribContents contents{{times.begin(), times.end()},
                        {depths.begin(), depths.end()},
                        {},
                        first->run_s ? std::optional{core::from_unix_seconds(*first->run_s)} : std::nullopt,
                        first->grid,
                        first->along_grid,
                        what == Moving::sea};
  if (!one_run) contents.run = std::nullopt;
  if (contents.depths_m.front() < 0.0 || contents.depths_m.back() > 12000.0)
    return refuse("the depths in the GRIB file run from " + number(contents.depths_m.front()) + " to " +
                  number(contents.depths_m.back()) + " m; no ocean does; the file is damaged");
  for (const double time : contents.times_s) {
    for (const double depth : contents.depths_m) {
      const GribBands bands = found[{time, depth}];
      if (bands.east == 0 || bands.north == 0)
        return refuse("the GRIB file lacks a component of the " + name +
                      (what == Moving::sea ? " at a depth of " + number(depth) + " m" : std::string{}) +
                      " at one of its times; gaps cannot be filled; ask for a complete file");
      contents.bands.push_back(bands);
    }
  }
  return contents;
}

Checked<std::vector<repository::DatasetKind>> kinds_of_grib(const std::filesystem::path& file) {
  const auto fields = grib_fields(file);
  if (!fields) return refuse(fields.error());
  std::vector<repository::DatasetKind> kinds;
  const bool current = std::ranges::any_of(*fields, is_current);
  const bool wind = std::ranges::any_of(
      *fields, [&](const GribField& field) { return is_wind(field) && (!current || is_state(field)); });
  if (!wind || current) kinds.push_back(repository::DatasetKind::currents);
  if (wind) kinds.push_back(repository::DatasetKind::wind);
  return kinds;
}

}  // namespace floeplan::ingest
