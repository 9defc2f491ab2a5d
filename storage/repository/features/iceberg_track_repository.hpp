#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Where one berg of a dataset was seen, at two moments at least.
struct IcebergTrack {
  std::int64_t first_row{};  // of its first sighting in the store: names the track
  DatasetId dataset;
  std::string berg_id;
  std::vector<ocean::IcebergFix> fixes;  // oldest first
};

/// Which tracks a list wants. Everything empty: all.
struct TrackFilter {
  std::optional<geo::BoundingBox> area{};  // that one of its sightings lies in
  std::optional<core::UtcTime> from{};     // last seen then or later
  std::optional<core::UtcTime> to{};       // first seen then or earlier
  std::optional<std::string> berg_id{};
};

/// Tracks by ascending first row, and whether there are more.
struct TrackPage {
  std::vector<IcebergTrack> tracks;
  bool more{false};
};

/// The sightings of each berg that has a name, put together. Of several at one moment the one stored last counts.
/// Threads  as the connection: one thread at a time
class IcebergTrackRepository {
 public:
  /// A page of tracks has no more fixes than this and those of its last track.
  static constexpr std::size_t most_fixes = 100'000;

  explicit IcebergTrackRepository(sql::Connection& db) : db_{db} {}

  [[nodiscard]] std::optional<IcebergTrack> find(std::int64_t first_row) const;
  /// At most `limit` tracks with a first row above `after`. Only theirs is read but for an index.
  [[nodiscard]] TrackPage list(const TrackFilter& filter, std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const TrackFilter& filter) const;

 private:
  [[nodiscard]] std::vector<ocean::IcebergFix> fixes_of(const IcebergTrack& track) const;

  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
