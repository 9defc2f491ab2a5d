#include "storage/ingest/readers/currents/component_source.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "storage/ingest/common/missing_value.hpp"

namespace floeplan::ingest {
namespace {

/// The evidence of the faces of a model's cell. `dry`: no face has shown water, and no mask or zero has shown
/// land.
enum class Cell { dry, water, land };

/// All cells of one level at one time.
class Cells {
 public:
  explicit Cells(const Staggering& way) : cells_(way.all_rows * way.all_columns, Cell::dry) {}

  void add_face(const CentresBeside& centres, double value, const ZeroLand* land) {
    // If the file marks land by zeros, a zero is no evidence of water.
    if (std::isnan(value) || (land != nullptr && value == 0.0)) return;
    for (const auto centre : {centres.before, centres.after})
      if (centre) cells_[*centre] = Cell::water;
  }
  void add_land(const Staggering& way, const ZeroLand& land, std::size_t level) {
    for (std::size_t row = 0; row < way.rows; ++row)
      for (std::size_t column = 0; column < way.columns; ++column)
        cells_[(row + way.first_row) * way.all_columns + column + way.second_column] =
            land.is_land(level, row * way.columns + column) ? Cell::land : Cell::water;
  }
  void add_land(const WaterMask& mask) {
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (!mask.is_water(i)) cells_[i] = Cell::land;
  }

  [[nodiscard]] bool is(std::optional<std::size_t> centre, Cell what) const {
    return centre && cells_[*centre] == what;
  }

  /// The value of a face, from the file's `value`, which is NaN over land.
  [[nodiscard]] float face(const CentresBeside& centres, double value) const {
    const bool at_land = is(centres.before, Cell::land) || is(centres.after, Cell::land);
    if (!std::isnan(value) && !at_land) return static_cast<float>(value);
    const bool at_water = is(centres.before, Cell::water) || is(centres.after, Cell::water);
    return at_water ? 0.0F : missing;
  }

 private:
  std::vector<Cell> cells_;
};

}  // namespace

template <class First, class Second>
void ComponentSource::for_each_point(const First& of_first, const Second& of_second) const {
  std::size_t point = 0;
  for (std::size_t row = 0; row < planes_.first_rows; ++row)
    for (std::size_t column = 0; column < planes_.first_columns; ++column)
      of_first(point++, row * parts_->first.columns() + column,
               beside_first(parts_->staggering, row, column));
  for (std::size_t row = 0; row < planes_.second_rows; ++row)
    for (std::size_t column = 0; column < planes_.second_columns; ++column)
      of_second(point++, row * parts_->second.columns() + column,
                beside_second(parts_->staggering, row, column));
}

ComponentSource ComponentSource::of_level(std::size_t level) const {
  ComponentSource one = *this;
  one.first_level_ += level;
  return one;
}

Checked<std::pair<ComponentSlice, ComponentSlice>> GridComponents::read(std::size_t time,
                                                                        std::size_t level) const {
  const std::size_t file_level = levels ? levels->file_level(level) : level;
  auto u = first.read(time, file_level);
  if (!u) return refuse(u.error());
  auto v = second.read(time, file_level);
  if (!v) return refuse(v.error());
  first_mask.apply(u->values);
  second_mask.apply(v->values);
  return std::pair{std::move(*u), std::move(*v)};
}

Checked<PointComponents> ComponentSource::read(std::size_t time, std::size_t level,
                                               const ZeroLand* land) const {
  const auto both = parts_->read(time, first_level_ + level);
  if (!both) return refuse(both.error());
  const auto& [first, second] = *both;

  Cells cells{parts_->staggering};
  const auto look_at = [&](const ComponentSlice& slice) {
    return [&cells, &slice, land](std::size_t /*point*/, std::size_t sample, const CentresBeside& centres) {
      cells.add_face(centres, slice.values[sample], land);
    };
  };
  for_each_point(look_at(first), look_at(second));
  if (land != nullptr) cells.add_land(parts_->staggering, *land, level);
  cells.add_land(parts_->centre_mask);

  PointComponents result;
  result.values.assign(points(), missing);
  const auto take_from = [&](const ComponentSlice& slice) {
    return [&cells, &slice, &result](std::size_t point, std::size_t sample, const CentresBeside& centres) {
      if (!slice.is_bad(sample)) result.values[point] = cells.face(centres, slice.values[sample]);
    };
  };
  for_each_point(take_from(first), take_from(second));
  const repository::SampleSteps of_first = parts_->first.steps();
  const repository::SampleSteps of_second = parts_->second.steps();
  if (of_first.step == of_second.step && of_first.offset == of_second.offset) result.steps = of_first;
  return result;
}

Checked<std::vector<float>> ComponentSource::level_depths(std::size_t time, std::size_t level) const {
  const auto at_centres = parts_->levels->depths(time, level);
  if (!at_centres) return refuse(at_centres.error());
  const auto depth_at = [&](std::optional<std::size_t> centre) {
    return centre && parts_->centre_mask.is_water(*centre) ? (*at_centres)[*centre] : missing;
  };
  const bool bed = level == parts_->first.layout().bed_levels;
  std::vector<float> depths(points(), missing);
  const auto between = [&](std::size_t point, std::size_t /*sample*/, const CentresBeside& centres) {
    const float before = depth_at(centres.before);
    const float after = depth_at(centres.after);
    const float mean = 0.5F * (before + after);
    depths[point] = std::isnan(before)  ? after
                    : std::isnan(after) ? before
                    : bed               ? std::max(before, after)
                                        : mean;
  };
  for_each_point(between, between);
  return depths;
}

}  // namespace floeplan::ingest
