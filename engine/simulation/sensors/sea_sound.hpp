#pragma once

namespace floeplan::simulation {

/// The water that sound goes through; the defaults are those of Arctic surface water in winter.
struct SoundWater {
  double temperature_deg_c{-1.0};
  double salinity_g_kg{33.0};
  double ph{8.0};
  double depth_m{100.0};
  double speed_m_s{1443.0};  // of sound in it, Mackenzie 1981, Nine-term equation, J. Acoust. Soc. Am. 70
  double wind_m_s{5.0};      // over open water; makes noise and roughens the surface

  friend bool operator==(const SoundWater&, const SoundWater&) = default;
};

/// What the water takes from sound on its way, dB for each metre.
/// Precondition frequency between 1 kHz and 1 MHz
/// Accuracy     within 10 % of Francois and Garrison 1982 for all natural waters, says its source
/// Source       Ainslie and McColm 1998, A simplified formula for viscous and chemical absorption in sea water, J.
///              Acoust. Soc. Am. 103, doi:10.1121/1.421258, equations 1 to 5
[[nodiscard]] double absorption_db_m(double frequency_khz, const SoundWater& water);

/// Noise of the sea, spectrum level in dB re 1 uPa^2/Hz: wind on open water and the thermal motion of the water.
/// Source   Coates 1990, Underwater acoustic systems, as quoted by Stojanovic 2007, On the relationship between
///          capacity and distance in an underwater acoustic channel, Mob. Comput. Commun. Rev. 11, section 2.2
///          (formulas after Wenz 1962)
[[nodiscard]] double noise_spectrum_db(double frequency_khz, double wind_m_s);

/// Power that the sea surface sends back from each square metre into the direction that it came from, as a share of
/// the intensity that reaches it, by the angle at which sound grazes it.
/// Source   Chapman and Harris 1962, Surface backscattering strengths measured with explosive sound sources, J.
///          Acoust. Soc. Am. 34, doi:10.1121/1.1909057
/// Differences the fit is of 0.4 to 6.4 kHz; above, where nearly constant strengths are measured, it is taken at 6.4
/// kHz,
///          and it never exceeds the share of a Lambert surface that sends back everything, sin^2 / pi
[[nodiscard]] double surface_backscatter(double sine_of_grazing, double frequency_khz, double wind_m_s);

}  // namespace floeplan::simulation
