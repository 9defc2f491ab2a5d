#include "tests/bench/ocean_file.hpp"

#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "storage/demo/cf_file.hpp"
#include "storage/demo/smooth_noise.hpp"

namespace floeplan::bench {
namespace {

constexpr std::uint64_t seed = 20261122;
constexpr double step_deg = 1.0 / 36.0;
constexpr double packed_step_m_s = 0.001;
constexpr std::int16_t packed_missing = -32767;
constexpr float missing = 1e20F;
constexpr double noise_m_s = 0.01;
constexpr std::size_t noise_count = 65'521;  // a prime, so that no two rows begin alike

std::vector<double> steps_from(double first, double step, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(first + step * static_cast<double>(i));
  return nodes;
}

std::vector<core::UtcTime> hours(std::size_t count) {
  std::vector<core::UtcTime> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(core::from_unix_seconds(1.8e9 + 3600.0 * static_cast<double>(i)));
  return times;
}

/// Generates slices of the two components, one after the other.
class Ocean {
 public:
  explicit Ocean(const OceanShape& shape) : shape_{shape} {
    std::mt19937_64 rng{seed};
    std::normal_distribution<double> gauss{0.0, noise_m_s};
    for (std::size_t i = 0; i < noise_count; ++i) noise_.push_back(static_cast<float>(gauss(rng)));
    const demo::SmoothNoise height{seed, 4};
    for (std::size_t row = 0; row < shape.rows; ++row)
      for (std::size_t column = 0; column < shape.columns; ++column)
        land_.push_back(height.at(0.008 * static_cast<double>(column), 0.008 * static_cast<double>(row)) >
                        0.25);
  }

  [[nodiscard]] std::vector<float> slice(std::size_t component, std::size_t time, std::size_t depth) {
    const double hour = static_cast<double>(time);
    const double fading = std::exp(-0.15 * static_cast<double>(depth));
    const auto along = wave(shape_.columns, 0.021, 2.0 * std::numbers::pi * hour / 12.42);
    const auto across = wave(shape_.rows, 0.034, 0.05 * hour + static_cast<double>(component));
    std::size_t noise = (component + 2 * (depth + shape_.depths * time)) * shape_.rows * shape_.columns;
    std::vector<float> values;
    values.reserve(land_.size());
    for (std::size_t row = 0; row < shape_.rows; ++row)
      for (std::size_t column = 0; column < shape_.columns; ++column, ++noise)
        values.push_back(land_[row * shape_.columns + column]
                             ? missing
                             : static_cast<float>(fading * 0.4 * along[column] * across[row]) +
                                   noise_[noise % noise_count]);
    return values;
  }

 private:
  static std::vector<double> wave(std::size_t count, double per_node, double phase) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < count; ++i)
      heights.push_back(std::sin(per_node * static_cast<double>(i) + phase));
    return heights;
  }

  OceanShape shape_;
  std::vector<bool> land_;
  std::vector<float> noise_;
};

std::shared_ptr<GDALMDArray> component_in(GDALGroup& group, const demo::CfDimensions& axes,
                                          const std::string& name, const std::string& direction,
                                          Numbers numbers) {
  const auto type = numbers == Numbers::full ? GDT_Float32 : GDT_Int16;
  auto array = group.CreateMDArray(name, axes, GDALExtendedDataType::Create(type));
  if (!array) throw std::runtime_error{"cannot write the variable " + name};
  if (numbers == Numbers::full) {
    array->SetRawNoDataValue(&missing);
  } else {
    array->SetRawNoDataValue(&packed_missing);
    array->SetScale(packed_step_m_s);
  }
  demo::add_cf_text(*array, "standard_name", direction + "_sea_water_velocity");
  demo::add_cf_text(*array, "units", "m s-1");
  return array;
}

void write(GDALMDArray& array, std::size_t time, std::size_t depth, const OceanShape& shape,
           const std::vector<float>& values, Numbers numbers) {
  const std::array<GUInt64, 4> start{time, depth, 0, 0};
  const std::array<std::size_t, 4> count{1, 1, shape.rows, shape.columns};
  std::vector<std::int16_t> steps;
  if (numbers == Numbers::packed)
    for (const float value : values)
      steps.push_back(value == missing ? packed_missing
                                       : static_cast<std::int16_t>(
                                             std::lround(static_cast<double>(value) / packed_step_m_s)));
  const bool is_full = numbers == Numbers::full;
  const void* const samples = is_full ? static_cast<const void*>(values.data()) : steps.data();
  if (!array.Write(start.data(), count.data(), nullptr, nullptr,
                   GDALExtendedDataType::Create(is_full ? GDT_Float32 : GDT_Int16), samples))
    throw std::runtime_error{"cannot write currents: " + std::string{CPLGetLastErrorMsg()}};
}

}  // namespace

void write_ocean(const std::filesystem::path& file, const OceanShape& shape, Numbers numbers) {
  const auto dataset = demo::create_cf_file(file, "benchmark", "no real currents");
  const auto group = dataset->GetRootGroup();
  const demo::CfDimensions axes{
      demo::add_time_axis(*group, hours(shape.times)),
      demo::add_axis(*group, "depth", steps_from(0.5, 10.0, shape.depths),
                     {{"standard_name", "depth"}, {"units", "m"}, {"positive", "down"}}),
      demo::add_axis(*group, "latitude", steps_from(50.0, step_deg, shape.rows),
                     {{"units", "degrees_north"}}),
      demo::add_axis(*group, "longitude", steps_from(-60.0, step_deg, shape.columns),
                     {{"units", "degrees_east"}})};
  const std::array arrays{component_in(*group, axes, "uo", "eastward", numbers),
                          component_in(*group, axes, "vo", "northward", numbers)};
  Ocean ocean{shape};
  for (std::size_t time = 0; time < shape.times; ++time)
    for (std::size_t depth = 0; depth < shape.depths; ++depth)
      for (std::size_t component = 0; component < arrays.size(); ++component)
        write(*arrays.at(component), time, depth, shape, ocean.slice(component, time, depth), numbers);
}

}  // namespace floeplan::bench
