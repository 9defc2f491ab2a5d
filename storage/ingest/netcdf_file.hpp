#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "storage/ingest/refusal.hpp"

class GDALDataset;
class GDALGroup;
class GDALMDArray;
class OGRSpatialReference;

namespace floeplan::ingest {

struct NetcdfDimension {
  std::string name;
  std::uint64_t size{};
};

/// One variable of a NetCDF file: what it says of itself, and its packed values.
class NetcdfVariable {
 public:
  NetcdfVariable(std::string name, std::shared_ptr<GDALMDArray> array, bool of_zarr);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<NetcdfDimension>& dimensions() const { return dimensions_; }
  /// Text of an attribute, trimmed; empty when it is absent.
  [[nodiscard]] std::string attribute(const std::string& name) const;
  [[nodiscard]] std::optional<double> numeric_attribute(const std::string& name) const;
  /// All numbers of an attribute such as flag_values; empty when it is absent or a text.
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const;
  [[nodiscard]] bool is_float32() const;
  [[nodiscard]] bool is_numeric() const;
  /// The CRS its grid mapping describes; null when there is none.
  [[nodiscard]] std::shared_ptr<OGRSpatialReference> crs() const;

  /// Packed values (no scale, no fill) of the block that starts at `start` and has `count` values along each
  /// dimension.
  /// Shape    row-major in the order of dimensions()
  [[nodiscard]] Checked<std::vector<double>> read_packed(const std::vector<std::uint64_t>& start,
                                                         const std::vector<std::size_t>& count) const;
  /// All values of a small variable (coordinates), scale and offset applied, fill as NaN.
  [[nodiscard]] Checked<std::vector<double>> read_all() const;
  /// All texts of a variable of characters, trimmed; empty of numbers, of a text without dimensions, of over 1000
  /// texts.
  [[nodiscard]] std::vector<std::string> texts() const;
  /// What a packed value stands for: scale and offset applied; NaN where it is the fill or the missing value.
  /// The fill is compared with the packed value, in the variable's own precision.
  [[nodiscard]] double unpacked(double packed) const;
  /// The same of many.
  void unpack(std::span<double> values) const;
  /// Takes a value that the file does not declare, unpacked, for a mark of what is missing.
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

/// An open NetCDF file (any variant) or Zarr store, seen through its root group or another one. Coordinates are never
/// taken from GDAL's own guesses. A variable whose last dimension is called "two" holds both components of a vector, as
/// SCHISM writes them: hvel becomes the two variables hvel[0] and hvel[1].
/// Threads  one thread at a time
class NetcdfFile {
 public:
  /// `also_missing`  a value that marks what is missing in fields, though not in axes and tables of positions
  /// Errors          GDAL's own words when it cannot open the file
  [[nodiscard]] static Checked<NetcdfFile> open(const std::filesystem::path& file,
                                                std::optional<double> also_missing = std::nullopt);

  [[nodiscard]] const std::vector<NetcdfVariable>& variables() const { return variables_; }
  /// All groups below the root ("/ocean", "/ocean/daily"), each before those below it; also of a file seen from one.
  [[nodiscard]] const std::vector<std::string>& groups() const { return groups_; }
  /// The file through one of those: its variables, then those of the groups round it that nothing of it hides.
  /// Source  CF conventions 1.8, section 2.7, scope of groups
  [[nodiscard]] NetcdfFile seen_from(const std::string& group) const;
  /// One of those groups alone, without what it sees of the groups round it.
  [[nodiscard]] NetcdfFile only(const std::string& group) const;
  /// Null when there is none.
  [[nodiscard]] const NetcdfVariable* find(const std::string& name) const;
  /// What the file states of itself as a whole, trimmed; empty when it does not.
  [[nodiscard]] std::string attribute(const std::string& name) const;
  /// A number that it states so.
  [[nodiscard]] std::optional<double> numeric_attribute(const std::string& name) const;

 private:
  [[nodiscard]] NetcdfFile seen_through(std::span<const std::shared_ptr<GDALGroup>> groups) const;
  void add_variables_of(GDALGroup& group);
  void list_groups_below(const GDALGroup& group, const std::string& path, std::size_t depth);

  std::shared_ptr<GDALDataset> dataset_;
  bool is_zarr_{false};
  std::optional<double> also_missing_;
  std::map<std::string, std::string> attributes_;
  std::vector<NetcdfVariable> variables_;
  std::vector<std::string> groups_;
};

}  // namespace floeplan::ingest
