#include "storage/ingest/grids/mesh_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/messages/ingest_grid_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/formats/netcdf/formula_terms.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

const NetcdfVariable* find_first(const NetcdfFile& file, std::initializer_list<std::string> names) {
  for (const std::string& name : names)
    if (const NetcdfVariable* variable = file.find(name)) return variable;
  return nullptr;
}

/// A table of lengths at every point of a mesh, constant or for every time.
class PointTable {
 public:
  /// nullopt if the variable does not have these dimensions or is not a length.
  static std::optional<PointTable> of(const NetcdfVariable* table, const std::string& points,
                                      const AxisNodes& times) {
    if (table == nullptr || !table->is_numeric() || table->dimensions().empty() ||
        table->dimensions().back().name != points)
      return std::nullopt;
    const auto& dimensions = table->dimensions();
    const bool fits =
        dimensions.size() == 1 ||
        (dimensions.size() == 2 && (dimensions[0].size == 1 || dimensions[0].size == times.nodes.size()));
    const std::string unit = table->attribute("units");
    const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
    if (!fits || !factor) return std::nullopt;
    return PointTable{*table, times, *factor};
  }

  [[nodiscard]] std::size_t points() const {
    return static_cast<std::size_t>(table_->dimensions().back().size);
  }
  [[nodiscard]] const NetcdfVariable& variable() const { return *table_; }

  /// The table's values (depths or elevations) at all points at one time, converted to metres; NaN where
  /// missing.
  [[nodiscard]] Checked<std::vector<double>> read(std::size_t time) const {
    std::vector<std::uint64_t> start;
    std::vector<std::size_t> count;
    if (table_->dimensions().size() == 2) {
      start.push_back(table_->dimensions()[0].size == 1 ? 0 : times_.source[time]);
      count.push_back(1);
    }
    start.push_back(0);
    count.push_back(points());
    auto values = table_->read_packed(start, count);
    if (!values) return values;
    table_->unpack(*values);
    for (double& value : *values) value *= factor_;
    return values;
  }

 private:
  PointTable(const NetcdfVariable& table, AxisNodes times, double factor)
      : table_{&table}, times_{std::move(times)}, factor_{factor} {}

  const NetcdfVariable* table_;  // borrowed
  AxisNodes times_;
  double factor_;
};

messages::Message too_deep(const NetcdfVariable& table, double depth_m) {
  return messages::ingest_grid_message<"bed-impossible">(table.name(), number(depth_m));
}

class SigmaLevels : public BedLevels {
 public:
  struct Parts {
    std::shared_ptr<const NetcdfFile> file;  // a reference that keeps the file open
    std::vector<double> sigma;               // [level] or [level][point], in the file's order
    std::size_t levels{};
    PointTable bed;  // depth of the bed
    std::optional<PointTable>
        surface;  // elevation of the surface; empty: depths count from the instantaneous or the mean surface
  };

  explicit SigmaLevels(Parts parts) : parts_{std::move(parts)} {
    const std::size_t stride = parts_.sigma.size() / parts_.levels;
    upwards_ = parts_.sigma.front() < parts_.sigma[(parts_.levels - 1) * stride];
  }

  [[nodiscard]] std::size_t file_level(std::size_t level) const override {
    return upwards_ ? parts_.levels - 1 - level : level;
  }

  [[nodiscard]] Checked<std::vector<float>> depths(std::size_t time, std::size_t level) const override {
    const auto bed_m = parts_.bed.read(time);
    if (!bed_m) return refuse(bed_m.error());
    std::vector<double> surface_m(bed_m->size(), 0.0);
    if (parts_.surface) {
      auto values = parts_.surface->read(time);
      if (!values) return refuse(values.error());
      surface_m = std::move(*values);
    }
    const bool per_point = parts_.sigma.size() > parts_.levels;
    std::vector<float> result(bed_m->size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      const std::size_t row = level == parts_.levels ? 0 : file_level(level);
      const double sigma =
          level == parts_.levels ? -1.0 : parts_.sigma[per_point ? row * result.size() + i : row];
      // tidal flats above the mean surface have negative depths
      const double bed = (*bed_m)[i] > 0.0 ? (*bed_m)[i] : 0.0;
      const double above_mean = std::isfinite(surface_m[i]) ? surface_m[i] : 0.0;
      result[i] = static_cast<float>(-sigma * (bed + above_mean));
    }
    return result;
  }

 private:
  Parts parts_;
  bool upwards_{false};
};

/// Levels whose heights are given in a table.
class HeightLevels : public BedLevels {
 public:
  struct Parts {
    std::shared_ptr<const NetcdfFile> file;  // a reference that keeps the file open
    const NetcdfVariable* table{nullptr};
    std::size_t level_dimension{};
    std::size_t point_dimension{};
    AxisNodes times;
    double factor{1.0};  // metres per unit of the table, positive up
  };

  static Checked<std::shared_ptr<const BedLevels>> of(Parts parts) {
    auto levels = std::make_shared<HeightLevels>(std::move(parts));
    const auto read = levels->read_columns(0);
    if (!read) return refuse(read.error());
    const auto& dimension = levels->parts_.table->dimensions()[levels->parts_.level_dimension];
    for (std::size_t point = 0; point < levels->points(); ++point) {
      double lowest = std::numeric_limits<double>::infinity();
      double highest = -lowest;
      std::optional<double> first;
      double last = 0.0;
      for (std::size_t level = 0; level < dimension.size; ++level) {
        const double height = levels->height(level, point);
        if (std::isnan(height)) continue;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        first = first.value_or(height);
        last = height;
      }
      if (highest - lowest > max_bed_depth_m)
        return refuse(too_deep(*levels->parts_.table, highest - lowest));
      if (first && *first != last) levels->upwards_ = *first < last;
    }
    return levels;
  }

  explicit HeightLevels(Parts parts) : parts_{std::move(parts)} {}

  [[nodiscard]] std::size_t file_level(std::size_t level) const override {
    return upwards_ ? levels() - 1 - level : level;
  }

  [[nodiscard]] Checked<std::vector<float>> depths(std::size_t time, std::size_t level) const override {
    if (const auto read = read_columns(time); !read) return refuse(read.error());
    std::vector<float> result(points(), missing);
    for (std::size_t point = 0; point < result.size(); ++point) {
      const double surface = extreme(point, [](double a, double b) { return std::max(a, b); });
      const double here = level == levels()
                              ? extreme(point, [](double a, double b) { return std::min(a, b); })
                              : height(file_level(level), point);
      result[point] = static_cast<float>(surface - here);
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t size_of(std::size_t dimension) const {
    return static_cast<std::size_t>(parts_.table->dimensions()[dimension].size);
  }
  [[nodiscard]] std::size_t levels() const { return size_of(parts_.level_dimension); }
  [[nodiscard]] std::size_t points() const { return size_of(parts_.point_dimension); }

  [[nodiscard]] double height(std::size_t level, std::size_t point) const {
    return static_cast<double>(parts_.level_dimension > parts_.point_dimension
                                   ? heights_m_[point * levels() + level]
                                   : heights_m_[level * points() + point]);
  }

  /// Highest or lowest level of a column, as `choose` decides; NaN for a column without levels.
  template <class Choose>
  [[nodiscard]] double extreme(std::size_t point, const Choose& choose) const {
    double found = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t level = 0; level < levels(); ++level) {
      const double here = height(level, point);
      if (!std::isnan(here)) found = std::isnan(found) ? here : choose(found, here);
    }
    return found;
  }

  Checked<bool> read_columns(std::size_t time) const {
    if (time_read_ && *time_read_ == time) return true;
    const auto& dimensions = parts_.table->dimensions();
    std::vector<std::uint64_t> start(dimensions.size(), 0);
    std::vector<std::size_t> count(dimensions.size(), 1);
    for (const std::size_t dimension : {parts_.level_dimension, parts_.point_dimension})
      count[dimension] = size_of(dimension);
    if (dimensions.size() == 3 && dimensions[0].size > 1) start[0] = parts_.times.source[time];
    auto values = parts_.table->read_packed(start, count);
    if (!values) return refuse(values.error());
    parts_.table->unpack(*values);
    heights_m_.resize(values->size());
    std::ranges::transform(*values, heights_m_.begin(),
                           [&](double value) { return static_cast<float>(value * parts_.factor); });
    time_read_ = time;
    return true;
  }

  Parts parts_;
  bool upwards_{true};
  mutable std::vector<float> heights_m_;  // heights of the time read last, in the file's order
  mutable std::optional<std::size_t> time_read_;
};

std::optional<std::size_t> dimension_called(const NetcdfVariable& variable, const std::string& name) {
  for (std::size_t i = 0; i < variable.dimensions().size(); ++i)
    if (variable.dimensions()[i].name == name) return i;
  return std::nullopt;
}

Checked<MeshLevels> levels_by_heights(const std::shared_ptr<const NetcdfFile>& file,
                                      const NetcdfVariable& table, const std::string& level_dimension,
                                      const MeshTopology& mesh, const AxisNodes& times) {
  const auto level = dimension_called(table, level_dimension);
  const auto node = dimension_called(table, mesh.node_dimension);
  const auto face = dimension_called(table, mesh.face_dimension);
  const auto& dimensions = table.dimensions();
  const bool fits =
      dimensions.size() == 2 ||
      (dimensions.size() == 3 && (dimensions[0].size == 1 || dimensions[0].size == times.nodes.size()));
  const std::string unit = table.attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!level || (!node && !face) || !fits ||
      (dimensions.size() == 3 && (*level == 0 || node == 0U || face == 0U)))
    return refuse(messages::ingest_grid_message<"level-heights-elsewhere">(table.name()));
  if (!factor)
    return refuse(messages::ingest_grid_message<"level-heights-without-length">(table.name(), unit));
  auto levels =
      HeightLevels::of({.file = file,
                        .table = &table,
                        .level_dimension = *level,
                        .point_dimension = node ? *node : *face,
                        .times = times,
                        .factor = lower(table.attribute("positive")) == "down" ? -*factor : *factor});
  if (!levels) return refuse(levels.error());
  return MeshLevels{std::move(*levels), !node};
}

}  // namespace

Checked<MeshLevels> mesh_levels(const std::shared_ptr<const NetcdfFile>& file, const NetcdfVariable& variable,
                                const NetcdfLayout& layout, const MeshTopology& mesh, Messages& warnings) {
  const NetcdfDimension& dimension = variable.dimensions()[layout.depth_dimension.value()];
  const AxisNodes times = layout.times_s.value_or(AxisNodes{{0.0}, {0}});
  if (const NetcdfVariable* heights = heights_along(*file, dimension))
    return levels_by_heights(file, *heights, dimension.name, mesh, times);

  const NetcdfVariable* coordinate = coordinate_of(*file, dimension);
  if (coordinate == nullptr) coordinate = find_first(*file, {dimension.name, "siglay", "sigma"});
  const std::string layout_name = coordinate == nullptr ? "" : lower(coordinate->attribute("standard_name"));
  if (layout_name.starts_with("ocean_") && !layout_name.starts_with("ocean_sigma_coordinate") &&
      !layout_name.starts_with("ocean_sigma/"))
    return refuse(messages::ingest_grid_message<"levels-of-unknown-layout">(coordinate->name(), layout_name,
                                                                            " on a mesh"));

  const auto named = [&](const char* term, std::initializer_list<std::string> usual) {
    const std::string name = formula_term(coordinate, term);
    return name.empty() ? find_first(*file, usual) : file->find(name);
  };
  const NetcdfVariable* sigma = named("sigma", {dimension.name, "siglay", "sigma"});
  if (sigma == nullptr) sigma = coordinate;
  const NetcdfVariable* bed_table = named("depth", {"h", "depth"});
  auto bed = PointTable::of(bed_table, mesh.node_dimension, times);
  const bool in_faces = !bed;
  const std::string& points = in_faces ? mesh.face_dimension : mesh.node_dimension;
  if (!bed) bed = PointTable::of(bed_table, points, times);
  if (sigma == nullptr || !bed)
    return refuse(messages::ingest_grid_message<"levels-incomplete">(
        variable.name(),
        sigma == nullptr ? "where they lie between the surface and the bed"
                         : "how deep the sea is at the nodes or in the faces of its mesh",
        "Ask the producer for a complete file"));
  auto values = sigma->read_all();
  if (!values) return refuse(values.error());
  const auto bed_m = bed->read(0);
  if (!bed_m) return refuse(bed_m.error());
  const std::size_t levels = layout.bed_levels;
  const bool per_point =
      values->size() == levels * bed->points() && sigma->dimensions().back().name == points;
  const bool possible =
      std::ranges::all_of(*values, [](double value) { return value >= -1.0 - 1e-4 && value <= 1e-4; });
  if ((values->size() != levels && !per_point) || !possible)
    return refuse(messages::ingest_grid_message<"levels-no-shares">(sigma->name()));
  for (const double depth : *bed_m)
    if (depth > max_bed_depth_m) return refuse(too_deep(*bed_table, depth));

  const bool of_the_moment = is_depth_of_the_moment(*bed_table);
  auto surface = of_the_moment ? std::nullopt : PointTable::of(named("eta", {"zeta"}), points, times);
  if (!surface && !of_the_moment) warnings.push_back(messages::ingest_grid_message<"surface-not-stated">());
  return MeshLevels{std::make_shared<const SigmaLevels>(SigmaLevels::Parts{.file = file,
                                                                           .sigma = std::move(*values),
                                                                           .levels = levels,
                                                                           .bed = std::move(*bed),
                                                                           .surface = std::move(surface)}),
                    in_faces};
}

}  // namespace floeplan::ingest
