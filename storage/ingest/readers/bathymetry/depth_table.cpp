#include "storage/ingest/readers/bathymetry/depth_table.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t max_rows = 20'000'000;  // 500 MB of text
// Least share of nodes with a value. A grid may have gaps over land; scattered soundings fill only a few
// nodes of a grid.
constexpr double least_share_of_nodes = 0.2;
// Tolerance as a share of the step. Tables round coordinates to few digits, so nodes may lie beside the
// regular grid.
constexpr double off_node = 0.05;

struct Columns {
  std::size_t x{};
  std::size_t y{};
  std::size_t z{};
};

std::optional<Columns> columns_of(const DelimitedText& table) {
  const auto x =
      table.column({"lon", "long", "longitude", "lon_deg", "longitude_deg", "x", "x_m", "easting"});
  const auto y = table.column({"lat", "latitude", "lat_deg", "latitude_deg", "y", "y_m", "northing"});
  const auto z = table.column({"depth", "depth_m", "depths", "elevation", "elevation_m", "z", "z_m",
                               "bathymetry", "altitude", "altitude_m", "height", "height_m", "topography"});
  if (!x || !y || !z) return std::nullopt;
  return Columns{*x, *y, *z};
}

struct Row {
  double x{};
  double y{};
  float z{};
};

Checked<std::vector<Row>> rows_of(std::istream& in, const DelimitedText& table, const Columns& columns) {
  std::vector<Row> rows;
  std::string line;
  for (std::size_t number_of_line = 2; std::getline(in, line); ++number_of_line) {
    const auto fields = table.fields(line);
    if (fields.empty()) continue;
    const auto at = [&](std::size_t column) {
      return column < fields.size() ? table.number(fields[column]) : std::nullopt;
    };
    const auto x = at(columns.x);
    const auto y = at(columns.y);
    const auto z = at(columns.z);
    if (!x || !y || !z)
      return refuse(messages::ingest_depth_message<"depth-row-unreadable">(number_of_line, line.substr(0, 60),
                                                                           table.header(columns.z)));
    if (rows.size() == max_rows)
      return refuse(messages::ingest_depth_message<"depth-table-too-long">(max_rows));
    rows.push_back({*x, *y, static_cast<float>(*z)});
  }
  if (rows.empty()) return refuse(messages::ingest_depth_message<"depth-table-empty">());
  return rows;
}

/// Equidistant nodes that fit all values of a coordinate.
struct EvenNodes {
  double first{};
  double step{};
  std::size_t count{};

  [[nodiscard]] std::optional<std::size_t> index_of(double value) const {
    const double position = (value - first) / step;
    const double nearest = std::round(position);
    if (std::abs(position - nearest) > off_node) return std::nullopt;
    return static_cast<std::size_t>(nearest);
  }
};

std::optional<EvenNodes> even_nodes(const std::vector<Row>& rows, double Row::* coordinate) {
  std::vector<double> values(rows.size());
  std::ranges::transform(rows, values.begin(), coordinate);
  std::ranges::sort(values);
  const double extent = values.back() - values.front();
  // Values closer than this are equal: far below the step of any grid with max_rows nodes, far above rounding
  // errors.
  const double same = extent / (4.0 * static_cast<double>(max_rows));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (const double step = values[i] - values[i - 1]; step > same) least = std::min(least, step);
  if (!std::isfinite(least)) return std::nullopt;
  const double steps = std::round(extent / least);
  if (steps > static_cast<double>(max_rows)) return std::nullopt;
  return EvenNodes{values.front(), extent / steps, static_cast<std::size_t>(steps) + 1};
}

messages::Message scattered(const std::string& name_of_z) {
  return messages::ingest_depth_message<"soundings-not-a-grid">(name_of_z);
}

std::unique_ptr<GDALDataset> empty_raster(const EvenNodes& x, const EvenNodes& y, const std::string& name) {
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  std::unique_ptr<GDALDataset> raster{
      memory->Create("", static_cast<int>(x.count), static_cast<int>(y.count), 1, GDT_Float32, nullptr)};
  if (!raster) return raster;
  std::array<double, 6> transform{x.first - 0.5 * x.step, x.step, 0.0, y.first - 0.5 * y.step, 0.0, y.step};
  raster->SetGeoTransform(transform.data());
  raster->GetRasterBand(1)->SetDescription(name.c_str());
  return raster;
}

Checked<std::vector<float>> values_on(const EvenNodes& x, const EvenNodes& y, const std::vector<Row>& rows,
                                      const std::string& name_of_z) {
  std::vector<float> values(x.count * y.count, std::numeric_limits<float>::quiet_NaN());
  for (const Row& row : rows) {
    const auto ix = x.index_of(row.x);
    const auto iy = y.index_of(row.y);
    if (!ix || !iy) return refuse(scattered(name_of_z));
    float& value = values[*iy * x.count + *ix];
    if (!std::isnan(value) && value != row.z)
      return refuse(messages::ingest_depth_message<"depth-stated-twice">(number(row.x, 9), number(row.y, 9),
                                                                         number(static_cast<double>(value)),
                                                                         number(static_cast<double>(row.z))));
    value = row.z;
  }
  return values;
}

}  // namespace

bool is_depth_table_header(std::string_view line) {
  return columns_of(DelimitedText{line}).has_value() && !names_water_properties(line);
}

Checked<std::unique_ptr<GDALDataset>> open_depth_table(const std::filesystem::path& file) {
  std::ifstream in{file};
  std::string header;
  std::getline(in, header);
  const DelimitedText table{header};
  const auto columns = columns_of(table);
  if (!columns) return refuse(messages::ingest_depth_message<"depth-columns-missing">());
  const std::string& name_of_z = table.header(columns->z);
  const auto rows = rows_of(in, table, *columns);
  if (!rows) return refuse(rows.error());
  const auto x = even_nodes(*rows, &Row::x);
  const auto y = even_nodes(*rows, &Row::y);
  const bool is_grid = x && y &&
                       static_cast<double>(x->count) * static_cast<double>(y->count) * least_share_of_nodes <=
                           static_cast<double>(rows->size());
  if (!is_grid) return refuse(scattered(name_of_z));
  auto values = values_on(*x, *y, *rows, name_of_z);
  if (!values) return refuse(values.error());

  auto raster = empty_raster(*x, *y, name_of_z);
  if (!raster ||
      raster->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, raster->GetRasterXSize(), raster->GetRasterYSize(),
                                         values->data(), raster->GetRasterXSize(), raster->GetRasterYSize(),
                                         GDT_Float32, 0, 0, nullptr) != CE_None)
    return refuse(messages::ingest_depth_message<"depth-table-too-large">());
  return raster;
}

}  // namespace floeplan::ingest
