#pragma once

#include <optional>
#include <vector>

#include "engine/geo/local_mission_axes.hpp"
#include "engine/ocean/currents/vehicle_axes.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"

namespace floeplan::ingest {

/// Follows the rows of a Slocum's logs, segment after segment, from dive to dive.
/// Places   fixes of the receiver, else the vehicle's own reckoning, which jumps where a fix corrects it. What it
///          reckons before its first fix may be where it was switched off: what no glider could reach from there is
///          left out
/// Currents the vehicle knows the current of a dive once it is up: m_initial_water right after it surfaced,
///          m_final_water after the drift at the surface, in the next segment. What changed between this dive and the
///          next is of this dive, the final one before the first; what it dived with (m_water) was of an earlier one
/// Frame    logged in the vehicle's own axes; given to the track towards true east and north, with the axes' convergence
///          where the dive was. Where nothing tells the axes (see ocean::LoggedAxes) the currents are left out, and told
/// Source   x_dr_state 1: under water, of the vendor's data dictionary of firmware 10.5; m_gps_status 0: a valid fix
class SlocumDives {
 public:
  explicit SlocumDives(TrackBuilder& track) : track_{track} {}

  /// The rows from now on are of this segment of their mission; 0: the first, or not told. Where segments between are
  /// not there, what the vehicle knows next is of their dives.
  void begin_log(int segment);
  void take(const SlocumRow& row);
  /// After the last row.
  void finish();

 private:
  using Current = std::optional<geo::VelocityLmc>;

  /// What the vehicle knows of currents after a row.
  struct Known {
    Current water;
    Current initial;
    Current final_one;
  };

  struct Dive {
    core::UtcTime dived;
    std::optional<geo::LonLat> from;
    std::optional<core::UtcTime> surfaced;
    std::optional<geo::LonLat> to;  // the first fix after it
    Known known;                    // when it came up
    std::size_t axes{};             // of the coordinates of the vehicle's dead reckoning
  };

  /// The current of a dive, in the axes of a number of `axes_`.
  struct Met {
    core::UtcTime time;
    std::optional<geo::LonLat> place;  // in the middle of the dive
    std::optional<geo::LonLat> near;   // the same, or where it began or ended
    geo::VelocityLmc current;
    std::size_t axes{};
  };

  [[nodiscard]] std::optional<bool> under_water(const SlocumRow& row);
  void note_axes(const SlocumRow& row, core::UtcTime time);
  void note_currents(const SlocumRow& row);
  void note_place(const SlocumRow& row, core::UtcTime time);
  void add_early_rows();
  void settle();
  void turn_currents();

  TrackBuilder& track_;  // borrowed
  ocean::LoggedAxes axes_;
  std::size_t axes_now_{};
  int segment_{};
  std::vector<Met> met_;
  Known known_;
  std::optional<Dive> dive_;
  std::optional<geo::LonLat> place_;
  std::vector<TrackRow> before_first_fix_;
  bool fixed_once_{false};
  bool has_states_{false};
  bool was_deep_{false};
};

}  // namespace floeplan::ingest
