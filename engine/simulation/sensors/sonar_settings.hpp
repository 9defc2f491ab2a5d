#pragma once

#include "engine/core/violation.hpp"
#include "engine/simulation/sensors/beam_pattern.hpp"
#include "engine/simulation/sensors/sea_sound.hpp"

namespace floeplan::simulation {

/// A forward-looking sonar of many simultaneous beams: rows of beams side by side, one row above another.
/// Source of the defaults: no sonar of a glider is prescribed. Frequency, source level, widths and listening
/// range are those of small commercial forward-looking sonars of 200 to 450 kHz; five rows reach 30 degrees
/// up and down, so that some look level at the pitch of 26 degrees at which a Slocum dives and climbs.
/// Strengths of the faces: rough rock has -30 to -20 dB (Olson, Lyons and Saebo 2016, J. Acoust. Soc. Am.
/// 139, doi:10.1121/1.4944644), the same is taken for ice; sea bed -27 dB, Mackenzie 1961, J. Acoust. Soc.
/// Am. 33; volume -70 dB, Urick 1983, section 8.5. Chosen without a source: a ping per second, four times the
/// travel time of an echo from 200 m; a pulse that resolves half a metre, finer than any map of a surface; a
/// blind zone of twice the pulse, while the transducer rings; a receiver without noise of its own; so few
/// false alarms that confirmed ones are rarer than one an hour (avoidance::EchoConfirmation); two returns per
/// beam, the nearest surface and one behind
struct SonarSettings {
  double frequency_khz{260.0};
  double source_level_db{200.0};  // re 1 uPa at 1 m
  double pulse_s{0.0007};         // length of the pulse; determines the range resolution
  double interval_s{1.0};         // between pings
  double range_m{200.0};          // maximum range
  double blind_m{1.0};            // minimum range, because it cannot hear while it transmits
  int beams{41};                  // per row
  int rows{5};
  double beam_step_rad{0.0523599};  // between beams of a row, 3 degrees
  double row_step_rad{0.2617994};   // between rows, 15 degrees
  double tilt_rad{0.0};             // of the middle row, positive upwards
  BeamPattern beam{0.0523599, 0.2617994};
  double receiver_noise_db{0.0};        // own noise, spectrum level re 1 uPa^2/Hz, added to the sea's
  double false_alarms_per_ping{0.02};   // over all beams; determines the threshold
  int most_returns_per_beam{2};         // the nearest ones
  double ice_strength_db{-20.0};        // of a square metre, perpendicular (Lambert)
  double sea_bed_strength_db{-27.0};    // of a square metre, perpendicular (Lambert)
  double volume_strength_db{-70.0};     // of a cubic metre of water
  double sound_speed_error_share{0.0};  // error of the sound speed used for ranges, relative
  SoundWater water{};

  /// Empty when valid, otherwise all of them; fields are JSON pointers within the settings.
  [[nodiscard]] core::Violations violations() const;

  friend bool operator==(const SonarSettings&, const SonarSettings&) = default;
};

/// Limits: beams of all rows together, and rays cast for a ping.
inline constexpr int most_beams = 240;

}  // namespace floeplan::simulation
