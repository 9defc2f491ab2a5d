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

/// The sightings of one berg of a dataset, at two or more times.
struct IcebergTrack {
  std::int64_t first_row{};  // row of its first sighting; identifies the track
  DatasetId dataset;
  std::string berg_id;
  std::vector<ocean::IcebergFix> fixes;  // oldest first
};

/// Conditions for a list of tracks. Empty members are no condition.
struct TrackFilter {
  std::optional<geo::BoundingBox> area{};  // one of its sightings lies in the area
  std::optional<core::UtcTime> from{};     // last sighting at this time or later
  std::optional<core::UtcTime> to{};       // first sighting at this time or earlier
  std::optional<std::string> berg_id{};
};

/// Tracks in ascending order of their first row, and whether there are more.
struct TrackPage {
  std::vector<IcebergTrack> tracks;
  bool more{false};
};

/// Tracks of the bergs that have a name, formed from their sightings. Of several at one time, the one stored
/// last counts.
/// Threads  as the connection: one thread at a time
class IcebergTrackRepository {
 public:
  /// Limit of fixes on a page; the last track may exceed it.
  static constexpr std::size_t most_fixes = 100'000;

  explicit IcebergTrackRepository(sql::Connection& db) : db_{db} {}

  [[nodiscard]] std::optional<IcebergTrack> find(std::int64_t first_row) const;
  /// At most `limit` tracks with a first row above `after`. Apart from an index, only their sightings are
  /// read.
  [[nodiscard]] TrackPage list(const TrackFilter& filter, std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const TrackFilter& filter) const;

 private:
  [[nodiscard]] std::vector<ocean::IcebergFix> fixes_of(const IcebergTrack& track) const;

  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
