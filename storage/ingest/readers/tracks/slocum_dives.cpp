#include "storage/ingest/readers/tracks/slocum_dives.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "engine/mission/document/packed_degrees.hpp"

namespace floeplan::ingest {
namespace {

constexpr double state_under_water = 1.0;
/// For logs without the state: deeper than dive_m is a dive, shallower than surface_m the surface. The range
/// between them allows for waves.
constexpr double dive_m = 3.0;
constexpr double surface_m = 1.5;
/// Limits beyond any glider's speed and any error of its receiver.
constexpr double fastest_between_fixes_m_s = 10.0;
constexpr double slack_m = 1'000.0;

std::optional<geo::VelocityLmc> current_of(const SlocumRow& row, SlocumSensor x, SlocumSensor y) {
  if (!row[x] || !row[y]) return std::nullopt;
  return geo::VelocityLmc{{*row[x]}, {*row[y]}};
}

std::optional<geo::LonLat> logged_place(const SlocumRow& row, SlocumSensor lon, SlocumSensor lat) {
  return row[lon] && row[lat] ? mission::unpack_place(*row[lon], *row[lat]) : std::nullopt;
}

std::optional<geo::LonLat> fix_of(const SlocumRow& row) {
  if (row[SlocumSensor::gps_status].value_or(0.0) != 0.0) return std::nullopt;
  return logged_place(row, SlocumSensor::gps_lon, SlocumSensor::gps_lat);
}

bool can_be_reached(const TrackRow& from, const TrackRow& to) {
  const double moved_m = geo::geodesic_between(*from.place, *to.place).length.value;
  return moved_m <= slack_m + fastest_between_fixes_m_s * (to.time - from.time).count();
}

geo::LonLat middle_place(geo::LonLat a, geo::LonLat b) {
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
  const auto note = [&](Current& known, SlocumSensor x, SlocumSensor y) {
    if (const auto current = current_of(row, x, y)) known = current;
  };
  note(known_.water, SlocumSensor::water_x, SlocumSensor::water_y);
  note(known_.initial, SlocumSensor::initial_x, SlocumSensor::initial_y);
  note(known_.final_one, SlocumSensor::final_x, SlocumSensor::final_y);
}

void SlocumDives::note_axes(const SlocumRow& row, core::UtcTime time) {
  const auto fix = fix_of(row);
  axes_now_ = axes_.note({.time = time,
                          .fix = fix,
                          .place = fix ? fix : logged_place(row, SlocumSensor::lon, SlocumSensor::lat),
                          .cosine = row[SlocumSensor::utm_to_lmc_00],
                          .sine = row[SlocumSensor::utm_to_lmc_01],
                          .variation_rad = row[SlocumSensor::variation],
                          .utm_zone = row[SlocumSensor::utm_zone],
                          .segment = segment_});
}

void SlocumDives::note_place(const SlocumRow& row, core::UtcTime time) {
  const auto fix = fix_of(row);
  const auto place = fix ? fix : logged_place(row, SlocumSensor::lon, SlocumSensor::lat);
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
    if (unreached > 0) track_.warn(messages::ingest_track_message<"reckoned-positions-left-out">(unreached));
  }
  if (place || noted.depth) track_.add(noted);
}

void SlocumDives::begin_log(int segment) {
  if (segment != segment_ && segment != segment_ + 1) settle();
  segment_ = segment;
}

void SlocumDives::take(const SlocumRow& row) {
  const auto& seconds = row[SlocumSensor::time];
  if (!seconds || !(*seconds > 0.0) || *seconds > 7.3e9) {  // times after the year 2201 are damaged
    track_.refuse_row();
    return;
  }
  const core::UtcTime time = core::from_unix_seconds(*seconds);
  const auto below = under_water(row);
  if (below && *below && (!dive_ || dive_->surfaced)) {
    settle();
    dive_ = Dive{.dived = time, .from = place_, .surfaced = {}, .to = {}, .known = {}, .axes = axes_now_};
  } else if (below && !*below && dive_ && !dive_->surfaced) {
    dive_->surfaced = time;
    dive_->known = known_;
  }
  note_currents(row);
  note_axes(row, time);
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
    Met met{.time = dive_->dived + 0.5 * (*dive_->surfaced - dive_->dived),
            .place = std::nullopt,
            .near = dive_->to     ? dive_->to
                    : dive_->from ? dive_->from
                                  : place_,
            .current = *found,
            .axes = dive_->axes};
    if (dive_->from && dive_->to) met.near = met.place = middle_place(*dive_->from, *dive_->to);
    met_.push_back(met);
  }
  dive_.reset();
}

void SlocumDives::add_early_rows() {
  for (const TrackRow& early : before_first_fix_) track_.add(early);
  before_first_fix_ = {};
}

void SlocumDives::turn_currents() {
  std::size_t unknown = 0;
  for (const Met& met : met_) {
    const auto known = axes_.axes(met.axes);
    if (!known || !met.near) {
      ++unknown;
      continue;
    }
    track_.add(TrackCurrent{
        .time = met.time, .place = met.place, .current = known->axes.to_true(met.current, *met.near)});
    track_.turned_from(*known);
    track_.warn(messages::ingest_track_message<"currents-turned-to-true-north">(ocean::words_of(*known)));
    for (const std::string& doubt : axes_.doubts(met.axes))
      track_.warn(messages::ingest_track_message<"axes-doubtful">(doubt));
  }
  if (unknown > 0) track_.warn(messages::ingest_track_message<"currents-in-vehicle-axes-left-out">(unknown));
}

void SlocumDives::finish() {
  settle();
  turn_currents();
  add_early_rows();
}

}  // namespace floeplan::ingest
