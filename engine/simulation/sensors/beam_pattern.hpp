#pragma once

namespace floeplan::simulation {

/// Sensitivity of a beam of a rectangular array, equal for transmission and reception. The array is shaded,
/// as in sonars whose forward beams must not hear the bed below: outside the main lobe its sensitivity is low
/// and constant.
struct BeamPattern {
  double width_rad{};   // horizontal full width at half power
  double height_rad{};  // vertical full width at half power
  double side_lobes_db{
      -26.0};  // level outside the main lobe, the same in all directions: imperfect elements fill the zeros
               // of an ideal array; value of a shaded array's first side lobe

  friend bool operator==(const BeamPattern&, const BeamPattern&) = default;
};

/// One-way power in a direction, 1 on the axis: the product of sin(x) / x squared of two line arrays, up to
/// the first zero.
/// Arguments  sines of the angles from the axis, in the plane of the width and in that of the height
/// Source     Urick 1983, Principles of underwater sound, 3rd ed., section 3.9: beam pattern of a continuous
///            line, and 3.10: shading, which lowers the side lobes and widens the beam by a few tenths
[[nodiscard]] double beam_power(const BeamPattern& pattern, double across, double up);

/// Angle from the axis to the first zero, the end of the main lobe.
[[nodiscard]] double main_lobe_half_width_rad(double width_rad);

/// Solid angle, in steradian, of an ideal beam with the same volume reverberation: the integral of the
/// two-way pattern.
/// Accuracy 3 % for beams of up to 40 degrees, by numerical integration in the tests
/// Source   Urick 1983, table 8.1, rectangular array: product of the equivalents of both widths
[[nodiscard]] double reverberation_angle_sr(const BeamPattern& pattern);

/// Directivity index in dB: by how much the beam reduces isotropic noise.
[[nodiscard]] double directivity_db(const BeamPattern& pattern);

}  // namespace floeplan::simulation
