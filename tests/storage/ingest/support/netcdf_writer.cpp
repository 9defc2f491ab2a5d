#include "tests/storage/ingest/support/netcdf_writer.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::ingest {
namespace {

GDALDataType gdal_type(NetcdfWriter::Type type) {
  switch (type) {
    case NetcdfWriter::Type::int16: return GDT_Int16;
    case NetcdfWriter::Type::int32: return GDT_Int32;
    case NetcdfWriter::Type::float32: return GDT_Float32;
    case NetcdfWriter::Type::float64: return GDT_Float64;
  }
  throw std::logic_error{"unknown type"};
}

void require(bool done) {
  if (!done) throw std::runtime_error{"the test's NetCDF file could not be written"};
}

}  // namespace

NetcdfWriter::NetcdfWriter(const std::filesystem::path& file) {
  register_drivers();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  require(driver != nullptr);
  dataset_.reset(driver->CreateMultiDimensional(file.c_str(), nullptr, nullptr));
  require(dataset_ != nullptr);
  leave_groups();
}

NetcdfWriter::~NetcdfWriter() = default;

void NetcdfWriter::enter(const std::string& group) {
  const auto there = group_->OpenGroup(group);
  group_ = there ? there : group_->CreateGroup(group);
  require(group_ != nullptr);
}

void NetcdfWriter::leave_groups() { group_ = dataset_->GetRootGroup(); }

void NetcdfWriter::dimension(const std::string& name, std::size_t size) {
  dimensions_[name] = group_->CreateDimension(name, "", "", size);
  require(dimensions_[name] != nullptr);
}

void NetcdfWriter::variable(const Variable& variable) {
  std::vector<std::shared_ptr<GDALDimension>> dimensions;
  std::vector<GUInt64> start;
  std::vector<std::size_t> count;
  for (const std::string& name : variable.dimensions) {
    dimensions.push_back(dimensions_.at(name));
    start.push_back(0);
    count.push_back(static_cast<std::size_t>(dimensions.back()->GetSize()));
  }
  const auto array = group_->CreateMDArray(variable.name, dimensions,
                                           GDALExtendedDataType::Create(gdal_type(variable.type)));
  require(array != nullptr);
  if (variable.fill) require(array->SetNoDataValue(*variable.fill));
  for (const auto& [name, text] : variable.texts) {
    const auto attribute = array->CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
    require(attribute != nullptr && attribute->Write(text.c_str()));
  }
  for (const auto& [name, number] : variable.numbers) {
    const auto attribute = array->CreateAttribute(name, {}, GDALExtendedDataType::Create(GDT_Float64));
    require(attribute != nullptr && attribute->Write(number));
  }
  for (const auto& [name, numbers] : variable.lists) {
    const auto attribute =
        array->CreateAttribute(name, {numbers.size()}, GDALExtendedDataType::Create(GDT_Float64));
    require(attribute != nullptr && attribute->Write(numbers.data(), numbers.size()));
  }
  if (variable.values.empty()) return;
  require(array->Write(start.data(), count.data(), nullptr, nullptr,
                       GDALExtendedDataType::Create(GDT_Float64), variable.values.data()));
}

void NetcdfWriter::text(const std::string& name, const std::string& value) {
  const auto array = group_->CreateMDArray(name, {}, GDALExtendedDataType::CreateString());
  const char* const raw[] = {value.c_str()};
  require(array != nullptr &&
          array->Write(nullptr, nullptr, nullptr, nullptr, GDALExtendedDataType::CreateString(), raw));
}

void NetcdfWriter::attribute(const std::string& name, const std::string& value) {
  const auto attribute = group_->CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
  require(attribute != nullptr && attribute->Write(value.c_str()));
}

void NetcdfWriter::axis(const std::string& name, const std::vector<double>& values,
                        std::map<std::string, std::string> texts) {
  dimension(name, values.size());
  variable({.name = name,
            .dimensions = {name},
            .values = values,
            .texts = std::move(texts),
            .numbers = {},
            .fill = std::nullopt,
            .type = Type::float64});
}

void CurrentFile::write(const std::filesystem::path& file) const {
  NetcdfWriter writer{file};
  if (title) writer.attribute("title", *title);
  writer.axis("time", times, time_texts);
  if (!depths.empty()) writer.axis("depth", depths, depth_texts);
  writer.axis("lat", lats, lat_texts);
  writer.axis("lon", lons, lon_texts);

  std::vector<std::string> dimensions = order;
  if (depths.empty()) std::erase(dimensions, "depth");
  const std::map<std::string, std::size_t> sizes{{"time", times.size()},
                                                 {"depth", std::max<std::size_t>(depths.size(), 1)},
                                                 {"lat", lats.size()},
                                                 {"lon", lons.size()}};

  for (const char component : {'u', 'v'}) {
    if (component == 'v' && !with_north) continue;
    std::vector<double> values;
    std::array<std::size_t, 4> at{};  // along `order`
    const auto index = [&](const std::string& name) {
      return at[static_cast<std::size_t>(std::find(order.begin(), order.end(), name) - order.begin())];
    };
    for (at[0] = 0; at[0] < sizes.at(order[0]); ++at[0])
      for (at[1] = 0; at[1] < sizes.at(order[1]); ++at[1])
        for (at[2] = 0; at[2] < sizes.at(order[2]); ++at[2])
          for (at[3] = 0; at[3] < sizes.at(order[3]); ++at[3])
            values.push_back(value(component, index("time"), index("depth"), index("lat"), index("lon")));
    writer.variable({.name = component == 'u' ? u_name : v_name,
                     .dimensions = dimensions,
                     .values = std::move(values),
                     .texts = component == 'u' ? u_texts : v_texts,
                     .numbers = numbers,
                     .fill = fill,
                     .type = type});
  }
}

}  // namespace floeplan::ingest
