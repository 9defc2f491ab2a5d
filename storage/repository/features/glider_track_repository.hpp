#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/currents/glider_track.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

struct StoredGliderTrack {
  std::int64_t row{};  // identifies the track
  DatasetId dataset;
  std::int64_t point_count{};    // number in the store; a list has fewer points of a long track
  std::int64_t current_count{};  // number in the store
  std::optional<core::Metres> deepest{};
  std::optional<geo::VelocityEn> mean_current{};  // mean of all its currents
  ocean::GliderTrack track;
};

/// Conditions for a list of tracks. Empty members are no condition.
struct GliderTrackFilter {
  std::optional<geo::BoundingBox> area{};  // tracks that enter the area, also between two points
  std::optional<core::UtcTime> from{};     // tracks that end at this time or later
  std::optional<core::UtcTime> to{};       // tracks that begin at this time or earlier
  std::optional<DatasetId> dataset{};
  std::optional<std::string> glider{};
};

/// Tracks in ascending order of their row, and whether there are more.
struct GliderTrackPage {
  std::vector<StoredGliderTrack> tracks;
  bool more{false};
};

/// Tracks of gliders and the depth-averaged currents along them.
/// Threads  as the connection: one thread at a time
class GliderTrackRepository {
 public:
  /// Largest number of points, and of currents, of each track in a list; enough to draw it.
  static constexpr std::size_t most_listed = 500;
  /// Limit of points on a page; the last track may exceed it.
  static constexpr std::size_t most_on_a_page = 100'000;

  explicit GliderTrackRepository(sql::Connection& db) : db_{db} {}

  /// Adds tracks to a dataset, which must be in the list of datasets.
  /// Errors   std::invalid_argument for a track without points, or if the dataset does not exist
  void insert(const DatasetId& dataset, const std::vector<ocean::GliderTrack>& tracks);

  /// A track with all its points.
  [[nodiscard]] std::optional<StoredGliderTrack> find(std::int64_t row) const;
  /// At most `limit` tracks with a row above `after`; long tracks have fewer points.
  [[nodiscard]] GliderTrackPage list(const GliderTrackFilter& filter, std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const GliderTrackFilter& filter) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
