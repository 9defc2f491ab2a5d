#include "storage/demo/land_mask.hpp"

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::demo {
namespace {

std::unique_ptr<GDALDataset> in_memory(const RasterFrame& frame, GDALDataType type) {
  ingest::register_drivers();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("MEM");
  if (driver == nullptr) throw std::runtime_error{"GDAL has no MEM driver"};
  std::unique_ptr<GDALDataset> dataset{
      driver->Create("", static_cast<int>(frame.columns), static_cast<int>(frame.rows), 1, type, nullptr)};
  std::array<double, 6> transform{frame.west_deg,    frame.step_lon_deg, 0.0, frame.south_deg, 0.0,
                                  frame.step_lat_deg};
  dataset->SetGeoTransform(transform.data());
  return dataset;
}

template <class Value>
std::vector<Value> values_of(GDALDataset& dataset, const RasterFrame& frame, GDALDataType type) {
  std::vector<Value> values(frame.size());
  const int columns = static_cast<int>(frame.columns);
  const int rows = static_cast<int>(frame.rows);
  if (dataset.GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, type, 0,
                                         0, nullptr) != CE_None)
    throw std::runtime_error{"reading a raster from memory failed"};
  return values;
}

void add_ring(OGRPolygon& polygon, const geo::Ring& ring) {
  OGRLinearRing line;
  for (const geo::LonLat place : ring) line.addPoint(place.lon_deg, place.lat_deg);
  line.closeRings();
  polygon.addRing(&line);
}

/// Mean over `radius` cells to both sides of each cell, along one direction of the grid.
std::vector<float> box_mean(const RasterFrame& frame, const std::vector<float>& values, std::size_t radius,
                            bool along_rows) {
  const std::size_t lines = along_rows ? frame.rows : frame.columns;
  const std::size_t cells = along_rows ? frame.columns : frame.rows;
  std::vector<float> means(values.size());
  std::vector<double> sums(cells + 1);
  for (std::size_t line = 0; line < lines; ++line) {
    const auto at = [&](std::size_t cell) {
      return along_rows ? frame.index(cell, line) : frame.index(line, cell);
    };
    for (std::size_t cell = 0; cell < cells; ++cell)
      sums[cell + 1] = sums[cell] + static_cast<double>(values[at(cell)]);
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const std::size_t from = cell > radius ? cell - radius : 0;
      const std::size_t end = std::min(cells, cell + radius + 1);
      means[at(cell)] = static_cast<float>((sums[end] - sums[from]) / static_cast<double>(end - from));
    }
  }
  return means;
}

}  // namespace

std::vector<std::uint8_t> land_mask(const RasterFrame& frame, const std::vector<geo::Polygon>& land) {
  const auto dataset = in_memory(frame, GDT_Byte);
  std::vector<std::unique_ptr<OGRPolygon>> shapes;
  std::vector<OGRGeometryH> handles;
  for (const geo::Polygon& piece : land) {
    auto shape = std::make_unique<OGRPolygon>();
    add_ring(*shape, piece.outer);
    for (const geo::Ring& hole : piece.holes) add_ring(*shape, hole);
    handles.push_back(OGRGeometry::ToHandle(shape.get()));
    shapes.push_back(std::move(shape));
  }
  const std::vector<double> burn(handles.size(), 1.0);
  int band = 1;
  if (!handles.empty() && GDALRasterizeGeometries(GDALDataset::ToHandle(dataset.get()), 1, &band,
                                                  static_cast<int>(handles.size()), handles.data(), nullptr,
                                                  nullptr, burn.data(), nullptr, nullptr, nullptr) != CE_None)
    throw std::runtime_error{"drawing the coastline on a raster failed"};
  return values_of<std::uint8_t>(*dataset, frame, GDT_Byte);
}

std::vector<float> cells_to(const RasterFrame& frame, const std::vector<std::uint8_t>& mask,
                            std::uint8_t value) {
  const auto source = in_memory(frame, GDT_Byte);
  const auto distance = in_memory(frame, GDT_Float32);
  const int columns = static_cast<int>(frame.columns);
  const int rows = static_cast<int>(frame.rows);
  std::vector<std::uint8_t> copy = mask;
  if (source->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, copy.data(), columns, rows, GDT_Byte,
                                         0, 0, nullptr) != CE_None)
    throw std::runtime_error{"writing a raster in memory failed"};
  std::string values = "VALUES=" + std::to_string(value);
  std::array<char*, 2> options{values.data(), nullptr};
  if (GDALComputeProximity(source->GetRasterBand(1), distance->GetRasterBand(1), options.data(), nullptr,
                           nullptr) != CE_None)
    throw std::runtime_error{"measuring distances to the coast failed"};
  return values_of<float>(*distance, frame, GDT_Float32);
}

std::vector<float> land_share(const RasterFrame& frame, const std::vector<std::uint8_t>& mask,
                              std::size_t radius) {
  std::vector<float> share(mask.begin(), mask.end());
  for (int pass = 0; pass < 2; ++pass)
    share = box_mean(frame, box_mean(frame, share, radius, true), radius, false);
  return share;
}

}  // namespace floeplan::demo
