#include "storage/repository/features/glider_track_repository.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/repository/encoding/box_index.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

/// Rows of numbers in the blob of a track, one number per point: time, longitude, latitude, depth (NaN:
/// unknown), and whether the position is a fix (1) or reckoned (0).
constexpr std::size_t planes = 5;
constexpr int first_of_box = 6;

const std::string track_columns =
    "row, (SELECT id FROM dataset WHERE dataset.row = dataset_row), glider, points, deepest_m, way, "
    "dataset_row, position, frame, variation_source, variation_west_rad, utm_zone ";

std::vector<double> flat_track(const std::vector<ocean::TrackPoint>& points) {
  const std::size_t count = points.size();
  std::vector<double> numbers(planes * count);
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = core::unix_seconds(points[i].time);
    numbers[count + i] = points[i].place.lon_deg;
    numbers[2 * count + i] = points[i].place.lat_deg;
    numbers[3 * count + i] =
        points[i].depth ? points[i].depth->value : std::numeric_limits<double>::quiet_NaN();
    numbers[4 * count + i] = points[i].fixed ? 1.0 : 0.0;
  }
  return numbers;
}

std::vector<ocean::TrackPoint> track_from(const std::vector<double>& numbers) {
  const std::size_t count = numbers.size() / planes;
  std::vector<ocean::TrackPoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {.time = core::from_unix_seconds(numbers[i]),
                 .place = {numbers[count + i], numbers[2 * count + i]},
                 .depth = std::nullopt,
                 .fixed = numbers[4 * count + i] != 0.0};
    if (const double depth_m = numbers[3 * count + i]; !std::isnan(depth_m))
      points[i].depth = core::Metres{depth_m};
  }
  return points;
}

std::vector<ocean::TrackPoint> points_of(const sql::Row& row, BlobCodec& codec) {
  return track_from(codec.unpack_doubles(row.blob(5), planes * static_cast<std::size_t>(row.integer(3))));
}

std::vector<ocean::DepthAveragedCurrent> currents_of(sql::Connection& db, const sql::Row& row) {
  sql::Statement query{db,
                       "SELECT time_s, lon_deg, lat_deg, east_m_s, north_m_s FROM glider_current WHERE "
                       "dataset_row = ?1 AND position = ?2 ORDER BY time_s, row"};
  query.bind_all(row.integer(6), row.integer(7));
  std::vector<ocean::DepthAveragedCurrent> currents;
  while (query.step())
    currents.push_back({.time = query.time(0),
                        .place = {query.real(1), query.real(2)},
                        .current = {{query.real(3)}, {query.real(4)}}});
  return currents;
}

std::optional<ocean::VehicleAxes> axes_of(const sql::Row& row) {
  const auto name = row.optional_text(9);
  const auto variation_west_rad = row.optional_real(10);
  const auto source = name ? ocean::parse_variation_source(*name) : std::nullopt;
  if (!source || !variation_west_rad) return std::nullopt;
  return ocean::VehicleAxes{{static_cast<int>(row.integer(11)), {*variation_west_rad}}, *source};
}

StoredGliderTrack read_track(sql::Connection& db, const sql::Row& row, BlobCodec& codec) {
  StoredGliderTrack stored;
  stored.row = row.integer(0);
  stored.dataset = {row.text(1)};
  stored.track = {.glider = row.text(2),
                  .points = points_of(row, codec),
                  .currents = currents_of(db, row),
                  .frame = ocean::parse_current_frame(row.text(8)).value(),
                  .turned_from = axes_of(row)};
  stored.point_count = row.integer(3);
  stored.current_count = std::ssize(stored.track.currents);
  if (const auto deepest_m = row.optional_real(4)) stored.deepest = core::Metres{*deepest_m};
  stored.mean_current = ocean::mean_current(stored.track.currents);
  return stored;
}

/// Whether a track enters the area between its points. May be true for a track that passes close to it.
bool comes_into(const geo::BoundingBox& area, const std::vector<ocean::TrackPoint>& points) {
  if (points.size() == 1) return geo::contains(area, points.front().place);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::array ends{points[i - 1].place, points[i].place};
    if (geo::contains(area, ends[1]) || geo::intersects(area, geo::bounding_box(ends))) return true;
  }
  return false;
}

/// `SELECT <what> FROM glider_track` with the filter's conditions and values. The area is only a coarse
/// condition.
sql::Statement select_tracks(sql::Connection& db, const std::string& what, const GliderTrackFilter& filter,
                             std::int64_t after, const std::string& order = " ORDER BY row") {
  std::string sql = "SELECT " + what + " FROM glider_track WHERE row > ?1";
  if (filter.from) sql += " AND end_s >= ?2";
  if (filter.to) sql += " AND start_s <= ?3";
  if (filter.dataset) sql += " AND dataset_row = (SELECT row FROM dataset WHERE id = ?4)";
  if (filter.glider) sql += " AND glider = ?5";
  if (filter.area) sql += " AND " + box_condition(db, "glider_track_box", first_of_box);

  sql::Statement query{db, sql + order};
  query.bind(1, after);
  if (filter.from) query.bind(2, *filter.from);
  if (filter.to) query.bind(3, *filter.to);
  if (filter.dataset) query.bind(4, filter.dataset->value);
  if (filter.glider) query.bind(5, *filter.glider);
  if (filter.area) bind_box(query, first_of_box, *filter.area);
  return query;
}

/// At most `most` of the currents, evenly distributed.
std::vector<ocean::DepthAveragedCurrent> chosen(const std::vector<ocean::DepthAveragedCurrent>& currents,
                                                std::size_t most) {
  if (currents.size() <= most) return currents;
  std::vector<ocean::DepthAveragedCurrent> some;
  some.reserve(most);
  for (std::size_t i = 0; i < most; ++i) some.push_back(currents[currents.size() * i / most]);
  return some;
}

class TrackWriter {
 public:
  TrackWriter(sql::Connection& db, const DatasetId& dataset)
      : dataset_row_{dataset_row(db, dataset)},
        track_{
            db,
            "INSERT INTO glider_track (dataset_row, position, glider, start_s, end_s, deepest_m, points, "
            "way, frame, variation_source, variation_west_rad, utm_zone) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, "
            "?8, ?9, ?10, ?11, ?12) RETURNING row"},
        box_{db, "glider_track_box"},
        current_{db,
                 "INSERT INTO glider_current (dataset_row, position, time_s, lon_deg, lat_deg, east_m_s, "
                 "north_m_s) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)"} {}

  void write(std::int64_t position, const ocean::GliderTrack& track) {
    if (track.points.empty()) throw std::invalid_argument{"a track without points"};
    const auto deepest = ocean::deepest(track.points);
    track_.bind_all(dataset_row_, position, track.glider, track.points.front().time, track.points.back().time,
                    deepest ? std::optional{deepest->value} : std::nullopt, std::ssize(track.points),
                    codec_.pack(flat_track(track.points)), std::string{ocean::frame_name(track.frame)});
    const auto& axes = track.turned_from;
    track_.bind(10, axes ? std::optional{std::string{ocean::source_name(axes->source)}} : std::nullopt);
    track_.bind(11, axes ? std::optional{axes->axes.variation_west().value} : std::nullopt);
    track_.bind(12, axes ? std::optional{std::int64_t{axes->axes.utm_zone()}} : std::nullopt);
    const std::int64_t row = sql::inserted_number(track_);
    std::vector<geo::LonLat> places;
    places.reserve(track.points.size());
    for (const ocean::TrackPoint& point : track.points) places.push_back(point.place);
    box_.run(row, geo::bounding_box(places));
    for (const ocean::DepthAveragedCurrent& each : track.currents) {
      current_.bind_all(dataset_row_, position, each.time, each.place.lon_deg, each.place.lat_deg,
                        each.current.east.value, each.current.north.value);
      current_.run();
    }
  }

 private:
  std::int64_t dataset_row_;
  sql::Statement track_;
  BoxInsert box_;
  sql::Statement current_;
  BlobCodec codec_;
};

}  // namespace

void GliderTrackRepository::insert(const DatasetId& dataset, const std::vector<ocean::GliderTrack>& tracks) {
  sql::Transaction transaction{db_};
  TrackWriter writer{db_, dataset};
  for (std::size_t i = 0; i < tracks.size(); ++i) writer.write(static_cast<std::int64_t>(i), tracks[i]);
  transaction.commit();
}

std::optional<StoredGliderTrack> GliderTrackRepository::find(std::int64_t row) const {
  sql::Statement query{db_, "SELECT " + track_columns + "FROM glider_track WHERE row = ?1"};
  query.bind(1, row);
  if (!query.step()) return std::nullopt;
  BlobCodec codec;
  return read_track(db_, query, codec);
}

GliderTrackPage GliderTrackRepository::list(const GliderTrackFilter& filter, std::int64_t after,
                                            int limit) const {
  sql::Statement query = select_tracks(db_, track_columns, filter, after);
  GliderTrackPage page;
  std::size_t listed = 0;
  BlobCodec codec;
  while (query.step()) {
    StoredGliderTrack stored = read_track(db_, query, codec);
    if (filter.area && !comes_into(*filter.area, stored.track.points)) continue;
    page.more = std::ssize(page.tracks) == limit || listed > most_on_a_page;
    if (page.more) return page;
    stored.track.points = ocean::thinned(stored.track.points, most_listed);
    stored.track.currents = chosen(stored.track.currents, most_listed);
    listed += stored.track.points.size() + stored.track.currents.size();
    page.tracks.push_back(std::move(stored));
  }
  return page;
}

std::int64_t GliderTrackRepository::count(const GliderTrackFilter& filter) const {
  if (!filter.area) {
    sql::Statement query = select_tracks(db_, "count(*)", filter, 0, "");
    return query.step() ? query.integer(0) : 0;
  }
  sql::Statement query = select_tracks(db_, track_columns, filter, 0);
  std::int64_t tracks = 0;
  BlobCodec codec;
  while (query.step()) tracks += comes_into(*filter.area, points_of(query, codec)) ? 1 : 0;
  return tracks;
}

}  // namespace floeplan::repository
