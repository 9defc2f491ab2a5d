#include "storage/demo/cf_file.hpp"

#include <gdal_priv.h>

#include <stdexcept>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::demo {

std::unique_ptr<GDALDataset> create_cf_file(const std::filesystem::path& file, const std::string& title,
                                            const std::string& comment) {
  ingest::register_drivers();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  if (driver == nullptr)
    throw std::runtime_error{"GDAL has no netCDF driver; install the package libgdal-dev"};
  CPLStringList options;
  options.SetNameValue("FORMAT", "NC4");
  std::unique_ptr<GDALDataset> dataset{driver->CreateMultiDimensional(file.c_str(), nullptr, options.List())};
  if (!dataset) throw std::runtime_error{"cannot write " + file.string() + ": " + CPLGetLastErrorMsg()};

  const auto group = dataset->GetRootGroup();
  add_cf_text(*group, "Conventions", "CF-1.8");
  add_cf_text(*group, "title", title);
  add_cf_text(*group, "comment", comment);
  add_cf_text(*group, "source", "floeplan demo: computed from formulas, not measured and not forecast");
  add_cf_text(*group, "license", "CC0-1.0");
  return dataset;
}

template <class Owner>
void add_cf_text(Owner& owner, const std::string& name, const std::string& text) {
  const auto attribute = owner.CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
  if (!attribute || !attribute->Write(text.c_str()))
    throw std::runtime_error{"cannot write the attribute " + name};
}
template void add_cf_text(GDALGroup&, const std::string&, const std::string&);
template void add_cf_text(GDALMDArray&, const std::string&, const std::string&);

std::shared_ptr<GDALDimension> add_axis(GDALGroup& group, const std::string& name,
                                        const std::vector<double>& nodes,
                                        const std::vector<std::pair<std::string, std::string>>& attributes) {
  const auto dimension = group.CreateDimension(name, {}, {}, nodes.size());
  const auto variable =
      dimension ? group.CreateMDArray(name, {dimension}, GDALExtendedDataType::Create(GDT_Float64)) : nullptr;
  if (!variable) throw std::runtime_error{"cannot write the axis " + name};
  for (const auto& [key, text] : attributes) add_cf_text(*variable, key, text);

  const GUInt64 start = 0;
  const std::size_t count = nodes.size();
  if (!variable->Write(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64),
                       nodes.data()))
    throw std::runtime_error{"cannot write the axis " + name};
  return dimension;
}

std::shared_ptr<GDALDimension> add_time_axis(GDALGroup& group, const std::vector<core::UtcTime>& times) {
  std::vector<double> seconds;
  seconds.reserve(times.size());
  for (const core::UtcTime time : times) seconds.push_back(core::unix_seconds(time));
  return add_axis(group, "time", seconds,
                  {{"standard_name", "time"},
                   {"units", "seconds since 1970-01-01 00:00:00"},
                   {"calendar", "standard"},
                   {"axis", "T"}});
}

std::shared_ptr<GDALDimension> add_latitudes(GDALGroup& group, const RasterFrame& frame) {
  std::vector<double> lat_deg;
  lat_deg.reserve(frame.rows);
  for (std::size_t r = 0; r < frame.rows; ++r) lat_deg.push_back(frame.lat_deg(r));
  return add_axis(group, "latitude", lat_deg,
                  {{"standard_name", "latitude"}, {"units", "degrees_north"}, {"axis", "Y"}});
}

std::shared_ptr<GDALDimension> add_longitudes(GDALGroup& group, const RasterFrame& frame) {
  std::vector<double> lon_deg;
  lon_deg.reserve(frame.columns);
  for (std::size_t c = 0; c < frame.columns; ++c) lon_deg.push_back(frame.lon_deg(c));
  return add_axis(group, "longitude", lon_deg,
                  {{"standard_name", "longitude"}, {"units", "degrees_east"}, {"axis", "X"}});
}

std::shared_ptr<GDALMDArray> add_packed(GDALGroup& group, const CfDimensions& axes,
                                        const PackedVariable& variable) {
  std::string chunk;
  for (std::size_t i = 0; i + 2 < axes.size(); ++i) chunk += "1,";
  chunk += std::to_string(axes[axes.size() - 2]->GetSize()) + "," + std::to_string(axes.back()->GetSize());
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("ZLEVEL", "4");
  options.SetNameValue("BLOCKSIZE", chunk.c_str());
  auto array =
      group.CreateMDArray(variable.name, axes, GDALExtendedDataType::Create(GDT_Int16), options.List());
  if (!array) throw std::runtime_error{"cannot write the variable " + variable.name};

  array->SetRawNoDataValue(&packed_missing);
  array->SetScale(variable.step);
  array->SetOffset(0.0);
  return array;
}

}  // namespace floeplan::demo
