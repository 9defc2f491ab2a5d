#include "storage/repository/features/iceberg_track_repository.hpp"

#include "storage/repository/encoding/box_index.hpp"
#include "storage/repository/features/iceberg_fixes.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::repository {
namespace {

constexpr int first_of_exact_box = 5;
constexpr int first_of_box_index = 9;

/// Bergs with a sighting in the area: those that the index finds near it, each looked at exactly.
std::string in_area(const sql::Connection& db) {
  return "(dataset_row, berg_id) IN (SELECT dataset_row, berg_id FROM sighting WHERE lat_deg BETWEEN ?5 AND "
         "?6 AND "
         "(wrapped_lon_deg BETWEEN ?7 AND ?8 OR wrapped_lon_deg + 360.0 BETWEEN ?7 AND ?8) AND " +
         box_condition(db, "sighting_box", first_of_box_index) + ")";
}

/// First row, dataset and name of each track that fits, all from the index by berg and time.
std::string heads(const sql::Connection& db, const TrackFilter& filter) {
  std::string sql =
      "SELECT min(row) AS first_row, (SELECT id FROM dataset WHERE dataset.row = dataset_row), berg_id FROM "
      "sighting WHERE berg_id <> ''";
  if (filter.berg_id) sql += " AND berg_id = ?2";
  if (filter.area) sql += " AND " + in_area(db);
  sql += " GROUP BY dataset_row, berg_id HAVING min(row) > ?1 AND min(observed_s) < max(observed_s)";
  if (filter.from) sql += " AND max(observed_s) >= ?3";
  if (filter.to) sql += " AND min(observed_s) <= ?4";
  return sql;
}

void bind_filter(sql::Statement& query, const TrackFilter& filter, std::int64_t after) {
  query.bind(1, after);
  if (filter.berg_id) query.bind(2, *filter.berg_id);
  if (filter.from) query.bind(3, *filter.from);
  if (filter.to) query.bind(4, *filter.to);
  if (!filter.area) return;
  const UnrolledBox box = unrolled(*filter.area);
  query.bind(first_of_exact_box, filter.area->south_deg);
  query.bind(first_of_exact_box + 1, filter.area->north_deg);
  query.bind(first_of_exact_box + 2, box.west_deg);
  query.bind(first_of_exact_box + 3, box.east_deg);
  bind_box(query, first_of_box_index, *filter.area);
}

IcebergTrack read_head(const sql::Row& row) {
  return {.first_row = row.integer(0), .dataset = {row.text(1)}, .berg_id = row.text(2), .fixes = {}};
}

}  // namespace

std::optional<IcebergTrack> IcebergTrackRepository::find(std::int64_t first_row) const {
  sql::Statement query{
      db_,
      "SELECT row, (SELECT id FROM dataset WHERE dataset.row = dataset_row), berg_id FROM sighting AS first "
      "WHERE row = ?1 AND berg_id <> '' AND NOT EXISTS (SELECT 1 FROM sighting WHERE dataset_row = "
      "first.dataset_row AND berg_id = first.berg_id AND row < first.row)"};
  query.bind(1, first_row);
  if (!query.step()) return std::nullopt;
  IcebergTrack track = read_head(query);
  track.fixes = fixes_of(track);
  return track.fixes.size() < 2 ? std::nullopt : std::optional{std::move(track)};
}

TrackPage IcebergTrackRepository::list(const TrackFilter& filter, std::int64_t after, int limit) const {
  sql::Statement query{db_, heads(db_, filter) + " ORDER BY first_row LIMIT " + std::to_string(limit + 1)};
  bind_filter(query, filter, after);
  TrackPage page;
  std::size_t fixes = 0;
  while (query.step()) {
    page.more = std::ssize(page.tracks) == limit || fixes > most_fixes;
    if (page.more) return page;
    IcebergTrack& track = page.tracks.emplace_back(read_head(query));
    track.fixes = fixes_of(track);
    fixes += track.fixes.size();
  }
  return page;
}

std::int64_t IcebergTrackRepository::count(const TrackFilter& filter) const {
  sql::Statement query{db_, "SELECT count(*) FROM (" + heads(db_, filter) + ") AS heads"};
  bind_filter(query, filter, 0);
  return query.step() ? query.integer(0) : 0;
}

std::vector<ocean::IcebergFix> IcebergTrackRepository::fixes_of(const IcebergTrack& track) const {
  return iceberg_fixes(db_, track.dataset, track.berg_id);
}

}  // namespace floeplan::repository
