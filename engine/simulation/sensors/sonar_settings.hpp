#pragma once

#include "engine/core/violation.hpp"
#include "engine/simulation/sensors/beam_pattern.hpp"
#include "engine/simulation/sensors/sea_sound.hpp"

namespace floeplan::simulation {

/// A forward-looking sonar of many beams that all look at once: rows of beams side by side, one row above the other.
/// Source of the defaults: no sonar of a glider is prescribed. Frequency, source level, widths and listening range are
///         those of small commercial forward-looking sonars of 200 to 450 kHz; five rows reach 30 degrees up and
///         down, so that some look level at the pitch of 26 degrees at which a Slocum dives and climbs. Strengths of
///         the faces: rough rock sends back -30 to -20 dB (Olson, Lyons and Saebo 2016, J. Acoust. Soc. Am. 139,
///         doi:10.1121/1.4944644), ice is taken alike; sea bed -27 dB, Mackenzie 1961, J. Acoust. Soc. Am. 33; volume
///         -70 dB, Urick 1983, section 8.5.
///         Chosen for want of a source: a ping a second, four times as long as the echo from 200 m takes; a pulse that
///         resolves half a metre, finer than any surface is mapped; blind for twice its length, while the transducer
///         rings; a receiver that adds nothing to the sea's noise; false alarms so seldom that confirmed ones are rarer
///         than one an hour (avoidance::EchoConfirmation), and two returns a beam, the nearest surface and one behind
struct SonarSettings {
  double frequency_khz{260.0};
  double source_level_db{200.0};  // re 1 uPa at 1 m
  double pulse_s{0.0007};         // length, which is the resolution in range
  double interval_s{1.0};         // from ping to ping
  double range_m{200.0};          // listened to
  double blind_m{1.0};            // nearer it cannot hear, while it sends
  int beams{41};                  // of a row
  int rows{5};
  double beam_step_rad{0.0523599};  // between neighbours of a row, 3 degrees
  double row_step_rad{0.2617994};   // between rows, 15 degrees
  double tilt_rad{0.0};             // of the middle row, upwards positive
  BeamPattern beam{0.0523599, 0.2617994};
  double receiver_noise_db{0.0};        // spectrum level of its own noise, re 1 uPa^2/Hz, added to the sea's
  double false_alarms_per_ping{0.02};   // of all beams together: sets the threshold
  int most_returns_per_beam{2};         // the nearest ones
  double ice_strength_db{-20.0};        // of a square metre at right angles (Lambert)
  double sea_bed_strength_db{-27.0};    // the same
  double volume_strength_db{-70.0};     // of a cubic metre of water
  double sound_speed_error_share{0.0};  // of the speed that the sonar reckons ranges with, from the true one
  SoundWater water{};

  /// Empty when valid, otherwise all of them; fields are JSON pointers within the settings.
  [[nodiscard]] core::Violations violations() const;

  friend bool operator==(const SonarSettings&, const SonarSettings&) = default;
};

/// Most beams of all rows together, and most rays that are cast to find what a ping hears.
inline constexpr int most_beams = 240;

}  // namespace floeplan::simulation
