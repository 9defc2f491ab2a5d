#pragma once

namespace floeplan::simulation {

/// Sensitivity of a beam of a rectangular array, the same for sending and for hearing.
struct BeamPattern {
  double width_rad{};   // between the points of half power, horizontally
  double height_rad{};  // the same vertically
  double side_lobes_db{
      -26.0};  // no direction in front of the array is weaker: imperfect elements fill the zeros of an
               // ideal array; a shaded array's first side lobe

  friend bool operator==(const BeamPattern&, const BeamPattern&) = default;
};

/// One-way power in a direction, 1 on the axis: the product of two line arrays' sin(x) / x squared.
/// Arguments  sines of the angles from the axis, in the plane of the width and in that of the height
/// Source     Urick 1983, Principles of underwater sound, 3rd ed., section 3.9: beam pattern of a continuous line
[[nodiscard]] double beam_power(const BeamPattern& pattern, double across, double up);

/// Solid angle of an ideal beam with the same volume reverberation, steradian: the two-way pattern's integral.
/// Accuracy 3 % for beams of up to 40 degrees, by numerical integration in the tests
/// Source   Urick 1983, table 8.1, rectangular array: product of the two widths' equivalents
[[nodiscard]] double reverberation_angle_sr(const BeamPattern& pattern);

/// Directivity index, dB: how much of noise from all directions alike the beam leaves out.
[[nodiscard]] double directivity_db(const BeamPattern& pattern);

}  // namespace floeplan::simulation
