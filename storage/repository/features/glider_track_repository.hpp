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
  std::int64_t row{};  // names the track
  DatasetId dataset;
  std::int64_t point_count{};    // in the store; a list gives fewer of a long track
  std::int64_t current_count{};  // as well
  std::optional<core::Metres> deepest{};
  std::optional<geo::VelocityEn> mean_current{};  // of all its currents
  ocean::GliderTrack track;
};

/// Which tracks a list wants. Everything empty: all.
struct GliderTrackFilter {
  std::optional<geo::BoundingBox> area{};  // tracks that come into it, between their points, too
  std::optional<core::UtcTime> from{};     // tracks that end at this time or later
  std::optional<core::UtcTime> to{};       // tracks that begin at this time or earlier
  std::optional<DatasetId> dataset{};
  std::optional<std::string> glider{};
};

/// Tracks by ascending row, and whether there are more.
struct GliderTrackPage {
  std::vector<StoredGliderTrack> tracks;
  bool more{false};
};

/// Ways of gliders and the depth-averaged currents that they met.
/// Threads  as the connection: one thread at a time
class GliderTrackRepository {
 public:
  /// The most points, and the most currents, of each track in a list: enough to draw it.
  static constexpr std::size_t most_listed = 500;
  /// A page has no more points than this and those of its last track.
  static constexpr std::size_t most_on_a_page = 100'000;

  explicit GliderTrackRepository(sql::Connection& db) : db_{db} {}

  /// Adds the tracks of a dataset, which must be in the list of datasets.
  /// Errors   std::invalid_argument for a track without points, or of a dataset that is not there
  void insert(const DatasetId& dataset, const std::vector<ocean::GliderTrack>& tracks);

  /// With every point.
  [[nodiscard]] std::optional<StoredGliderTrack> find(std::int64_t row) const;
  /// At most `limit` tracks with a row above `after`, long ones thinned.
  [[nodiscard]] GliderTrackPage list(const GliderTrackFilter& filter, std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const GliderTrackFilter& filter) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
