#include "api/service/probe_service.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "api/service/probe_tide.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/geo/polygon.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/resampled.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/known_icebergs.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/forecast_runs.hpp"

namespace floeplan::service {
namespace {

using repository::Dataset;
using repository::DatasetKind;

geo::BoundingBox box_at(geo::LonLat place) {
  return {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
}

/// The datasets to use: for a kind with named datasets only these, in the order of their names in the query;
/// for other kinds all that are stored, newest run first.
struct Sources {
  std::vector<Dataset> datasets;
  std::vector<Dataset> named;

  [[nodiscard]] std::optional<Dataset> first_named(DatasetKind kind) const {
    const auto found = std::ranges::find(named, kind, &Dataset::kind);
    return found == named.end() ? std::nullopt : std::optional{*found};
  }
};

/// The dataset to use, or the reason why there is none.
struct Source {
  std::optional<Dataset> dataset;
  std::string reason;
};

bool covers_time(const Dataset& dataset, core::UtcTime time) {
  return (!dataset.time_start || *dataset.time_start <= time) &&
         (!dataset.time_end || time <= *dataset.time_end);
}

/// The first named dataset of a kind; otherwise the newest that covers the place and, if possible, the time.
Source choose(const Sources& sources, DatasetKind kind, const ProbeQuery& query) {
  if (const auto named = sources.first_named(kind)) return {named, ""};
  Source source{std::nullopt, "no " + repository::kind_name(kind) + " data are stored for this place"};
  for (const auto& dataset : sources.datasets) {
    if (dataset.kind != kind || !geo::contains(dataset.bounds, query.place)) continue;
    if (covers_time(dataset, query.time)) return {dataset, ""};
    if (!source.dataset) source = {dataset, ""};
  }
  return source;
}

/// The time to read from ice data for `time`. Outside the period of the data this is the nearest end of the
/// period, as in plans.
std::optional<core::UtcTime> told_of(const Dataset& ice, core::UtcTime time) {
  if (covers_time(ice, time)) return time;
  const core::UtcTime end = ice.time_end && time > *ice.time_end ? *ice.time_end : *ice.time_start;
  const core::Seconds away = time > end ? time - end : end - time;
  return away <= ocean::longest_ice_hold ? std::optional{end} : std::nullopt;
}

/// Chooses the source of sea ice. Of the datasets that cover place and time it prefers, as plans do, the first
/// with the highest IceStanding, because one dataset may fill a long gap of another.
Source choose_ice(sql::Connection& db, const Sources& sources, const ProbeQuery& query) {
  Source source = choose(sources, DatasetKind::ice, query);
  if (sources.first_named(DatasetKind::ice)) return source;
  auto most = ocean::IceStanding::not_begun;
  for (const Dataset& dataset : sources.datasets) {
    if (dataset.kind != DatasetKind::ice || !geo::contains(dataset.bounds, query.place)) continue;
    if (!told_of(dataset, query.time)) continue;
    const auto shape = repository::FieldRepository{db}.shape(dataset.id);
    if (!shape || !shape->times_s) continue;
    const auto standing = ocean::ice_moment(shape->times_s->nodes(), core::unix_seconds(query.time)).standing;
    if (standing <= most) continue;
    most = standing;
    source.dataset = dataset;
  }
  return source;
}

/// The depths that plans use at this place: from the finest dataset with a value, or from the first named
/// one.
void read_depth(sql::Connection& db, const Sources& sources, codec::Probe& probe) {
  const repository::FieldRepository fields{db};
  std::vector<std::pair<core::Metres, Dataset>> layers;
  const bool by_name = sources.first_named(DatasetKind::bathymetry).has_value();
  for (const Dataset& dataset : sources.datasets) {
    if (dataset.kind != DatasetKind::bathymetry || (!by_name && !geo::contains(dataset.bounds, probe.place)))
      continue;
    if (const auto shape = fields.shape(dataset.id)) layers.emplace_back(shape->grid.spacing(), dataset);
  }
  if (!by_name)
    std::ranges::stable_sort(layers, {}, [](const auto& layer) {
      return std::pair{layer.first, repository::was_resampled(layer.second.warnings)};
    });
  for (const auto& [spacing, dataset] : layers) {
    const auto bathymetry = fields.load_bathymetry(dataset.id, box_at(probe.place));
    if (!bathymetry || !bathymetry->depth(probe.place)) continue;
    probe.depth = bathymetry->depth(probe.place);
    probe.shoalest_depth = bathymetry->shoalest(probe.place);
    return;
  }
  probe.depth_reason = layers.empty()
                           ? "no bathymetry data are stored for this place"
                           : "outside the area of " + layers.front().second.name + ", or no value there";
}

/// The steps of the data before and after the requested time.
template <class Part>
void read_steps(sql::Connection& db, const Dataset& dataset, core::UtcTime time, Part& part) {
  const auto shape = repository::FieldRepository{db}.shape(dataset.id);
  if (!shape || !shape->times_s) return;
  const auto position = shape->times_s->locate(core::unix_seconds(time));
  if (!position) return;
  part.time_before = core::from_unix_seconds((*shape->times_s)[position->lower]);
  part.time_after = core::from_unix_seconds((*shape->times_s)[position->upper]);
}

std::string outside_period(const Dataset& dataset) {
  return "outside the period of the data, " + core::iso8601(*dataset.time_start) + " to " +
         core::iso8601(*dataset.time_end);
}

void read_ice(sql::Connection& db, const Source& source, codec::Probe& probe) {
  auto& ice = probe.ice;
  ice.reason = source.reason;
  if (!source.dataset) return;
  const Dataset& dataset = *source.dataset;
  ice.dataset_id = dataset.id.value;
  ice.dataset_name = dataset.name;
  ice.run = dataset.run;
  const auto time = told_of(dataset, probe.time);
  if (!time) {
    ice.reason = outside_period(dataset);
    return;
  }
  read_steps(db, dataset, *time, ice);
  const auto field = repository::FieldRepository{db}.load_ice(dataset.id, box_at(probe.place),
                                                              repository::Period{*time, *time});
  if (field) ice.state = field->at(probe.place, *time);
  if (!ice.state) ice.reason = "no value here: land, a gap of the data, or beyond their area";
}

/// The parts of joined data around a time, each reduced to its steps next to it.
std::vector<repository::JoinedPart> around(std::vector<repository::JoinedPart> parts, core::UtcTime time) {
  std::vector<repository::JoinedPart> near;
  for (repository::JoinedPart& part : parts) {
    if (part.used.from <= time && time <= part.used.to) {
      part.used = {time, time};
      return {part};
    }
    if (part.used.to < time) {
      part.used.from = part.used.to;
      near = {part};
      continue;
    }
    part.used.to = part.used.from;
    near.push_back(part);
    return near;
  }
  return near;
}

/// The velocities around the time, from the newest runs, joined as in plans; and their run, or, between two
/// runs, the earlier one.
struct Velocities {
  std::optional<ocean::CurrentGrid> grid;
  Dataset dataset;
};

std::optional<Velocities> joined_velocities(sql::Connection& db, const std::vector<Dataset>& datasets,
                                            DatasetKind kind, const ProbeQuery& query) {
  std::vector<Dataset> runs;
  std::ranges::copy_if(datasets, std::back_inserter(runs), [&](const Dataset& dataset) {
    return dataset.kind == kind && geo::contains(dataset.bounds, query.place);
  });
  // reads beyond the end of a run, to join it with the next
  constexpr core::Seconds before_and_after{2.0 * 86400.0};
  const repository::Period within{query.time - before_and_after, query.time + before_and_after};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].time_start) continue;
    const auto parts = around(repository::join_runs(db, runs, i, within, query.time, false), query.time);
    if (parts.empty()) continue;
    return Velocities{repository::load_joined(db, parts, box_at(query.place), query.time, std::nullopt),
                      parts.front().dataset};
  }
  return std::nullopt;
}

/// Velocities of a single dataset: one that the query names, or one with a single time.
std::optional<Velocities> own_velocities(sql::Connection& db, const Dataset& dataset,
                                         const ProbeQuery& query) {
  if (!covers_time(dataset, query.time)) return std::nullopt;
  return Velocities{
      repository::FieldRepository{db}.load_currents(dataset.id, box_at(query.place),
                                                    repository::Period{query.time, query.time}, std::nullopt),
      dataset};
}

void tell_source(const Dataset& dataset, codec::Probe::Velocity& part) {
  part.dataset_id = dataset.id.value;
  part.dataset_name = dataset.name;
  part.run = dataset.run;
}

/// The velocity of the sea or the air, at the requested depth or else the shallowest level.
void read_velocity(sql::Connection& db, const Sources& sources, DatasetKind kind, const ProbeQuery& query,
                   codec::Probe::Velocity& part) {
  const bool by_name = sources.first_named(kind).has_value();
  auto velocities = by_name ? std::nullopt : joined_velocities(db, sources.datasets, kind, query);
  if (!velocities) {
    const Source source = choose(sources, kind, query);
    part.reason = source.reason;
    if (!source.dataset) return;
    tell_source(*source.dataset, part);
    velocities = own_velocities(db, *source.dataset, query);
    if (!velocities) {
      part.reason = outside_period(*source.dataset);
      return;
    }
  }
  tell_source(velocities->dataset, part);
  const auto& grid = velocities->grid;
  if (!grid) {
    part.reason = "outside the area of the data";
    return;
  }
  const auto& times_s = grid->samples().times_s;
  if (const auto position = times_s.locate(core::unix_seconds(query.time));
      position && velocities->dataset.time_start) {
    part.time_before = core::from_unix_seconds(times_s[position->lower]);
    part.time_after = core::from_unix_seconds(times_s[position->upper]);
  }
  const auto& depths = grid->samples().depths_m;
  const core::Metres depth = query.depth.value_or(core::Metres{depths ? depths->front() : 0.0});
  part.velocity = grid->at(query.place, depth, query.time);
  if (!part.velocity) {
    part.reason = kind == DatasetKind::wind
                      ? "no value here: a gap of the data"
                      : "no value here: land, below the bottom, or outside the data's depths";
  }
}

void read_land(sql::Connection& db, const std::vector<Dataset>& datasets, codec::Probe& probe) {
  std::vector<Dataset> coastlines;
  std::ranges::copy_if(datasets, std::back_inserter(coastlines), [&](const Dataset& dataset) {
    return dataset.kind == DatasetKind::coastline && geo::contains(dataset.bounds, probe.place);
  });
  repository::keep_newest_coastline(coastlines);
  for (const Dataset& dataset : coastlines) {
    const auto polygons = repository::CoastlineRepository{db}.load(dataset.id, box_at(probe.place));
    const bool inside = std::ranges::any_of(
        polygons, [&](const geo::Polygon& polygon) { return geo::contains(polygon, probe.place); });
    probe.land = inside || probe.land.value_or(false);
    if (inside && probe.coastline.empty()) probe.coastline = dataset.name;
  }
  if (probe.land) return;
  if (probe.depth) probe.land = probe.depth->value <= 0.0;
}

/// The named datasets of a kind; default choice if none is named.
repository::DatasetChoice choice_of(const Sources& sources, DatasetKind kind) {
  repository::DatasetChoice choice;
  for (const Dataset& dataset : sources.named) {
    if (dataset.kind == kind) choice.ids.push_back(dataset.id);
  }
  if (!choice.ids.empty()) choice.how = repository::DatasetChoice::How::named;
  return choice;
}

void read_icebergs(sql::Connection& db, const Sources& sources, const ProbeQuery& query,
                   codec::Probe& probe) {
  core::Violations far_away;  // ignored: a named dataset far away simply has no icebergs here
  const auto known = repository::known_icebergs(db, sources.datasets,
                                                {.choice = choice_of(sources, DatasetKind::icebergs),
                                                 .area = box_at(probe.place),
                                                 .reach = probe_iceberg_range,
                                                 .as_of = probe.time,
                                                 .depart = query.departure.value_or(probe.time),
                                                 .max_age = query.max_sighting_age},
                                                far_away);
  for (const auto& sighting : known.sightings) {
    const auto distance = geo::geodesic_between(probe.place, sighting.iceberg.place).length;
    if (distance <= probe_iceberg_range) probe.icebergs.push_back({sighting.iceberg, distance});
  }
  std::stable_sort(probe.icebergs.begin(), probe.icebergs.end(),
                   [](const auto& a, const auto& b) { return a.distance < b.distance; });
}

void read_zones(sql::Connection& db, const std::vector<Dataset>& datasets, codec::Probe& probe) {
  for (const auto& dataset : datasets) {
    if (dataset.kind != DatasetKind::zones) continue;
    for (ocean::Zone& zone : repository::ZoneRepository{db}.at(dataset.id, probe.place)) {
      const bool in_force =
          (!zone.from || *zone.from <= probe.time) && (!zone.until || probe.time <= *zone.until);
      probe.zones.push_back({std::move(zone), in_force, dataset.id.value, dataset.name});
    }
  }
}

/// Errors  a violation for each id that is no dataset, or is a glider track, which has no values at a place
tl::expected<Sources, core::Violations> find_sources(sql::Connection& db,
                                                     const std::vector<std::string>& ids) {
  Sources sources{repository::DatasetRepository{db}.list(), {}};
  repository::sort_newest_run_first(sources.datasets);
  core::Violations violations;
  for (const std::string& id : ids) {
    const auto found = std::ranges::find(sources.datasets, repository::DatasetId{id}, &Dataset::id);
    if (found == sources.datasets.end()) {
      violations.push_back({"dataset", "no dataset has the id " + id});
    } else if (found->kind == DatasetKind::glider_tracks) {
      violations.push_back({"dataset", "must not be glider-tracks, which have no values at a place"});
    } else {
      sources.named.push_back(*found);
    }
  }
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  std::erase_if(sources.datasets,
                [&](const Dataset& one) { return sources.first_named(one.kind).has_value(); });
  sources.datasets.insert(sources.datasets.end(), sources.named.begin(), sources.named.end());
  return sources;
}

}  // namespace

tl::expected<codec::Probe, core::Violations> probe(sql::Connection& db, const ProbeQuery& query) {
  const auto sources = find_sources(db, query.dataset_ids);
  if (!sources) return tl::unexpected(sources.error());
  codec::Probe result;
  result.place = query.place;
  result.time = query.time;
  read_depth(db, *sources, result);
  read_velocity(db, *sources, DatasetKind::currents, query, result.currents);
  ProbeQuery above = query;
  above.depth.reset();
  read_velocity(db, *sources, DatasetKind::wind, above, result.wind);
  read_ice(db, choose_ice(db, *sources, query), result);
  result.tide = probe_tide(db, sources->datasets, query.place, query.time);
  result.water_level = probe_water_level(db, sources->datasets, query.place, query.time);
  read_land(db, sources->datasets, result);
  read_icebergs(db, *sources, query, result);
  read_zones(db, sources->datasets, result);
  return result;
}

}  // namespace floeplan::service
