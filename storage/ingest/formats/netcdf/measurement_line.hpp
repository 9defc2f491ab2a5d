#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/formats/netcdf/quality_flags.hpp"

namespace floeplan::ingest {

/// A variable of a NetCDF file with values along a single dimension, and its quality flags. Further
/// dimensions have length 1.
class MeasurementLine {
 public:
  /// Empty if the variable is null, not numeric or a scalar, or has several dimensions longer than 1.
  [[nodiscard]] static std::optional<MeasurementLine> of(const NetcdfFile& file,
                                                         const NetcdfVariable* variable);

  [[nodiscard]] const NetcdfVariable& variable() const { return *variable_; }
  [[nodiscard]] const std::string& dimension() const { return variable_->dimensions()[axis_].name; }
  [[nodiscard]] std::uint64_t size() const { return variable_->dimensions()[axis_].size; }
  /// `count` values from `first` on; NaN where a value is missing or its flags forbid its use.
  /// Errors   the file was cut short
  [[nodiscard]] Checked<std::vector<double>> read(std::uint64_t first, std::size_t count) const;

 private:
  [[nodiscard]] Checked<std::vector<double>> packed(const NetcdfVariable& variable, std::uint64_t first,
                                                    std::size_t count) const;

  const NetcdfVariable* variable_{};
  std::size_t axis_{};
  std::vector<QualityFlags> flags_;
};

/// The first variable with one of the names, in upper or lower case; otherwise one with one of the standard
/// names; or null.
[[nodiscard]] const NetcdfVariable* find_measured(const NetcdfFile& file,
                                                  const std::vector<std::string_view>& names,
                                                  const std::vector<std::string_view>& standard_names);

}  // namespace floeplan::ingest
