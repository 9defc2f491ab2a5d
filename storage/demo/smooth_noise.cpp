#include "storage/demo/smooth_noise.hpp"

#include <cmath>

namespace floeplan::demo {
namespace {

/// Source   Steele, Lea, Flood 2014, Fast splittable pseudorandom number generators (finaliser of SplitMix64)
std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31);
}

double lattice_value(std::uint64_t seed, std::int64_t i, std::int64_t j) {
  const std::uint64_t bits =
      mixed(mixed(seed + static_cast<std::uint64_t>(i)) + static_cast<std::uint64_t>(j));
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

double blend(double from, double to, double share) {
  return from + (to - from) * share * share * share * (share * (6.0 * share - 15.0) + 10.0);
}

double one_octave(std::uint64_t seed, double x, double y) {
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto left = static_cast<std::int64_t>(i);
  const auto low = static_cast<std::int64_t>(j);
  const double lower = blend(lattice_value(seed, left, low), lattice_value(seed, left + 1, low), x - i);
  const double upper =
      blend(lattice_value(seed, left, low + 1), lattice_value(seed, left + 1, low + 1), x - i);
  return blend(lower, upper, y - j);
}

}  // namespace

double SmoothNoise::at(double x, double y) const {
  double sum = 0.0;
  double total = 0.0;
  double amplitude = 1.0;
  for (int octave = 0; octave < octaves_; ++octave) {
    const double frequency = std::ldexp(1.0, octave);
    // Each octave is rotated, so that the lattices do not line up.
    const double turned_x = (0.8 * x - 0.6 * y) * frequency;
    const double turned_y = (0.6 * x + 0.8 * y) * frequency;
    sum += amplitude * one_octave(seed_ + static_cast<std::uint64_t>(octave) * 7919U, turned_x, turned_y);
    total += amplitude;
    amplitude *= 0.5;
  }
  return sum / total;
}

}  // namespace floeplan::demo
