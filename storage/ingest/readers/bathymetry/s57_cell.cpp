#include "storage/ingest/readers/bathymetry/s57_cell.hpp"

#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using ChartPtr = std::shared_ptr<GDALDataset>;

std::filesystem::path part(const std::filesystem::path& base, int number) {
  std::array<char, 16> ending{};
  std::snprintf(ending.data(), ending.size(), ".%03d", number);
  std::filesystem::path file = base;
  return file.replace_extension(ending.data());
}

constexpr int most_updates = 999;

Checked<ChartPtr> open_cell(const std::filesystem::path& base, const char* updates) {
  register_drivers();
  const GdalMessages messages;
  const char* const drivers[] = {"S57", nullptr};
  const char* const options[] = {
      updates, "SPLIT_MULTIPOINT=ON", "ADD_SOUNDG_DEPTH=ON", "RETURN_PRIMITIVES=OFF", "LNAM_REFS=OFF",
      nullptr};
  ChartPtr cell{GDALDataset::Open(std::filesystem::absolute(base).c_str(),
                                  GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options)};
  if (!cell) return refuse(messages::ingest_depth_message<"chart-not-opened">(messages.first_error()));
  return cell;
}

std::optional<double> number_of(const OGRFeature& feature, const char* field) {
  const int index = feature.GetFieldIndex(field);
  if (index < 0 || feature.IsFieldSetAndNotNull(index) == 0) return std::nullopt;
  return feature.GetFieldAsDouble(index);
}

/// Number of records in an ISO/IEC 8211 file, including the one that describes it, counted by the length at
/// the start of each record. GDAL does not report that a file was cut short.
/// Errors   a length that is not a number or exceeds the end of the file
/// Source   ISO/IEC 8211:1994, 6.2: the first five octets of a leader
Checked<std::size_t> iso8211_records(const std::filesystem::path& file) {
  constexpr std::uint64_t leader_octets = 24;
  std::ifstream in{file, std::ios::binary};
  const std::uint64_t size = std::filesystem::file_size(file);
  std::size_t records = 0;
  for (std::uint64_t at = 0; at < size; ++records) {
    std::array<char, 5> digits{};
    in.seekg(static_cast<std::streamoff>(at));
    in.read(digits.data(), digits.size());
    const bool number = in && std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    const std::uint64_t length = number ? std::stoull(std::string{digits.data(), digits.size()}) : 0;
    if (length < leader_octets || length > size - at)
      return refuse(
          messages::ingest_depth_message<"chart-record-damaged">(records + 1, file.filename().string()));
    at += length;
  }
  return records;
}

/// Number of records that a base cell states for itself: its description, identification and parameters, and
/// all records that it counts.
std::size_t records_stated(const OGRFeature& dsid) {
  double records = 3.0;
  for (const char* count : {"DSSI_NOMR", "DSSI_NOCR", "DSSI_NOGR", "DSSI_NOLR", "DSSI_NOIN", "DSSI_NOCN",
                            "DSSI_NOED", "DSSI_NOFA"})
    records += std::max(number_of(dsid, count).value_or(0.0), 0.0);
  return static_cast<std::size_t>(records);
}

Checked<void> check_head(GDALDataset& cell, std::size_t records, ChartCell& chart) {
  OGRLayer* const head = cell.GetLayerByName("DSID");
  const OGRFeatureUniquePtr dsid{head == nullptr ? nullptr : head->GetNextFeature()};
  if (!dsid)
    return refuse(messages::ingest_depth_message<"chart-damaged">("has no head that says what it is"));
  constexpr double is_update = 2.0;  // EXPP, appendix B.1: 1 new data set, 2 update
  if (number_of(*dsid, "DSID_EXPP") == is_update)
    return refuse(messages::ingest_depth_message<"chart-update-alone">());
  if (records < records_stated(*dsid))
    return refuse(messages::ingest_depth_message<"chart-cut-short">(records, records_stated(*dsid)));
  constexpr double metres = 1.0;
  if (number_of(*dsid, "DSPM_DUNI") != metres)
    return refuse(messages::ingest_depth_message<"chart-not-in-metres">());
  chart.scale = static_cast<int>(number_of(*dsid, "DSPM_CSCL").value_or(0.0));
  if (chart.scale < 100 || chart.scale > 100'000'000)
    return refuse(messages::ingest_depth_message<"chart-damaged">("does not state its scale"));
  const auto datum = number_of(*dsid, "DSPM_SDAT");
  chart.warnings.push_back(messages::ingest_depth_message<"chart-datum">(
      datum ? "code " + number(*datum) + " of S-57's VERDAT" : std::string{"which it does not state"}));
  return {};
}

/// What an object class states about depths.
enum class Meaning { area, sounding, danger, land, coverage };

struct ObjectClass {
  const char* name;
  Meaning meaning;
};

constexpr std::array classes{ObjectClass{"DEPARE", Meaning::area},     ObjectClass{"DRGARE", Meaning::area},
                             ObjectClass{"SOUNDG", Meaning::sounding}, ObjectClass{"OBSTRN", Meaning::danger},
                             ObjectClass{"WRECKS", Meaning::danger},   ObjectClass{"UWTROC", Meaning::danger},
                             ObjectClass{"LNDARE", Meaning::land},     ObjectClass{"COALNE", Meaning::land},
                             ObjectClass{"SLCONS", Meaning::land},     ObjectClass{"OFSPLF", Meaning::land},
                             ObjectClass{"M_COVR", Meaning::coverage}};

bool is_area(const OGRGeometry& geometry) {
  const auto type = wkbFlatten(geometry.getGeometryType());
  return type == wkbPolygon || type == wkbMultiPolygon;
}

/// Numbers of objects without a depth in the chart.
struct Unstated {
  int dangers{};
  int areas{};
};

void note(ChartCell& chart, const OGRFeature& feature, Meaning meaning, Unstated& unstated) {
  if (feature.GetGeometryRef() == nullptr || feature.GetGeometryRef()->IsEmpty()) return;
  const std::shared_ptr<const OGRGeometry> geometry{feature.GetGeometryRef()->clone()};
  switch (meaning) {
    case Meaning::coverage:
      if (number_of(feature, "CATCOV") == 1.0) chart.covered.push_back(geometry);
      return;
    case Meaning::area: {
      const auto least = number_of(feature, "DRVAL1");
      if (!least) ++unstated.areas;
      const double least_m = least.value_or(0.0);
      const double most_m = std::max(number_of(feature, "DRVAL2").value_or(least_m), least_m);
      chart.shoals.push_back({geometry, least_m});
      if (is_area(*geometry)) chart.areas.push_back({geometry, 0.5 * (least_m + most_m)});
      return;
    }
    case Meaning::sounding:
      if (const auto depth = number_of(feature, "DEPTH")) chart.shoals.push_back({geometry, *depth});
      return;
    case Meaning::danger: {
      const auto depth = number_of(feature, "VALSOU");
      if (!depth) ++unstated.dangers;
      chart.shoals.push_back({geometry, depth.value_or(0.0)});
      return;
    }
    case Meaning::land:
      chart.shoals.push_back({geometry, 0.0});
      if (is_area(*geometry)) chart.areas.push_back({geometry, 0.0});
      return;
  }
}

Checked<void> read_features(GDALDataset& cell, ChartCell& chart) {
  Unstated unstated;
  CPLErrorReset();
  for (const ObjectClass& object : classes) {
    OGRLayer* const layer = cell.GetLayerByName(object.name);
    if (layer == nullptr) continue;
    for (const auto& feature : *layer) note(chart, *feature, object.meaning, unstated);
    if (CPLGetLastErrorType() >= CE_Failure)
      return refuse(messages::ingest_depth_message<"chart-objects-unreadable">(CPLGetLastErrorMsg()));
  }
  if (unstated.dangers > 0)
    chart.warnings.push_back(messages::ingest_depth_message<"dangers-without-depth">(unstated.dangers));
  if (unstated.areas > 0)
    chart.warnings.push_back(messages::ingest_depth_message<"areas-without-depth">(unstated.areas));
  return {};
}

Checked<void> check_updates(const std::filesystem::path& base) {
  const auto applied = static_cast<int>(parts_of_s57(base).size()) - 1;
  for (int number = applied + 2; number <= most_updates; ++number)
    if (std::filesystem::is_regular_file(part(base, number)))
      return refuse(messages::ingest_depth_message<"chart-update-missing">(number, applied + 1));
  return {};
}

}  // namespace

std::vector<std::filesystem::path> parts_of_s57(const std::filesystem::path& base) {
  std::vector<std::filesystem::path> parts{base};
  if (base.extension() != ".000") return parts;
  for (int number = 1; number <= most_updates && std::filesystem::is_regular_file(part(base, number));
       ++number)
    parts.push_back(part(base, number));
  return parts;
}

Checked<ChartCell> read_s57_cell(const std::filesystem::path& base) {
  ChartCell chart;
  std::size_t records = 0;  // in the last file read, which is the base cell
  for (const auto& file : parts_of_s57(base) | std::views::reverse) {
    const auto counted = iso8211_records(file);
    if (!counted) return refuse(counted.error());
    records = *counted;
  }
  {
    const auto unchanged = open_cell(base, "UPDATES=IGNORE");
    if (!unchanged) return refuse(unchanged.error());
    if (const auto head = check_head(**unchanged, records, chart); !head) return refuse(head.error());
  }
  if (const auto updates = check_updates(base); !updates) return refuse(updates.error());
  const auto cell = open_cell(base, "UPDATES=APPLY");
  if (!cell) return refuse(cell.error());
  const GdalMessages messages;
  if (const auto read = read_features(**cell, chart); !read) return refuse(read.error());
  if (chart.covered.empty() || chart.areas.empty())
    return refuse(messages::ingest_depth_message<"chart-without-depths">());
  const std::size_t updates = parts_of_s57(base).size() - 1;
  chart.warnings.push_back(updates == 0 ? messages::ingest_depth_message<"chart-without-updates">()
                                        : messages::ingest_depth_message<"chart-updated">(updates));
  return chart;
}

}  // namespace floeplan::ingest
