#include "api/codec/documents/flight_document.hpp"

#include <cmath>
#include <string>

#include "engine/core/units.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using simulation::FlightRecord;
using simulation::Vector;

/// Resolution of the written values: each constant is the number of steps per unit.
constexpr double per_degree_of_place = 1e7;
constexpr double per_metre = 100.0;
constexpr double per_degree = 100.0;
constexpr double per_second = 100.0;
constexpr double per_speed = 1e4;

double rounded(double value, double per_unit) {
  const double steps = std::round(value * per_unit);
  return (steps == 0.0 ? 0.0 : steps) / per_unit;
}

double degrees(double angle_rad) { return rounded(core::radians_to_degrees(angle_rad), per_degree); }

double heading(double angle_rad) {
  const double turned = std::fmod(core::radians_to_degrees(angle_rad), 360.0);
  return std::fmod(rounded(turned < 0.0 ? turned + 360.0 : turned, per_degree), 360.0);
}

class Places {
 public:
  explicit Places(const geo::LocalProjection& projection) : projection_{projection} {}

  [[nodiscard]] geo::LonLat of(const Vector& position) const {
    const geo::LonLat place = projection_.to_lon_lat({position.east, position.north});
    return {rounded(place.lon_deg, per_degree_of_place), rounded(place.lat_deg, per_degree_of_place)};
  }
  void write(const Vector& position, json& object) const {
    const geo::LonLat place = of(position);
    object["lon"] = place.lon_deg;
    object["lat"] = place.lat_deg;
    object["depth_m"] = rounded(position.down, per_metre);
  }

 private:
  const geo::LocalProjection& projection_;  // borrowed
};

json track_json(const FlightRecord& record, const Places& places) {
  json track;
  for (const char* column :
       {"time_s", "lon", "lat", "depth_m", "believed_lon", "believed_lat", "sigma_m", "heading_deg",
        "pitch_deg", "roll_deg", "east_m_s", "north_m_s", "down_m_s", "energy_j", "at_surface", "mode"})
    track[column] = json::array();
  for (const simulation::TrackPoint& point : record.track) {
    const geo::LonLat place = places.of(point.position);
    const geo::LonLat believed = places.of(point.believed);
    track["time_s"].push_back(rounded((point.time - record.departure).count(), per_second));
    track["lon"].push_back(place.lon_deg);
    track["lat"].push_back(place.lat_deg);
    track["depth_m"].push_back(rounded(point.position.down, per_metre));
    track["believed_lon"].push_back(believed.lon_deg);
    track["believed_lat"].push_back(believed.lat_deg);
    track["sigma_m"].push_back(rounded(point.sigma_m, per_metre));
    track["heading_deg"].push_back(heading(point.attitude.heading_rad));
    track["pitch_deg"].push_back(degrees(point.attitude.pitch_rad));
    track["roll_deg"].push_back(degrees(point.attitude.roll_rad));
    track["east_m_s"].push_back(rounded(point.over_ground.east, per_speed));
    track["north_m_s"].push_back(rounded(point.over_ground.north, per_speed));
    track["down_m_s"].push_back(rounded(point.over_ground.down, per_speed));
    track["energy_j"].push_back(rounded(point.energy.value, 1.0));
    track["at_surface"].push_back(point.at_surface);
    track["mode"].push_back(avoidance::text(point.mode));
  }
  return track;
}

json events_json(const FlightRecord& record, const Places& places) {
  json events = json::array();
  for (const simulation::FlightEvent& event : record.events) {
    json one{
        {"time", core::iso8601(event.time)}, {"kind", simulation::text(event.kind)}, {"text", event.text}};
    places.write(event.position, one);
    events.push_back(std::move(one));
  }
  return events;
}

json approaches_json(const FlightRecord& record, const Places& places) {
  json approaches = json::array();
  for (const simulation::ClosestApproach& approach : record.approaches) {
    json one{{"to", approach.to},
             {"distance_m", rounded(approach.distance_m, per_metre)},
             {"time", core::iso8601(approach.time)}};
    places.write(approach.position, one);
    approaches.push_back(std::move(one));
  }
  return approaches;
}

/// The columns of one sensor's log.
class Columns {
 public:
  explicit Columns(std::initializer_list<const char*> names) {
    for (const char* name : names) columns_[name] = json::array();
  }
  void add(const char* column, double value, double per_unit) {
    columns_[column].push_back(rounded(value, per_unit));
  }
  void add(const char* column, int value) { columns_[column].push_back(value); }
  [[nodiscard]] json taken() { return std::move(columns_); }

 private:
  json columns_;
};

json sensors_json(const FlightRecord& record, const Places& places) {
  const auto since = [&](core::UtcTime time) { return (time - record.departure).count(); };
  const simulation::SensorLog& log = record.sensors;
  Columns sonar{"time_s", "returns", "nearest_m"};
  for (const auto& entry : log.sonar) {
    sonar.add("time_s", since(entry.time), per_second);
    sonar.add("returns", entry.returns);
    sonar.add("nearest_m", entry.nearest_m, per_metre);
  }
  Columns altimeter{"time_s", "altitude_m"};
  for (const auto& entry : log.altimeter) {
    altimeter.add("time_s", since(entry.time), per_second);
    altimeter.add("altitude_m", entry.altitude_m, per_metre);
  }
  Columns currents{"time_s", "depth_m", "east_m_s", "north_m_s", "sigma_m_s"};
  for (const auto& entry : log.currents) {
    currents.add("time_s", since(entry.time), per_second);
    currents.add("depth_m", entry.depth_m, per_metre);
    currents.add("east_m_s", entry.measured.east.value, per_speed);
    currents.add("north_m_s", entry.measured.north.value, per_speed);
    currents.add("sigma_m_s", entry.one_sigma.value, per_speed);
  }
  Columns fixes{"time_s", "lon", "lat", "believed_lon", "believed_lat", "east_m_s", "north_m_s"};
  for (const auto& entry : log.fixes) {
    const geo::LonLat fixed = places.of(entry.fixed);
    const geo::LonLat believed = places.of(entry.believed);
    fixes.add("time_s", since(entry.time), per_second);
    fixes.add("lon", fixed.lon_deg, per_degree_of_place);
    fixes.add("lat", fixed.lat_deg, per_degree_of_place);
    fixes.add("believed_lon", believed.lon_deg, per_degree_of_place);
    fixes.add("believed_lat", believed.lat_deg, per_degree_of_place);
    fixes.add("east_m_s", entry.depth_averaged.east.value, per_speed);
    fixes.add("north_m_s", entry.depth_averaged.north.value, per_speed);
  }
  return {{"sonar", sonar.taken()},
          {"altimeter", altimeter.taken()},
          {"currents", currents.taken()},
          {"fixes", fixes.taken()}};
}

json interval_json(const std::optional<simulation::Interval>& interval) {
  return interval ? json::array({interval->low, interval->high}) : json();
}

json distribution_json(const std::optional<simulation::Distribution>& distribution) {
  if (!distribution) return nullptr;
  json quantiles = json::array();
  for (const auto& quantile : distribution->quantiles) {
    quantiles.push_back({{"share", quantile.share},
                         {"value", quantile.value},
                         {"interval_95", interval_json(quantile.interval)}});
  }
  const auto& deviation = distribution->standard_deviation;
  return {{"runs", distribution->runs},
          {"mean", distribution->mean},
          {"mean_interval_95", interval_json(distribution->mean_interval)},
          {"standard_deviation", deviation ? json(*deviation) : json()},
          {"quantiles", std::move(quantiles)},
          {"least", distribution->least},
          {"most", distribution->most}};
}

}  // namespace

json flight_document(const FlightRecord& record, const geo::LocalProjection& projection, std::size_t run) {
  const Places places{projection};
  return {{"run", run},
          {"seed", std::to_string(record.seed)},
          {"end", simulation::text(record.end)},
          {"end_reason", record.end_reason},
          {"departure", core::iso8601(record.departure)},
          {"finished", core::iso8601(record.finished)},
          {"travel_time_s", rounded(record.duration().count(), per_second)},
          {"distance_m", rounded(record.distance_m, per_metre)},
          {"energy_j", rounded(record.energy.value, 1.0)},
          {"teeth", record.teeth},
          {"track", track_json(record, places)},
          {"events", events_json(record, places)},
          {"approaches", approaches_json(record, places)},
          {"sensors", sensors_json(record, places)}};
}

json summary_document(const simulation::RunSummary& summary, std::size_t run) {
  return {{"run", run},
          {"seed", std::to_string(summary.seed)},
          {"end", simulation::text(summary.end)},
          {"travel_time_s", rounded(summary.travel_time.count(), per_second)},
          {"final_position_error_m", rounded(summary.final_position_error_m, per_metre)},
          {"worst_position_error_m", rounded(summary.worst_position_error_m, per_metre)},
          {"clearance_m", summary.clearance_m ? json(rounded(*summary.clearance_m, per_metre)) : json()},
          {"energy_j", rounded(summary.energy.value, 1.0)},
          {"distance_m", rounded(summary.distance_m, per_metre)},
          {"why", summary.why.empty() ? json() : json(summary.why)},
          {"could_be_saved", summary.could_be_saved ? json(*summary.could_be_saved) : json()}};
}

json statistics_document(const simulation::BatchStatistics& statistics) {
  json ends = json::array();
  for (const auto& end : statistics.ends) {
    ends.push_back({{"end", simulation::text(end.end)},
                    {"runs", end.share.runs},
                    {"share", end.share.share},
                    {"share_interval_95", interval_json(end.share.interval)}});
  }
  return {{"runs", statistics.runs},
          {"ends", std::move(ends)},
          {"travel_time_s", distribution_json(statistics.travel_time_s)},
          {"final_position_error_m", distribution_json(statistics.final_position_error_m)},
          {"worst_position_error_m", distribution_json(statistics.worst_position_error_m)},
          {"clearance_m", distribution_json(statistics.clearance_m)},
          {"energy_j", distribution_json(statistics.energy_j)}};
}

}  // namespace floeplan::codec
