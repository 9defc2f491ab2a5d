#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/hdf5/hdf5_references.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/zarr/zarr3_view.hpp"
#include "storage/ingest/formats/zarr/zarr_store.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

/// The name to give to GDAL. GDAL 3.6 recognises the classic format with 64-bit numbers (CDF-5) only with a
/// prefix.
std::string name_for_gdal(const std::filesystem::path& file) {
  const std::string path = std::filesystem::absolute(file).string();
  return first_bytes(file, 4) == "CDF\x05" ? "NETCDF:\"" + path + "\"" : path;
}

/// A group and its parent groups, innermost first, the root last; contains a null first if there is no such
/// group.
std::vector<std::shared_ptr<GDALGroup>> way_out(std::shared_ptr<GDALGroup> root, const std::string& path) {
  std::vector<std::shared_ptr<GDALGroup>> way{std::move(root)};
  std::istringstream names{path.substr(1)};
  for (std::string name; way.back() && std::getline(names, name, '/');)
    way.push_back(way.back()->OpenGroup(name));
  std::ranges::reverse(way);
  return way;
}

}  // namespace

Checked<NetcdfFile> NetcdfFile::open(const std::filesystem::path& file, std::optional<double> also_missing) {
  register_drivers();
  const GdalMessages messages;
  const bool is_zarr = std::filesystem::is_directory(file);
  if (!is_zarr)
    if (const auto checked = check_hdf5_references(file); !checked) return refuse(checked.error());
  const char* const drivers[] = {is_zarr ? "Zarr" : "netCDF", nullptr};
  const std::string path =
      is_zarr ? (is_zarr3(file) ? zarr3_view(file) : std::filesystem::absolute(file).string())
              : name_for_gdal(file);
  NetcdfFile result;
  result.dataset_.reset(
      GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_VERBOSE_ERROR, drivers));
  const auto root = result.dataset_ ? result.dataset_->GetRootGroup() : nullptr;
  if (!root)
    return refuse(messages::ingest_file_message<"file-damaged">(is_zarr ? "Zarr store" : "NetCDF file",
                                                                messages.first_error()));

  result.is_zarr_ = is_zarr;
  result.also_missing_ = also_missing;
  result.list_groups_below(*root, "", 0);
  result.add_variables_of(*root);
  return result;
}

NetcdfFile NetcdfFile::seen_from(const std::string& group) const {
  return seen_through(way_out(dataset_->GetRootGroup(), group));
}

NetcdfFile NetcdfFile::only(const std::string& group) const {
  const auto groups = way_out(dataset_->GetRootGroup(), group);
  return seen_through(std::span{groups}.first(1));
}

NetcdfFile NetcdfFile::seen_through(std::span<const std::shared_ptr<GDALGroup>> groups) const {
  NetcdfFile result;
  result.dataset_ = dataset_;
  result.is_zarr_ = is_zarr_;
  result.also_missing_ = also_missing_;
  result.groups_ = groups_;
  for (const auto& group : groups)
    if (group) result.add_variables_of(*group);
  return result;
}

void NetcdfFile::add_variables_of(GDALGroup& group) {
  for (const auto& attribute : group.GetAttributes())
    if (const char* text = attribute->ReadAsString())
      attributes_.emplace(attribute->GetName(), trimmed(text));

  // A parent's variable is hidden if the group has a variable of its name, or one of its dimensions with
  // another length.
  std::map<std::string, std::uint64_t> sizes;
  for (const NetcdfVariable& variable : variables_)
    for (const NetcdfDimension& dimension : variable.dimensions())
      sizes.emplace(dimension.name, dimension.size);
  const auto is_hidden = [&](const NetcdfVariable& variable) {
    return find(variable.name()) != nullptr ||
           std::ranges::any_of(variable.dimensions(), [&](const NetcdfDimension& dimension) {
             const auto found = sizes.find(dimension.name);
             return found != sizes.end() && found->second != dimension.size;
           });
  };
  std::vector<NetcdfVariable> found;
  const char* const scalars_too[] = {"SHOW_ZERO_DIM=YES", nullptr};
  for (const std::string& name : group.GetMDArrayNames(const_cast<char**>(scalars_too))) {
    auto array = group.OpenMDArray(name);
    if (!array) continue;
    NetcdfVariable variable{name, array, is_zarr_};
    if (is_hidden(variable)) continue;
    found.push_back(std::move(variable));
    const auto& dimensions = found.back().dimensions();
    if (dimensions.size() < 2 || dimensions.back().name != "two" || dimensions.back().size != 2) continue;
    for (const char* const part : {"[0]", "[1]"})
      if (auto component = array->GetView(std::string{"[...,"} + part[1] + "]"))
        found.emplace_back(name + part, std::move(component), is_zarr_);
  }
  for (NetcdfVariable& variable : found) {
    const AxisRole role = role_of(variable);
    const bool position = role == AxisRole::longitude || role == AxisRole::latitude;
    if (also_missing_ && variable.dimensions().size() >= 2 && !position)
      variable.also_missing(*also_missing_);
    variables_.push_back(std::move(variable));
  }
}

void NetcdfFile::list_groups_below(const GDALGroup& group, const std::string& path, std::size_t depth) {
  constexpr std::size_t deepest = 8;
  constexpr std::size_t most_groups = 1000;
  if (depth == deepest) return;
  for (const std::string& name : group.GetGroupNames()) {
    const auto below = group.OpenGroup(name);
    if (!below || groups_.size() == most_groups) continue;
    // a copy, because groups_ grows in the call and would invalidate a reference to its last element
    const std::string path_below = path + "/" + name;
    groups_.push_back(path_below);
    list_groups_below(*below, path_below, depth + 1);
  }
}

std::string NetcdfFile::attribute(const std::string& name) const {
  const auto found = attributes_.find(name);
  return found == attributes_.end() ? std::string{} : found->second;
}

std::optional<double> NetcdfFile::numeric_attribute(const std::string& name) const {
  return parse_number(attribute(name));
}

const NetcdfVariable* NetcdfFile::find(const std::string& name) const {
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [&](const auto& variable) { return variable.name() == name; });
  return found == variables_.end() ? nullptr : &*found;
}

}  // namespace floeplan::ingest
