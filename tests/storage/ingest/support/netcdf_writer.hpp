#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class GDALDataset;
class GDALDimension;
class GDALGroup;

namespace floeplan::ingest {

/// Writes small NetCDF-4 files for tests.
class NetcdfWriter {
 public:
  enum class Type { int16, int32, float32, float64 };

  struct Variable {
    std::string name;
    std::vector<std::string> dimensions;
    std::vector<double> values;  // packed, row-major
    std::map<std::string, std::string> texts;
    std::map<std::string, double> numbers;  // scale_factor, add_offset, missing_value, ...
    std::optional<double> fill;             // _FillValue
    Type type{Type::float32};
    std::map<std::string, std::vector<double>> lists{};  // flag_values, valid_range, ...
  };

  explicit NetcdfWriter(const std::filesystem::path& file);
  ~NetcdfWriter();

  /// Enters a group of the present one, created if missing; everything written afterwards is in it.
  void enter(const std::string& group);
  /// Returns to the top level.
  void leave_groups();
  void dimension(const std::string& name, std::size_t size);
  void variable(const Variable& variable);
  /// Writes a variable with a single text.
  void text(const std::string& name, const std::string& value);
  /// Writes a global attribute.
  void attribute(const std::string& name, const std::string& value);
  /// Writes a dimension and its coordinate variable.
  void axis(const std::string& name, const std::vector<double>& values,
            std::map<std::string, std::string> texts);

 private:
  std::unique_ptr<GDALDataset> dataset_;
  std::shared_ptr<GDALGroup> group_;
  std::map<std::string, std::shared_ptr<GDALDimension>> dimensions_;
};

/// A file of currents with a few times, latitudes and longitudes, which tests change.
struct CurrentFile {
  std::vector<double> lons{0.0, 1.0, 2.0, 3.0};
  std::vector<double> lats{50.0, 51.0, 52.0};
  std::vector<double> depths;  // empty: no depth dimension
  std::vector<double> times{0.0, 6.0};
  std::map<std::string, std::string> lon_texts{{"units", "degrees_east"}};
  std::map<std::string, std::string> lat_texts{{"units", "degrees_north"}};
  std::map<std::string, std::string> depth_texts{
      {"units", "m"}, {"positive", "down"}, {"standard_name", "depth"}};
  std::map<std::string, std::string> time_texts{{"units", "hours since 2026-11-20 00:00:00"}};
  std::map<std::string, std::string> u_texts{{"units", "m s-1"},
                                             {"standard_name", "eastward_sea_water_velocity"}};
  std::map<std::string, std::string> v_texts{{"units", "m s-1"},
                                             {"standard_name", "northward_sea_water_velocity"}};
  std::map<std::string, double> numbers;
  std::optional<double> fill;
  NetcdfWriter::Type type{NetcdfWriter::Type::float64};
  std::string u_name{"uo"};
  std::string v_name{"vo"};
  std::vector<std::string> order{"time", "depth", "lat", "lon"};  // "depth" is left out when there are none
  bool with_north{true};
  std::optional<std::string> title{};
  /// Packed value of a component ('u', 'v') for the indices of time, depth, latitude and longitude, with the
  /// axes above.
  std::function<double(char, std::size_t, std::size_t, std::size_t, std::size_t)> value{
      [](char component, std::size_t t, std::size_t z, std::size_t y, std::size_t x) {
        return 0.001 * static_cast<double>(1000 * t + 100 * z + 10 * y + x + 1) *
               (component == 'u' ? 1.0 : -1.0) * 0.1;
      }};

  void write(const std::filesystem::path& file) const;
};

}  // namespace floeplan::ingest
