#include "storage/demo/ice_file.hpp"

#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "storage/demo/cf_file.hpp"

namespace floeplan::demo {
namespace {

constexpr double step_of_concentration = 1e-4;
constexpr double step_of_thickness_m = 1e-3;

void write_ice_slice(GDALMDArray& array, std::size_t time, const RasterFrame& frame,
                     const std::vector<double>& values, const std::vector<bool>& masked, double step) {
  std::vector<std::int16_t> packed(values.size(), packed_missing);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!masked[i]) packed[i] = static_cast<std::int16_t>(std::lround(values[i] / step));
  }
  const std::array<GUInt64, 3> start{time, 0, 0};
  const std::array<std::size_t, 3> count{1, frame.rows, frame.columns};
  if (!array.Write(start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Int16),
                   packed.data()))
    throw std::runtime_error{"cannot write sea ice: " + std::string{CPLGetLastErrorMsg()}};
}

}  // namespace

void write_ice(const std::filesystem::path& file, const IceFile& content) {
  const std::unique_ptr<GDALDataset> dataset = create_cf_file(file, content.title, content.comment);
  const auto group = dataset->GetRootGroup();
  const CfDimensions axes{add_time_axis(*group, content.times), add_latitudes(*group, content.frame),
                          add_longitudes(*group, content.frame)};
  const auto concentration = add_packed(*group, axes, {.name = "siconc", .step = step_of_concentration});
  add_cf_text(*concentration, "standard_name", "sea_ice_area_fraction");
  add_cf_text(*concentration, "long_name", "synthetic sea ice concentration, not for navigation");
  add_cf_text(*concentration, "units", "1");
  const auto thickness = add_packed(*group, axes, {.name = "sithick", .step = step_of_thickness_m});
  add_cf_text(*thickness, "standard_name", "sea_ice_thickness");
  add_cf_text(*thickness, "long_name", "synthetic sea ice thickness, not for navigation");
  add_cf_text(*thickness, "units", "m");

  for (std::size_t time = 0; time < content.times.size(); ++time) {
    const IceLayer layer = content.layer(content.times[time]);
    write_ice_slice(*concentration, time, content.frame, layer.concentration, layer.masked,
                    step_of_concentration);
    write_ice_slice(*thickness, time, content.frame, layer.thickness_m, layer.masked, step_of_thickness_m);
  }
}

}  // namespace floeplan::demo
