#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "engine/geo/written_place.hpp"
#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/formats/tcd/tcd_file.hpp"
#include "storage/ingest/notation/stated_place.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tides/station_rows.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"

namespace floeplan::ingest {
namespace {

/// Whether this program knows the constituent with the file's speed. The same name with another speed, and
/// names with another reference ("SA-IOS"), are other constituents.
bool is_known(const TcdConstituent& constituent) {
  const auto line = tide::find_constituent(constituent.name);
  return line && is_speed_of(*line, constituent.speed_deg_h);
}

/// Whether the position is known. Zero and zero mark an unknown one: libtcd.html, TIDE_STATION_HEADER.
bool has_place(const TcdStation& station) { return station.lon_deg != 0.0 || station.lat_deg != 0.0; }

/// Counts of the file's content that is not stored.
struct LeftOut {
  std::int64_t currents{};
  std::int64_t differences{};
  std::int64_t incomplete{};
  std::set<std::string> constituents;
  double greatest_m{};  // greatest amplitude of the ignored constituents
  std::string greatest_at;

  [[nodiscard]] std::int64_t stations() const { return currents + differences + incomplete; }
  void warn(Messages& warnings) const {
    if (stations() > 0)
      warnings.push_back(
          messages::ingest_tide_message<"tcd-stations-left-out">(currents, differences, incomplete));
    if (!constituents.empty())
      warnings.push_back(messages::ingest_tide_message<"tcd-constituents-left-out">(
          enumeration({constituents.begin(), constituents.end()}), number(greatest_m, 2), greatest_at));
  }
};

Checked<std::vector<tide::HarmonicConstant>> constants_of(const TcdFile& file, const std::vector<bool>& known,
                                                          const TcdStation& station, double metres,
                                                          LeftOut& left_out) {
  StationRows rows;
  for (const TcdConstant& constant : station.constants) {
    const auto& [name, speed_deg_h] = file.constituents[constant.constituent];
    if (!known[constant.constituent]) {
      left_out.constituents.insert(name);
      if (constant.amplitude * metres > left_out.greatest_m) {
        left_out.greatest_m = constant.amplitude * metres;
        left_out.greatest_at = station.name;
      }
      continue;
    }
    const double phase_deg = std::fmod(constant.phase_deg - speed_deg_h * station.zone_h, 360.0);
    const auto added = rows.add({name, constant.amplitude, phase_deg, speed_deg_h}, metres);
    if (!added) return refuse(about(station.name, added.error().front()));
  }
  return std::move(rows).constants();
}

}  // namespace

Checked<PreparedDataset> read_tcd_stations(const std::filesystem::path& path) {
  const auto file = read_tcd(path);
  if (!file) return refuse(file.error());
  std::vector<bool> known;
  for (const TcdConstituent& constituent : file->constituents) known.push_back(is_known(constituent));

  LeftOut left_out;
  std::vector<repository::TideStation> stations;
  for (const TcdStation& station : file->stations) {
    const auto metres = metres_of(station.unit);
    if (!station.has_constants) {
      ++left_out.differences;
    } else if (station.unit.starts_with("knots")) {
      ++left_out.currents;
    } else if (!has_place(station)) {
      ++left_out.incomplete;
    } else if (!metres) {
      return refuse(
          about(station.name, messages::ingest_tide_message<"amplitude-unit-unknown">(station.unit)));
    } else {
      if (const auto fault = fault_of_place({station.lon_deg, station.lat_deg}))
        return refuse(
            about(station.name, messages::ingest_tide_message<"station-place-impossible">(fault->text)));
      auto constants = constants_of(*file, known, station, *metres, left_out);
      if (!constants) return refuse(constants.error());
      if (constants->empty()) {
        ++left_out.incomplete;
        continue;
      }
      stations.push_back({station.name, *geo::written_place(station.lon_deg, station.lat_deg),
                          ocean::TideQuantity::elevation, std::move(*constants)});
    }
  }
  if (stations.empty() && !file->stations.empty())
    return refuse(messages::ingest_tide_message<"tcd-without-levels">());
  Messages warnings;
  left_out.warn(warnings);
  auto data = prepared_stations(std::move(stations), std::move(warnings));
  if (data) data->rows_refused = left_out.stations();
  return data;
}

}  // namespace floeplan::ingest
