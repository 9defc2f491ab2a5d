#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>

namespace floeplan::support {

/// Calls `law(rng)` once for each of the seeds 1 to `count`; a failure prints the seed, and the first one
/// ends the loop. `law` may use both EXPECT_ and ASSERT_ macros.
template <class Law>
void for_each_seed(std::uint64_t count, const Law& law) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(seed)};
    std::mt19937_64 rng{seed};

    law(rng);

    if (testing::Test::HasFailure()) return;
  }
}

/// Uniform in [low, high).
inline double uniform(std::mt19937_64& rng, double low, double high) {
  return std::uniform_real_distribution<double>{low, high}(rng);
}

/// Uniform in low..high, both included.
inline int uniform_int(std::mt19937_64& rng, int low, int high) {
  return std::uniform_int_distribution<int>{low, high}(rng);
}

}  // namespace floeplan::support
