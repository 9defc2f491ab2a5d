#include <algorithm>
#include <limits>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/common/in_blocks.hpp"
#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"
#include "storage/ingest/grids/netcdf_shape.hpp"
#include "storage/ingest/grids/true_north.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/velocity_sources.hpp"
#include "storage/ingest/readers/velocity/component_checks.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

/// Direction of the grid's x axis at each node, anticlockwise from east.
GridDirections x_directions_of(const ocean::HorizontalGrid& grid) {
  GridDirections directions;
  const double step = std::max(1.0, 1e-3 * grid.x().mean_step());
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
      const double x = grid.x()[ix];
      const double y = grid.y()[iy];
      directions.add(geo::direction_at(grid.place(ix, iy), grid.projection().to_lon_lat({x - step, y}),
                                       grid.projection().to_lon_lat({x + step, y})));
    }
  }
  return directions;
}

class RectilinearSource : public VelocitySource {
 public:
  RectilinearSource(NetcdfFiles files, VelocityComponent first, VelocityComponent second,
                    ocean::HorizontalGrid grid, std::optional<GridDirections> directions)
      : files_{std::move(files)},
        first_{std::move(first)},
        second_{std::move(second)},
        grid_{std::move(grid)},
        directions_{std::move(directions)} {
    shape_ = shape_in_time_and_depth(first_.layout(), false);
    shape_.columns = grid_.x().size();
    shape_.rows = grid_.y().size();
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }

  [[nodiscard]] geo::LonLat place(std::size_t point) const override {
    const std::size_t ix = point % shape_.columns;
    const std::size_t iy = point / shape_.columns;
    if (std::holds_alternative<geo::GeographicFrame>(grid_.frame())) return {grid_.x()[ix], grid_.y()[iy]};
    return grid_.place(ix, iy);
  }

  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t level) const override {
    const auto first = first_.read(time, level);
    if (!first) return refuse(first.error());
    const auto second = second_.read(time, level);
    if (!second) return refuse(second.error());

    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    const std::size_t points = shape_.points();
    VelocitySlice slice{std::vector<float>(points), std::vector<float>(points),
                        std::max(first->undeclared_fill, second->undeclared_fill)};
    slice.flagged = of_both(first->flagged, second->flagged);
    if (!directions_) {
      slice.east_steps = first_.steps();
      slice.north_steps = second_.steps();
      in_blocks(points, [&](std::size_t begin, auto count) {
        const double* const u = first->values.data() + begin;
        const double* const v = second->values.data() + begin;
        float* const east = slice.east.data() + begin;
        float* const north = slice.north.data() + begin;
        for (std::size_t i = 0; i < count; ++i) {
          const bool known = u[i] == u[i] && v[i] == v[i];  // neither is NaN
          east[i] = static_cast<float>(known ? u[i] : missing);
          north[i] = static_cast<float>(known ? v[i] : missing);
        }
      });
      return slice;
    }
    for (std::size_t i = 0; i < points; ++i) {
      const EastNorth current = to_true_north(first->values[i], second->values[i], *directions_, i);
      slice.east[i] = current.east;
      slice.north[i] = current.north;
    }
    return slice;
  }

  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t /*time*/,
                                                         std::size_t /*level*/) const override {
    return refuse(messages::ingest_current_message<"levels-not-of-the-bed">("a regular grid"));
  }

 private:
  NetcdfFiles files_;  // references that keep the files open
  VelocityComponent first_;
  VelocityComponent second_;
  ocean::HorizontalGrid grid_;
  std::optional<GridDirections> directions_;
  SourceShape shape_;
};

}  // namespace

Checked<RectilinearCurrents> rectilinear_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                                  const std::optional<std::string>& stated_crs,
                                                  Messages& warnings) {
  auto layout = layout_of(*pair.first_file, *pair.first);
  if (!layout) return refuse(layout.error());
  auto second_layout = layout_of(*pair.second_file, *pair.second);
  if (!second_layout) return refuse(second_layout.error());
  if (const auto differs = times_or_depths_differ(*layout, *second_layout)) return refuse(*differs);
  if (layout->x.nodes != second_layout->x.nodes || layout->y.nodes != second_layout->y.nodes)
    return refuse(
        messages::ingest_current_message<"staggered-plain-axes">(pair.first->name(), pair.second->name()));
  if (!layout->projected)
    if (auto doubt = doubt_in_nominal_axes(pair, layout->y.nodes.back())) return refuse(std::move(*doubt));

  auto grid = grid_of(*pair.first_file, *pair.first, *layout, stated_crs);
  if (!grid) return refuse(grid.error());
  std::optional<GridDirections> directions;
  if (layout->projected && pair.axes == VelocityAxes::unstated)
    return refuse(messages::ingest_current_message<"direction-of-components-unknown">(
        pair.first->name(), pair.second->name(), "projected"));
  if (layout->projected && pair.axes == VelocityAxes::grid) {
    directions = x_directions_of(*grid);
    warnings.push_back(messages::ingest_current_message<"turned-from-projected-grid">(pair.first->name(),
                                                                                      pair.second->name()));
  }
  if (!layout->projected && pair.axes == VelocityAxes::grid)
    warnings.push_back(
        messages::ingest_current_message<"along-parallels">(pair.first->name(), pair.second->name()));

  warnings.insert(warnings.end(), layout->warnings.begin(), layout->warnings.end());
  auto first = VelocityComponent::of(*pair.first_file, *pair.first, std::move(*layout), warnings);
  if (!first) return refuse(first.error());
  auto second = VelocityComponent::of(*pair.second_file, *pair.second, std::move(*second_layout), warnings);
  if (!second) return refuse(second.error());
  auto source = std::make_shared<const RectilinearSource>(files, std::move(*first), std::move(*second), *grid,
                                                          std::move(directions));
  return RectilinearCurrents{std::move(source), std::move(*grid)};
}

}  // namespace floeplan::ingest
