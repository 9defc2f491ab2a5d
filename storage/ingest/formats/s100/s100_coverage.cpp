#include "storage/ingest/formats/s100/s100_coverage.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/core/utc_text.hpp"
#include "engine/geo/written_place.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

// Codes of dataCodingFormat.
constexpr double stations = 1.0;
constexpr double regular_grid = 2.0;
constexpr double ungeorectified_grid = 3.0;
constexpr double moving_platform = 4.0;
constexpr double triangulated_mesh = 7.0;
constexpr double stations_one_by_one = 8.0;

constexpr double most_side = 1'000'000.0;  // nodes along one side
constexpr std::size_t most_records = 100'000;

tl::unexpected<Messages> s100_lacks(const std::string& what) {
  return refuse(messages::ingest_hdf5_message<"s-hundred-incomplete">(what));
}

/// The refusal of values in this layout.
messages::Message refusal_of_layout(const std::string& feature, double data_coding_format) {
  if (data_coding_format == stations || data_coding_format == stations_one_by_one)
    return messages::ingest_hdf5_message<"s-hundred-of-stations">(feature, number(data_coding_format));
  if (data_coding_format == moving_platform)
    return messages::ingest_hdf5_message<"s-hundred-of-a-platform">(feature, number(data_coding_format));
  constexpr std::array words{"fixed stations",      "a regular grid",    "a grid of places of their own",
                             "a moving platform",   "an irregular grid", "cells of several sizes",
                             "a triangulated mesh", "fixed stations",    "a regular grid of features"};
  const auto index = static_cast<std::size_t>(data_coding_format) - 1;
  return messages::ingest_hdf5_message<"s-hundred-layout-not-read">(
      feature,
      data_coding_format >= 1.0 && index < words.size() ? words.at(index) : "a layout that is not known");
}

/// Where a value lies in its cell, as a share of the cell from its south-western corner along x and y.
/// Without an offset code the first value lies at the grid's origin, as with code 1.
std::optional<std::array<double, 2>> place_in_cell(const Hdf5Group& feature) {
  constexpr std::array<std::array<double, 2>, 5> places{
      {{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.5}}};
  const double code = feature.number("dataOffsetCode").value_or(1.0);
  if (!(code >= 1.0 && code <= static_cast<double>(places.size()))) return std::nullopt;
  return places.at(static_cast<std::size_t>(code) - 1);
}

/// Whether rows run from south to north and the values of each row from west to east.
bool runs_row_by_row(const Hdf5Group& feature, const Hdf5Group& area) {
  if (feature.number("sequencingRule.type").value_or(1.0) != 1.0) return false;  // linear
  std::string order = lower(feature.text("sequencingRule.scanDirection").value_or("longitude,latitude"));
  std::erase(order, ' ');
  std::string start = area.text("startSequence").value_or("0,0");
  std::erase_if(start, [](char c) { return c == ' ' || c == '(' || c == ')'; });
  return (order == "longitude,latitude" || order == "easting,northing" || order == "x,y") && start == "0,0";
}

Checked<std::vector<double>> s100_nodes(const Hdf5Group& area, const std::string& direction, double share) {
  const auto origin = area.number("gridOrigin" + direction);
  const std::string axis = direction == "Longitude" ? "Longitudinal" : "Latitudinal";
  const auto spacing = area.number("gridSpacing" + axis);
  const auto count = area.number("numPoints" + axis);
  if (!origin || !spacing || !count || !std::isfinite(*origin) || !(*spacing > 0.0) || !(*count >= 1.0) ||
      !(*count <= most_side))
    return s100_lacks("where its grid lies (gridOrigin" + direction + ", gridSpacing" + axis + ", numPoints" +
                      axis + ")");
  std::vector<double> values;
  for (std::size_t i = 0; i < static_cast<std::size_t>(*count); ++i)
    values.push_back(*origin + *spacing * (static_cast<double>(i) + share));
  return values;
}

Checked<geo::GridFrame> s100_frame(const Hdf5Group& file) {
  auto code = file.number("horizontalCRS");
  if (!code && file.text("horizontalDatumReference") == "EPSG") code = file.number("horizontalDatumValue");
  if (!code) return s100_lacks("which reference system its places have (horizontalCRS)");
  OGRSpatialReference crs;
  if (!(*code > 0.0 && *code <= 999'999.0) || crs.importFromEPSG(static_cast<int>(*code)) != OGRERR_NONE)
    return refuse(messages::ingest_hdf5_message<"s-hundred-crs-unknown">(number(*code)));
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const auto frame = grid_frame_of(crs);
  if (!frame) return refuse(messages::ingest_hdf5_message<"s-hundred-crs-unusable">(number(*code)));
  return *frame;
}

/// The descriptions of a feature's values in the group Group_F.
Checked<std::map<std::string, S100Value>> described_values(const Hdf5Group& file,
                                                           const std::string& feature) {
  const auto descriptions = file.group("Group_F");
  if (!descriptions) return refuse(descriptions.error());
  const auto table = descriptions->table(feature);
  if (!table) return refuse(table.error());
  const auto codes = table->texts("code");
  const auto units = table->texts("uom.name");
  const auto fills = table->texts("fillValue");
  for (const auto* column : {&codes, &units, &fills})
    if (!*column) return refuse(column->error());
  std::map<std::string, S100Value> values;
  for (std::size_t i = 0; i < codes->size(); ++i) {
    const auto fill = parse_number((*fills)[i]);
    values[(*codes)[i]] = {(*units)[i], fill ? static_cast<float>(*fill) : missing};
  }
  return values;
}

/// The only area of a feature: "SurfaceCurrent.01".
Checked<Hdf5Group> only_area(const Hdf5Group& feature, const std::string& name) {
  std::vector<std::string> areas;
  for (const std::string& member : feature.members())
    if (member.starts_with(name + ".")) areas.push_back(member);
  if (areas.size() == 1) return feature.group(areas.front());
  return refuse(areas.empty() ? messages::ingest_hdf5_message<"s-hundred-without-values">(name)
                              : messages::ingest_hdf5_message<"s-hundred-areas">(areas.size(), name));
}

Checked<std::vector<Hdf5Group>> records_in(const Hdf5Group& area) {
  std::vector<Hdf5Group> records;
  for (const std::string& member : area.members()) {
    if (!member.starts_with("Group_")) continue;
    if (records.size() == most_records)
      return refuse(messages::ingest_hdf5_message<"s-hundred-too-many-records">());
    auto record = area.group(member);
    if (!record) return refuse(record.error());
    records.push_back(std::move(*record));
  }
  const double stated = area.number("numGRP").value_or(static_cast<double>(records.size()));
  if (records.empty() || stated != static_cast<double>(records.size()))
    return refuse(messages::ingest_hdf5_message<"s-hundred-records-missing">(number(stated), records.size()));
  return records;
}

/// The triangles of a mesh, if it has any. Triangles with the same corner twice have no area and are dropped.
/// Errors  a corner that is none of the places; no triangle has an area
Checked<std::vector<std::array<std::uint32_t, 3>>> triangles_in(const Hdf5Group& positioning,
                                                                std::size_t places) {
  constexpr const char* name = "triangles";
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto members = positioning.members();
  if (std::ranges::find(members, name) == members.end()) return triangles;
  const auto corners = positioning.integers(name, 3);
  if (!corners) return refuse(corners.error());
  for (std::size_t i = 0; i < corners->size(); i += 3) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::int64_t place = (*corners)[i + corner];
      if (place < 0 || place >= static_cast<std::int64_t>(places))
        return refuse(messages::ingest_hdf5_message<"s-hundred-triangle-impossible">(place, places));
      triangle.at(corner) = static_cast<std::uint32_t>(place);
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      triangles.push_back(triangle);
  }
  if (triangles.empty()) return refuse(messages::ingest_hdf5_message<"s-places-without-area">());
  return triangles;
}

}  // namespace

bool is_s100(std::string_view bytes, std::string_view product) {
  return bytes.starts_with("\x89HDF\r\n\x1a\n") &&
         bytes.find("INT.IHO." + std::string{product}) != std::string_view::npos;
}

Checked<Hdf5Table> S100Coverage::table(std::size_t record) const {
  auto table = records[record].table("values");
  if (!table) return refuse(table.error());
  if (table->shape() != std::vector{grid.y().size(), file_columns})
    return refuse(messages::ingest_hdf5_message<"s-hundred-record-of-other-size">());
  return table;
}

Checked<std::vector<float>> S100Coverage::read(const Hdf5Table& table, const std::string& value,
                                               std::size_t first_row, std::size_t rows) const {
  const auto all = table.numbers(value, first_row, rows);
  if (!all) return refuse(all.error());
  const auto described = values.find(value);
  const float fill = described == values.end() ? missing : described->second.fill;
  std::vector<float> result;
  result.reserve(rows * columns.size());
  for (std::size_t row = 0; row < rows; ++row) {
    for (const std::size_t column : columns) {
      const float stored = (*all)[row * file_columns + column];
      result.push_back(!std::isfinite(stored) || stored == fill ? missing : stored);
    }
  }
  return result;
}

Checked<std::vector<float>> S100Points::read(std::size_t record, const std::string& value) const {
  auto read = read_station(record, value);
  if (read && read->size() != places.size())
    return refuse(messages::ingest_hdf5_message<"s-hundred-record-of-other-size">());
  return read;
}

Checked<std::vector<float>> S100Points::read_station(std::size_t record, const std::string& value) const {
  const auto table = records[record].table("values");
  if (!table) return refuse(table.error());
  const auto stored = table->all_numbers(value);
  if (!stored) return refuse(stored.error());
  const auto described = values.find(value);
  const float fill = described == values.end() ? missing : described->second.fill;
  std::vector<float> result;
  result.reserve(stored->size());
  for (const double number : *stored) {
    const auto single = static_cast<float>(number);
    result.push_back(!std::isfinite(single) || single == fill ? missing : single);
  }
  return result;
}

Checked<S100Layout> s100_layout(const std::filesystem::path& path, const std::string& feature_name) {
  const auto file = Hdf5Group::root_of(path);
  if (!file) return refuse(file.error());
  const auto feature = file->group(feature_name);
  if (!feature) return refuse(feature.error());
  const double layout = feature->number("dataCodingFormat").value_or(0.0);
  if (layout == regular_grid) return S100Layout::regular_grid;
  if (layout == stations) return S100Layout::stations;
  if (layout == stations_one_by_one) return S100Layout::stations_one_by_one;
  return layout == ungeorectified_grid || layout == triangulated_mesh ? S100Layout::points
                                                                      : S100Layout::other;
}

std::optional<core::UtcTime> s100_time(std::string text) {
  constexpr std::size_t basic_length = 16;
  if (text.size() == basic_length) {
    for (const std::size_t at : {13UL, 11UL}) text.insert(at, ":");
    for (const std::size_t at : {6UL, 4UL}) text.insert(at, "-");
  }
  return core::parse_iso8601(text);
}

Checked<AxisNodes> s100_times(const std::vector<Hdf5Group>& records) {
  std::vector<double> times_s;
  for (const Hdf5Group& record : records) {
    const std::string text = record.text("timePoint").value_or("");
    const auto time = s100_time(text);
    if (!time) return refuse(messages::ingest_hdf5_message<"s-time-unreadable">(text));
    times_s.push_back(core::unix_seconds(*time));
  }
  return sorted_nodes("timePoint", std::move(times_s));
}

Checked<S100Points> s100_points(const std::filesystem::path& path, const std::string& feature_name) {
  auto file = Hdf5Group::root_of(path);
  if (!file) return refuse(file.error());
  const auto feature = file->group(feature_name);
  if (!feature) return refuse(feature.error());
  const auto area = only_area(*feature, feature_name);
  if (!area) return refuse(area.error());
  const auto frame = s100_frame(*file);
  if (!frame) return refuse(frame.error());
  if (!std::holds_alternative<geo::GeographicFrame>(*frame))
    return refuse(messages::ingest_hdf5_message<"s-hundred-places-projected">());
  const auto positioning = area->group("Positioning");
  if (!positioning) return refuse(positioning.error());
  const auto table = positioning->table("geometryValues");
  if (!table) return refuse(table.error());
  const auto lons = table->all_numbers("longitude");
  if (!lons) return refuse(lons.error());
  const auto lats = table->all_numbers("latitude");
  if (!lats) return refuse(lats.error());
  std::vector<geo::LonLat> places;
  for (std::size_t i = 0; i < lons->size(); ++i) {
    const auto place = geo::written_place((*lons)[i], (*lats)[i]);
    if (!place)
      return refuse(messages::ingest_hdf5_message<"s-hundred-place-impossible">(number((*lons)[i]),
                                                                                number((*lats)[i])));
    places.push_back(*place);
  }
  auto triangles = triangles_in(*positioning, places.size());
  if (!triangles) return refuse(triangles.error());
  auto values = described_values(*file, feature_name);
  if (!values) return refuse(values.error());
  auto records = records_in(*area);
  if (!records) return refuse(records.error());
  return S100Points{std::move(*file),   *area, std::move(places), std::move(*triangles), std::move(*values),
                    std::move(*records)};
}

Checked<S100Coverage> s100_coverage(const std::filesystem::path& path, const std::string& feature_name) {
  auto file = Hdf5Group::root_of(path);
  if (!file) return refuse(file.error());
  const auto feature = file->group(feature_name);
  if (!feature) return refuse(feature.error());
  const double layout = feature->number("dataCodingFormat").value_or(0.0);
  if (layout != regular_grid) return refuse(refusal_of_layout(feature_name, layout));
  const auto area = only_area(*feature, feature_name);
  if (!area) return refuse(area.error());
  const auto share = place_in_cell(*feature);
  if (!share || !runs_row_by_row(*feature, *area))
    return refuse(messages::ingest_hdf5_message<"s-hundred-order-not-read">());
  const auto frame = s100_frame(*file);
  if (!frame) return refuse(frame.error());
  const auto x_values = s100_nodes(*area, "Longitude", (*share)[0]);
  if (!x_values) return refuse(x_values.error());
  const auto y_values = s100_nodes(*area, "Latitude", (*share)[1]);
  if (!y_values) return refuse(y_values.error());
  const bool geographic = std::holds_alternative<geo::GeographicFrame>(*frame);
  auto x = geographic ? longitude_nodes("longitude", *x_values) : monotonic_nodes("x", *x_values);
  if (!x) return refuse(x.error());
  const auto y = geographic ? latitude_nodes("latitude", *y_values) : monotonic_nodes("y", *y_values);
  if (!y) return refuse(y.error());
  ocean::HorizontalGrid grid{*frame, ocean::Axis{x->nodes}, ocean::Axis{y->nodes}};
  if (!geographic && !lies_in_projection(grid))
    return refuse(messages::ingest_hdf5_message<"s-hundred-beyond-projection">());
  auto values = described_values(*file, feature_name);
  if (!values) return refuse(values.error());
  auto records = records_in(*area);
  if (!records) return refuse(records.error());
  return S100Coverage{
      std::move(*file),   *area, std::move(grid), x_values->size(), std::move(x->source), std::move(*values),
      std::move(*records)};
}

}  // namespace floeplan::ingest
