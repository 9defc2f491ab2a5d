#include "storage/ingest/current_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "storage/ingest/netcdf_layout.hpp"
#include "storage/ingest/text.hpp"
#include "storage/ingest/velocity_pair.hpp"
#include "storage/ingest/zero_land.hpp"
#include "storage/repository/field_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr double max_speed_m_s = 10.0;
constexpr std::uint64_t max_values = 4'000'000'000;  // of one component in one file

/// Both components of one slice, m/s, NaN where missing.
struct Slice {
  std::vector<float> u;
  std::vector<float> v;
  std::int64_t undeclared_fill{};  // values taken as missing although the file does not say so
};

/// Everything needed to read slices of one file, now or later.
struct CurrentSource {
  std::shared_ptr<const NetcdfFile> file;
  VelocityPair pair;
  NetcdfLayout layout;
  double east_factor{1.0};  // metres per second in one of the component's unit
  double north_factor{1.0};
  std::size_t levels{1};
  std::size_t times{1};
};

/// Numbers that producers write for "missing" without declaring them, when they are also too large for a
/// current.
bool is_undeclared_fill(double value, double factor) {
  constexpr std::array markers{999.0, 9999.0, 99999.0, 32767.0, 32768.0};
  if (std::abs(value) * factor <= max_speed_m_s) return false;
  return std::abs(value) >= 1e10 ||
         std::find(markers.begin(), markers.end(), std::abs(value)) != markers.end();
}

Checked<Slice> read(const CurrentSource& source, std::size_t time, std::size_t level) {
  const auto east = read_slice(*source.pair.east, source.layout, time, level);
  if (!east) return refuse(east.error());
  const auto north = read_slice(*source.pair.north, source.layout, time, level);
  if (!north) return refuse(north.error());

  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  Slice slice{std::vector<float>(east->size(), missing), std::vector<float>(east->size(), missing), 0};
  for (std::size_t i = 0; i < east->size(); ++i) {
    const double u = (*east)[i];
    const double v = (*north)[i];
    if (std::isnan(u) || std::isnan(v)) continue;
    if (is_undeclared_fill(u, source.east_factor) || is_undeclared_fill(v, source.north_factor)) {
      ++slice.undeclared_fill;
      continue;
    }
    slice.u[i] = static_cast<float>(u * source.east_factor);
    slice.v[i] = static_cast<float>(v * source.north_factor);
  }
  return slice;
}

std::string too_fast(const CurrentSource& source, std::size_t node, double speed) {
  const std::size_t columns = source.layout.x.nodes.size();
  const std::string where = "longitude " + number(source.layout.x.nodes[node % columns]) + ", latitude " +
                            number(source.layout.y.nodes[node / columns]);
  if (source.pair.east->attribute("units").empty())
    return "the current reaches " + number(speed, 4) + " at " + where +
           " and the file states no unit; in m/s no ocean is that fast, so the unit is probably cm/s; ask "
           "the producer, or add the units attribute";
  return "the current reaches " + number(speed, 4) + " m/s at " + where +
         "; no ocean is that fast; the unit is wrong or the file marks missing values without declaring "
         "them; ask the producer";
}

struct Survey {
  std::int64_t valid{};
  std::int64_t undeclared_fill{};
  std::shared_ptr<ZeroLand> land;
};

/// Reads every value once.
Checked<Survey> survey(const CurrentSource& source, const core::ProgressCallback& progress) {
  Survey result{
      0, 0,
      std::make_shared<ZeroLand>(source.layout.x.nodes.size(), source.layout.y.nodes.size(), source.levels)};
  for (std::size_t time = 0; time < source.times; ++time) {
    for (std::size_t level = 0; level < source.levels; ++level) {
      const auto slice = read(source, time, level);
      if (!slice) return refuse(slice.error());
      for (std::size_t i = 0; i < slice->u.size(); ++i) {
        if (std::isnan(slice->u[i])) continue;
        ++result.valid;
        const double speed = std::hypot(slice->u[i], slice->v[i]);
        if (speed > max_speed_m_s) return refuse(too_fast(source, i, speed));
      }
      result.undeclared_fill += slice->undeclared_fill;
      result.land->add(level, slice->u, slice->v);
    }
    if (progress)
      progress("checking", 0.5 * static_cast<double>(time + 1) / static_cast<double>(source.times));
  }
  return result;
}

tl::expected<void, std::string> write(const CurrentSource& source, const ZeroLand* land,
                                      const core::ProgressCallback& progress, sqlite::Connection& db,
                                      const repository::DatasetId& id) {
  repository::FieldRepository fields{db};
  const auto optional_axis = [](const std::optional<AxisNodes>& nodes) -> std::optional<ocean::Axis> {
    if (!nodes) return std::nullopt;
    return ocean::Axis{nodes->nodes};
  };
  fields.create(id, {ocean::HorizontalGrid{geo::GeographicFrame{}, ocean::Axis{source.layout.x.nodes},
                                           ocean::Axis{source.layout.y.nodes}},
                     optional_axis(source.layout.depths_m), optional_axis(source.layout.times_s)});

  for (std::size_t time = 0; time < source.times; ++time) {
    for (std::size_t level = 0; level < source.levels; ++level) {
      auto slice = read(source, time, level);
      if (!slice) return refuse(slice.error());
      for (std::size_t i = 0; land != nullptr && i < slice->u.size(); ++i)
        if (land->is_land(level, i)) slice->u[i] = slice->v[i] = std::numeric_limits<float>::quiet_NaN();
      fields.write_slice(id, "u_m_s", time, level, slice->u);
      fields.write_slice(id, "v_m_s", time, level, slice->v);
    }
    if (progress)
      progress("storing", 0.5 + 0.5 * static_cast<double>(time + 1) / static_cast<double>(source.times));
  }
  return {};
}

Checked<CurrentSource> open_source(const std::shared_ptr<const NetcdfFile>& file,
                                   std::vector<std::string>& warnings) {
  auto pair = find_velocity_pair(*file);
  if (!pair) return refuse(pair.error());
  auto layout = layout_of(*file, *pair->east);
  if (!layout) return refuse(layout.error());
  if (layout->projected)
    return refuse(
        "the currents lie on a projected grid; this layout is not yet supported; interpolate them to a "
        "regular longitude-latitude grid first");
  if (!layout->times_s)
    return refuse(
        "the file does not say for which time its currents hold; a plan needs to know; ask the producer for "
        "a file with a time axis");
  const auto east = speed_factor_of(*pair->east, warnings);
  if (!east) return refuse(east.error());
  const auto north = speed_factor_of(*pair->north, warnings);
  if (!north) return refuse(north.error());

  warnings.insert(warnings.end(), pair->warnings.begin(), pair->warnings.end());
  warnings.insert(warnings.end(), layout->warnings.begin(), layout->warnings.end());
  const std::size_t levels = layout->depths_m ? layout->depths_m->nodes.size() : 1;
  const std::size_t times = layout->times_s->nodes.size();
  const std::uint64_t nodes = layout->x.nodes.size() * layout->y.nodes.size();
  if (levels * times > max_values / nodes)
    return refuse("the file holds " + std::to_string(times) + " times and " + std::to_string(levels) +
                  " depths of " + std::to_string(nodes) +
                  " nodes, more than this program accepts; cut out your area and period first");
  return CurrentSource{.file = file,
                       .pair = std::move(*pair),
                       .layout = std::move(*layout),
                       .east_factor = *east,
                       .north_factor = *north,
                       .levels = levels,
                       .times = times};
}

}  // namespace

Checked<PreparedDataset> read_currents(const std::shared_ptr<const NetcdfFile>& file,
                                       const core::ProgressCallback& progress) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::currents;
  auto source = open_source(file, data.warnings);
  if (!source) return refuse(source.error());
  const auto found = survey(*source, progress);
  if (!found) return refuse(found.error());
  if (found->valid == 0)
    return refuse("every value of \"" + source->pair.east->name() + "\" and \"" + source->pair.north->name() +
                  "\" is missing; there is nothing to store; check the area and the period of your download");
  if (found->land->everything_is_zero())
    return refuse(
        "every current in the file is exactly zero; that is a file without data, not still water; check the "
        "area and the period of your download");

  const NetcdfLayout& layout = source->layout;
  data.variables = {source->pair.east->name(), source->pair.north->name()};
  if (found->undeclared_fill > 0)
    data.warnings.push_back(
        std::to_string(found->undeclared_fill) +
        " values are markers for \"missing\" that the file does not declare; they were left out");
  const std::shared_ptr<const ZeroLand> land = found->land->found() ? found->land : nullptr;
  if (land)
    data.warnings.push_back("the file marks no land, but " + number(100.0 * land->share(), 3) +
                            " % of its nodes are exactly zero at all times and lie together; taken as land");

  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{layout.x.nodes},
                                   ocean::Axis{layout.y.nodes}};
  data.bounds = grid.bounds();
  data.rows_accepted = static_cast<std::int64_t>(grid.size());
  data.time_start = core::from_unix_seconds(layout.times_s->nodes.front());
  data.time_end = core::from_unix_seconds(layout.times_s->nodes.back());
  data.write = [source = std::move(*source), land, progress](sqlite::Connection& db,
                                                             const repository::DatasetId& id) {
    return write(source, land.get(), progress, db, id);
  };
  return data;
}

}  // namespace floeplan::ingest
