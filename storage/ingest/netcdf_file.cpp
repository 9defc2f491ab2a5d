#include "storage/ingest/netcdf_file.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <type_traits>

#include "storage/ingest/first_bytes.hpp"
#include "storage/ingest/gdal_guard.hpp"
#include "storage/ingest/hdf5_references.hpp"
#include "storage/ingest/in_blocks.hpp"
#include "storage/ingest/netcdf_axis.hpp"
#include "storage/ingest/text.hpp"
#include "storage/ingest/zarr3_view.hpp"
#include "storage/ingest/zarr_store.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t max_coordinate_values = 50'000'000;

template <class Number>
constexpr GDALDataType gdal_type = GDT_Float64;
template <>
constexpr GDALDataType gdal_type<float> = GDT_Float32;
template <>
constexpr GDALDataType gdal_type<std::int16_t> = GDT_Int16;
template <>
constexpr GDALDataType gdal_type<std::int32_t> = GDT_Int32;

/// GDAL 3.6 takes the classic format with 64-bit numbers (CDF-5) for NetCDF only when it is told so.
std::string name_for_gdal(const std::filesystem::path& file) {
  const std::string path = std::filesystem::absolute(file).string();
  return first_bytes(file, 4) == "CDF\x05" ? "NETCDF:\"" + path + "\"" : path;
}

/// The group and those round it, up to the root; null where there is none of the name.
std::vector<std::shared_ptr<GDALGroup>> way_out(std::shared_ptr<GDALGroup> root, const std::string& path) {
  std::vector<std::shared_ptr<GDALGroup>> way{std::move(root)};
  std::istringstream names{path.substr(1)};
  for (std::string name; way.back() && std::getline(names, name, '/');)
    way.push_back(way.back()->OpenGroup(name));
  std::ranges::reverse(way);
  return way;
}

}  // namespace

NetcdfVariable::NetcdfVariable(std::string name, std::shared_ptr<GDALMDArray> array, bool of_zarr)
    : name_{std::move(name)}, array_{std::move(array)} {
  for (const auto& dimension : array_->GetDimensions())
    dimensions_.push_back({dimension->GetName(), dimension->GetSize()});

  const char* const everything[] = {"SHOW_ALL=YES", nullptr};
  for (const auto& attribute : array_->GetAttributes(const_cast<char**>(everything))) {
    const char* text = attribute->ReadAsString();
    if (text != nullptr) attributes_.emplace(attribute->GetName(), trimmed(text));
    if (attribute->GetDataType().GetClass() == GEDTC_NUMERIC)
      numbers_.emplace(attribute->GetName(), attribute->ReadAsDoubleArray());
    if (attribute->GetName() != "_FillValue" && attribute->GetName() != "missing_value") continue;
    for (const double fill : attribute->ReadAsDoubleArray())
      fills_.push_back(is_float32() ? static_cast<double>(static_cast<float>(fill)) : fill);
  }
  // Zarr states a fill there alone. The netCDF driver must not be asked: where the type of the attribute is wider than
  // the variable's, GDAL 3.6 writes it past the end of its buffer, and else casts it to another number.
  if (of_zarr && fills_.empty()) {
    bool stated = false;
    const double no_data = array_->GetNoDataValueAsDouble(&stated);
    if (stated) fills_.push_back(no_data);
  }
  // The unit of a variable that counts since a date is not among GDAL's attributes in every version.
  if (!array_->GetUnit().empty()) attributes_.emplace("units", trimmed(array_->GetUnit()));

  bool given = false;
  const double scale = array_->GetScale(&given);
  if (given) scale_ = scale;
  const double offset = array_->GetOffset(&given);
  if (given) offset_ = offset;
}

std::string NetcdfVariable::attribute(const std::string& name) const {
  const auto found = attributes_.find(name);
  return found == attributes_.end() ? std::string{} : found->second;
}

std::optional<double> NetcdfVariable::numeric_attribute(const std::string& name) const {
  return parse_number(attribute(name));
}

std::vector<double> NetcdfVariable::numbers(const std::string& name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? std::vector<double>{} : found->second;
}

bool NetcdfVariable::is_float32() const { return array_->GetDataType().GetNumericDataType() == GDT_Float32; }

bool NetcdfVariable::is_numeric() const { return array_->GetDataType().GetClass() == GEDTC_NUMERIC; }

std::shared_ptr<OGRSpatialReference> NetcdfVariable::crs() const { return array_->GetSpatialRef(); }

Checked<std::vector<double>> NetcdfVariable::read_packed(const std::vector<std::uint64_t>& start,
                                                         const std::vector<std::size_t>& count) const {
  // GDAL converts number by number, three times as slowly as this program does.
  switch (array_->GetDataType().GetNumericDataType()) {
    case GDT_Int16: return read_as<std::int16_t>(start, count);
    case GDT_Int32: return read_as<std::int32_t>(start, count);
    case GDT_Float32: return read_as<float>(start, count);
    default: return read_as<double>(start, count);
  }
}

template <class Number>
Checked<std::vector<double>> NetcdfVariable::read_as(const std::vector<std::uint64_t>& start,
                                                     const std::vector<std::size_t>& count) const {
  std::size_t size = 1;
  for (const std::size_t n : count) size *= n;
  std::vector<Number> values(size);
  const GdalMessages messages;
  const std::vector<GUInt64> first(start.begin(), start.end());
  if (!array_->Read(first.data(), count.data(), nullptr, nullptr,
                    GDALExtendedDataType::Create(gdal_type<Number>), values.data()))
    return refuse("the variable \"" + name_ + "\" cannot be read to its end (" + messages.first_error() +
                  "); the file is damaged or was cut short; copy or download it again");
  if constexpr (std::is_same_v<Number, double>) {
    return values;
  } else {
    return std::vector<double>(values.begin(), values.end());
  }
}

Checked<std::vector<double>> NetcdfVariable::read_all() const {
  std::vector<std::uint64_t> start;
  std::vector<std::size_t> count;
  std::uint64_t size = 1;
  for (const NetcdfDimension& dimension : dimensions_) {
    if (dimension.size == 0 || dimension.size > max_coordinate_values / size)
      return refuse("the variable \"" + name_ + "\" has " + std::to_string(dimension.size) +
                    " values along \"" + dimension.name +
                    "\", which no coordinate has; the file is damaged; copy or download it again");
    size *= dimension.size;
    start.push_back(0);
    count.push_back(static_cast<std::size_t>(dimension.size));
  }
  auto values = read_packed(start, count);
  if (values) unpack(*values);
  return values;
}

std::vector<std::string> NetcdfVariable::texts() const {
  constexpr std::uint64_t most = 1000;
  if (array_->GetDataType().GetClass() != GEDTC_STRING) return {};
  // Of a text without dimensions GDAL 3.6 gives the bytes of its address.
  if (dimensions_.empty()) return {};
  std::uint64_t size = 1;
  std::vector<GUInt64> start;
  std::vector<std::size_t> count;
  for (const NetcdfDimension& dimension : dimensions_) {
    if (dimension.size == 0 || dimension.size > most / size) return {};
    size *= dimension.size;
    start.push_back(0);
    count.push_back(static_cast<std::size_t>(dimension.size));
  }
  std::vector<char*> raw(static_cast<std::size_t>(size), nullptr);
  const GdalMessages messages;
  const bool read = array_->Read(start.data(), count.data(), nullptr, nullptr,
                                 GDALExtendedDataType::CreateString(), static_cast<void*>(raw.data()));
  std::vector<std::string> result;
  for (char* text : raw) {
    if (read && text != nullptr) result.push_back(trimmed(text));
    CPLFree(text);
  }
  return result;
}

double NetcdfVariable::unpacked(double packed) const {
  unpack({&packed, 1});
  return packed;
}

void NetcdfVariable::unpack(std::span<double> values) const {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  constexpr double largest = std::numeric_limits<double>::max();
  const double scale = scale_;
  const double offset = offset_;
  in_blocks(values.size(), [&](std::size_t first, auto count) {
    double* const some = values.data() + first;
    for (const double fill : fills_)
      for (std::size_t i = 0; i < count; ++i) some[i] = some[i] == fill ? missing : some[i];
    for (std::size_t i = 0; i < count; ++i) {
      const double whole = some[i] * scale + offset;
      some[i] = std::abs(some[i]) <= largest ? whole : missing;
    }
    for (const double mark : also_missing_) {
      const double rounding = 1e-6 * std::abs(mark);  // of single precision, and of scaling
      for (std::size_t i = 0; i < count; ++i)
        some[i] = std::abs(some[i] - mark) <= rounding ? missing : some[i];
    }
  });
}

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
    return refuse("the " + std::string{is_zarr ? "Zarr store" : "NetCDF file"} + " cannot be opened (" +
                  messages.first_error() + "); it is damaged or was cut short; copy or download it again");

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

  // What a group round this one calls by the name of a variable or of a dimension of another length is hidden.
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
    const std::string path_below = path + "/" + name;  // not groups_.back(): the list grows below
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
