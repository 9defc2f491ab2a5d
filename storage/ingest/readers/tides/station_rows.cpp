#include "storage/ingest/readers/tides/station_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double highest_amplitude_m = 20.0;

}  // namespace

double speed_deg_h(tide::Constituent constituent) {
  return core::radians_to_degrees(tide::angular_speed(constituent)) * 3600.0;
}

bool is_speed_of(tide::Constituent constituent, double stated_deg_h) {
  return std::abs(stated_deg_h - speed_deg_h(constituent)) <= 0.001;
}

Checked<bool> StationRows::add(const ConstituentRow& row, double metres) {
  if (!std::isfinite(row.amplitude) || row.amplitude < 0.0 || row.amplitude * metres > highest_amplitude_m)
    return refuse(
        messages::ingest_tide_message<"amplitude-impossible">(row.name, number(row.amplitude * metres)));
  if (!std::isfinite(row.phase_deg) || std::abs(row.phase_deg) > 720.0)
    return refuse(messages::ingest_tide_message<"phase-impossible">(row.name, number(row.phase_deg)));
  if (row.amplitude == 0.0) return true;
  const auto line = tide::find_constituent(row.name);
  if (!line) {
    unknown_.push_back(row.name);
    unknown_m_ += row.amplitude * metres;
    return true;
  }
  if (row.speed_deg_h && !is_speed_of(*line, *row.speed_deg_h))
    return refuse(messages::ingest_tide_message<"constituent-speed-differs">(
        row.name, number(*row.speed_deg_h, 9), number(speed_deg_h(*line), 9)));
  if (std::ranges::find(constants_, *line, &tide::HarmonicConstant::constituent) != constants_.end())
    return refuse(messages::ingest_tide_message<"constituent-twice">(row.name));
  constants_.push_back({*line, tide::harmonic_value(row.amplitude * metres, row.phase_deg)});
  return true;
}

void StationRows::warn(Messages& warnings) const {
  if (!unknown_.empty())
    warnings.push_back(messages::ingest_tide_message<"station-constituents-left-out">(enumeration(unknown_),
                                                                                      number(unknown_m_, 3)));
}

Checked<PreparedDataset> prepared_stations(std::vector<repository::TideStation> stations, Messages warnings) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::tides;
  std::vector<geo::LonLat> places;
  for (const repository::TideStation& station : stations) {
    if (station.constants.empty())
      return refuse(messages::ingest_tide_message<"station-without-constituents">());
    places.push_back(station.place);
    for (const tide::HarmonicConstant& constant : station.constants) {
      const std::string& name = tide::constituent_name(constant.constituent);
      if (std::ranges::find(data.variables, name) == data.variables.end()) data.variables.push_back(name);
    }
  }
  if (stations.empty()) return refuse(messages::ingest_tide_message<"stations-missing">());
  data.bounds = geo::bounding_box(places);
  data.rows_accepted = static_cast<std::int64_t>(stations.size());
  data.warnings = std::move(warnings);
  data.write = [stations = std::move(stations)](sql::Connection& db,
                                                const repository::DatasetId& id) -> Checked<void> {
    repository::TideRepository{db}.insert(id, stations);
    return {};
  };
  return data;
}

std::optional<double> metres_of(const std::string& unit) {
  constexpr std::array units{
      std::pair{"m", 1.0},      std::pair{"meters", 1.0},  std::pair{"metres", 1.0},
      std::pair{"metric", 1.0}, std::pair{"cm", 0.01},     std::pair{"mm", 0.001},
      std::pair{"ft", 0.3048},  std::pair{"feet", 0.3048}, std::pair{"english", 0.3048}};
  for (const auto& [name, metres] : units)
    if (lower(unit) == name) return metres;
  return std::nullopt;
}

}  // namespace floeplan::ingest
