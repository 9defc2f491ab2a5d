#pragma once

#include <optional>
#include <vector>

#include "engine/geo/local_mission_axes.hpp"
#include "engine/ocean/currents/vehicle_axes.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"

namespace floeplan::ingest {

/// Finds the dives of a Slocum, with their positions and currents, in the rows of its logs, segment after
/// segment.
/// Places   fixes, or else the vehicle's own dead reckoning, which jumps where a fix corrects it. Positions
///          reckoned before the first fix may be those where the vehicle was switched off; they are ignored
///          if no glider could have reached the fix from there
/// Currents After it has surfaced, the vehicle estimates the current of the dive: first m_initial_water,
/// then, after its drift at the surface and in the next segment, m_final_water. A value that changes between
/// this dive and the next is the current of this dive; m_final_water is preferred. m_water, which is known
/// while diving, is the current of an earlier dive
/// Frame    logged along the vehicle's own axes; added to the track towards true east and north, by the axes'
///          convergence at the dive. If the axes are unknown (see ocean::LoggedAxes) the currents are
///          ignored, with a warning
/// Source   x_dr_state 1: under water, in the vendor's data dictionary of firmware 10.5; m_gps_status 0: a
///          valid fix
class SlocumDives {
 public:
  explicit SlocumDives(TrackBuilder& track) : track_{track} {}

  /// Tells that the next rows are from this segment of the mission; 0: the first segment, or unknown. If
  /// segments in between are missing, the next estimates belong to the missing dives.
  void begin_log(int segment);
  void take(const SlocumRow& row);
  /// Call after the last row.
  void finish();

 private:
  using Current = std::optional<geo::VelocityLmc>;

  /// The vehicle's estimates of the current after a row.
  struct Known {
    Current water;
    Current initial;
    Current final_one;
  };

  struct Dive {
    core::UtcTime dived;
    std::optional<geo::LonLat> from;
    std::optional<core::UtcTime> surfaced;
    std::optional<geo::LonLat> to;  // first fix after the dive
    Known known;                    // estimates when it surfaced
    std::size_t axes{};             // number of the dead reckoning's axes in `axes_`
  };

  /// The current of a dive, along the axes with a number in `axes_`.
  struct Met {
    core::UtcTime time;
    std::optional<geo::LonLat> place;  // position in the middle of the dive
    std::optional<geo::LonLat> near;   // the same, or else where the dive began or ended
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
