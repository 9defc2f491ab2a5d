#include <algorithm>
#include <cmath>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/bed_levels.hpp"
#include "storage/ingest/grids/centre_tables.hpp"
#include "storage/ingest/grids/grid_directions.hpp"
#include "storage/ingest/grids/netcdf_shape.hpp"
#include "storage/ingest/grids/row_mesh.hpp"
#include "storage/ingest/grids/s_coordinate.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/water_mask.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/velocity_sources.hpp"
#include "storage/ingest/readers/velocity/component_checks.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

constexpr double straight_deg = 1.0;  // a grid rotated by less counts as along east and north

struct ComponentPlane {
  PlaneDimensions dimensions;
  std::optional<Positions> positions;
};

/// Both components at those centres of their grid that have all their points.
class CurvilinearSource : public VelocitySource {
 public:
  CurvilinearSource(std::shared_ptr<const GridComponents> parts, std::vector<geo::LonLat> centres,
                    GridDirections directions, WaterMask mask)
      : parts_{std::move(parts)},
        centres_{std::move(centres)},
        directions_{std::move(directions)},
        centre_mask_{std::move(mask)} {
    shape_ = shape_in_time_and_depth(parts_->first.layout(), parts_->levels != nullptr);
    shape_.columns = parts_->staggering.columns;
    shape_.rows = parts_->staggering.rows;
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return centres_[point]; }

  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t level) const override {
    const auto components = parts_->read(time, level);
    if (!components) return refuse(components.error());
    const auto& [first, second] = *components;

    VelocitySlice slice{std::vector<float>(shape_.points(), missing),
                        std::vector<float>(shape_.points(), missing),
                        std::max(first.undeclared_fill, second.undeclared_fill)};
    slice.flagged = of_both(first.flagged, second.flagged);
    for (std::size_t row = 0; row < shape_.rows; ++row) {
      for (std::size_t column = 0; column < shape_.columns; ++column) {
        const std::size_t point = row * shape_.columns + column;
        if (!centre_mask_.is_water(point)) continue;
        const auto both = parts_->staggering.collocated ? as_read(first, second, point)
                                                        : at_centre(first, second, row, column);
        if (!both) continue;
        const EastNorth current = to_true_north(both->u, both->v, directions_, point);
        slice.east[point] = current.east;
        slice.north[point] = current.north;
      }
    }
    return slice;
  }

  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const override {
    const auto depths = parts_->levels->depths(time, level);
    if (!depths) return refuse(depths.error());
    return of_whole_centres(parts_->staggering, *depths);
  }

 private:
  struct Components {
    double u{};
    double v{};
  };

  static std::optional<Components> as_read(const ComponentSlice& first, const ComponentSlice& second,
                                           std::size_t point) {
    const Components both{first.values[point], second.values[point]};
    if (std::isnan(both.u) || std::isnan(both.v)) return std::nullopt;
    return both;
  }

  /// The mean of the two points of each component beside a centre. No water flows through a coast, so a point
  /// on a coast counts as zero. A centre without water on any side is land. If a point has a bad quality
  /// flag, the current at the centre is not known.
  [[nodiscard]] std::optional<Components> at_centre(const ComponentSlice& first, const ComponentSlice& second,
                                                    std::size_t row, std::size_t column) const {
    const Staggering& way = parts_->staggering;
    const std::size_t left = (row + way.first_row) * parts_->first.columns() + column;
    const std::size_t below = row * parts_->second.columns() + column + way.second_column;
    if (first.is_bad(left) || first.is_bad(left + 1) || second.is_bad(below) ||
        second.is_bad(below + parts_->second.columns()))
      return std::nullopt;
    const double u_left = first.values[left];
    const double u_right = first.values[left + 1];
    const double v_below = second.values[below];
    const double v_above = second.values[below + parts_->second.columns()];
    if (std::isnan(u_left) && std::isnan(u_right) && std::isnan(v_below) && std::isnan(v_above))
      return std::nullopt;
    const auto flow = [](double value) { return std::isnan(value) ? 0.0 : value; };
    return Components{0.5 * (flow(u_left) + flow(u_right)), 0.5 * (flow(v_below) + flow(v_above))};
  }

  std::shared_ptr<const GridComponents> parts_;
  std::vector<geo::LonLat> centres_;
  GridDirections directions_;
  WaterMask centre_mask_;
  SourceShape shape_;
};

/// Whether the model is POP. Its components run along its grid, although its files do not always say so.
/// Source  Smith et al. 2010, The Parallel Ocean Program (POP) Reference Manual, section 3.2
bool is_model_of_grid_axes(const NetcdfVariable& variable) { return lower(variable.name()) == "uvel"; }

messages::Message without_positions(const VelocityPair& pair) {
  return messages::ingest_current_message<"bent-grid-without-positions">(pair.first->name());
}

Checked<ComponentPlane> plane_with_positions(const NetcdfFiles& files, const NetcdfFile& file,
                                             const NetcdfVariable& variable, GridPoints points) {
  const auto dimensions = plane_of(file, variable);
  if (!dimensions)
    return refuse(messages::ingest_current_message<"axes-of-variable-unknown">(variable.name()));
  auto positions = positions_of(files, file, variable, *dimensions, points);
  if (!positions) return refuse(positions.error());
  return ComponentPlane{*dimensions, std::move(*positions)};
}

std::optional<messages::Message> doubt_in_axes(const VelocityPair& pair, const ComponentPlane& plane) {
  if (!plane.positions || !plane.positions->from_plain_axes) return std::nullopt;
  double northernmost_deg = -90.0;
  for (const geo::LonLat place : plane.positions->places)
    northernmost_deg = std::max(northernmost_deg, place.lat_deg);
  return doubt_in_nominal_axes(pair, northernmost_deg);
}

bool falls(const NetcdfFile& file, const NetcdfDimension& dimension) {
  const NetcdfVariable* coordinate = coordinate_of(file, dimension);
  if (coordinate == nullptr) return false;
  const auto values = coordinate->read_all();
  return values && values->size() > 1 && values->front() > values->back();
}

/// Positions and arrangement of the points.
struct Arrangement {
  Staggering staggering;
  Positions first;
  Positions second;
  std::vector<geo::LonLat> centres;
};

/// The arrangement for components without positions of their own, from the positions of the centres.
Checked<Arrangement> arrangement_round_centres(const NetcdfFiles& files, const VelocityPair& pair,
                                               const ComponentPlane& first, const ComponentPlane& second) {
  const auto centres = centre_positions(files);
  if (!centres) return refuse(centres.error());
  if (!*centres) return refuse(without_positions(pair));
  const auto size = [](const NetcdfVariable& variable, std::size_t dimension) {
    return static_cast<std::size_t>(variable.dimensions()[dimension].size);
  };
  const Positions& rho = **centres;
  const std::size_t first_rows = size(*pair.first, first.dimensions.y);
  const std::size_t first_columns = size(*pair.first, first.dimensions.x);
  const std::size_t second_rows = size(*pair.second, second.dimensions.y);
  const std::size_t second_columns = size(*pair.second, second.dimensions.x);
  auto way =
      points_after_centres(first_rows, first_columns, second_rows, second_columns, rho.rows, rho.columns);
  if (!way) return refuse(way.error());
  if (std::min(first_rows, second_rows) > rho.rows || std::min(first_columns, second_columns) > rho.columns)
    return refuse(without_positions(pair));

  // Each component's point lies half-way between its centre and the next one.
  Arrangement result{*way, {{}, way->rows + 1, way->columns + 1}, {{}, way->rows + 1, way->columns + 1}, {}};
  for (std::size_t row = 0; row <= way->rows; ++row) {
    for (std::size_t column = 0; column <= way->columns; ++column) {
      result.first.places.push_back(geo::midpoint(rho.at(row, column), rho.at(row, column + 1)));
      result.second.places.push_back(geo::midpoint(rho.at(row, column), rho.at(row + 1, column)));
    }
  }
  for (std::size_t row = 0; row < way->rows; ++row)
    for (std::size_t column = 0; column < way->columns; ++column)
      result.centres.push_back(rho.at(row + 1, column + 1));
  return result;
}

Checked<Arrangement> arrangement_of(const NetcdfFiles& files, const VelocityPair& pair, ComponentPlane first,
                                    ComponentPlane second) {
  if (!first.positions || !second.positions) return arrangement_round_centres(files, pair, first, second);
  auto way = staggering_of(*first.positions, *second.positions);
  if (!way) return refuse(way.error());
  std::vector<geo::LonLat> centres = centres_of(*way, *first.positions);
  return Arrangement{*way, std::move(*first.positions), std::move(*second.positions), std::move(centres)};
}

/// Directions of the components at the centres and, for a staggered grid, at their own points.
struct Directions {
  GridDirections at_centres;
  ocean::ComponentAxes of_components;
};

/// Finds the directions; no rotation is needed if the components already point east and north.
Checked<Directions> directions_for(const NetcdfFiles& files, const VelocityPair& pair,
                                   const ComponentPlane& first, const Arrangement& arrangement,
                                   const CentreTables& tables, Messages& warnings) {
  const FallingAxes falling{falls(*pair.first_file, pair.first->dimensions()[first.dimensions.x]),
                            falls(*pair.first_file, pair.first->dimensions()[first.dimensions.y])};
  const auto stated = tables.angle(files);
  if (!stated) return refuse(stated.error());
  const Staggering& way = arrangement.staggering;
  auto directions =
      directions_of(way, arrangement.first, arrangement.second, falling, of_whole_centres(way, *stated));
  if (!directions) return refuse(directions.error());

  const bool straight = directions->largest_turn_deg() < straight_deg;
  if (pair.axes == VelocityAxes::east_north && !way.collocated && !straight)
    return refuse(messages::ingest_current_message<"called-eastward-on-a-turned-grid">(pair.first->name(),
                                                                                       pair.second->name()));
  if (pair.axes == VelocityAxes::east_north)
    return Directions{GridDirections::along_east(arrangement.centres.size()),
                      axes_east_and_north(arrangement.first, arrangement.second)};
  if (pair.axes == VelocityAxes::unstated && way.collocated && !straight) {
    if (!is_model_of_grid_axes(*pair.first))
      return refuse(messages::ingest_current_message<"direction-of-components-unknown">(
          pair.first->name(), pair.second->name(), "bent"));
  }
  if (!straight)
    warnings.push_back(messages::ingest_current_message<"turned-from-model-grid">(
        pair.first->name(), pair.second->name(), number(directions->largest_turn_deg(), 3)));
  Directions result{std::move(*directions), {}};
  if (!way.collocated)
    result.of_components = axes_of_components(way, arrangement.first, arrangement.second, falling, *stated);
  return result;
}

/// Stores collocated components at their points, towards east and north, and those of a staggered grid at
/// their own points.
MeshCurrents kept_at_points(std::shared_ptr<const GridComponents> parts, Arrangement arrangement,
                            Directions directions, bool straight_axes) {
  const Staggering way = arrangement.staggering;
  MeshCurrents result;
  if (way.collocated) {
    result.mesh = mesh_of_rows(arrangement.centres, way.columns);
    result.layout = straight_axes ? "a grid whose levels follow the sea bed" : "a bent grid";
  } else {
    const ComponentSource::Planes planes{arrangement.first.rows, arrangement.first.columns,
                                         arrangement.second.rows, arrangement.second.columns};
    result.components =
        std::make_shared<const ComponentSource>(parts, planes, std::move(directions.of_components));
    result.mesh = mesh_of_components(arrangement.first, arrangement.second);
    result.layout = "the faces of a staggered grid";
  }
  WaterMask mask = whole_centres_of(way, parts->centre_mask);
  result.source = std::make_shared<const CurvilinearSource>(
      std::move(parts), std::move(arrangement.centres), std::move(directions.at_centres), std::move(mask));
  return result;
}

}  // namespace

Checked<MeshCurrents> curvilinear_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                           Messages& warnings) {
  auto first = plane_with_positions(files, *pair.first_file, *pair.first, GridPoints::first_component);
  if (!first) return refuse(first.error());
  auto second = plane_with_positions(files, *pair.second_file, *pair.second, GridPoints::second_component);
  if (!second) return refuse(second.error());
  if (auto doubt = doubt_in_axes(pair, *first)) return refuse(std::move(*doubt));
  auto layout = layout_over(*pair.first_file, *pair.first, first->dimensions.y, first->dimensions.x);
  if (!layout) return refuse(layout.error());
  auto second_layout =
      layout_over(*pair.second_file, *pair.second, second->dimensions.y, second->dimensions.x);
  if (!second_layout) return refuse(second_layout.error());
  if (const auto differs = times_or_depths_differ(*layout, *second_layout)) return refuse(*differs);

  const bool straight_axes = first->positions && first->positions->from_plain_axes;
  const PlaneDimensions first_plane = first->dimensions;
  const PlaneDimensions second_plane = second->dimensions;
  const ComponentPlane directions_plane{first_plane, std::nullopt};
  auto arrangement = arrangement_of(files, pair, std::move(*first), std::move(*second));
  if (!arrangement) return refuse(arrangement.error());
  const CentreTables tables{arrangement->staggering, *pair.first, first_plane};
  auto directions = directions_for(files, pair, directions_plane, *arrangement, tables, warnings);
  if (!directions) return refuse(directions.error());

  std::shared_ptr<const BedLevels> levels;
  if (layout->bed_levels > 0) {
    auto found = s_coordinate_levels(files, *pair.first_file, *pair.first, *layout, tables, warnings);
    if (!found) return refuse(found.error());
    levels = std::move(*found);
  }
  auto centre_mask = tables.mask(files);
  if (!centre_mask) return refuse(centre_mask.error());
  auto first_mask = mask_over(files, *pair.first, first_plane, "mask_u");
  if (!first_mask) return refuse(first_mask.error());
  auto second_mask = mask_over(files, *pair.second, second_plane, "mask_v");
  if (!second_mask) return refuse(second_mask.error());

  warnings.insert(warnings.end(), layout->warnings.begin(), layout->warnings.end());
  auto u = VelocityComponent::of(*pair.first_file, *pair.first, std::move(*layout), warnings);
  if (!u) return refuse(u.error());
  auto v = VelocityComponent::of(*pair.second_file, *pair.second, std::move(*second_layout), warnings);
  if (!v) return refuse(v.error());
  auto parts = std::make_shared<const GridComponents>(GridComponents{.files = files,
                                                                     .first = std::move(*u),
                                                                     .second = std::move(*v),
                                                                     .staggering = arrangement->staggering,
                                                                     .first_mask = std::move(*first_mask),
                                                                     .second_mask = std::move(*second_mask),
                                                                     .centre_mask = std::move(*centre_mask),
                                                                     .levels = std::move(levels)});
  return kept_at_points(std::move(parts), std::move(*arrangement), std::move(*directions), straight_axes);
}

}  // namespace floeplan::ingest
