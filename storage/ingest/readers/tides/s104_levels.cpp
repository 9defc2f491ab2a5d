#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/shown_text.hpp"
#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "engine/messages/ingest_time_messages.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/formats/s100/s100_coverage.hpp"
#include "storage/ingest/grids/scattered_mesh.hpp"
#include "storage/ingest/notation/cf_time.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"
#include "storage/repository/fields/water_level_repository.hpp"

namespace floeplan::ingest {
namespace {

using repository::WaterLevelRepository;
using repository::WaterLevelStation;

constexpr const char* level_feature = "WaterLevel";
constexpr const char* level_name = "waterLevelHeight";
constexpr const char* level_time_name = "waterLevelTime";
constexpr double highest_level_m = 99.99;          // S-104 edition 2.0.0, table 10-3, both ways
constexpr std::size_t longest_series = 1'000'000;  // chosen: two years, minute by minute

/// Words for the codes of verticalDatum, from 1 on.
/// Source  IHO S-104 edition 2.0.0, table 12-8; S-100 edition 5.2.0, part 17
std::optional<std::string> datum_of_s100(double code) {
  constexpr std::array words{"mean low water springs",
                             "mean lower low water springs",
                             "mean sea level",
                             "lowest low water",
                             "mean low water",
                             "lowest low water springs",
                             "approximate mean low water springs",
                             "Indian spring low water",
                             "low water springs",
                             "approximate lowest astronomical tide",
                             "nearly lowest low water",
                             "mean lower low water",
                             "low water",
                             "approximate mean low water",
                             "approximate mean lower low water",
                             "mean high water",
                             "mean high water springs",
                             "high water",
                             "approximate mean sea level",
                             "high water springs",
                             "mean higher high water",
                             "equinoctial spring low water",
                             "lowest astronomical tide",
                             "local datum",
                             "International Great Lakes Datum 1985",
                             "mean water level",
                             "lower low water large tide",
                             "higher high water large tide",
                             "nearly highest high water",
                             "highest astronomical tide"};
  constexpr double baltic = 44.0;
  constexpr double great_lakes_2020 = 46.0;
  if (code == baltic) return "Baltic Sea Chart Datum 2000";
  if (code == great_lakes_2020) return "International Great Lakes Datum 2020";
  if (!(code >= 1.0 && code <= static_cast<double>(words.size())) || code != std::floor(code))
    return std::nullopt;
  return words.at(static_cast<std::size_t>(code) - 1);
}

/// The datum in words. An area may have another one than its file.
Checked<std::string> datum_of(const Hdf5Group& file, const Hdf5Group& area) {
  constexpr double of_s100 = 1.0;  // verticalDatumReference
  constexpr double of_epsg = 2.0;
  const bool own = area.number("verticalDatum").has_value();
  const auto code = own ? area.number("verticalDatum") : file.number("verticalDatum");
  const double reference = (own ? area : file).number("verticalDatumReference").value_or(of_s100);
  std::optional<std::string> words;
  if (code && reference == of_s100) words = datum_of_s100(*code);
  if (code && reference == of_epsg && *code > 0.0) words = "EPSG:" + number(*code);
  if (words) return *words;
  return refuse(messages::ingest_hdf5_message<"level-datum-missing">(code ? number(*code) : "missing"));
}

/// Refuses every vertical axis but heights upwards in metres above the datum. Before edition 2 the axis was not stated;
/// a height of the water is one upwards by its definition.
Checked<bool> heights_go_up(const Hdf5Group& file) {
  constexpr std::array wanted{std::pair{"verticalCS", 6499.0},  // EPSG: gravity-related height, up, metres
                              std::pair{"verticalCoordinateBase", 2.0}};  // the vertical datum
  for (const auto& [attribute, code] : wanted) {
    const auto stated = file.number(attribute);
    if (stated && *stated != code)
      return refuse(
          messages::ingest_hdf5_message<"level-sign-unknown">(attribute, number(*stated), number(code)));
  }
  return true;
}

/// The metadata of all levels of a file, whatever their layout.
struct LevelHead {
  float unit_m{};
  std::string datum;
};

template <class Values>
Checked<LevelHead> level_head_of(const Values& levels) {
  const auto described = levels.values.find(level_name);
  const std::string unit = described == levels.values.end() ? "" : described->second.unit;
  const auto unit_m = length_factor(unit);
  if (!unit_m) return refuse(messages::ingest_hdf5_message<"level-unit-unknown">(unit));
  if (const auto up = heights_go_up(levels.file); !up) return refuse(up.error());
  auto datum = datum_of(levels.file, levels.area);
  if (!datum) return refuse(datum.error());
  return LevelHead{static_cast<float>(*unit_m), std::move(*datum)};
}

/// The lowest level of a file and how many there are.
class LevelSurvey {
 public:
  /// Errors  an impossible level
  Checked<bool> look_at(const std::vector<float>& heights_m) {
    for (const float height : heights_m) {
      if (std::isnan(height)) continue;
      const auto height_m = static_cast<double>(height);
      if (!(std::abs(height_m) <= highest_level_m))
        return refuse(messages::ingest_hdf5_message<"level-impossible">(number(height_m)));
      lowest_m_ = std::min(lowest_m_, height_m);
      any_ = true;
    }
    return true;
  }
  /// Errors  there is no level
  [[nodiscard]] Checked<Messages> result(const std::string& datum) const {
    if (!any_) return refuse(messages::ingest_hdf5_message<"levels-all-missing">());
    Messages told{messages::ingest_hdf5_message<"levels-above-datum">(datum)};
    if (lowest_m_ < 0.0)
      told.push_back(messages::ingest_hdf5_message<"levels-below-datum">(number(-lowest_m_, 2), datum));
    return told;
  }

 private:
  double lowest_m_{std::numeric_limits<double>::infinity()};
  bool any_{false};
};

PreparedDataset dataset_of_levels(Messages warnings) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::water_levels;
  data.variables = {level_name};
  data.warnings = std::move(warnings);
  return data;
}

void set_period(PreparedDataset& data, double from_s, double to_s) {
  data.time_start = core::from_unix_seconds(from_s);
  data.time_end = core::from_unix_seconds(to_s);
}

/// Heights of a grid or a mesh, one time after the other.
struct LevelField {
  std::string datum;
  AxisNodes times;
  ocean::HorizontalGrid grid;
  std::optional<repository::MeshInBlocks> own_points;  // empty: the heights are at the grid's nodes
  /// In metres, in the order of the file. `time`: its index among the ascending times
  std::function<Checked<std::vector<float>>(std::size_t time)> read;

  [[nodiscard]] std::size_t points() const {
    return own_points ? own_points->mesh.points.size() : grid.size();
  }
};

Checked<void> write_levels(const LevelField& field, const core::ProgressCallback& progress,
                           sql::Connection& db, const repository::DatasetId& id) {
  WaterLevelRepository levels{db};
  const repository::FieldShape shape{field.grid, std::nullopt, ocean::Axis{field.times.nodes}};
  if (field.own_points)
    levels.create(id, field.datum, shape, {field.own_points->mesh});
  else
    levels.create(id, field.datum, shape);
  const std::size_t times = field.times.nodes.size();
  for (std::size_t time = 0; time < times; ++time) {
    const auto heights_m = field.read(time);
    if (!heights_m) return refuse(heights_m.error());
    levels.write(id, time, field.own_points ? field.own_points->in_order(*heights_m) : *heights_m);
    if (progress) progress("storing", 0.5 + 0.5 * static_cast<double>(time + 1) / static_cast<double>(times));
  }
  return {};
}

/// Reads the field once to check every value; it is read again to be written, so that memory holds one time.
Checked<PreparedDataset> prepare_levels(LevelField field, const core::ProgressCallback& progress) {
  const std::size_t times = field.times.nodes.size();
  if (times > max_grid_values / field.points())
    return refuse(messages::ingest_hdf5_message<"levels-too-large">(times, field.points(), max_grid_values));
  LevelSurvey survey;
  for (std::size_t time = 0; time < times; ++time) {
    const auto heights_m = field.read(time);
    if (!heights_m) return refuse(heights_m.error());
    if (const auto possible = survey.look_at(*heights_m); !possible) return refuse(possible.error());
    if (progress) progress("checking", 0.5 * static_cast<double>(time + 1) / static_cast<double>(times));
  }
  auto told = survey.result(field.datum);
  if (!told) return refuse(told.error());

  PreparedDataset data = dataset_of_levels(std::move(*told));
  data.bounds = field.grid.bounds();
  set_period(data, field.times.nodes.front(), field.times.nodes.back());
  data.rows_accepted = static_cast<std::int64_t>(field.points());
  data.keeping = field.own_points ? Keeping::at_own_points : keeping_on(field.grid.frame());
  data.write = [field = std::move(field), progress](sql::Connection& db, const repository::DatasetId& id) {
    return write_levels(field, progress, db, id);
  };
  return data;
}

void scale(std::vector<float>& heights, float unit_m) {
  for (float& height : heights) height *= unit_m;
}

Checked<PreparedDataset> levels_on_grid(const std::filesystem::path& file,
                                        const core::ProgressCallback& progress) {
  auto opened = s100_coverage(file, level_feature);
  if (!opened) return refuse(opened.error());
  auto head = level_head_of(*opened);
  if (!head) return refuse(head.error());
  auto times = s100_times(opened->records);
  if (!times) return refuse(times.error());
  const auto levels = std::make_shared<const S100Coverage>(std::move(*opened));
  const auto read = [levels, unit_m = head->unit_m,
                     records = times->source](std::size_t time) -> Checked<std::vector<float>> {
    const auto table = levels->table(records[time]);
    if (!table) return refuse(table.error());
    auto heights = levels->read(*table, level_name, 0, levels->grid.y().size());
    if (heights) scale(*heights, unit_m);
    return heights;
  };
  return prepare_levels({std::move(head->datum), std::move(*times), levels->grid, std::nullopt, read},
                        progress);
}

Checked<PreparedDataset> levels_on_mesh(const std::filesystem::path& file,
                                        const core::ProgressCallback& progress) {
  auto opened = s100_points(file, level_feature);
  if (!opened) return refuse(opened.error());
  auto head = level_head_of(*opened);
  if (!head) return refuse(head.error());
  auto times = s100_times(opened->records);
  if (!times) return refuse(times.error());
  const auto mesh = mesh_of(*opened);
  if (!mesh) return refuse(mesh.error());
  auto grid = ocean::lattice_for(mesh->mesh);
  if (!grid) return refuse(messages::ingest_grid_message<"positions-enclose-no-area">());
  if (!ocean::MeshSampling::of(mesh->mesh, *grid))
    return refuse(messages::ingest_grid_message<"cells-overlap">());
  auto own_points = repository::in_blocks(mesh->mesh);
  const auto levels = std::make_shared<const S100Points>(std::move(*opened));
  const auto read = [levels, unit_m = head->unit_m,
                     records = times->source](std::size_t time) -> Checked<std::vector<float>> {
    auto heights = levels->read(records[time], level_name);
    if (heights) scale(*heights, unit_m);
    return heights;
  };
  auto data = prepare_levels(
      {std::move(head->datum), std::move(*times), std::move(*grid), std::move(own_points), read}, progress);
  if (data)
    data->warnings.push_back(messages::ingest_grid_message<"kept-at-own-points">(
        static_cast<std::size_t>(data->rows_accepted), mesh->layout));
  return data;
}

/// The times of a station's record: at equal steps, or listed beside its levels.
Checked<AxisNodes> times_of_station(const Hdf5Group& area, const Hdf5Group& record, std::size_t count) {
  const auto first_text = [](const Hdf5Group& group) {
    const auto start = group.text("startDateTime");
    return start ? start : group.text("dateTimeOfFirstRecord");
  };
  const std::string stated = (first_text(record) ? first_text(record) : first_text(area)).value_or("");
  const auto start = s100_time(stated);
  const auto own_step_s = record.number("timeRecordInterval");
  const double step_s = (own_step_s ? own_step_s : area.number("timeRecordInterval")).value_or(0.0);
  const bool uniform = record.number("timeIntervalIndex").value_or(1.0) != 0.0;
  std::vector<double> times_s;
  if (uniform && start && step_s > 0.0) {
    for (std::size_t i = 0; i < count; ++i)
      times_s.push_back(core::unix_seconds(*start) + step_s * static_cast<double>(i));
    if (!times_s.empty() && !is_possible_time(times_s.back()))
      return refuse(messages::ingest_time_message<"time-out-of-range">(
          core::counted(count - 1, "step") + " of " + number(step_s) + " s after " + stated));
    return sorted_nodes("timeRecordInterval", std::move(times_s));
  }
  const auto table = record.table("values");
  if (!table) return refuse(table.error());
  const auto texts = table->texts(level_time_name);
  if (!texts) return refuse(texts.error());
  for (const std::string& text : *texts) {
    const auto time = s100_time(text);
    if (!time) return refuse(messages::ingest_hdf5_message<"s-time-unreadable">(text));
    times_s.push_back(core::unix_seconds(*time));
  }
  return sorted_nodes(level_time_name, std::move(times_s));
}

std::string station_name(const Hdf5Group& record) {
  const auto name = record.text("stationName");
  return name && !name->empty() ? *name : record.text("stationIdentification").value_or("");
}

/// A record for each station.
Checked<std::vector<WaterLevelStation>> stations_one_by_one_in(const S100Points& levels, float unit_m) {
  if (levels.records.size() != levels.places.size())
    return refuse(
        messages::ingest_hdf5_message<"level-stations-unequal">(levels.records.size(), levels.places.size()));
  const std::size_t most =
      std::min(longest_series, max_grid_points / std::max<std::size_t>(1, levels.places.size()));
  std::vector<WaterLevelStation> stations;
  for (std::size_t i = 0; i < levels.places.size(); ++i) {
    auto heights = levels.read_station(i, level_name);
    if (!heights) return refuse(heights.error());
    if (heights->size() > most)
      return refuse(messages::ingest_hdf5_message<"levels-too-large">(heights->size(), 1, most));
    scale(*heights, unit_m);
    const auto times = times_of_station(levels.area, levels.records[i], heights->size());
    if (!times) return refuse(times.error());
    if (heights->empty() || times->nodes.size() != heights->size())
      return refuse(messages::ingest_hdf5_message<"s-hundred-record-of-other-size">());
    WaterLevelStation station{station_name(levels.records[i]), levels.places[i], times->nodes, {}};
    for (const std::size_t source : times->source) station.heights_m.push_back((*heights)[source]);
    stations.push_back(std::move(station));
  }
  return stations;
}

/// A record for each time.
Checked<std::vector<WaterLevelStation>> stations_by_time_in(const S100Points& levels, float unit_m) {
  const auto times = s100_times(levels.records);
  if (!times) return refuse(times.error());
  if (times->nodes.size() > max_grid_points / levels.places.size())
    return refuse(messages::ingest_hdf5_message<"levels-too-large">(times->nodes.size(), levels.places.size(),
                                                                    max_grid_points));
  std::vector<WaterLevelStation> stations;
  for (const geo::LonLat place : levels.places) stations.push_back({"", place, times->nodes, {}});
  for (const std::size_t record : times->source) {
    auto heights = levels.read(record, level_name);
    if (!heights) return refuse(heights.error());
    scale(*heights, unit_m);
    for (std::size_t i = 0; i < stations.size(); ++i) stations[i].heights_m.push_back((*heights)[i]);
  }
  return stations;
}

Checked<PreparedDataset> levels_at_stations(const std::filesystem::path& file, S100Layout layout) {
  const auto levels = s100_points(file, level_feature);
  if (!levels) return refuse(levels.error());
  const auto head = level_head_of(*levels);
  if (!head) return refuse(head.error());
  if (levels->places.empty()) return refuse(messages::ingest_hdf5_message<"levels-all-missing">());
  auto stations = layout == S100Layout::stations ? stations_by_time_in(*levels, head->unit_m)
                                                 : stations_one_by_one_in(*levels, head->unit_m);
  if (!stations) return refuse(stations.error());
  LevelSurvey survey;
  double from_s = std::numeric_limits<double>::infinity();
  double to_s = -from_s;
  for (const WaterLevelStation& station : *stations) {
    if (const auto possible = survey.look_at(station.heights_m); !possible) return refuse(possible.error());
    from_s = std::min(from_s, station.times_s.front());
    to_s = std::max(to_s, station.times_s.back());
  }
  auto told = survey.result(head->datum);
  if (!told) return refuse(told.error());

  PreparedDataset data = dataset_of_levels(std::move(*told));
  data.bounds = geo::bounding_box(levels->places);
  set_period(data, from_s, to_s);
  data.rows_accepted = std::ssize(*stations);
  data.write = [stations = std::move(*stations), datum = head->datum](
                   sql::Connection& db, const repository::DatasetId& id) -> Checked<void> {
    WaterLevelRepository{db}.insert(id, datum, stations);
    return {};
  };
  return data;
}

}  // namespace

Checked<PreparedDataset> read_s104_levels(const std::filesystem::path& file,
                                          const core::ProgressCallback& progress) {
  const auto layout = s100_layout(file, level_feature);
  if (!layout) return refuse(layout.error());
  switch (*layout) {
    case S100Layout::points: return levels_on_mesh(file, progress);
    case S100Layout::stations:
    case S100Layout::stations_one_by_one: return levels_at_stations(file, *layout);
    case S100Layout::regular_grid:
    case S100Layout::other: break;  // s100_coverage refuses the others
  }
  return levels_on_grid(file, progress);
}

}  // namespace floeplan::ingest
