#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/repository/datasets/dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

struct DataFormat;

/// What a format is told by.
struct FileStart {
  std::string_view bytes{};        // the first ones; of a text in UTF-8 without a mark of the byte order
  bool icebergs_stated{false};     // by the user: tables need no column of their own for them
  std::filesystem::path folder{};  // of data that are a folder

  [[nodiscard]] std::string_view first_line() const { return bytes.substr(0, bytes.find('\n')); }
};

/// What the user said that a file is.
struct Expectation {
  std::optional<repository::DatasetKind> kind{};
  bool zone_kind_stated{false};  // polygons without a word of their own are zones then
  std::optional<std::string>
      variable{};  // the component of currents or the concentration of sea ice that is wanted
  std::optional<double> missing{};  // what marks missing values beside what the file declares
};

/// A file that was opened and looked into.
struct RecognisedFile {
  std::filesystem::path path;
  const DataFormat* format{};                  // never null
  std::vector<repository::DatasetKind> kinds;  // at least one
  std::shared_ptr<const NetcdfFile> netcdf;    // for the NetCDF formats
  NetcdfFiles companions;                      // files that were given to be read together with it
  std::shared_ptr<GDALDataset> features;       // for GeoJSON, KML, GeoPackage and shapefiles
  Messages warnings{};                         // which part of the file this is
};

/// What a reader is given.
struct Reading {
  const RecognisedFile& file;
  const FileGroup& files;  // the file first
  repository::DatasetKind kind;
  const IngestOptions& options;
  const core::ProgressCallback& progress;
};

/// The kind of encoding: it decides by which bytes the format is recognised.
enum class Writing : std::uint8_t { folder, binary, json, xml, text };

/// Which other files may make one dataset with a file; see file_groups.
enum class Together : std::uint8_t {
  none,
  model_output,
  adcirc_run,
  chart_updates,
  glider_log,
  seaglider_dives,
  seaexplorer_dives
};

/// A format that this program reads: a row of data_formats().
struct DataFormat {
  std::string_view name;                       // as people call it; README.md does
  std::string_view reads;                      // what of it is read, for people
  std::string_view tested_with;                // files of which producers, for people
  std::vector<repository::DatasetKind> kinds;  // that a file of it may hold
  Writing writing{};
  bool (*is_it)(const FileStart&){};  // asked row by row, of files that are written so
  Checked<PreparedDataset> (*read)(const Reading&){};

  // Only where a format needs them.
  /// What has to hold before GDAL or a reader may open a file.
  Checked<bool> (*check)(const std::filesystem::path&){};
  /// Opens a file that may hold several kinds and finds out which it holds. Null: the file holds the one kind in `kinds`.
  Checked<bool> (*look_into)(RecognisedFile&, const Expectation&){};
  /// SHA-256 of everything that a dataset is made of. Null: of the files of its group.
  Checked<std::string> (*digest)(const FileGroup&){};
  Together together{Together::none};
  /// Text lines. If the last line has no line end, its last number may be cut off.
  bool has_lines{false};
  /// A raster of numbers without a stated meaning; it is read as depths only.
  bool is_plain_raster{false};
};

}  // namespace floeplan::ingest
