#pragma once

#include <cstdint>

namespace floeplan::demo {

/// Smooth, isotropic noise of a plane, from -1 to 1 with mean about 0: random values on a lattice of unit
/// spacing, smoothly interpolated, plus finer lattices of half the amplitude each. The same seed gives the
/// same values on every machine.
class SmoothNoise {
 public:
  SmoothNoise(std::uint64_t seed, int octaves) : seed_{seed}, octaves_{octaves} {}

  [[nodiscard]] double at(double x, double y) const;

 private:
  std::uint64_t seed_;
  int octaves_;
};

}  // namespace floeplan::demo
