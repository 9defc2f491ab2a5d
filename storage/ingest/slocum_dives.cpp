#include "storage/ingest/slocum_dives.hpp"

#include <algorithm>

#include "engine/geo/geodesic.hpp"
#include "engine/mission/packed_degrees.hpp"

namespace floeplan::ingest {
namespace {

constexpr double state_under_water = 1.0;
/// Of logs without the state: deeper is a dive, and shallower the surface, whose waves reach between the two.
constexpr double dive_m = 3.0;
constexpr double surface_m = 1.5;
/// No glider is faster, and its receiver no further off.
constexpr double fastest_m_s = 10.0;
constexpr double slack_m = 1'000.0;

std::optional<geo::VelocityEn> current_of(const SlocumRow& row, SlocumSensor east, SlocumSensor north) {
  if (!row[east] || !row[north]) return std::nullopt;
  return geo::VelocityEn{{*row[east]}, {*row[north]}};
}

std::optional<geo::LonLat> place_of(const SlocumRow& row, SlocumSensor lon, SlocumSensor lat) {
  return row[lon] && row[lat] ? mission::unpack_place(*row[lon], *row[lat]) : std::nullopt;
}

std::optional<geo::LonLat> fix_of(const SlocumRow& row) {
  if (row[SlocumSensor::gps_status].value_or(0.0) != 0.0) return std::nullopt;
  return place_of(row, SlocumSensor::gps_lon, SlocumSensor::gps_lat);
}

bool can_be_reached(const TrackRow& from, const TrackRow& to) {
  const double moved_m = geo::geodesic_between(*from.place, *to.place).length.value;
  return moved_m <= slack_m + fastest_m_s * (to.time - from.time).count();
}

geo::LonLat middle(geo::LonLat a, geo::LonLat b) {
  return {geo::wrap_longitude(a.lon_deg + 0.5 * geo::longitude_difference(a.lon_deg, b.lon_deg)),
          0.5 * (a.lat_deg + b.lat_deg)};
}

}  // namespace

std::optional<bool> SlocumDives::under_water(const SlocumRow& row) {
  if (const auto& state = row[SlocumSensor::dr_state]) {
    has_states_ = true;
    return *state == state_under_water;
  }
  const auto& depth_m = row[SlocumSensor::depth];
  if (has_states_ || !depth_m) return std::nullopt;
  if (*depth_m > dive_m) was_deep_ = true;
  if (*depth_m < surface_m) was_deep_ = false;
  return was_deep_;
}

void SlocumDives::note_currents(const SlocumRow& row) {
  const auto note = [&](Current& known, SlocumSensor east, SlocumSensor north) {
    if (const auto current = current_of(row, east, north)) known = current;
  };
  note(known_.water, SlocumSensor::water_east, SlocumSensor::water_north);
  note(known_.initial, SlocumSensor::initial_east, SlocumSensor::initial_north);
  note(known_.final_one, SlocumSensor::final_east, SlocumSensor::final_north);
}

void SlocumDives::note_place(const SlocumRow& row, core::UtcTime time) {
  const auto fix = fix_of(row);
  const auto place = fix ? fix : place_of(row, SlocumSensor::lon, SlocumSensor::lat);
  TrackRow noted{.time = time, .place = place, .fixed = fix.has_value()};
  if (const auto& depth_m = row[SlocumSensor::depth]) noted.depth = core::Metres{*depth_m};
  if (place) place_ = place;
  if (fix && dive_ && dive_->surfaced && !dive_->to) dive_->to = fix;
  if (!fix && !fixed_once_) {
    if (place || noted.depth) before_first_fix_.push_back(noted);
    if (before_first_fix_.size() == TrackBuilder::most_rows) add_early_rows();
    return;
  }
  if (!fixed_once_) {
    fixed_once_ = true;
    std::size_t unreached = 0;
    for (TrackRow& early : before_first_fix_) {
      if (!early.place || can_be_reached(early, noted)) continue;
      early.place.reset();
      ++unreached;
    }
    add_early_rows();
    if (unreached > 0)
      track_.warn(
          std::to_string(unreached) +
          " positions that the vehicle reckoned before its first fix are too far from it and left out");
  }
  if (place || noted.depth) track_.add(noted);
}

void SlocumDives::take(const SlocumRow& row) {
  const auto& seconds = row[SlocumSensor::time];
  if (!seconds || !(*seconds > 0.0) || *seconds > 7.3e9) {  // the year 2201: what follows is no time of a log
    track_.refuse_row();
    return;
  }
  const core::UtcTime time = core::from_unix_seconds(*seconds);
  const auto below = under_water(row);
  if (below && *below && (!dive_ || dive_->surfaced)) {
    settle();
    dive_ = Dive{.dived = time, .from = place_, .surfaced = {}, .to = {}, .known = {}};
  } else if (below && !*below && dive_ && !dive_->surfaced) {
    dive_->surfaced = time;
    dive_->known = known_;
  }
  note_currents(row);
  note_place(row, time);
}

void SlocumDives::settle() {
  if (!dive_ || !dive_->surfaced) return;
  Current found;
  const auto changed = [](const Current& before, const Current& now) { return now && now != before; };
  if (changed(dive_->known.final_one, known_.final_one)) {
    found = known_.final_one;
  } else if (changed(dive_->known.initial, known_.initial)) {
    found = known_.initial;
  } else if (!known_.final_one && !known_.initial && changed(dive_->known.water, known_.water)) {
    found = known_.water;
  }
  if (found) {
    TrackCurrent current{.time = dive_->dived + 0.5 * (*dive_->surfaced - dive_->dived),
                         .place = std::nullopt,
                         .current = *found};
    if (dive_->from && dive_->to) current.place = middle(*dive_->from, *dive_->to);
    track_.add(current);
  }
  dive_.reset();
}

void SlocumDives::add_early_rows() {
  for (const TrackRow& early : before_first_fix_) track_.add(early);
  before_first_fix_ = {};
}

void SlocumDives::finish() {
  settle();
  add_early_rows();
}

}  // namespace floeplan::ingest
