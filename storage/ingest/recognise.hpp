#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "storage/ingest/file_format.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/repository/dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// A file that was opened and looked into.
struct RecognisedFile {
  std::filesystem::path path;
  FileFormat format{};
  std::vector<repository::DatasetKind> kinds;  // at least one
  std::shared_ptr<const NetcdfFile> netcdf;    // for the NetCDF formats
  NetcdfFiles companions;                      // files that were given to be read together with it
  std::shared_ptr<GDALDataset> features;       // for GeoJSON, KML, GeoPackage and shapefiles
  std::vector<std::string> warnings{};         // which part of the file this is
};

/// What the user said that a file is.
struct Expectation {
  std::optional<repository::DatasetKind> kind{};
  bool zone_kind_stated{false};  // polygons without a word of their own are zones then
  std::optional<std::string>
      variable{};  // the component of currents or the concentration of sea ice that is wanted
  std::optional<double> missing{};  // what marks missing values beside what the file declares
};

/// Finds out by content which kinds of data a file holds; its name plays no part.
/// Errors   what format_of refuses; a file that holds nothing this program reads, or not the kind that was
/// asked for
[[nodiscard]] Checked<RecognisedFile> recognise(const std::filesystem::path& file,
                                                const Expectation& expected);

}  // namespace floeplan::ingest
