#include "storage/ingest/readers/bathymetry/bathymetry_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/repository/fields/field_overviews.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr float deepest_sea_m = 12000.0F;
constexpr float highest_land_m = 9000.0F;

/// Nodes in a band. With the range of its cells and the buffers of GDAL or HDF5, a band takes a quarter of a
/// reader's memory.
constexpr std::size_t band_nodes = 4'000'000;

using Rows = std::function<Checked<RawRows>(std::size_t, std::size_t)>;

/// The numbers of columns and rows of a file; points of their own count as rows of one column.
struct Sides {
  std::size_t columns{};
  std::size_t rows{};
};

Sides sides_of(const RawBathymetry& raw) {
  if (raw.own_points) return {1, raw.own_points->mesh.points.size()};
  return {raw.grid.x().size(), raw.grid.y().size()};
}

std::size_t rows_of_band(Sides sides) {
  constexpr std::size_t together = repository::FieldRepository::rows_together;
  return std::max<std::size_t>(band_nodes / sides.columns / together, 1) * together;
}

/// Calls `visit` with the first row and the rows of each band; stops at the first refusal.
template <class Visit>
Checked<bool> for_each_band(Sides sides, const Rows& read, const Visit& visit) {
  const std::size_t step = rows_of_band(sides);
  for (std::size_t first = 0; first < sides.rows; first += step) {
    auto rows = read(first, std::min(step, sides.rows - first));
    if (!rows) return refuse(rows.error());
    visit(first, *rows);
  }
  return true;
}

/// Whether producers use this number for "missing". 9999 is not among them: it is also a possible depth, and
/// counts as a mark only if no other value is as large.
bool is_certain_marker(float value) {
  constexpr std::array markers{32767.0F, 32768.0F, 99999.0F, 999999.0F};
  const float size = std::abs(value);
  return size >= 1e6F || std::find(markers.begin(), markers.end(), size) != markers.end();
}

bool is_doubtful_marker(float value) { return std::abs(value) == 9999.0F; }

/// A value and the first node that has it.
struct Extreme {
  float value{};
  std::size_t node{};
};

/// Facts about all values that are needed before the first can be stored.
class Survey {
 public:
  explicit Survey(std::size_t columns) : columns_{columns} {}

  void look_at(std::size_t first_row, const RawRows& rows) {
    for (std::size_t i = 0; i < rows.values_m.size(); ++i) {
      const float value = rows.values_m[i];
      if (std::isnan(value)) continue;
      const Extreme met{value, first_row * columns_ + i};
      if (is_certain_marker(value)) {
        ++certain_;
      } else if (is_doubtful_marker(value)) {
        ++doubtful_;
        widen(with_doubtful_, met);
      } else {
        widen(without_, met);
        if (std::abs(value) > 9000.0F) other_is_large_ = true;
        for (const auto* const ends : {&rows.lowest_m, &rows.highest_m})
          if (!ends->empty() && !std::isnan((*ends)[i])) widen(cells_, {(*ends)[i], met.node});
      }
      if (!rows.lowest_m.empty() && rows.lowest_m[i] < value) reaches_lower_ = true;
      if (!rows.highest_m.empty() && rows.highest_m[i] > value) reaches_higher_ = true;
    }
  }

  [[nodiscard]] bool is_marker(float value) const {
    return is_certain_marker(value) || (is_doubtful_marker(value) && !other_is_large_);
  }
  [[nodiscard]] std::int64_t markers() const { return certain_ + (other_is_large_ ? 0 : doubtful_); }
  /// The lowest and the highest value; empty if every value is missing.
  [[nodiscard]] std::optional<std::pair<Extreme, Extreme>> range() const {
    Range range = without_;
    if (other_is_large_ && with_doubtful_) {
      widen(range, with_doubtful_->first);
      widen(range, with_doubtful_->second);
    }
    return range;
  }
  /// The shoalest value in any cell; empty if the ranges of cells are not known.
  [[nodiscard]] std::optional<Extreme> shoalest_cell(VerticalSense sense) const {
    if (!cells_ || !has_shoaler_cells(sense)) return std::nullopt;
    return sense == VerticalSense::up ? cells_->second : cells_->first;
  }
  /// Whether any cell has values shoaler than the value of its node.
  [[nodiscard]] bool has_shoaler_cells(VerticalSense sense) const {
    return sense == VerticalSense::up ? reaches_higher_ : reaches_lower_;
  }

 private:
  using Range = std::optional<std::pair<Extreme, Extreme>>;  // lowest and highest value

  static void widen(Range& range, const Extreme& met) {
    if (!range) range = {met, met};
    if (met.value < range->first.value) range->first = met;
    if (met.value > range->second.value) range->second = met;
  }

  std::size_t columns_;
  Range without_;
  Range with_doubtful_;
  Range cells_;  // range of the cells of nodes that are not missing
  std::int64_t certain_{};
  std::int64_t doubtful_{};
  bool other_is_large_{false};
  bool reaches_lower_{false};
  bool reaches_higher_{false};
};

bool covers_the_globe(const ocean::HorizontalGrid& grid) {
  const ocean::Axis& x = grid.x();
  const ocean::Axis& y = grid.y();
  return std::holds_alternative<geo::GeographicFrame>(grid.frame()) &&
         x.back() - x.front() + x.mean_step() > 359.0 && y.back() - y.front() + y.mean_step() > 170.0;
}

geo::LonLat place_of(const RawBathymetry& raw, std::size_t node) {
  if (raw.own_points) return raw.own_points->mesh.points[node];
  return raw.grid.place(node % raw.grid.x().size(), node / raw.grid.x().size());
}

std::optional<messages::Message> fault_of_depths(const RawBathymetry& raw, VerticalSense sense,
                                                 const std::pair<Extreme, Extreme>& range,
                                                 const std::optional<Extreme>& shoalest_cell) {
  for (const Extreme& extreme : {range.first, range.second, shoalest_cell.value_or(range.first)}) {
    const float depth_m = sense == VerticalSense::up ? 0.0F - extreme.value : extreme.value;
    if (depth_m <= deepest_sea_m && depth_m >= -highest_land_m) continue;
    const geo::LonLat at = place_of(raw, extreme.node);
    const std::string what = depth_m > 0.0F ? "a depth of " + number(static_cast<double>(depth_m)) + " m"
                                            : "land " + number(static_cast<double>(-depth_m)) + " m high";
    return messages::ingest_depth_message<"depth-impossible">(raw.description.name, what, number(at.lon_deg),
                                                              number(at.lat_deg));
  }
  return std::nullopt;
}

/// Rows in the form in which they are stored: positive down, NaN for missing.
struct DepthRows {
  std::vector<float> depth_m;
  std::vector<float> shoalest_m;  // shoalest depth of each cell; empty if the ranges of cells are not known
};

DepthRows depths_of(const RawRows& rows, VerticalSense sense, const Survey& survey) {
  const bool up = sense == VerticalSense::up;
  const auto depth = [&](float value) { return up ? 0.0F - value : value; };
  DepthRows result;
  result.depth_m.reserve(rows.values_m.size());
  for (const float value : rows.values_m)
    result.depth_m.push_back(survey.is_marker(value) ? missing : depth(value));
  const std::vector<float>& bounds = up ? rows.highest_m : rows.lowest_m;
  if (bounds.empty()) return result;
  result.shoalest_m = result.depth_m;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const float bound = depth(bounds[i]);
    if (bound < result.shoalest_m[i]) result.shoalest_m[i] = bound;  // false for a missing bound (NaN)
  }
  return result;
}

/// Depths at points of their own, all of one slice, and beside them the shoalest of each cell where it is known.
Checked<void> write_at_own_points(const RawBathymetry& raw, const Survey& survey, VerticalSense sense,
                                  sql::Connection& db, const repository::DatasetId& id) {
  DepthRows all;
  const auto read = for_each_band(sides_of(raw), raw.read, [&](std::size_t, const RawRows& rows) {
    const DepthRows band = depths_of(rows, sense, survey);
    all.depth_m.insert(all.depth_m.end(), band.depth_m.begin(), band.depth_m.end());
    all.shoalest_m.insert(all.shoalest_m.end(), band.shoalest_m.begin(), band.shoalest_m.end());
  });
  if (!read) return tl::unexpected(read.error());
  repository::FieldRepository fields{db};
  fields.create(id, {raw.grid, std::nullopt, std::nullopt}, {raw.own_points->mesh});
  fields.write_slice(id, "depth_m", 0, 0, all.depth_m);
  if (survey.has_shoaler_cells(sense)) fields.write_slice(id, "shoalest_m", 0, 0, all.shoalest_m);
  return {};
}

/// If all rows fit into one band, they are kept and not read again.
Rows kept_if_alone(Sides sides, Rows read) {
  if (rows_of_band(sides) < sides.rows) return read;
  return [kept = std::make_shared<std::optional<RawRows>>(), read = std::move(read)](
             std::size_t first, std::size_t rows) -> Checked<RawRows> {
    if (*kept) return **kept;
    auto all = read(first, rows);
    if (all) *kept = *all;
    return all;
  };
}

}  // namespace

std::function<Checked<RawRows>(std::size_t, std::size_t)> rows_in_memory(RawRows all, std::size_t columns) {
  return [all = std::make_shared<const RawRows>(std::move(all)), columns](
             std::size_t first, std::size_t rows) -> Checked<RawRows> {
    const auto part = [&](const std::vector<float>& values) {
      if (values.empty()) return values;
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first * columns);
      return std::vector<float>(begin, begin + static_cast<std::ptrdiff_t>(rows * columns));
    };
    return RawRows{part(all->values_m), part(all->lowest_m), part(all->highest_m)};
  };
}

void widen(RawRows& rows, const std::vector<float>& uncertainty_m) {
  if (rows.lowest_m.empty()) rows.lowest_m = rows.values_m;
  if (rows.highest_m.empty()) rows.highest_m = rows.values_m;
  for (std::size_t i = 0; i < uncertainty_m.size(); ++i) {
    if (!(uncertainty_m[i] > 0.0F) || uncertainty_m[i] > 1000.0F) continue;  // missing, or a mark for missing
    rows.lowest_m[i] -= uncertainty_m[i];
    rows.highest_m[i] += uncertainty_m[i];
  }
}

Checked<PreparedDataset> prepare_bathymetry(RawBathymetry raw, const std::optional<std::string>& positive) {
  const Sides sides = sides_of(raw);
  raw.read = kept_if_alone(sides, std::move(raw.read));
  Survey survey{sides.columns};
  const auto surveyed = for_each_band(
      sides, raw.read, [&](std::size_t first_row, const RawRows& rows) { survey.look_at(first_row, rows); });
  if (!surveyed) return refuse(surveyed.error());

  PreparedDataset data;
  data.kind = repository::DatasetKind::bathymetry;
  data.variables = {raw.description.name};
  data.warnings = raw.warnings;
  if (const std::int64_t markers = survey.markers(); markers > 0)
    data.warnings.push_back(messages::ingest_depth_message<"depth-markers-left-out">(markers));

  const auto range = survey.range();
  if (!range) return refuse(messages::ingest_depth_message<"depths-all-missing">(raw.description.name));
  const auto finding =
      vertical_sense_of(positive, raw.description,
                        {static_cast<double>(range->first.value), static_cast<double>(range->second.value),
                         covers_the_globe(raw.grid)});
  if (!finding) return refuse(finding.error());
  if (const auto& warning = finding->warning) data.warnings.push_back(*warning);
  if (const auto fault = fault_of_depths(raw, finding->sense, *range, survey.shoalest_cell(finding->sense)))
    return refuse(*fault);

  data.bounds = raw.grid.bounds();
  data.rows_accepted = static_cast<std::int64_t>(sides.columns * sides.rows);
  if (raw.own_points) {
    data.keeping = Keeping::at_own_points;
    data.write = [raw = std::move(raw), survey, sense = finding->sense](
                     sql::Connection& db, const repository::DatasetId& id) -> Checked<void> {
      return write_at_own_points(raw, survey, sense, db, id);
    };
    return data;
  }
  data.keeping = keeping_on(raw.grid.frame());
  data.write = [grid = std::move(raw.grid), read = std::move(raw.read), survey, sense = finding->sense](
                   sql::Connection& db, const repository::DatasetId& id) -> Checked<void> {
    repository::FieldRepository fields{db};
    fields.create(id, {grid, std::nullopt, std::nullopt});
    const auto written = for_each_band({grid.x().size(), grid.y().size()}, read,
                                       [&](std::size_t first_row, const RawRows& rows) {
                                         const DepthRows depths = depths_of(rows, sense, survey);
                                         fields.write_rows(id, "depth_m", first_row, depths.depth_m);
                                         if (survey.has_shoaler_cells(sense))
                                           fields.write_rows(id, "shoalest_m", first_row, depths.shoalest_m);
                                       });
    if (!written) return tl::unexpected(written.error());
    repository::FieldOverviews{db}.make(id, "depth_m");
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
