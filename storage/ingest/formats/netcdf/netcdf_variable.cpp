#include "storage/ingest/formats/netcdf/netcdf_variable.hpp"

#include <gdal_priv.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/common/in_blocks.hpp"
#include "storage/ingest/notation/text.hpp"

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
  // Zarr states a fill value only here. The netCDF driver must not be asked for it: if the attribute's type
  // is wider than the variable's, GDAL 3.6 writes past the end of its buffer; otherwise it may change the
  // number.
  if (of_zarr && fills_.empty()) {
    bool stated = false;
    const double no_data = array_->GetNoDataValueAsDouble(&stated);
    if (stated) fills_.push_back(no_data);
  }
  // Some versions of GDAL do not list the unit of a variable that counts from a date among its attributes.
  if (!array_->GetUnit().empty()) attributes_.emplace("units", trimmed(array_->GetUnit()));

  bool given = false;
  const double scale = array_->GetScale(&given);
  if (given) scale_ = scale;
  const double offset = array_->GetOffset(&given);
  if (given) offset_ = offset;
}

std::optional<std::size_t> NetcdfVariable::dimension_named(std::string_view name) const {
  for (std::size_t i = 0; i < dimensions_.size(); ++i)
    if (dimensions_[i].name == name) return i;
  return std::nullopt;
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
  // The values are read in their own type: GDAL's conversion is three times slower than this program's.
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
    return refuse(messages::ingest_netcdf_message<"variable-unreadable">(name_, messages.first_error()));
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
      return refuse(
          messages::ingest_netcdf_message<"coordinate-too-long">(name_, dimension.size, dimension.name));
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
  // For a text without dimensions GDAL 3.6 returns the bytes of its address.
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
      const double rounding = 1e-6 * std::abs(mark);  // rounding by single precision and by scaling
      for (std::size_t i = 0; i < count; ++i)
        some[i] = std::abs(some[i] - mark) <= rounding ? missing : some[i];
    }
  });
}

}  // namespace floeplan::ingest
