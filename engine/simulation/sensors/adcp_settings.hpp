#pragma once

#include "engine/core/violation.hpp"

namespace floeplan::simulation {

inline constexpr int most_adcp_cells = 64;

/// An acoustic Doppler current profiler with four beams in Janus geometry, looking down along the hull's down
/// axis, and the processing of its data on board.
/// Source of the defaults: a 600 kHz profiler with 4 m cells measures the horizontal velocity with 0.03 to
/// 0.07 m/s from a single ping, which is 0.03 m/s along a beam, and neighbouring cells share 15 % of their
/// noise (Teledyne RD Instruments, Acoustic Doppler current profiler: principles of operation, 3rd ed. 2011,
/// sections 4 and 7). The reference, the vehicle's velocity over ground, is known to a few cm/s from
/// depth-averaged currents (Todd, Rudnick, Sherman, Owens and George 2017, J. Atmos. Oceanic Technol. 34,
/// doi:10.1175/JTECH-D-16-0156.1). Chosen without a source: beams between the usual 20 and 30 degrees;
/// fifteen cells, the 60 m range of such a profiler; half a minute of pings per minute, to save the battery;
/// attitude errors of a compass module; sway of the hull slightly larger; a correlation time of the reference
/// of an hour, about one dive
struct AdcpSettings {
  double beam_angle_rad{0.4363323};  // of each beam from the axis, 25 degrees
  double blank_m{2.0};               // vertical, before the first cell, level vehicle
  double cell_m{4.0};                // vertical, if the vehicle is level
  int cells{15};
  int pings{30};  // averaged into one profile
  double ping_interval_s{1.0};
  double interval_s{60.0};               // between profiles
  double ping_sigma_m_s{0.03};           // of one ping, one beam, one cell
  double neighbour_correlation{0.15};    // of the noise of adjacent cells
  double attitude_sigma_rad{0.0052360};  // of heading, pitch and roll as sensed for one ping, 0.3 degrees
  double sway_sigma_rad{0.0087266};      // of true heading, pitch and roll about their means, 0.5 degrees
  double reference_sigma_m_s{0.03};      // of each component of the reference
  double reference_time_s{3600.0};       // correlation time of the reference's error (Gauss-Markov)

  [[nodiscard]] core::Violations violations() const;

  friend bool operator==(const AdcpSettings&, const AdcpSettings&) = default;
};

}  // namespace floeplan::simulation
