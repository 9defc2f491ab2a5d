#include "storage/demo/bathymetry_file.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::demo {

void write_bathymetry(const std::filesystem::path& file, const RasterFrame& frame,
                      const std::vector<float>& elevation_m, const std::string& description) {
  ingest::register_drivers();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr) throw std::runtime_error{"GDAL has no GTiff driver"};

  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  const std::unique_ptr<GDALDataset> dataset{driver->Create(file.c_str(), static_cast<int>(frame.columns),
                                                            static_cast<int>(frame.rows), 1, GDT_Float32,
                                                            options.List())};
  if (!dataset) throw std::runtime_error{"cannot write " + file.string() + ": " + CPLGetLastErrorMsg()};

  const double north_deg = frame.south_deg + static_cast<double>(frame.rows) * frame.step_lat_deg;
  std::array<double, 6> transform{frame.west_deg,     frame.step_lon_deg, 0.0, north_deg, 0.0,
                                  -frame.step_lat_deg};
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  dataset->SetGeoTransform(transform.data());
  dataset->SetSpatialRef(&wgs84);
  dataset->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", description.c_str());
  dataset->SetMetadataItem("AREA_OR_POINT", "Area");
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  band.SetDescription("elevation (synthetic, not for navigation)");
  band.SetUnitType("m");
  band.SetMetadataItem("standard_name", "height_above_mean_sea_level");
  band.SetMetadataItem("positive", "up");

  const int columns = static_cast<int>(frame.columns);
  for (std::size_t row = 0; row < frame.rows; ++row) {
    std::vector<float> line(
        elevation_m.begin() + static_cast<std::ptrdiff_t>(frame.index(0, frame.rows - 1 - row)),
        elevation_m.begin() + static_cast<std::ptrdiff_t>(frame.index(0, frame.rows - row)));
    if (band.RasterIO(GF_Write, 0, static_cast<int>(row), columns, 1, line.data(), columns, 1, GDT_Float32, 0,
                      0, nullptr) != CE_None)
      throw std::runtime_error{"cannot write " + file.string() + ": " + CPLGetLastErrorMsg()};
  }
}

}  // namespace floeplan::demo
