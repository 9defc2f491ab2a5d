#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/currents/glider_track.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// One row of a glider's data. A row without a place lies between its neighbours that have one.
struct TrackRow {
  core::UtcTime time;
  std::optional<geo::LonLat> place{};
  std::optional<core::Metres> depth{};
  bool fixed{true};  // the place was measured
};

/// A current that a file states, where it says so with its place.
struct TrackCurrent {
  core::UtcTime time;
  std::optional<geo::LonLat> place{};
  geo::VelocityEn current;
};

/// Collects the rows of one glider from its files, checks them and makes a track of them.
/// Bounds   `most_rows` rows: of more every second one is kept, as often as it takes, and the track says so
class TrackBuilder {
 public:
  static constexpr std::size_t most_rows = 1'000'000;

  explicit TrackBuilder(std::string glider) : glider_{std::move(glider)} {}

  void add(const TrackRow& row);
  /// Towards true east and north, as the file states it unless `turned_from` says otherwise.
  void add(const TrackCurrent& current) { currents_.push_back(current); }
  /// The currents were turned from these axes; the first ones count.
  void turned_from(const ocean::VehicleAxes& axes) {
    if (!turned_from_) turned_from_ = axes;
  }
  /// A row that cannot be used at all.
  void refuse_row() { ++rows_refused_; }
  /// For the user, in the order of the calls; the same words are said once.
  void warn(messages::Message told);

  /// The track, with its times ascending. Left out and told: places that are none, depths and currents that cannot be,
  /// currents of exactly nothing. Told alone: a speed over ground between fixes that no glider has, and currents whose
  /// frame is only stated.
  /// Errors   no row with a place is left
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
