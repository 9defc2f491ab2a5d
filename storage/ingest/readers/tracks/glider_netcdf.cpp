#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/formats/netcdf/measurement_line.hpp"
#include "storage/ingest/notation/cf_time.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tracks/glider_currents.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t rows_at_once = 65'536;

/// The variables from which a row of a track is read.
struct Columns {
  MeasurementLine time;
  MeasurementLine lat;
  MeasurementLine lon;
  std::optional<MeasurementLine> depth{};  // depth or pressure
  double depth_factor{};                   // to metres, positive down; for pressure: to decibars
  bool is_pressure{false};
  CfTime calendar;
};

/// Decibars per unit.
std::optional<double> pressure_factor(std::string_view unit) {
  const std::string name = lower(unit);
  if (name == "dbar" || name == "decibar" || name == "decibars") return 1.0;
  if (name == "bar") return 10.0;
  if (name == "pa" || name == "pascal") return 1e-4;
  if (name == "kpa") return 0.1;
  return std::nullopt;
}

/// Depth in metres of a pressure in decibars: Saunders 1981, equations 1 and 2.
double depth_of(double pressure_dbar, double lat_deg) {
  const double sine = std::sin(core::degrees_to_radians(lat_deg));
  const double linear = (5.92 + 5.25 * sine * sine) * 1e-3;
  constexpr double quadratic = 2.21e-6;
  return (1.0 - linear) * pressure_dbar - quadratic * pressure_dbar * pressure_dbar;
}

bool shares_rows(const std::optional<MeasurementLine>& line, const MeasurementLine& time) {
  return line && line->dimension() == time.dimension() && line->size() == time.size();
}

void take_depth(const NetcdfFile& file, Columns& columns, TrackBuilder& track) {
  auto depth = MeasurementLine::of(file, find_measured(file, {"depth"}, {"depth", "sea_water_depth"}));
  if (shares_rows(depth, columns.time)) {
    const auto factor = length_factor(depth->variable().attribute("units"));
    const bool up = lower(depth->variable().attribute("positive")) == "up";
    if (!factor) {
      track.warn(messages::ingest_track_message<"track-depth-without-unit">(depth->variable().name()));
      return;
    }
    columns.depth_factor = up ? -*factor : *factor;
    columns.depth = std::move(depth);
    return;
  }
  auto pressure =
      MeasurementLine::of(file, find_measured(file, {"pressure", "pres"}, {"sea_water_pressure"}));
  if (!shares_rows(pressure, columns.time)) return;
  const auto factor = pressure_factor(pressure->variable().attribute("units"));
  if (!factor) {
    track.warn(messages::ingest_track_message<"track-pressure-without-unit">(pressure->variable().name()));
    return;
  }
  columns.depth_factor = *factor;
  columns.is_pressure = true;
  columns.depth = std::move(pressure);
}

Checked<Columns> columns_of(const NetcdfFile& file, TrackBuilder& track) {
  auto time = MeasurementLine::of(file, find_measured(file, {"time"}, {"time"}));
  auto lat = MeasurementLine::of(file, find_measured(file, {"lat", "latitude"}, {"latitude"}));
  auto lon = MeasurementLine::of(file, find_measured(file, {"lon", "longitude"}, {"longitude"}));
  if (!time || !lat || !lon || !shares_rows(lat, *time) || !shares_rows(lon, *time))
    return refuse(messages::ingest_track_message<"track-without-rows">());
  auto calendar = CfTime::parse(time->variable().attribute("units"), time->variable().attribute("calendar"));
  if (!calendar) return refuse(calendar.error());
  Columns columns{.time = std::move(*time),
                  .lat = std::move(*lat),
                  .lon = std::move(*lon),
                  .calendar = std::move(*calendar)};
  take_depth(file, columns, track);
  return columns;
}

/// Adds the rows of one file and returns their time span; empty if no row has a time.
Checked<std::optional<TimeSpanOfRows>> add_rows(const Columns& columns, TrackBuilder& track) {
  std::optional<TimeSpanOfRows> span;
  for (std::uint64_t first = 0; first < columns.time.size(); first += rows_at_once) {
    const auto count =
        static_cast<std::size_t>(std::min<std::uint64_t>(rows_at_once, columns.time.size() - first));
    const auto times = columns.time.read(first, count);
    const auto lats = columns.lat.read(first, count);
    const auto lons = columns.lon.read(first, count);
    const auto depths = columns.depth ? columns.depth->read(first, count)
                                      : Checked<std::vector<double>>{std::vector(count, std::nan(""))};
    for (const auto* values : {&times, &lats, &lons, &depths})
      if (!*values) return refuse(values->error());
    for (std::size_t i = 0; i < count; ++i) {
      const auto time = columns.calendar.at((*times)[i]);
      if (!time) {
        track.refuse_row();
        continue;
      }
      TrackRow row{.time = *time};
      if (std::isfinite((*lats)[i]) && std::isfinite((*lons)[i]))
        row.place = geo::LonLat{(*lons)[i], (*lats)[i]};
      const double scaled = (*depths)[i] * columns.depth_factor;
      if (std::isfinite(scaled) && (!columns.is_pressure || row.place))
        row.depth = core::Metres{columns.is_pressure ? depth_of(scaled, row.place->lat_deg) : scaled};
      track.add(row);
      if (!span) span = {*time, *time};
      span = {std::min(span->first, *time), std::max(span->last, *time)};
    }
  }
  return span;
}

std::vector<std::string> names_of(const Columns& columns, const NetcdfFile& file) {
  std::vector<std::string> names{columns.time.variable().name(), columns.lat.variable().name(),
                                 columns.lon.variable().name()};
  if (columns.depth) names.push_back(columns.depth->variable().name());
  for (std::string& name : names_of_currents(file)) names.push_back(std::move(name));
  return names;
}

/// Texts of the variable that names the trajectory; its own name varies.
std::vector<std::string> trajectories_of(const NetcdfFile& file) {
  for (const NetcdfVariable& variable : file.variables())
    if (lower(variable.name()) == "trajectory" || lower(variable.attribute("cf_role")) == "trajectory_id")
      if (auto texts = variable.texts(); !texts.empty()) return texts;
  return {};
}

}  // namespace

bool is_glider_track(const NetcdfFile& file) {
  if (file.find("profile_id") != nullptr || file.find("lat_uv") != nullptr ||
      file.find("TRAJECTORY") != nullptr)
    return true;
  const std::string says = lower(file.attribute("featureType") + " " + file.attribute("cdm_data_type"));
  if (!contains_any(says, {"trajectory"})) return false;
  const auto time = MeasurementLine::of(file, find_measured(file, {"time"}, {"time"}));
  const auto depth = MeasurementLine::of(
      file, find_measured(file, {"depth", "pressure", "pres"}, {"depth", "sea_water_pressure"}));
  return time && shares_rows(depth, *time);
}

std::string trajectory_of(const NetcdfFile& file) {
  const auto names = trajectories_of(file);
  if (names.size() > 1) return {};
  if (!names.empty() && !names.front().empty()) return names.front();
  for (const char* attribute : {"trajectory", "deployment_name", "id"})
    if (std::string name = file.attribute(attribute); !name.empty()) return name;
  return {};
}

Checked<PreparedDataset> read_glider_netcdf(const FileGroup& files, const core::ProgressCallback& progress) {
  std::optional<TrackBuilder> track;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress("reading", static_cast<double>(i) / static_cast<double>(files.size()));
    const auto file = NetcdfFile::open(files[i]);
    if (!file) return refuse(file.error());
    if (trajectories_of(*file).size() > 1) return refuse(messages::ingest_track_message<"several-gliders">());
    if (!track) {
      const std::string name = trajectory_of(*file);
      track.emplace(name.empty() ? files[i].stem().string() : name);
    }
    const auto columns = columns_of(*file, *track);
    if (!columns) return refuse(columns.error());
    const auto span = add_rows(*columns, *track);
    if (!span) return refuse(span.error());
    if (*span)
      if (const auto added = add_currents(*file, **span, *track); !added) return refuse(added.error());
    if (names.empty()) names = names_of(*columns, *file);
  }
  return std::move(*track).prepared(std::move(names));
}

}  // namespace floeplan::ingest
