#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/messages/ingest_ice_messages.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/bent_plane.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/ice/ice_readers.hpp"
#include "storage/ingest/readers/ice/ice_units.hpp"
#include "storage/ingest/readers/ice/ice_variables.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::ingest {
namespace {

/// Deepest level that counts as the surface. Models often give surface fields the depth of their uppermost
/// level.
constexpr double deepest_top_level_m = 20.0;

/// Ratio of thickness to draft of floating level ice without snow: densities 1025 kg/m3 of sea water, 915
/// kg/m3 of ice.
/// Source  Timco and Frederking 1996, A review of sea ice density, doi:10.1016/0165-232X(95)00007-X
constexpr double thickness_over_draft = 1025.0 / 915.0;

/// One variable, with the meaning of its numbers.
struct Quantity {
  const NetcdfVariable* variable{nullptr};
  MissingMarks marks;
  IceUnit unit;
};

/// All that is needed to read slices of a file, for checking and later for writing.
struct IceSource {
  std::shared_ptr<const NetcdfFile> file;
  std::vector<Quantity> concentrations;
  std::vector<Quantity> thickness;  // one or none
  NetcdfLayout layout;
  ocean::HorizontalGrid grid;
  std::optional<BentPlane> bent;  // empty: the layout's points are the grid's nodes

  [[nodiscard]] std::size_t times() const { return layout.times_s->nodes.size(); }
};

/// Reads every value of a variable once and returns what they show.
Checked<Found> look_through(const Quantity& quantity, const NetcdfLayout& layout) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Found found{.extent = {infinite, -infinite}, .whole_numbers = true, .values = 0, .undeclared = 0};
  for (std::size_t time = 0; time < layout.times_s->nodes.size(); ++time) {
    const auto slice = read_slice(*quantity.variable, layout, time, 0);
    if (!slice) return refuse(slice.error());
    for (const double value : *slice) {
      if (std::isnan(value)) continue;
      if (quantity.marks.cover(value, quantity.unit.possible)) {
        ++found.undeclared;
        continue;
      }
      ++found.values;
      found.extent.least = std::min(found.extent.least, value);
      found.extent.greatest = std::max(found.extent.greatest, value);
      found.whole_numbers = found.whole_numbers && value == std::round(value);
    }
  }
  if (found.values == 0)
    return refuse(messages::ingest_ice_message<"ice-all-missing">(quantity.variable->name()));
  return found;
}

void warn_of_marks(const Quantity& quantity, const Found& found, Messages& warnings) {
  if (found.undeclared > 0)
    warnings.push_back(
        messages::ingest_ice_message<"ice-marks-left-out">(found.undeclared, quantity.variable->name()));
}

Checked<Quantity> concentration_of(const NetcdfVariable& variable, const NetcdfLayout& layout,
                                   const std::optional<std::string>& given_unit, Messages& warnings) {
  const auto stated = stated_unit_of_concentration(variable, given_unit);
  if (!stated) return refuse(stated.error());
  Quantity quantity{&variable, MissingMarks{variable}, *stated};
  const auto found = look_through(quantity, layout);
  if (!found) return refuse(found.error());
  const auto settled = settled_unit_of_concentration(variable, *stated, *found, warnings);
  if (!settled) return refuse(settled.error());
  quantity.unit = *settled;
  warn_of_marks(quantity, *found, warnings);
  return quantity;
}

Checked<Quantity> thickness_of(const NetcdfVariable& variable, bool is_draft, const NetcdfLayout& layout,
                               Messages& warnings) {
  const auto unit = unit_of_thickness(variable, warnings);
  if (!unit) return refuse(unit.error());
  Quantity quantity{&variable, MissingMarks{variable}, *unit};
  const auto found = look_through(quantity, layout);
  if (!found) return refuse(found.error());
  if (const auto checked = check_thickness(variable, *unit, *found); !checked) return refuse(checked.error());
  warn_of_marks(quantity, *found, warnings);
  if (is_draft) {
    quantity.unit.factor *= thickness_over_draft;
    warnings.push_back(messages::ingest_ice_message<"draft-stored-as-thickness">(variable.name()));
  }
  return quantity;
}

/// The greatest of several quantities at each node, [y][x], limited to [0, most]; NaN where all are missing.
Checked<std::vector<float>> read_greatest(const std::vector<Quantity>& quantities, const NetcdfLayout& layout,
                                          std::size_t time, double most) {
  std::vector<float> result(layout.x.nodes.size() * layout.y.nodes.size(), missing);
  for (const Quantity& quantity : quantities) {
    const auto slice = read_slice(*quantity.variable, layout, time, 0);
    if (!slice) return refuse(slice.error());
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (quantity.marks.cover((*slice)[i], quantity.unit.possible)) continue;
      const auto value = static_cast<float>(std::clamp((*slice)[i] * quantity.unit.factor, 0.0, most));
      if (!(result[i] >= value)) result[i] = value;
    }
  }
  return result;
}

Checked<void> write(const IceSource& source, const core::ProgressCallback& progress, sql::Connection& db,
                    const repository::DatasetId& id) {
  repository::FieldRepository fields{db};
  const repository::FieldShape shape{source.grid, std::nullopt, ocean::Axis{source.layout.times_s->nodes}};
  if (source.bent)
    fields.create(id, shape, {source.bent->own.kept.mesh});
  else
    fields.create(id, shape);
  for (std::size_t time = 0; time < source.times(); ++time) {
    const auto stored = [&](const std::vector<float>& values) {
      return source.bent ? source.bent->own.kept.in_order(values) : values;
    };
    const auto concentration = read_greatest(source.concentrations, source.layout, time, 1.0);
    if (!concentration) return refuse(concentration.error());
    fields.write_slice(id, "concentration", time, 0, stored(*concentration));
    if (!source.thickness.empty()) {
      const auto thickness_m = read_greatest(source.thickness, source.layout, time, INFINITY);
      if (!thickness_m) return refuse(thickness_m.error());
      fields.write_slice(id, "thickness_m", time, 0, stored(*thickness_m));
    }
    if (progress) progress("storing", static_cast<double>(time + 1) / static_cast<double>(source.times()));
  }
  return {};
}

/// Uses the user's time if the file states none: the date of a daily chart is often only in its name.
Checked<bool> settle_time(NetcdfLayout& layout, const std::optional<core::UtcTime>& stated) {
  if (layout.times_s && stated) layout.warnings.push_back(messages::ingest_ice_message<"ice-time-in-file">());
  if (!layout.times_s && !stated) return refuse(messages::ingest_ice_message<"ice-time-missing">());
  if (!layout.times_s) layout.times_s = AxisNodes{{core::unix_seconds(*stated)}, {0}};
  return true;
}

/// The layout of ice, which must have times and no depths.
Checked<NetcdfLayout> layout_of_ice(NetcdfLayout layout, const NetcdfVariable& variable,
                                    const std::optional<core::UtcTime>& stated_time) {
  if (const auto settled = settle_time(layout, stated_time); !settled) return refuse(settled.error());
  if (layout.depths_m && layout.depths_m->nodes.size() > 1)
    return refuse(messages::ingest_ice_message<"ice-with-depths">(variable.name()));
  if (layout.depths_m && layout.depths_m->nodes.front() > deepest_top_level_m)
    return refuse(messages::ingest_ice_message<"ice-at-depth">(variable.name(),
                                                               number(layout.depths_m->nodes.front())));
  const std::uint64_t nodes = layout.x.nodes.size() * layout.y.nodes.size();
  if (layout.times_s->nodes.size() > max_grid_values / nodes)
    return refuse(messages::ingest_ice_message<"ice-too-large">(layout.times_s->nodes.size(), nodes));
  return layout;
}

Checked<IceSource> open_source(const std::shared_ptr<const NetcdfFile>& file, const IngestOptions& options,
                               Messages& warnings) {
  const auto ice = find_ice(*file, options.variable);
  if (!ice) return refuse(ice.error());
  const NetcdfVariable& first = *ice->concentrations.front();
  auto place = place_of(file, first, options.crs);
  if (!place) return refuse(place.error());
  if (place->bent)
    warnings.push_back(messages::ingest_grid_message<"kept-at-own-points">(
        place->bent->own.kept.mesh.points.size(), std::string{"a bent grid"}));
  auto layout = layout_of_ice(std::move(place->layout), first, options.time);
  if (!layout) return refuse(layout.error());

  warnings.insert(warnings.end(), ice->warnings.begin(), ice->warnings.end());
  warnings.insert(warnings.end(), layout->warnings.begin(), layout->warnings.end());
  IceSource source{file, {}, {}, std::move(*layout), std::move(place->grid), std::move(place->bent)};
  for (const NetcdfVariable* variable : ice->concentrations) {
    auto quantity = concentration_of(*variable, source.layout, options.unit, warnings);
    if (!quantity) return refuse(quantity.error());
    source.concentrations.push_back(std::move(*quantity));
  }
  if (ice->thickness != nullptr) {
    auto quantity = thickness_of(*ice->thickness, ice->thickness_is_draft, source.layout, warnings);
    if (!quantity) return refuse(quantity.error());
    source.thickness.push_back(std::move(*quantity));
  }
  return source;
}

}  // namespace

Checked<PreparedDataset> read_ice(const std::shared_ptr<const NetcdfFile>& file, const IngestOptions& options,
                                  const core::ProgressCallback& progress) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::ice;
  auto source = open_source(file, options, data.warnings);
  if (!source) return refuse(source.error());

  for (const Quantity& quantity : source->concentrations) data.variables.push_back(quantity.variable->name());
  for (const Quantity& quantity : source->thickness) data.variables.push_back(quantity.variable->name());
  data.bounds = source->grid.bounds();
  data.rows_accepted = static_cast<std::int64_t>(source->bent ? source->bent->own.kept.mesh.points.size()
                                                              : source->grid.size());
  data.keeping = source->bent ? Keeping::at_own_points : keeping_on(source->grid.frame());
  data.time_start = core::from_unix_seconds(source->layout.times_s->nodes.front());
  data.time_end = core::from_unix_seconds(source->layout.times_s->nodes.back());
  data.write = [source = std::move(*source), progress](sql::Connection& db, const repository::DatasetId& id) {
    return write(source, progress, db, id);
  };
  return data;
}

}  // namespace floeplan::ingest
