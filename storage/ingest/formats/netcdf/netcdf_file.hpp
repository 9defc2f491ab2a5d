#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_variable.hpp"

class GDALDataset;
class GDALGroup;

namespace floeplan::ingest {

/// An open NetCDF file (any variant) or Zarr store, seen from its root group or from another group. GDAL's
/// guesses of the coordinates are not used. A variable whose last dimension is called "two" holds both
/// components of a vector, as SCHISM writes them: hvel becomes the two variables hvel[0] and hvel[1].
/// Threads  one thread at a time
class NetcdfFile {
 public:
  /// `also_missing`  a further value for missing data; it applies to fields, not to axes or tables of
  ///                 positions
  /// Errors          GDAL's own words when it cannot open the file
  [[nodiscard]] static Checked<NetcdfFile> open(const std::filesystem::path& file,
                                                std::optional<double> also_missing = std::nullopt);

  [[nodiscard]] const std::vector<NetcdfVariable>& variables() const { return variables_; }
  /// All groups below the root ("/ocean", "/ocean/daily"), each before its subgroups; the same from whichever
  /// group it is seen.
  [[nodiscard]] const std::vector<std::string>& groups() const { return groups_; }
  /// The file seen from a group: the group's variables, and those of its parent groups that they do not hide.
  /// Source  CF conventions 1.8, section 2.7, scope of groups
  [[nodiscard]] NetcdfFile seen_from(const std::string& group) const;
  /// One of those groups alone, without the variables of its parent groups.
  [[nodiscard]] NetcdfFile only(const std::string& group) const;
  /// The variable with this name; null if there is none.
  [[nodiscard]] const NetcdfVariable* find(const std::string& name) const;
  /// A global attribute as text, trimmed; empty if the file does not have it.
  [[nodiscard]] std::string attribute(const std::string& name) const;
  /// A numeric global attribute.
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

/// Files that are read together: the components of a velocity and the tables of positions may be in different
/// files.
using NetcdfFiles = std::vector<std::shared_ptr<const NetcdfFile>>;

}  // namespace floeplan::ingest
