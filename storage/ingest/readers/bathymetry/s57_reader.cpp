#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_grid.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"
#include "storage/ingest/readers/bathymetry/s57_cell.hpp"

namespace floeplan::ingest {
namespace {

constexpr double paper_m = 0.0005;  // grid spacing on paper, about the width of the thickest line of a chart
constexpr double metres_per_degree = 111'195.0;
constexpr double finest_m = 5.0;
constexpr double most_chart_nodes = 6'000'000.0;

/// Nodes of the grid, which are the centres of a raster's cells.
struct Frame {
  double west_deg{};
  double south_deg{};
  double dx_deg{};
  double dy_deg{};
  int columns{};
  int rows{};

  [[nodiscard]] ocean::HorizontalGrid grid() const {
    std::vector<double> x;
    std::vector<double> y;
    x.reserve(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i) x.push_back(west_deg + dx_deg * (i + 0.5));
    y.reserve(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) y.push_back(south_deg + dy_deg * (i + 0.5));
    return {geo::GeographicFrame{}, ocean::Axis{std::move(x)}, ocean::Axis{std::move(y)}};
  }
};

Checked<Frame> frame_of(const ChartCell& chart) {
  OGREnvelope extent;
  for (const auto& covered : chart.covered) {
    OGREnvelope one;
    covered->getEnvelope(&one);
    extent.Merge(one);
  }
  const double width = extent.MaxX - extent.MinX;
  const double height = extent.MaxY - extent.MinY;
  if (!(width > 0.0 && height > 0.0 && width <= 360.0 && extent.MinY >= -90.0 && extent.MaxY <= 90.0))
    return refuse(
        messages::ingest_depth_message<"chart-damaged">("has a coverage that is no area on the Earth"));
  const double spacing_m = std::max(paper_m * chart.scale, finest_m);
  const double middle = 0.5 * (extent.MinY + extent.MaxY) * std::numbers::pi / 180.0;
  Frame frame{.west_deg = extent.MinX, .south_deg = extent.MinY};
  frame.dy_deg = spacing_m / metres_per_degree;
  frame.dx_deg = frame.dy_deg / std::max(std::cos(middle), 0.01);
  const double columns = std::ceil(width / frame.dx_deg);
  const double rows = std::ceil(height / frame.dy_deg);
  if (columns * rows > most_chart_nodes)
    return refuse(messages::ingest_depth_message<"chart-covers-too-much">(number(columns), number(rows)));
  frame.columns = std::max(static_cast<int>(columns), 2);
  frame.rows = std::max(static_cast<int>(rows), 2);
  return frame;
}

/// A raster with one value per node; the southernmost row comes first.
class BurntPlane {
 public:
  BurntPlane(const Frame& frame, float value)
      : raster_{GetGDALDriverManager()->GetDriverByName("MEM")->Create("", frame.columns, frame.rows, 1,
                                                                       GDT_Float32, nullptr)} {
    std::array<double, 6> transform{frame.west_deg, frame.dx_deg, 0.0, frame.south_deg, 0.0, frame.dy_deg};
    raster_->SetGeoTransform(transform.data());
    raster_->GetRasterBand(1)->Fill(static_cast<double>(value));
  }

  /// Writes the depths of shapes into the raster; later shapes replace earlier ones. `touched`: also into
  /// cells that a shape only touches.
  [[nodiscard]] bool burn(const std::vector<ChartedDepth>& shapes, bool touched) {
    std::vector<OGRGeometryH> geometries;
    std::vector<double> values;
    for (const ChartedDepth& shape : shapes) {
      geometries.push_back(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(shape.geometry.get())));
      values.push_back(shape.depth_m);
    }
    if (geometries.empty()) return true;
    int band = 1;
    char all_touched[] = "ALL_TOUCHED=TRUE";
    char* options[] = {touched ? all_touched : nullptr, nullptr};
    return GDALRasterizeGeometries(GDALDataset::ToHandle(raster_.get()), 1, &band,
                                   static_cast<int>(geometries.size()), geometries.data(), nullptr, nullptr,
                                   values.data(), options, nullptr, nullptr) == CE_None;
  }

  /// The values of all nodes; empty if they cannot be read.
  [[nodiscard]] std::vector<float> values() const {
    const int columns = raster_->GetRasterXSize();
    const int rows = raster_->GetRasterYSize();
    std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const bool read =
        raster_->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows,
                                            GDT_Float32, 0, 0, nullptr) == CE_None;
    return read ? values : std::vector<float>{};
  }

 private:
  std::unique_ptr<GDALDataset> raster_;
};

/// Sorts the shapes so that the shoalest is written last and replaces all others.
std::vector<ChartedDepth> deepest_first(std::vector<ChartedDepth> shapes) {
  std::ranges::stable_sort(shapes, [](const auto& a, const auto& b) { return a.depth_m > b.depth_m; });
  return shapes;
}

}  // namespace

Checked<PreparedDataset> read_s57_bathymetry(const std::filesystem::path& base) {
  auto chart = read_s57_cell(base);
  if (!chart) return refuse(chart.error());
  const auto frame = frame_of(*chart);
  if (!frame) return refuse(frame.error());
  std::vector<ChartedDepth> covered;
  for (const auto& geometry : chart->covered) covered.push_back({geometry, 1.0});

  constexpr float deep = 1e6F;  // deeper than any depth written over it
  BurntPlane coverage{*frame, 0.0F};
  BurntPlane areas{*frame, missing};
  BurntPlane shoals{*frame, deep};
  if (!coverage.burn(covered, false) || !areas.burn(deepest_first(std::move(chart->areas)), false) ||
      !shoals.burn(deepest_first(std::move(chart->shoals)), true))
    return refuse(messages::ingest_depth_message<"chart-damaged">("has areas that cannot be drawn"));

  const std::vector<float> is_covered = coverage.values();
  const std::vector<float> shoalest = shoals.values();
  RawRows rows{.values_m = areas.values()};
  if (is_covered.empty() || shoalest.empty() || rows.values_m.empty())
    return refuse(messages::ingest_depth_message<"chart-damaged">("has areas that cannot be drawn"));
  rows.lowest_m.resize(rows.values_m.size(), missing);
  for (std::size_t i = 0; i < rows.values_m.size(); ++i) {
    if (is_covered[i] == 0.0F) rows.values_m[i] = missing;
    if (!std::isnan(rows.values_m[i])) rows.lowest_m[i] = std::min(rows.values_m[i], shoalest[i]);
  }
  RawBathymetry raw{
      .grid = frame->grid(),
      .description = {.name = "DEPARE", .standard_name = "", .long_name = "", .positive = "down"},
      .warnings = std::move(chart->warnings),
      .read = rows_in_memory(std::move(rows), static_cast<std::size_t>(frame->columns))};
  auto data = prepare_bathymetry(std::move(raw), std::nullopt);
  if (data) data->variables = {"DEPARE", "SOUNDG"};
  return data;
}

}  // namespace floeplan::ingest
