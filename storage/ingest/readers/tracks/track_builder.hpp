#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/currents/glider_track.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// One row of a glider's data. A row without a position gets one by interpolation between rows that have one.
struct TrackRow {
  core::UtcTime time;
  std::optional<geo::LonLat> place{};
  std::optional<core::Metres> depth{};
  bool fixed{true};  // true: a fix; false: reckoned
};

/// A current of a file, with its position if the file states one.
struct TrackCurrent {
  core::UtcTime time;
  std::optional<geo::LonLat> place{};
  geo::VelocityEn current;
};

/// Collects the rows of one glider from its files, checks them and makes a track.
/// Bounds   `most_rows` rows; beyond that every second row is dropped, repeatedly, and the track says so
class TrackBuilder {
 public:
  static constexpr std::size_t most_rows = 1'000'000;

  explicit TrackBuilder(std::string glider) : glider_{std::move(glider)} {}

  void add(const TrackRow& row);
  /// Adds a current towards true east and north, as stated by the file unless `turned_from` was called.
  void add(const TrackCurrent& current) { currents_.push_back(current); }
  /// Tells that the currents were rotated from these axes; only the first call counts.
  void turned_from(const ocean::VehicleAxes& axes) {
    if (!turned_from_) turned_from_ = axes;
  }
  /// Counts a row that cannot be used at all.
  void refuse_row() { ++rows_refused_; }
  /// Adds a warning for the user, in the order of the calls; the same text is added once.
  void warn(messages::Message told);

  /// The track, with ascending times. Ignored, with a warning: invalid positions, impossible depths and
  /// currents, currents of exactly zero. Only a warning: a speed over ground between fixes that no glider
  /// reaches, and currents whose frame is only stated, not verified.
  /// Errors   no row with a position is left
  [[nodiscard]] Checked<PreparedDataset> prepared(std::vector<std::string> variables) &&;

 private:
  void sort_rows();
  void leave_out_impossible_places();
  void leave_out_impossible_depths();
  void fill_places();
  void leave_out_impossible_currents();
  void warn_of_speed(const std::vector<ocean::TrackPoint>& points);
  [[nodiscard]] std::vector<ocean::TrackPoint> points() const;
  [[nodiscard]] std::vector<ocean::DepthAveragedCurrent> currents(
      const std::vector<ocean::TrackPoint>& points) const;

  std::string glider_;
  std::vector<TrackRow> rows_;
  std::vector<TrackCurrent> currents_;
  std::optional<ocean::VehicleAxes> turned_from_;
  Messages warnings_;
  std::int64_t rows_refused_{};
  std::size_t seen_{};
  std::size_t stride_{1};
};

}  // namespace floeplan::ingest
