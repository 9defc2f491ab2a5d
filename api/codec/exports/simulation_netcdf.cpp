#include <algorithm>

#include "api/codec/bytes/netcdf_classic.hpp"
#include "api/codec/exports/simulation_exports.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using Texts = NetcdfClassic::Texts;

const std::vector<std::string>& modes() {
  static const std::vector<std::string> names{"mission", "path", "reactive", "given_up"};
  return names;
}

double since_1970_s(const json& flight) {
  return core::unix_seconds(*core::parse_iso8601(flight.at("departure").get<std::string>()));
}

/// A column of the tracks of all flights, flight after flight.
std::vector<double> column(const std::vector<json>& flights, const std::string& name) {
  std::vector<double> values;
  for (const json& flight : flights) {
    const double origin = name == "time_s" ? since_1970_s(flight) : 0.0;
    for (const json& value : flight.at("track").at(name)) values.push_back(origin + value.get<double>());
  }
  return values;
}

std::vector<std::int32_t> surface_flags(const std::vector<json>& flights) {
  std::vector<std::int32_t> values;
  for (const json& flight : flights) {
    for (const json& value : flight.at("track").at("at_surface")) values.push_back(value.get<bool>() ? 1 : 0);
  }
  return values;
}

std::vector<std::int32_t> mode_flags(const std::vector<json>& flights) {
  std::vector<std::int32_t> values;
  for (const json& flight : flights) {
    for (const json& value : flight.at("track").at("mode")) {
      std::string name = value.get<std::string>();
      std::ranges::replace(name, ' ', '_');
      values.push_back(static_cast<std::int32_t>(std::ranges::find(modes(), name) - modes().begin()));
    }
  }
  return values;
}

struct Column {
  const char* name;
  const char* source;  // name of the column in the track
  Texts attributes;
};

std::vector<Column> columns() {
  const std::pair<std::string, std::string> at{"coordinates", "time lat lon depth"};
  return {
      {"time",
       "time_s",
       {{"standard_name", "time"},
        {"units", "seconds since 1970-01-01 00:00:00"},
        {"calendar", "standard"},
        {"axis", "T"}}},
      {"lon", "lon", {{"standard_name", "longitude"}, {"units", "degrees_east"}, {"axis", "X"}}},
      {"lat", "lat", {{"standard_name", "latitude"}, {"units", "degrees_north"}, {"axis", "Y"}}},
      {"depth", "depth_m", {{"standard_name", "depth"}, {"units", "m"}, {"positive", "down"}, {"axis", "Z"}}},
      {"estimated_lon",
       "believed_lon",
       {{"long_name", "longitude that the vehicle estimates"}, {"units", "degrees_east"}, at}},
      {"estimated_lat",
       "believed_lat",
       {{"long_name", "latitude that the vehicle estimates"}, {"units", "degrees_north"}, at}},
      {"position_sigma",
       "sigma_m",
       {{"long_name", "standard deviation of the estimated place, of east and of north"},
        {"units", "m"},
        at}},
      {"heading", "heading_deg", {{"standard_name", "platform_orientation"}, {"units", "degree"}, at}},
      {"pitch", "pitch_deg", {{"standard_name", "platform_pitch_fore_up"}, {"units", "degree"}, at}},
      {"roll", "roll_deg", {{"standard_name", "platform_roll_starboard_down"}, {"units", "degree"}, at}},
      {"eastward_velocity",
       "east_m_s",
       {{"long_name", "velocity of the vehicle over ground, eastward"}, {"units", "m s-1"}, at}},
      {"northward_velocity",
       "north_m_s",
       {{"long_name", "velocity of the vehicle over ground, northward"}, {"units", "m s-1"}, at}},
      {"downward_velocity",
       "down_m_s",
       {{"long_name", "velocity of the vehicle, downward"}, {"units", "m s-1"}, at}},
      {"energy",
       "energy_j",
       {{"long_name", "energy drawn from the battery since the departure"}, {"units", "J"}, at}}};
}

std::string text_of(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

}  // namespace

std::string simulation_netcdf(const json& simulation, const std::vector<json>& flights) {
  std::vector<std::int32_t> lengths;
  std::vector<std::string> names;
  std::size_t points = 0;
  std::size_t longest = 1;
  for (const json& flight : flights) {
    const std::size_t length = flight.at("track").at("time_s").size();
    points += length;
    lengths.push_back(static_cast<std::int32_t>(length));
    names.push_back(text_of(simulation.at("simulation_id")) + "-" + flight.at("run").dump());
    longest = std::max(longest, names.back().size());
  }

  NetcdfClassic file;
  const auto trajectory = file.add_dimension("trajectory", flights.size());
  const auto obs = file.add_dimension("obs", points);
  const auto letters = file.add_dimension("name_length", longest);
  file.add_text("Conventions", "CF-1.8");
  file.add_text("featureType", "trajectory");
  file.add_text("title", "Simulated flights of an underwater glider");
  file.add_text("source", "Floeplan simulation " + text_of(simulation.at("simulation_id")) + " of plan " +
                              text_of(simulation.at("plan_id")));
  file.add_text("seed", text_of(simulation.at("seed")));
  file.add_characters("trajectory", {trajectory, letters}, names,
                      {{"cf_role", "trajectory_id"}, {"long_name", "simulation and run"}});
  file.add_integers("row_size", {trajectory}, lengths,
                    {{"long_name", "number of points of the trajectory"}, {"sample_dimension", "obs"}});
  for (const Column& one : columns())
    file.add_doubles(one.name, {obs}, column(flights, one.source), one.attributes);
  file.add_flags(
      "at_surface", {obs}, surface_flags(flights), {"under_water", "at_surface"},
      {{"long_name", "whether the vehicle is at the surface"}, {"coordinates", "time lat lon depth"}});
  file.add_flags("mode", {obs}, mode_flags(flights), modes(),
                 {{"long_name", "who steers"}, {"coordinates", "time lat lon depth"}});
  return file.bytes();
}

}  // namespace floeplan::codec
