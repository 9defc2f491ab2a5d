#include "storage/ingest/netcdf_contents.hpp"

#include <algorithm>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/formats/slocum/slocum_netcdf.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"
#include "storage/ingest/readers/coastline/coastline_readers.hpp"
#include "storage/ingest/readers/coastline/gshhg_reader.hpp"
#include "storage/ingest/readers/currents/current_readers.hpp"
#include "storage/ingest/readers/ice/ice_readers.hpp"
#include "storage/ingest/readers/ice/ice_variables.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"
#include "storage/ingest/readers/tides/tide_variables.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"
#include "storage/ingest/readers/velocity/velocity_hints.hpp"
#include "storage/ingest/readers/velocity/velocity_names.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {
namespace {

using repository::DatasetKind;

/// Whether a variable lies on a grid that can be stored unchanged. Other variables on a curvilinear or
/// rotated grid are ignored; the currents in the same file are still read.
bool lies_on_regular_grid(const NetcdfFile& file, const NetcdfVariable& variable,
                          const std::optional<std::string>& stated_crs) {
  const auto layout = layout_of(file, variable);
  return layout && grid_of(file, variable, *layout, stated_crs);
}

bool ice_is_readable(const NetcdfFile& file) {
  const auto ice = find_ice(file, std::nullopt);
  return ice && lies_on_regular_grid(file, *ice->concentrations.front(), std::nullopt);
}

std::vector<DatasetKind> kinds_of_netcdf(const std::shared_ptr<const NetcdfFile>& opened,
                                         const Expectation& expected) {
  const NetcdfFile& file = *opened;
  const std::optional<DatasetKind> wanted = expected.kind;
  if (holds_tides(file)) return {DatasetKind::tides};
  std::vector<DatasetKind> kinds;
  const bool bathymetry_wanted = wanted == DatasetKind::bathymetry;
  const bool velocity = holds_velocity(file, Moving::sea, expected.variable);
  if (!wanted && velocity && names_velocity(file, expected.variable)) return {DatasetKind::currents};
  if (velocity) kinds.push_back(DatasetKind::currents);
  const NetcdfVariable* bathymetry = find_bathymetry(file, bathymetry_wanted);
  const bool worth_reading = bathymetry != nullptr && (!velocity || bathymetry_wanted ||
                                                       lies_on_regular_grid(file, *bathymetry, std::nullopt));
  if (worth_reading) kinds.push_back(DatasetKind::bathymetry);
  const bool named_ice = wanted == DatasetKind::ice && expected.variable;
  const bool lone_ice = wanted == DatasetKind::ice || !velocity;
  if (named_ice || (holds_ice(file) &&
                    (lone_ice || (velocity_parts(file) == VelocityParts::both && ice_is_readable(file)))))
    kinds.push_back(DatasetKind::ice);
  // Wind that cannot be read is no reason to refuse the other data in the file.
  const bool lone_wind = wanted == DatasetKind::wind || kinds.empty();
  if (holds_wind(file) && (lone_wind || wind_is_readable(opened))) kinds.push_back(DatasetKind::wind);
  return kinds;
}

/// "the wind" or "the current" if the file has it as speed and direction; otherwise empty.
std::string known_by_direction(const NetcdfFile& file) {
  for (const NetcdfVariable& variable : file.variables()) {
    const std::string words = lower(variable.name() + " " + variable.attribute("standard_name") + " " +
                                    variable.attribute("long_name"));
    if (!variable.is_numeric() || variable.dimensions().size() < 2 ||
        !contains_any(words, {"direction", "_dir"}))
      continue;
    if (contains_any(words, {"wave", "swell", "ice"})) continue;
    if (contains_any(words, {"wind"})) return "the wind";
    if (contains_any(words, {"sea_water", "current"})) return "the current";
  }
  return "";
}

/// Whether a variable is part of a variable of the file, as hvel[0] is one component of hvel.
bool is_part_of_another(const NetcdfFile& file, const NetcdfVariable& variable) {
  const std::size_t bracket = variable.name().find('[');
  return bracket != std::string::npos && file.find(variable.name().substr(0, bracket)) != nullptr;
}

/// The refusal of a variable that has the name of a current but another standard name or unit; empty if there
/// is none.
std::optional<messages::Message> called_currents(const NetcdfFile& file) {
  for (const NetcdfVariable& variable : file.variables()) {
    const std::string standard_name = standard_name_of(variable);
    const auto known = known_name(variable.name(), Moving::sea);
    if (!known || known->generic || variable.dimensions().size() < 2) continue;
    const std::string unit = variable.attribute("units");
    if (!names_another_quantity(standard_name, Moving::sea) && (unit.empty() || speed_factor(unit))) continue;
    const std::string quantity = standard_name.empty() ? variable.attribute("long_name") : standard_name;
    return messages::ingest_file_message<"called-as-currents">(
        variable.name(), quantity + (unit.empty() ? "" : " in " + unit));
  }
  return std::nullopt;
}

messages::Message nothing_known(const NetcdfFile& file) {
  if (const std::string what = known_by_direction(file); !what.empty())
    return messages::ingest_file_message<"current-as-direction">(what);
  if (file.find("x_range") != nullptr && file.find("y_range") != nullptr && file.find("spacing") != nullptr)
    return messages::ingest_file_message<"grid-of-old-gmt">();
  for (const char* const part : {"horizontalVelX", "horizontalVelY", "zCoordinates"})
    if (file.find(part) != nullptr) return messages::ingest_file_message<"schism-in-parts">();
  if (auto left_out = ice_left_out(file)) return std::move(*left_out);
  if (const std::string product = file.attribute("productSpecification"); product.starts_with("INT.IHO.S-"))
    return messages::ingest_file_message<"hydrographic-product-not-read">(product);
  if (holds_ice_thickness(file)) return messages::ingest_file_message<"thickness-without-concentration">();
  for (const Moving what : {Moving::sea, Moving::air})
    if (auto left_out = velocities_left_out(file, what)) return std::move(*left_out);
  if (auto other = called_currents(file)) return std::move(*other);
  if (!file.groups().empty())
    return messages::ingest_file_message<"groups-without-data">(enumeration(file.groups()));
  std::vector<std::string> names;
  for (const NetcdfVariable& variable : file.variables())
    if (!is_part_of_another(file, variable)) names.push_back(variable.name());
  if (names.empty()) return messages::ingest_file_message<"netcdf-without-variables">();
  return messages::ingest_file_message<"variables-not-recognised">(enumeration(names));
}

/// A group that holds data, opened as if it were a file of its own.
struct DataGroup {
  std::string path;
  std::shared_ptr<const NetcdfFile> seen;
  std::vector<DatasetKind> kinds;
  bool has_own_data{false};  // false: all its data come from the groups around it
};

bool holds_wanted(const std::vector<DatasetKind>& kinds, const Expectation& expected) {
  return expected.kind ? std::ranges::find(kinds, *expected.kind) != kinds.end() : !kinds.empty();
}

std::vector<DataGroup> groups_with_data(const NetcdfFile& file, const Expectation& expected) {
  std::vector<DataGroup> found;
  for (const std::string& path : file.groups()) {
    const auto alone = std::make_shared<const NetcdfFile>(file.only(path));
    const bool has_own_data = holds_wanted(kinds_of_netcdf(alone, expected), expected);
    const bool below_another = std::ranges::any_of(
        found, [&](const DataGroup& group) { return path.starts_with(group.path + "/"); });
    if (below_another && !has_own_data) continue;  // this group sees the same variables again
    auto seen = std::make_shared<const NetcdfFile>(file.seen_from(path));
    auto kinds = kinds_of_netcdf(seen, expected);
    if (holds_wanted(kinds, expected))
      found.push_back({path, std::move(seen), std::move(kinds), has_own_data});
  }
  return found;
}

std::string groups_in_words(const std::vector<DataGroup>& groups) {
  std::vector<std::string> texts;
  for (const DataGroup& group : groups) {
    std::vector<std::string> kinds;
    for (const DatasetKind kind : group.kinds) kinds.push_back(repository::kind_name(kind));
    texts.push_back(group.path + " (" + enumeration(kinds) + ")");
  }
  return enumeration(texts);
}

/// If the top level does not hold the wanted data, looks into the groups; if it does, warns of the data in
/// the groups.
Checked<bool> look_into_groups(RecognisedFile& file, const Expectation& expected) {
  if (file.netcdf->groups().empty()) return true;
  const bool top_level = holds_wanted(file.kinds, expected);
  // A group also sees the variables of the top level; those are not its own data.
  std::vector<DataGroup> groups = groups_with_data(*file.netcdf, expected);
  if (top_level) {
    std::erase_if(groups,
                  [&](const DataGroup& group) { return !group.has_own_data && group.kinds == file.kinds; });
    if (!groups.empty())
      file.warnings.push_back(
          messages::ingest_file_message<"groups-not-read">(groups_in_words(groups), groups.front().path));
    return true;
  }
  if (groups.size() > 1)
    return refuse(
        messages::ingest_file_message<"several-groups">(groups_in_words(groups), groups.front().path));
  if (groups.empty()) return true;
  const std::vector<DatasetKind>& kinds = groups.front().kinds;
  const auto holds = [&](DatasetKind kind) { return std::ranges::find(kinds, kind) != kinds.end(); };
  if (holds(DatasetKind::currents) || holds(DatasetKind::wind) || holds(DatasetKind::ice))
    if (auto statistic = statistic_in_group(groups.front().path)) return refuse(std::move(*statistic));
  if (holds(DatasetKind::currents))
    if (auto part = part_in_group(groups.front().path)) file.warnings.push_back(std::move(*part));
  file.netcdf = std::move(groups.front().seen);
  file.kinds = std::move(groups.front().kinds);
  file.warnings.push_back(messages::ingest_file_message<"data-in-group">(groups.front().path));
  return true;
}

/// A file and the files that are read together with it.
NetcdfFiles together(const RecognisedFile& file) {
  NetcdfFiles files{file.netcdf};
  files.insert(files.end(), file.companions.begin(), file.companions.end());
  return files;
}

}  // namespace

Checked<bool> look_into_netcdf(RecognisedFile& file, const Expectation& expected) {
  auto netcdf = NetcdfFile::open(file.path, expected.missing);
  if (!netcdf) return refuse(netcdf.error());
  file.netcdf = std::make_shared<const NetcdfFile>(std::move(*netcdf));
  if (is_seaglider_dive(*file.netcdf) || is_glider_track(*file.netcdf) || is_slocum_netcdf(*file.netcdf)) {
    file.kinds = {DatasetKind::glider_tracks};
    return true;
  }
  file.kinds = kinds_of_netcdf(file.netcdf, expected);
  if (file.kinds.empty() && file.format->writing == Writing::binary && is_gshhg(file.path))
    file.kinds = {DatasetKind::coastline};
  if (const auto looked = look_into_groups(file, expected); !looked) return looked;
  if (file.kinds.empty()) return refuse(nothing_known(*file.netcdf));
  return true;
}

std::optional<messages::Message> ice_not_named(const NetcdfFile& file) {
  const NetcdfVariable* const plane = find_bathymetry(file, true);
  if (plane == nullptr || !standard_name_of(*plane).empty() || !plane->attribute("units").empty())
    return std::nullopt;
  return messages::ingest_file_message<"ice-not-named">(plane->name());
}

Checked<PreparedDataset> read_netcdf(const Reading& reading) {
  const RecognisedFile& file = reading.file;
  const IngestOptions& options = reading.options;
  if (reading.kind == DatasetKind::glider_tracks && is_seaglider_dive(*file.netcdf))
    return read_seaglider_netcdf(reading.files, reading.progress);
  if (reading.kind == DatasetKind::glider_tracks)
    return is_glider_track(*file.netcdf) ? read_glider_netcdf(reading.files, reading.progress)
                                         : read_slocum_tracks(reading.files, reading.progress);
  if (reading.kind == DatasetKind::coastline) return read_gshhg_coastline(file.path, reading.progress);
  if (reading.kind == DatasetKind::tides)
    return read_tides(together(file), file.path, options, reading.progress);
  if (reading.kind == DatasetKind::wind) return read_wind(file.netcdf, options.crs, reading.progress);
  if (reading.kind == DatasetKind::ice) return read_ice(file.netcdf, options, reading.progress);
  return reading.kind == DatasetKind::currents
             ? read_currents(together(file), options.crs, options.variable, reading.progress)
             : read_netcdf_bathymetry(file.netcdf, options);
}

void warn_of_what_is_left(const RecognisedFile& file, Messages& warnings) {
  const auto left = [&](DatasetKind kind, bool held, const std::string& what) {
    if (!held || std::ranges::find(file.kinds, kind) != file.kinds.end()) return;
    warnings.push_back(
        messages::ingest_file_message<"other-data-not-stored">(what, repository::kind_name(kind)));
  };
  left(DatasetKind::ice, holds_ice(*file.netcdf), "concentrations of sea ice");
  left(DatasetKind::bathymetry, find_bathymetry(*file.netcdf, false) != nullptr, "depths of the sea bed");
}

}  // namespace floeplan::ingest
