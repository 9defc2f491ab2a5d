#include "api/service/probe_tide.hpp"

#include <algorithm>
#include <utility>

#include "engine/core/shown_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/tide/minor_constituents.hpp"
#include "storage/repository/fields/tide_repository.hpp"
#include "storage/repository/fields/water_level_repository.hpp"

namespace floeplan::service {
namespace {

using ocean::TideQuantity;
using repository::Dataset;
using repository::DatasetKind;

std::string station_words(const std::string& name, core::Metres distance) {
  return (name.empty() ? "a station" : name) + ", " + core::distance_text(distance) + " away";
}

void note_lines(codec::Probe::Tide& tide, const std::vector<tide::HarmonicConstant>& constants) {
  tide.constituents.clear();
  for (const tide::HarmonicConstant& constant : constants)
    tide.constituents.push_back(tide::constituent_name(constant.constituent));
}

void predict(const std::vector<ocean::TideGrid>& models, geo::LonLat place, core::UtcTime time,
             codec::Probe::Tide& tide) {
  const auto elevation = joined_constants(models, TideQuantity::elevation, place);
  const auto east = joined_constants(models, TideQuantity::east, place);
  const auto north = joined_constants(models, TideQuantity::north, place);
  if (elevation) {
    tide.elevation = core::Metres{tide::predict(*elevation, time)};
    note_lines(tide, *elevation);
  }
  if (east && north) {
    tide.velocity = geo::VelocityEn{{tide::predict(*east, time)}, {tide::predict(*north, time)}};
    note_lines(tide, *east);
  }
}

/// A tide station with its distance and its dataset.
struct NearStation {
  repository::TideStation station;
  core::Metres distance;
  Dataset dataset;
};

std::optional<NearStation> nearest_station(sql::Connection& db, const std::vector<Dataset>& datasets,
                                           geo::LonLat place) {
  std::optional<NearStation> nearest;
  for (const Dataset& dataset : datasets) {
    for (const auto& station : repository::TideRepository{db}.stations(dataset.id)) {
      const auto distance = geo::geodesic_between(place, station.place).length;
      if (distance <= probe_station_range && (!nearest || distance < nearest->distance))
        nearest = NearStation{station, distance, dataset};
    }
  }
  return nearest;
}

void predict(const NearStation& near, core::UtcTime time, codec::Probe::Tide& tide) {
  tide.elevation = core::Metres{tide::predict(near.station.constants, time)};
  note_lines(tide, near.station.constants);
  tide.dataset_ids = {near.dataset.id.value};
  tide.dataset_names = {near.dataset.name};
  tide.station = station_words(near.station.name, near.distance);
}

std::vector<Dataset> of_kind(const std::vector<Dataset>& datasets, DatasetKind kind) {
  std::vector<Dataset> found;
  std::ranges::copy_if(datasets, std::back_inserter(found),
                       [&](const Dataset& dataset) { return dataset.kind == kind; });
  return found;
}

void note_level(const Dataset& dataset, const repository::WaterLevel& level, const std::string& station,
                codec::Probe::WaterLevel& found) {
  found.height = level.height;
  found.time_before = level.before;
  found.time_after = level.after;
  found.dataset_id = dataset.id.value;
  found.dataset_name = dataset.name;
  found.station = station;
}

}  // namespace

codec::Probe::Tide probe_tide(sql::Connection& db, const std::vector<Dataset>& datasets, geo::LonLat place,
                              core::UtcTime time) {
  const std::vector<Dataset> tides = of_kind(datasets, DatasetKind::tides);
  codec::Probe::Tide tide;
  std::vector<ocean::TideGrid> models;
  for (const Dataset& dataset : tides) {
    if (!geo::contains(dataset.bounds, place)) continue;
    auto model = repository::TideRepository{db}.load(
        dataset.id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg});
    if (!model) continue;
    models.push_back(std::move(*model));
    tide.dataset_ids.push_back(dataset.id.value);
    tide.dataset_names.push_back(dataset.name);
  }
  predict(models, place, time, tide);
  if (!tide.elevation && !tide.velocity)
    if (const auto near = nearest_station(db, tides, place)) predict(*near, time, tide);
  if (!tide.elevation && !tide.velocity)
    tide.reason =
        models.empty() ? "no tides are stored for this place" : "no value here: land, or a gap of the data";
  return tide;
}

codec::Probe::WaterLevel probe_water_level(sql::Connection& db, const std::vector<Dataset>& datasets,
                                           geo::LonLat place, core::UtcTime time) {
  const repository::WaterLevelRepository levels{db};
  codec::Probe::WaterLevel found;
  std::optional<core::Metres> nearest;
  bool covered = false;
  for (const Dataset& dataset : of_kind(datasets, DatasetKind::water_levels)) {
    if (geo::contains(dataset.bounds, place)) {
      if (const auto level = levels.at(dataset.id, place, time)) {
        note_level(dataset, *level, "", found);
        break;
      }
      covered = true;
    }
    for (const repository::WaterLevelStation& station : levels.stations(dataset.id)) {
      const core::Metres distance = geo::geodesic_between(place, station.place).length;
      if (distance > probe_station_range || (nearest && *nearest <= distance)) continue;
      covered = true;
      const auto level = repository::level_at(station, time);
      if (!level) continue;
      nearest = distance;
      note_level(dataset, *level, station_words(station.name, distance), found);
    }
  }
  if (found.height) {
    found.datum = levels.datum({found.dataset_id});
  } else {
    found.reason = covered ? "no value here and then: land, a gap of the data, or outside their period"
                           : "no water-levels data are stored for this place";
  }
  return found;
}

}  // namespace floeplan::service
