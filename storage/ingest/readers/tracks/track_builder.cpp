#include "storage/ingest/readers/tracks/track_builder.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"
#include "storage/repository/features/glider_track_repository.hpp"

namespace floeplan::ingest {
namespace {

/// Depth sensors read a little above the surface in waves, and when their zero has drifted.
constexpr double highest_m = -20.0;
constexpr double deepest_m = 12'000.0;  // the deepest sea has 11 km
/// A glider makes 0.3 m/s through the water, an aircraft carrier or a ship that recovers it 10 m/s.
constexpr double fastest_m_s = 10.0;
/// Times of logs and files are often whole seconds, so shorter steps say nothing of the speed.
constexpr core::Seconds least_step{1.0};
/// Scatter of the fixes of a receiver.
constexpr double scatter_m = 100.0;

bool is_place(geo::LonLat place) {
  // A vehicle without a fix logs zeros.
  return geo::is_valid(place) && place != geo::LonLat{0.0, 0.0};
}

/// The position at a time between two rows, interpolated.
geo::LonLat between(const TrackRow& before, const TrackRow& after, core::UtcTime time) {
  return ocean::place_at(
      {{.time = before.time, .place = *before.place}, {.time = after.time, .place = *after.place}}, time);
}

}  // namespace

void TrackBuilder::add(const TrackRow& row) {
  if (seen_++ % stride_ != 0) return;
  rows_.push_back(row);
  if (rows_.size() < most_rows) return;
  for (std::size_t i = 0; 2 * i < rows_.size(); ++i) rows_[i] = rows_[2 * i];
  rows_.resize((rows_.size() + 1) / 2);
  stride_ *= 2;
}

void TrackBuilder::warn(messages::Message told) {
  if (std::ranges::find(warnings_, told) == warnings_.end()) warnings_.push_back(std::move(told));
}

void TrackBuilder::leave_out_impossible_places() {
  std::size_t removed = 0;
  for (TrackRow& row : rows_) {
    if (!row.place || is_place(*row.place)) continue;
    row.place.reset();
    ++removed;
  }
  if (removed > 0) warn(messages::ingest_track_message<"track-positions-left-out">(removed));
}

void TrackBuilder::leave_out_impossible_depths() {
  std::size_t removed = 0;
  for (TrackRow& row : rows_) {
    if (!row.depth || (row.depth->value >= highest_m && row.depth->value <= deepest_m)) continue;
    row.depth.reset();
    ++removed;
  }
  if (removed > 0) warn(messages::ingest_track_message<"track-depths-left-out">(removed));
}

void TrackBuilder::sort_rows() {
  const auto by_time = [](const TrackRow& row) { return row.time; };
  if (!std::ranges::is_sorted(rows_, {}, by_time)) {
    warn(messages::ingest_track_message<"track-put-in-order">());
    std::ranges::stable_sort(rows_, {}, by_time);
  }
  const auto [first, last] = std::ranges::unique(rows_, [](const TrackRow& a, const TrackRow& b) {
    return a.time == b.time && a.place == b.place && a.depth == b.depth;
  });
  rows_.erase(first, last);
}

void TrackBuilder::fill_places() {
  std::vector<TrackRow> placed;
  placed.reserve(rows_.size());
  for (std::size_t i = 0; i < rows_.size();) {
    if (rows_[i].place) {
      placed.push_back(rows_[i++]);
      continue;
    }
    std::size_t next = i;
    while (next < rows_.size() && !rows_[next].place) ++next;
    const bool inside = !placed.empty() && next < rows_.size();
    const TrackRow before = inside ? placed.back() : TrackRow{};
    for (; i < next; ++i) {
      if (!inside || !rows_[i].depth) {
        ++rows_refused_;
        continue;
      }
      placed.push_back(rows_[i]);
      placed.back().place = between(before, rows_[next], rows_[i].time);
      placed.back().fixed = false;
    }
  }
  rows_ = std::move(placed);
}

void TrackBuilder::leave_out_impossible_currents() {
  const auto nothing = std::erase_if(currents_, [](const TrackCurrent& each) {
    return each.current.east.value == 0.0 && each.current.north.value == 0.0;
  });
  if (nothing > 0) warn(messages::ingest_track_message<"zero-currents-left-out">(nothing));
  const auto impossible = std::erase_if(currents_, [](const TrackCurrent& each) {
    return !(geo::strength(each.current).value <= max_speed_m_s) || (each.place && !is_place(*each.place));
  });
  if (impossible > 0) warn(messages::ingest_track_message<"impossible-currents-left-out">(impossible));
}

void TrackBuilder::warn_of_speed(const std::vector<ocean::TrackPoint>& points) {
  const ocean::TrackPoint* before = nullptr;
  std::size_t found = 0;
  std::pair<double, core::UtcTime> fastest{};
  for (const ocean::TrackPoint& point : points) {
    if (!point.fixed) continue;
    if (before != nullptr && point.place != before->place) {
      const core::Seconds took = std::max(point.time - before->time, least_step);
      const double moved_m = geo::geodesic_between(before->place, point.place).length.value;
      const double speed_m_s = moved_m / took.count();
      if (moved_m > scatter_m && speed_m_s > fastest_m_s) {
        ++found;
        fastest = std::max(fastest, {speed_m_s, point.time});
      }
    }
    before = &point;
  }
  if (found > 0)
    warn(messages::ingest_track_message<"track-too-fast">(found, number(fastest.first, 3), fastest.second));
}

std::vector<ocean::TrackPoint> TrackBuilder::points() const {
  std::vector<ocean::TrackPoint> points;
  points.reserve(rows_.size());
  for (const TrackRow& row : rows_)
    points.push_back({.time = row.time,
                      .place = {geo::wrap_longitude(row.place->lon_deg), row.place->lat_deg},
                      .depth = row.depth,
                      .fixed = row.fixed});
  return points;
}

std::vector<ocean::DepthAveragedCurrent> TrackBuilder::currents(
    const std::vector<ocean::TrackPoint>& points) const {
  std::vector<ocean::DepthAveragedCurrent> currents;
  for (const TrackCurrent& each : currents_) {
    const geo::LonLat place = each.place.value_or(ocean::place_at(points, each.time));
    currents.push_back({each.time, {geo::wrap_longitude(place.lon_deg), place.lat_deg}, each.current});
  }
  std::ranges::stable_sort(currents, {}, &ocean::DepthAveragedCurrent::time);
  const auto [first, last] = std::ranges::unique(currents);
  currents.erase(first, last);
  return currents;
}

Checked<PreparedDataset> TrackBuilder::prepared(std::vector<std::string> variables) && {
  if (stride_ > 1) warn(messages::ingest_track_message<"track-thinned">(seen_, stride_));
  leave_out_impossible_places();
  leave_out_impossible_depths();
  sort_rows();
  fill_places();
  if (rows_.empty()) return refuse(messages::ingest_track_message<"track-without-places">());
  leave_out_impossible_currents();

  ocean::GliderTrack track{.glider = std::move(glider_), .points = points(), .currents = {}};
  rows_ = {};
  track.currents = currents(track.points);
  if (turned_from_) {
    track.frame = ocean::CurrentFrame::turned;
    track.turned_from = turned_from_;
  } else if (!track.currents.empty()) {
    warn(messages::ingest_track_message<"currents-taken-as-true-north">());
  }
  warn_of_speed(track.points);

  PreparedDataset data;
  data.kind = repository::DatasetKind::glider_tracks;
  data.variables = std::move(variables);
  data.bounds = ocean::bounding_box(track);
  data.time_start = track.points.front().time;
  data.time_end = track.points.back().time;
  data.rows_accepted = std::ssize(track.points);
  data.rows_refused = rows_refused_;
  data.warnings = std::move(warnings_);
  data.write = [track = std::move(track)](sql::Connection& db,
                                          const repository::DatasetId& id) -> Checked<void> {
    repository::GliderTrackRepository{db}.insert(id, {track});
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
