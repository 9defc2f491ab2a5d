#pragma once

namespace floeplan::simulation {

/// The water that sound travels through. Defaults: Arctic surface water in winter.
struct SoundWater {
  double temperature_deg_c{-1.0};
  double salinity_g_kg{33.0};
  double ph{8.0};
  double depth_m{100.0};
  double speed_m_s{1443.0};  // of sound in it, Mackenzie 1981, Nine-term equation, J. Acoust. Soc. Am. 70
  double wind_m_s{5.0};      // over open water; causes noise and roughens the surface

  friend bool operator==(const SoundWater&, const SoundWater&) = default;
};

/// Absorption of sound by the water in dB per metre.
/// Precondition frequency between 1 kHz and 1 MHz
/// Accuracy     within 10 % of Francois and Garrison 1982 for all natural waters, by its source
/// Source       Ainslie and McColm 1998, A simplified formula for viscous and chemical absorption in sea
///              water, J. Acoust. Soc. Am. 103, doi:10.1121/1.421258, equations 1 to 5
[[nodiscard]] double absorption_db_m(double frequency_khz, const SoundWater& water);

/// Noise of the sea as a spectrum level in dB re 1 uPa^2/Hz: wind on open water and thermal motion of the
/// water.
/// Source   Coates 1990, Underwater acoustic systems, as quoted by Stojanovic 2007, On the relationship
///          between capacity and distance in an underwater acoustic channel, Mob. Comput. Commun. Rev. 11,
///          section 2.2 (formulas after Wenz 1962)
[[nodiscard]] double noise_spectrum_db(double frequency_khz, double wind_m_s);

/// Backscattering of the sea surface: power per square metre that returns in the direction of the source, as
/// a share of the incident intensity. It depends on the grazing angle.
/// Source   Chapman and Harris 1962, Surface backscattering strengths measured with explosive sound sources,
///          J. Acoust. Soc. Am. 34, doi:10.1121/1.1909057
/// Differences The fit is for 0.4 to 6.4 kHz. Above, measured strengths are nearly constant, so the value at
/// 6.4 kHz is used. It never exceeds that of a Lambert surface that reflects everything, sin^2 / pi
[[nodiscard]] double surface_backscatter(double sine_of_grazing, double frequency_khz, double wind_m_s);

}  // namespace floeplan::simulation
