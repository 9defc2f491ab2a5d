#pragma once

namespace floeplan::simulation {

/// Sensitivity of a beam of a rectangular array, the same for sending and for hearing. The array is shaded, as sonars
/// are that must not hear the bed below in a beam that looks ahead: outside its main lobe it hears evenly and little.
struct BeamPattern {
  double width_rad{};   // between the points of half power, horizontally
  double height_rad{};  // the same vertically
  double side_lobes_db{
      -26.0};  // of every direction outside the main lobe, and none is weaker: imperfect elements fill the zeros
               // of an ideal array; a shaded array's first side lobe

  friend bool operator==(const BeamPattern&, const BeamPattern&) = default;
};

/// One-way power in a direction, 1 on the axis: the product of two line arrays' sin(x) / x squared up to its first
/// zero.
/// Arguments  sines of the angles from the axis, in the plane of the width and in that of the height
/// Source     Urick 1983, Principles of underwater sound, 3rd ed., section 3.9: beam pattern of a continuous line, and
///            3.10: shading, which trades its side lobes for a few tenths of width
[[nodiscard]] double beam_power(const BeamPattern& pattern, double across, double up);

/// Angle from the axis to the first zero, where the main lobe ends.
[[nodiscard]] double main_lobe_half_width_rad(double width_rad);

/// Solid angle of an ideal beam with the same volume reverberation, steradian: the two-way pattern's integral.
/// Accuracy 3 % for beams of up to 40 degrees, by numerical integration in the tests
/// Source   Urick 1983, table 8.1, rectangular array: product of the two widths' equivalents
[[nodiscard]] double reverberation_angle_sr(const BeamPattern& pattern);

/// Directivity index, dB: how much of noise from all directions alike the beam leaves out.
[[nodiscard]] double directivity_db(const BeamPattern& pattern);

}  // namespace floeplan::simulation
