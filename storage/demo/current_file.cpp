#include "storage/demo/current_file.hpp"

#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "storage/demo/cf_file.hpp"

namespace floeplan::demo {
namespace {

constexpr double step_m_s = 0.0005;

std::shared_ptr<GDALMDArray> add_component(GDALGroup& group, const CfDimensions& axes,
                                           const std::string& name, const std::string& direction) {
  const auto component = add_packed(group, axes, {.name = name, .step = step_m_s});
  add_cf_text(*component, "standard_name", direction + "_sea_water_velocity");
  add_cf_text(*component, "long_name", "synthetic " + direction + " sea water velocity, not for navigation");
  add_cf_text(*component, "units", "m s-1");
  return component;
}

std::vector<std::int16_t> packed(const std::vector<double>& values, const std::vector<bool>& masked) {
  std::vector<std::int16_t> steps(values.size(), packed_missing);
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
  const std::unique_ptr<GDALDataset> dataset = create_cf_file(file, content.title, content.comment);
  const auto group = dataset->GetRootGroup();
  const CfDimensions axes{
      add_time_axis(*group, content.times),
      add_axis(*group, "depth", content.depth_m,
               {{"standard_name", "depth"}, {"units", "m"}, {"positive", "down"}, {"axis", "Z"}}),
      add_latitudes(*group, content.frame), add_longitudes(*group, content.frame)};
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
