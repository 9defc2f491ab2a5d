#include "storage/demo/current_file.hpp"

#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "storage/ingest/gdal_guard.hpp"

namespace floeplan::demo {
namespace {

constexpr double step_m_s = 0.0005;
constexpr std::int16_t missing = -32767;

using Attributes = std::vector<std::pair<std::string, std::string>>;
using Dimensions = std::vector<std::shared_ptr<GDALDimension>>;

template <class Owner>
void add_text(Owner& owner, const std::string& name, const std::string& text) {
  const auto attribute = owner.CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
  if (!attribute || !attribute->Write(text.c_str()))
    throw std::runtime_error{"cannot write the attribute " + name};
}

std::shared_ptr<GDALDimension> add_axis(GDALGroup& group, const std::string& name,
                                        const std::vector<double>& nodes, const Attributes& attributes) {
  const auto dimension = group.CreateDimension(name, {}, {}, nodes.size());
  const auto variable =
      dimension ? group.CreateMDArray(name, {dimension}, GDALExtendedDataType::Create(GDT_Float64)) : nullptr;
  if (!variable) throw std::runtime_error{"cannot write the axis " + name};
  for (const auto& [key, text] : attributes) add_text(*variable, key, text);

  const GUInt64 start = 0;
  const std::size_t count = nodes.size();
  if (!variable->Write(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64),
                       nodes.data()))
    throw std::runtime_error{"cannot write the axis " + name};
  return dimension;
}

Dimensions add_axes(GDALGroup& group, const CurrentFile& content) {
  std::vector<double> seconds;
  for (const core::UtcTime time : content.times) seconds.push_back(core::unix_seconds(time));
  std::vector<double> lat_deg;
  for (std::size_t r = 0; r < content.frame.rows; ++r) lat_deg.push_back(content.frame.lat_deg(r));
  std::vector<double> lon_deg;
  for (std::size_t c = 0; c < content.frame.columns; ++c) lon_deg.push_back(content.frame.lon_deg(c));
  return {add_axis(group, "time", seconds,
                   {{"standard_name", "time"},
                    {"units", "seconds since 1970-01-01 00:00:00"},
                    {"calendar", "standard"},
                    {"axis", "T"}}),
          add_axis(group, "depth", content.depth_m,
                   {{"standard_name", "depth"}, {"units", "m"}, {"positive", "down"}, {"axis", "Z"}}),
          add_axis(group, "latitude", lat_deg,
                   {{"standard_name", "latitude"}, {"units", "degrees_north"}, {"axis", "Y"}}),
          add_axis(group, "longitude", lon_deg,
                   {{"standard_name", "longitude"}, {"units", "degrees_east"}, {"axis", "X"}})};
}

std::shared_ptr<GDALMDArray> add_component(GDALGroup& group, const Dimensions& axes, const std::string& name,
                                           const std::string& direction) {
  // One time and depth is one chunk: readers take the file slice by slice.
  const std::string chunk =
      "1,1," + std::to_string(axes[2]->GetSize()) + "," + std::to_string(axes[3]->GetSize());
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("ZLEVEL", "4");
  options.SetNameValue("BLOCKSIZE", chunk.c_str());
  auto component = group.CreateMDArray(name, axes, GDALExtendedDataType::Create(GDT_Int16), options.List());
  if (!component) throw std::runtime_error{"cannot write the variable " + name};

  component->SetRawNoDataValue(&missing);
  component->SetScale(step_m_s);
  component->SetOffset(0.0);
  add_text(*component, "standard_name", direction + "_sea_water_velocity");
  add_text(*component, "long_name", "synthetic " + direction + " sea water velocity, not for navigation");
  add_text(*component, "units", "m s-1");
  return component;
}

std::vector<std::int16_t> packed(const std::vector<double>& values, const std::vector<bool>& masked) {
  std::vector<std::int16_t> steps(values.size(), missing);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!masked[i]) steps[i] = static_cast<std::int16_t>(std::lround(values[i] / step_m_s));
  }
  return steps;
}

void write_slice(GDALMDArray& component, std::size_t time, std::size_t depth, const RasterFrame& frame,
                 const std::vector<std::int16_t>& values) {
  const std::array<GUInt64, 4> start{time, depth, 0, 0};
  const std::array<std::size_t, 4> count{1, 1, frame.rows, frame.columns};
  if (!component.Write(start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Int16),
                       values.data()))
    throw std::runtime_error{"cannot write currents: " + std::string{CPLGetLastErrorMsg()}};
}

}  // namespace

void write_currents(const std::filesystem::path& file, const CurrentFile& content) {
  ingest::register_drivers();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  if (driver == nullptr)
    throw std::runtime_error{"GDAL has no netCDF driver; install the package libgdal-dev"};
  CPLStringList options;
  options.SetNameValue("FORMAT", "NC4");
  const std::unique_ptr<GDALDataset> dataset{
      driver->CreateMultiDimensional(file.c_str(), nullptr, options.List())};
  if (!dataset) throw std::runtime_error{"cannot write " + file.string() + ": " + CPLGetLastErrorMsg()};

  const auto group = dataset->GetRootGroup();
  add_text(*group, "Conventions", "CF-1.8");
  add_text(*group, "title", content.title);
  add_text(*group, "comment", content.comment);
  add_text(*group, "source", "floeplan demo: computed from formulas, not measured and not forecast");
  add_text(*group, "license", "CC0-1.0");
  const Dimensions axes = add_axes(*group, content);
  const auto east = add_component(*group, axes, "uo", "eastward");
  const auto north = add_component(*group, axes, "vo", "northward");

  for (std::size_t time = 0; time < content.times.size(); ++time) {
    for (std::size_t depth = 0; depth < content.depth_m.size(); ++depth) {
      const CurrentLayer layer = content.layer(content.times[time], content.depth_m[depth]);
      write_slice(*east, time, depth, content.frame, packed(layer.flow.east, layer.masked));
      write_slice(*north, time, depth, content.frame, packed(layer.flow.north, layer.masked));
    }
  }
}

}  // namespace floeplan::demo
