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

/// Files that are read together: the components of a velocity may be in different ones, and so may the tables that
/// place them.
using NetcdfFiles = std::vector<std::shared_ptr<const NetcdfFile>>;

}  // namespace floeplan::ingest
