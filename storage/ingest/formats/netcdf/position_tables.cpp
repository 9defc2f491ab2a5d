#include "storage/ingest/formats/netcdf/position_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/formats/netcdf/netcdf_projection.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using Names = std::vector<std::string_view>;

/// Names of the tables of longitude for these points in NEMO, ROMS, MOM and POP.
const Names& names_of(GridPoints points) {
  static const Names first{"glamu",       "lon_u", "geolon_u", "nav_lon_u", "nav_lon_grid_u",
                           "longitude_u", "ulon",  "ulong",    "geolon_c"};
  static const Names second{"glamv",       "lon_v", "geolon_v", "nav_lon_v", "nav_lon_grid_v",
                            "longitude_v", "ulon",  "ulong",    "geolon_c"};
  static const Names centres{"lon_rho", "nav_lon_rho"};
  if (points == GridPoints::first_component) return first;
  return points == GridPoints::second_component ? second : centres;
}

bool is_neutral(std::string_view name) {
  constexpr std::array<std::string_view, 7> names{"nav_lon", "lon",        "longitude", "lons",
                                                  "xlon",    "longitudes", "lon2d"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_called(std::string_view name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The last two dimensions, if all dimensions before them have length 1.
std::optional<std::array<NetcdfDimension, 2>> table_dimensions(const NetcdfVariable& variable) {
  const auto& all = variable.dimensions();
  if (!variable.is_numeric() || all.size() < 2) return std::nullopt;
  for (std::size_t i = 0; i + 2 < all.size(); ++i)
    if (all[i].size != 1) return std::nullopt;
  return std::array{all[all.size() - 2], all[all.size() - 1]};
}

bool is_longitude_table(const NetcdfVariable& variable) {
  if (!table_dimensions(variable)) return false;
  const std::string name = lower(variable.name());
  return is_called(name, names_of(GridPoints::first_component)) ||
         is_called(name, names_of(GridPoints::second_component)) ||
         is_called(name, names_of(GridPoints::centres)) || is_neutral(name) ||
         role_of(variable) == AxisRole::longitude;
}

/// The table of latitudes that belongs to a table of longitudes: the same name, with "lat" for "lon".
const NetcdfVariable* latitudes_beside(const NetcdfFile& file, const NetcdfVariable& lons) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> words{
      {{"longitude", "latitude"}, {"long", "lat"}, {"lon", "lat"}, {"glam", "gphi"}}};
  const std::string name = lower(lons.name());
  for (const auto& [of_lon, of_lat] : words) {
    const std::size_t at = name.find(of_lon);
    if (at == std::string::npos) continue;
    std::string wanted = name;
    wanted.replace(at, of_lon.size(), of_lat);
    for (const NetcdfVariable& variable : file.variables()) {
      if (lower(variable.name()) != wanted) continue;
      const auto same = [](const NetcdfDimension& a, const NetcdfDimension& b) { return a.name == b.name; };
      if (std::ranges::equal(variable.dimensions(), lons.dimensions(), same)) return &variable;
    }
  }
  return nullptr;
}

bool names_it(const NetcdfVariable& variable, const std::string& table) {
  std::istringstream words{variable.attribute("coordinates")};
  for (std::string word; words >> word;)
    if (word == table) return true;
  return false;
}

struct Table {
  const NetcdfVariable* lons{nullptr};
  const NetcdfVariable* lats{nullptr};
  int rank{};  // a larger rank is preferred
};

int rank_of(const NetcdfVariable& table, const NetcdfVariable& variable, bool own_file, GridPoints points) {
  const std::string name = lower(table.name());
  if (own_file && names_it(variable, table.name())) return 3;
  if (is_called(name, names_of(points))) return 2;
  return is_neutral(name) || name.ends_with("_rho") ? 1 : 0;
}

/// All tables over the variable's horizontal dimensions, best first.
std::vector<Table> tables_over(const NetcdfFiles& files, const NetcdfFile& file,
                               const NetcdfVariable& variable, PlaneDimensions plane, GridPoints points) {
  const NetcdfDimension& y = variable.dimensions()[plane.y];
  const NetcdfDimension& x = variable.dimensions()[plane.x];
  std::vector<Table> found;
  const auto add_from = [&](const NetcdfFile& source) {
    for (const NetcdfVariable& lons : source.variables()) {
      if (!is_longitude_table(lons)) continue;
      const auto dimensions = table_dimensions(lons).value();
      const bool fits = dimensions[0].name == y.name && dimensions[1].name == x.name &&
                        dimensions[0].size == y.size && dimensions[1].size == x.size;
      const int rank = rank_of(lons, variable, &source == &file, points);
      const NetcdfVariable* lats = latitudes_beside(source, lons);
      if (fits && rank > 0 && lats != nullptr) found.push_back({&lons, lats, rank});
    }
  };
  add_from(file);
  for (const auto& other : files)
    if (other.get() != &file) add_from(*other);
  std::ranges::stable_sort(found, std::ranges::greater{}, &Table::rank);
  return found;
}

/// Reads a table of positions; empty if it holds the same value everywhere.
Checked<std::optional<Positions>> read_table(const Table& table) {
  const auto dimensions = table_dimensions(*table.lons).value();
  if (dimensions[0].size == 0 || dimensions[1].size == 0 ||
      dimensions[0].size > max_grid_points / dimensions[1].size)
    return refuse(messages::ingest_netcdf_message<"too-many-nodes">(
        "the table of positions \"" + table.lons->name() + "\"", dimensions[0].size, dimensions[1].size,
        max_grid_points));
  const auto lons = table.lons->read_all();
  if (!lons) return refuse(lons.error());
  const auto lats = table.lats->read_all();
  if (!lats) return refuse(lats.error());

  Positions positions{
      {}, static_cast<std::size_t>(dimensions[0].size), static_cast<std::size_t>(dimensions[1].size), false};
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  bool varies = false;
  for (std::size_t i = 0; i < lons->size(); ++i) {
    const double lon = (*lons)[i];
    const double lat = (*lats)[i];
    const bool known = std::abs(lat) <= 90.0 + 1e-6 && std::abs(lon) <= 720.0;
    positions.places.push_back(known ? geo::LonLat{geo::wrap_longitude(lon), std::clamp(lat, -90.0, 90.0)}
                                     : geo::LonLat{nowhere, nowhere});
    varies = varies || (known && (lon != lons->front() || lat != lats->front()));
  }
  if (!varies) return std::optional<Positions>{};
  return std::optional{std::move(positions)};
}

/// Positions from axes of longitude and latitude: all combinations of their values.
Checked<std::optional<Positions>> positions_of_axes(const NetcdfFile& file, const NetcdfVariable& variable,
                                                    PlaneDimensions plane) {
  const NetcdfVariable* y = coordinate_of(file, variable.dimensions()[plane.y]);
  const NetcdfVariable* x = coordinate_of(file, variable.dimensions()[plane.x]);
  if (y == nullptr || x == nullptr || role_of(*y) != AxisRole::latitude || role_of(*x) != AxisRole::longitude)
    return std::optional<Positions>{};
  if (y->dimensions()[0].size > max_grid_points / std::max<std::uint64_t>(1, x->dimensions()[0].size))
    return refuse(messages::ingest_netcdf_message<"too-many-points">(variable.name()));
  const auto lats = y->read_all();
  if (!lats) return refuse(lats.error());
  const auto lons = x->read_all();
  if (!lons) return refuse(lons.error());
  Positions positions{{}, lats->size(), lons->size(), true};
  for (const double lat : *lats)
    for (const double lon : *lons) positions.places.push_back({geo::wrap_longitude(lon), lat});
  return std::optional{std::move(positions)};
}

}  // namespace

std::optional<PlaneDimensions> plane_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < variable.dimensions().size(); ++i) {
    const NetcdfDimension& dimension = variable.dimensions()[i];
    const NetcdfVariable* coordinate = coordinate_of(file, dimension);
    const AxisRole role = coordinate == nullptr ? AxisRole::unknown : role_of(*coordinate);
    const bool level_or_time = role == AxisRole::depth || role == AxisRole::time ||
                               role == AxisRole::model_level || role == AxisRole::other_level ||
                               lower(dimension.name).starts_with("s_rho");
    if (!level_or_time) found.push_back(i);
  }
  // Dimensions before the last two are a time or a depth without coordinates.
  if (found.size() < 2) return std::nullopt;
  found.erase(found.begin(), found.end() - 2);
  return PlaneDimensions{found[0], found[1]};
}

Checked<std::optional<Positions>> positions_of(const NetcdfFiles& files, const NetcdfFile& file,
                                               const NetcdfVariable& variable, PlaneDimensions plane,
                                               GridPoints points) {
  for (const Table& table : tables_over(files, file, variable, plane, points)) {
    auto positions = read_table(table);
    if (!positions || *positions) return positions;
  }
  auto of_axes = positions_of_axes(file, variable, plane);
  if (!of_axes || *of_axes || !is_placed_by_projection(file, variable, plane.y, plane.x)) return of_axes;
  auto places = places_by_projection(file, variable, plane.y, plane.x);
  if (!places) return refuse(places.error());
  return std::optional{Positions{std::move(*places),
                                 static_cast<std::size_t>(variable.dimensions()[plane.y].size),
                                 static_cast<std::size_t>(variable.dimensions()[plane.x].size), false}};
}

Checked<std::optional<Positions>> centre_positions(const NetcdfFiles& files) {
  for (const auto& file : files) {
    for (const NetcdfVariable& lons : file->variables()) {
      if (!table_dimensions(lons) || !is_called(lower(lons.name()), names_of(GridPoints::centres))) continue;
      const NetcdfVariable* lats = latitudes_beside(*file, lons);
      if (lats == nullptr) continue;
      auto positions = read_table({&lons, lats, 0});
      if (!positions || *positions) return positions;
    }
  }
  return std::optional<Positions>{};
}

bool has_positions(const NetcdfFiles& files, const NetcdfFile& file, const NetcdfVariable& variable,
                   PlaneDimensions plane) {
  return is_placed_by_projection(file, variable, plane.y, plane.x) ||
         !tables_over(files, file, variable, plane, GridPoints::first_component).empty() ||
         !tables_over(files, file, variable, plane, GridPoints::second_component).empty();
}

bool holds_position_tables(const NetcdfFile& file) {
  return std::ranges::any_of(file.variables(), is_longitude_table);
}

}  // namespace floeplan::ingest
