#include "api/routes/edr/edr_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_overviews.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::routes {
namespace {

using repository::DatasetKind;
using repository::FieldRepository;

/// The direction of flow, degrees clockwise from true north.
double direction_deg(const geo::VelocityEn& velocity) {
  const double degrees = std::atan2(velocity.east.value, velocity.north.value) * 180.0 / std::numbers::pi;
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

class CurrentsField : public EdrField {
 public:
  explicit CurrentsField(std::shared_ptr<const ocean::CurrentGrid> grid) : grid_{std::move(grid)} {}
  void sample(geo::LonLat place, core::Metres depth, core::UtcTime time,
              std::span<std::optional<double>> values) const override {
    const auto velocity = grid_->at(place, depth, time);
    if (!velocity) return;
    values[0] = velocity->east.value;
    values[1] = velocity->north.value;
    values[2] = std::hypot(velocity->east.value, velocity->north.value);
    values[3] = direction_deg(*velocity);
  }
  const ocean::HorizontalGrid& grid() const override { return grid_->samples().grid; }

 private:
  std::shared_ptr<const ocean::CurrentGrid> grid_;
};

class DepthField : public EdrField {
 public:
  DepthField(ocean::Bathymetry bathymetry, std::size_t nodes_apart)
      : bathymetry_{std::move(bathymetry)}, nodes_apart_{nodes_apart} {}
  void sample(geo::LonLat place, core::Metres, core::UtcTime,
              std::span<std::optional<double>> values) const override {
    if (const auto depth = bathymetry_.depth(place)) values[0] = depth->value;
  }
  const ocean::HorizontalGrid& grid() const override { return bathymetry_.grid(); }
  std::size_t nodes_apart() const override { return nodes_apart_; }

 private:
  ocean::Bathymetry bathymetry_;
  std::size_t nodes_apart_;
};

class SeaIceField : public EdrField {
 public:
  explicit SeaIceField(ocean::IceField ice) : ice_{std::move(ice)} {}
  void sample(geo::LonLat place, core::Metres, core::UtcTime time,
              std::span<std::optional<double>> values) const override {
    const auto state = ice_.at(place, time);
    if (!state) return;
    values[0] = state->concentration;
    if (state->thickness) values[1] = state->thickness->value;
  }
  const ocean::HorizontalGrid& grid() const override { return ice_.samples().grid; }

 private:
  ocean::IceField ice_;
};

/// The period to read; empty for data without time.
std::optional<repository::Period> period_of(const EdrShape& shape, core::UtcTime from, core::UtcTime to) {
  if (shape.times.empty()) return std::nullopt;
  return repository::Period{from, to};
}

/// The depths to read; an empty limit is no limit.
struct DepthRange {
  std::optional<core::Metres> shallowest;
  std::optional<core::Metres> deepest;
};

DepthRange range_of(const std::vector<double>& depths_m) {
  if (depths_m.empty()) return {};
  return {core::Metres{std::ranges::min(depths_m)}, core::Metres{std::ranges::max(depths_m)}};
}

/// Distance of neighbouring rows of the field, counted in rows of the dataset.
std::size_t nodes_apart(const ocean::Axis& all, const ocean::Axis& kept) {
  if (kept.size() < 2) return 1;
  const auto first = std::ranges::lower_bound(all.nodes(), kept.front());
  const auto last = std::ranges::lower_bound(all.nodes(), kept.back());
  const double apart = static_cast<double>(last - first) / static_cast<double>(kept.size() - 1);
  return static_cast<std::size_t>(std::max(1.0, std::round(apart)));
}

void sort_finest_first(std::vector<repository::Dataset>& datasets, sql::Connection& db) {
  using Ranked = std::pair<double, repository::Dataset>;  // by the spacing in metres
  std::vector<Ranked> ranked;
  for (const auto& dataset : datasets) {
    const auto shape = FieldRepository{db}.shape(dataset.id);
    ranked.emplace_back(shape ? shape->grid.spacing().value : INFINITY, dataset);
  }
  std::ranges::stable_sort(ranked, {}, &Ranked::first);
  for (std::size_t i = 0; i < ranked.size(); ++i) datasets[i] = std::move(ranked[i].second);
}

bool meets_span(const repository::Dataset& dataset, const TimeSpan& span) {
  return (!span.from || !dataset.time_end || *dataset.time_end >= *span.from) &&
         (!span.to || !dataset.time_start || *dataset.time_start <= *span.to);
}

}  // namespace

const std::vector<EdrCollection>& edr_collections() {
  static const std::vector<EdrCollection> collections{
      {"currents",
       "Currents",
       "Velocity of the sea water, towards which it goes; of the newest model run that knows them there and "
       "then.",
       DatasetKind::currents,
       true,
       {{"eastward_sea_water_velocity", "Velocity towards the east", "m/s"},
        {"northward_sea_water_velocity", "Velocity towards the north", "m/s"},
        {"sea_water_speed", "Speed", "m/s"},
        {"sea_water_velocity_to_direction", "Direction towards which it goes, from true north", "deg"}}},
      {"bathymetry",
       "Bathymetry",
       "Depth of the sea bed, of the finest data that know it there; negative on land where they tell its "
       "height.",
       DatasetKind::bathymetry,
       false,
       {{"sea_floor_depth_below_mean_sea_level", "Depth of the sea bed", "m"}}},
      {"sea-ice",
       "Sea ice",
       "Concentration and thickness of sea ice; from the newest data at that place and time.",
       DatasetKind::ice,
       false,
       {{"sea_ice_area_fraction", "Share of the sea surface that is covered", "1"},
        {"sea_ice_thickness", "Thickness of level ice", "m"}}}};
  return collections;
}

std::vector<repository::Dataset> edr_datasets(sql::Connection& db, const EdrCollection& collection,
                                              const std::optional<geo::BoundingBox>& area,
                                              const TimeSpan& span) {
  auto datasets = repository::DatasetRepository{db}.list();
  std::erase_if(datasets, [&](const repository::Dataset& dataset) {
    return dataset.kind != collection.kind || !meets_span(dataset, span) ||
           (area && !geo::intersects(dataset.bounds, *area));
  });
  repository::sort_newest_run_first(datasets);
  if (collection.kind == DatasetKind::bathymetry && datasets.size() > 1) sort_finest_first(datasets, db);
  return datasets;
}

bool are_of_one_model(const EdrShape& a, const EdrShape& b) {
  return a.dataset.variables == b.dataset.variables && a.depths_m == b.depths_m &&
         a.grid.frame() == b.grid.frame() && a.grid.x().nodes() == b.grid.x().nodes() &&
         a.grid.y().nodes() == b.grid.y().nodes();
}

std::optional<EdrShape> edr_shape(sql::Connection& db, const repository::Dataset& dataset) {
  const auto stored = FieldRepository{db}.shape(dataset.id);
  if (!stored) return std::nullopt;
  EdrShape shape{.dataset = dataset, .grid = stored->grid, .depths_m = {}, .times = {}};
  if (stored->depths_m) shape.depths_m = stored->depths_m->nodes();
  if (stored->times_s) {
    for (const double seconds : stored->times_s->nodes())
      shape.times.push_back(core::from_unix_seconds(seconds));
  }
  return shape;
}

std::unique_ptr<EdrField> load_edr_field(sql::Connection& db, const EdrShape& shape,
                                         const geo::BoundingBox& area, core::UtcTime from, core::UtcTime to,
                                         const std::vector<double>& depths_m) {
  const FieldRepository fields{db};
  const auto& id = shape.dataset.id;
  if (shape.dataset.kind == DatasetKind::bathymetry) {
    using repository::FieldOverviews;
    auto bathymetry = FieldOverviews{db}.bathymetry(id, area, FieldOverviews::plenty);
    if (!bathymetry) return nullptr;
    const std::size_t apart = nodes_apart(shape.grid.y(), bathymetry->grid().y());
    return std::make_unique<DepthField>(std::move(*bathymetry), apart);
  }
  if (shape.dataset.kind == DatasetKind::ice) {
    auto ice = fields.load_ice(id, area, period_of(shape, from, to));
    return ice ? std::make_unique<SeaIceField>(std::move(*ice)) : nullptr;
  }
  const auto [shallowest, deepest] = range_of(depths_m);
  auto currents = fields.load_currents(id, area, period_of(shape, from, to), deepest, shallowest);
  if (!currents) return nullptr;
  return std::make_unique<CurrentsField>(std::make_shared<const ocean::CurrentGrid>(std::move(*currents)));
}

std::unique_ptr<EdrField> load_edr_field_at(sql::Connection& db, const EdrShape& shape, geo::LonLat place,
                                            core::UtcTime from, core::UtcTime to,
                                            const std::vector<double>& depths_m,
                                            repository::CurrentBlocks* kept) {
  if (shape.dataset.kind != DatasetKind::currents || kept == nullptr) {
    const geo::BoundingBox at_place{place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
    return load_edr_field(db, shape, at_place, from, to, depths_m);
  }
  const auto [shallowest, deepest] = range_of(depths_m);
  auto currents = FieldRepository{db}.load_currents_at(shape.dataset.id, place, period_of(shape, from, to),
                                                       deepest, shallowest, *kept);
  return currents ? std::make_unique<CurrentsField>(std::move(currents)) : nullptr;
}

}  // namespace floeplan::routes
