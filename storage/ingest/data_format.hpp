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

/// The parts of a file by which its format is recognised.
struct FileStart {
  std::string_view bytes{};  // the first bytes of the file; of a UTF-8 text without its byte order mark
  // the user said that the file holds icebergs; a table then needs no column that says so
  bool icebergs_stated{false};
  std::filesystem::path folder{};  // set if the data are a folder, not a file

  [[nodiscard]] std::string_view first_line() const { return bytes.substr(0, bytes.find('\n')); }
};

/// Statements of the user about the content of a file.
struct Expectation {
  std::optional<repository::DatasetKind> kind{};
  // the user said which kind of zones they are; polygons then need no property that says so
  bool zone_kind_stated{false};
  std::optional<std::string>
      variable{};  // the component of currents or the concentration of sea ice that is wanted
  // the value that marks missing values, in addition to those that the file declares
  std::optional<double> missing{};
};

/// A file that was opened and whose kinds of data are known.
struct RecognisedFile {
  std::filesystem::path path;
  const DataFormat* format{};                  // never null
  std::vector<repository::DatasetKind> kinds;  // at least one
  std::shared_ptr<const NetcdfFile> netcdf;    // for the NetCDF formats
  NetcdfFiles companions;                      // files that are read together with this one
  std::shared_ptr<GDALDataset> features;       // for GeoJSON, KML, GeoPackage and shapefiles
  Messages warnings{};                         // says which part of the file is read
};

/// The input of a reader.
struct Reading {
  const RecognisedFile& file;
  const FileGroup& files;  // all files of the dataset; `file` comes first
  repository::DatasetKind kind;
  const IngestOptions& options;
  const core::ProgressCallback& progress;
};

/// The kind of encoding: it decides by which bytes the format is recognised.
enum class Writing : std::uint8_t { folder, binary, json, xml, text };

/// How further files can belong to the dataset of a file; see file_groups.
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
  bool (*is_it)(const FileStart&){};  // called row by row for files of this kind of encoding
  Checked<PreparedDataset> (*read)(const Reading&){};

  // The members below are set only where a format needs them.
  /// What has to hold before GDAL or a reader may open a file.
  Checked<bool> (*check)(const std::filesystem::path&){};
  /// Opens a file that may hold several kinds of data and finds out which. Null: the file holds the one kind
  /// in `kinds`.
  Checked<bool> (*look_into)(RecognisedFile&, const Expectation&){};
  /// SHA-256 over everything that a dataset is read from. Null: over the files of its group.
  Checked<std::string> (*digest)(const FileGroup&){};
  Together together{Together::none};
  /// The file consists of text lines. If the last line has no line end, its last number may be cut off.
  bool has_lines{false};
  /// A raster of numbers without a stated meaning; it is read as depths only.
  bool is_plain_raster{false};
};

}  // namespace floeplan::ingest
