#include "storage/ingest/readers/tracks/glider_currents.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/formats/netcdf/measurement_line.hpp"
#include "storage/ingest/notation/cf_time.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_meaning.hpp"

namespace floeplan::ingest {
namespace {

/// A dive has many rows. A current that lasts fewer rows than this was interpolated from row to row.
constexpr std::size_t least_rows_a_current = 4;
constexpr std::size_t few_currents = 100;

struct Pair {
  const NetcdfVariable* east{};
  const NetcdfVariable* north{};
};

Pair find_named_pair(const NetcdfFile& file) {
  return {find_measured(file, {"u", "watercurrents_u", "water_velocity_eastward", "depth_avg_curr_east"},
                        {"barotropic_eastward_sea_water_velocity", "eastward_sea_water_velocity"}),
          find_measured(file, {"v", "watercurrents_v", "water_velocity_northward", "depth_avg_curr_north"},
                        {"barotropic_northward_sea_water_velocity", "northward_sea_water_velocity"})};
}

/// The pair of components; exchanged if both describe themselves as the other component, against their names.
Pair find_pair(const NetcdfFile& file) {
  const Pair named = find_named_pair(file);
  if (named.east == nullptr || named.north == nullptr) return named;
  const bool crossed = stated_component(*named.east) == Component::second &&
                       stated_component(*named.north) == Component::first;
  return crossed ? Pair{named.north, named.east} : named;
}

/// Whether exactly one of the two describes itself as the other component.
bool contradicts_itself(const Pair& pair) {
  return stated_component(*pair.east) == Component::second ||
         stated_component(*pair.north) == Component::first;
}

bool is_alone(const NetcdfVariable& variable) {
  return std::ranges::all_of(variable.dimensions(),
                             [](const auto& dimension) { return dimension.size == 1; });
}

/// All values, with NaN for bad flags; one value for a scalar.
Checked<std::vector<double>> values_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  if (is_alone(variable)) {
    auto values = variable.read_all();
    if (!values) return values;
    for (const QualityFlags& flags : quality_flags_of(file, variable)) {
      const auto worth = flags.variable->read_all();
      if (!worth) return worth;
      if (flags.forbids(worth->front())) values->front() = std::nan("");
    }
    return values;
  }
  const auto line = MeasurementLine::of(file, &variable);
  if (!line) return refuse(messages::ingest_track_message<"currents-on-several-dimensions">(variable.name()));
  return line->read(0, static_cast<std::size_t>(line->size()));
}

/// Values of a variable that belong to the currents; all NaN if the file does not have the same number of
/// them.
Checked<std::vector<double>> values_beside(const NetcdfFile& file, const NetcdfVariable* variable,
                                           std::size_t count) {
  std::vector<double> none(count, std::nan(""));
  if (variable == nullptr) return none;
  auto values = values_of(file, *variable);
  if (values && values->size() != count) return none;
  return values;
}

/// The variable with the times or positions of the currents: found by its own name, or the variable of the
/// rows, if the currents have a value for each row.
const NetcdfVariable* beside(const NetcdfFile& file, const std::vector<std::string_view>& names,
                             std::string_view of_rows, const NetcdfVariable& current) {
  if (const NetcdfVariable* own = find_measured(file, names, {})) return own;
  const NetcdfVariable* rows = find_measured(file, {of_rows}, {of_rows});
  const bool fits = rows != nullptr && !is_alone(current) &&
                    std::ranges::equal(rows->dimensions(), current.dimensions(), {}, &NetcdfDimension::name,
                                       &NetcdfDimension::name);
  return fits ? rows : nullptr;
}

std::optional<core::UtcTime> time_at(const std::optional<CfTime>& calendar, double value) {
  if (!calendar || !std::isfinite(value)) return std::nullopt;
  const auto time = calendar->at(value);
  return time ? std::optional{*time} : std::nullopt;
}

core::UtcTime middle_time(core::UtcTime first, core::UtcTime last) { return first + 0.5 * (last - first); }

/// A current that stays the same from one row to another.
struct Run {
  geo::VelocityEn current;
  std::size_t first{};
  std::size_t last{};
};

/// Rows without a current do not end the run around them.
std::vector<Run> runs_of(const std::vector<double>& east, const std::vector<double>& north,
                         double east_factor, double north_factor) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < east.size(); ++i) {
    if (!std::isfinite(east[i]) || !std::isfinite(north[i])) continue;
    const geo::VelocityEn current{{east[i] * east_factor}, {north[i] * north_factor}};
    if (runs.empty() || runs.back().current != current) runs.push_back({current, i, i});
    runs.back().last = i;
  }
  return runs;
}

/// Programs that write NetCDF name the vehicle's sensor from which a variable comes.
bool is_of_vehicle_axes(const NetcdfVariable& variable) {
  return contains_any(lower(variable.attribute("source")), {"_water_vx", "_water_vy"});
}

messages::Message without_unit(const NetcdfVariable& variable) {
  const std::string unit = variable.attribute("units");
  if (unit.empty()) return messages::ingest_track_message<"currents-without-unit">(variable.name());
  return messages::ingest_track_message<"currents-with-unknown-unit">(variable.name(), unit);
}

}  // namespace

std::vector<std::string> names_of_currents(const NetcdfFile& file) {
  const Pair pair = find_pair(file);
  if (pair.east == nullptr || pair.north == nullptr || contradicts_itself(pair)) return {};
  return {pair.east->name(), pair.north->name()};
}

Checked<bool> add_currents(const NetcdfFile& file, const TimeSpanOfRows& rows, TrackBuilder& track) {
  const Pair pair = find_pair(file);
  if (pair.east == nullptr || pair.north == nullptr) return true;
  if (contradicts_itself(pair)) {
    track.warn(
        messages::ingest_track_message<"currents-with-one-component">(pair.east->name(), pair.north->name()));
    return true;
  }
  const auto east = values_of(file, *pair.east);
  if (!east) return refuse(east.error());
  const auto north = values_beside(file, pair.north, east->size());
  if (!north) return refuse(north.error());
  const auto is_known = [](double value) { return std::isfinite(value); };
  if (std::ranges::none_of(*east, is_known) || std::ranges::none_of(*north, is_known)) return true;

  const auto east_factor = speed_factor(pair.east->attribute("units"));
  const auto north_factor = speed_factor(pair.north->attribute("units"));
  if (!east_factor || !north_factor) {
    track.warn(without_unit(east_factor ? *pair.north : *pair.east));
    return true;
  }
  const std::vector<Run> runs = runs_of(*east, *north, *east_factor, *north_factor);
  if (runs.size() > few_currents && runs.size() * least_rows_a_current > east->size()) {
    const auto times = find_measured(file, {"time_uv", "time_watercurrents"}, {});
    if (times == nullptr) {
      track.warn(
          messages::ingest_track_message<"currents-not-of-dives">(pair.east->name(), pair.north->name()));
      return true;
    }
  }

  if (is_of_vehicle_axes(*pair.east))
    track.warn(messages::ingest_track_message<"currents-of-vehicle-axes">(pair.east->name(),
                                                                          pair.east->attribute("source")));

  const NetcdfVariable* time = beside(file, {"time_uv", "time_watercurrents"}, "time", *pair.east);
  const auto times = values_beside(file, time, east->size());
  const auto lons = values_beside(
      file, beside(file, {"lon_uv", "longitude_uv", "longitude_watercurrents"}, "longitude", *pair.east),
      east->size());
  const auto lats = values_beside(
      file, beside(file, {"lat_uv", "latitude_uv", "latitude_watercurrents"}, "latitude", *pair.east),
      east->size());
  for (const auto* values : {&times, &lons, &lats})
    if (!*values) return refuse(values->error());
  std::optional<CfTime> calendar;
  if (time != nullptr)
    if (auto parsed = CfTime::parse(time->attribute("units"), time->attribute("calendar")))
      calendar = *parsed;

  for (const Run& run : runs) {
    const auto first = time_at(calendar, (*times)[run.first]);
    const auto last = time_at(calendar, (*times)[run.last]);
    if (!first && !is_alone(*pair.east)) {
      track.warn(messages::ingest_track_message<"track-currents-without-time">());
      continue;
    }
    TrackCurrent current{
        .time = first ? middle_time(*first, last.value_or(*first)) : middle_time(rows.first, rows.last),
        .place = std::nullopt,
        .current = run.current};
    const geo::LonLat place{(*lons)[run.first], (*lats)[run.first]};
    if (run.first == run.last && std::isfinite(place.lon_deg) && std::isfinite(place.lat_deg))
      current.place = place;
    track.add(current);
  }
  return true;
}

}  // namespace floeplan::ingest
