#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace floeplan::core {

/// The random generator for one named source of chance in a run. Each source has its own stream, so a source
/// that draws more or fewer numbers does not change the others.
/// Source   the name's 64 bits by FNV-1a (Fowler, Noll, Vo; RFC 9923), mixed with the seed by SplitMix64
///          (Steele, Lea and Flood 2014, Fast splittable pseudorandom number generators, OOPSLA)
[[nodiscard]] std::mt19937_64 random_stream(std::uint64_t seed, std::string_view name);

/// Seed of the run with number `index` in a batch that has this seed.
[[nodiscard]] std::uint64_t seed_of_run(std::uint64_t seed, std::uint64_t index);

/// Uniform in [0, 1), a multiple of 2^-53. Unlike distributions of <random> it gives the same values with
/// every library.
[[nodiscard]] inline double uniform(std::mt19937_64& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

/// Standard normal deviate.
/// Source   Marsaglia and Bray 1964, A convenient method for generating normal variables, SIAM Review 6
[[nodiscard]] double normal(std::mt19937_64& rng);

/// Poisson deviate: number of events if `mean` of them are expected. `mean` from 0 to 100.
/// Source   Knuth 1997, The Art of Computer Programming, volume 2, section 3.4.1: product of uniform deviates
[[nodiscard]] int poisson(std::mt19937_64& rng, double mean);

}  // namespace floeplan::core
