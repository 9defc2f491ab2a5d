#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class GDALMDArray;
class OGRSpatialReference;

namespace floeplan::ingest {

struct NetcdfDimension {
  std::string name;
  std::uint64_t size{};
};

/// One variable of a NetCDF file: its attributes and its packed values.
class NetcdfVariable {
 public:
  NetcdfVariable(std::string name, std::shared_ptr<GDALMDArray> array, bool of_zarr);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<NetcdfDimension>& dimensions() const { return dimensions_; }
  /// Index of the dimension with this name; empty if there is none.
  [[nodiscard]] std::optional<std::size_t> dimension_named(std::string_view name) const;
  /// Text of an attribute, trimmed; empty when it is absent.
  [[nodiscard]] std::string attribute(const std::string& name) const;
  [[nodiscard]] std::optional<double> numeric_attribute(const std::string& name) const;
  /// All numbers of an attribute such as flag_values; empty when it is absent or a text.
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const;
  [[nodiscard]] bool is_float32() const;
  [[nodiscard]] bool is_numeric() const;
  /// The CRS that its grid mapping describes; null if there is none.
  [[nodiscard]] std::shared_ptr<OGRSpatialReference> crs() const;

  /// Packed values (no scale, no fill) of the block that starts at `start` and has `count` values along each
  /// dimension.
  /// Shape    row-major in the order of dimensions()
  [[nodiscard]] Checked<std::vector<double>> read_packed(const std::vector<std::uint64_t>& start,
                                                         const std::vector<std::size_t>& count) const;
  /// All values of a small variable (coordinates), scale and offset applied, fill as NaN.
  [[nodiscard]] Checked<std::vector<double>> read_all() const;
  /// All texts of a variable of characters, trimmed. Empty if it is numeric, has no dimensions or holds more
  /// than 1000 texts.
  [[nodiscard]] std::vector<std::string> texts() const;
  /// The value of a packed number: scale and offset applied; NaN for the fill value or the missing value.
  /// The fill is compared with the packed value, in the variable's own precision.
  [[nodiscard]] double unpacked(double packed) const;
  /// Unpacks many values in place.
  void unpack(std::span<double> values) const;
  /// Adds an unpacked value that counts as missing although the file does not declare it.
  void also_missing(double value) { also_missing_.push_back(value); }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double offset() const { return offset_; }

 private:
  template <class Number>
  [[nodiscard]] Checked<std::vector<double>> read_as(const std::vector<std::uint64_t>& start,
                                                     const std::vector<std::size_t>& count) const;

  std::string name_;
  std::shared_ptr<GDALMDArray> array_;
  std::vector<NetcdfDimension> dimensions_;
  std::map<std::string, std::string> attributes_;
  std::map<std::string, std::vector<double>> numbers_;
  std::vector<double> fills_;
  std::vector<double> also_missing_;  // unpacked
  double scale_{1.0};
  double offset_{0.0};
};

}  // namespace floeplan::ingest
