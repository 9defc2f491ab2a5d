#include "engine/core/random.hpp"

#include <cmath>

namespace floeplan::core {
namespace {

std::uint64_t mixed(std::uint64_t value) {
  value += 0x9E3779B97F4A7C15U;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
  return value ^ (value >> 31);
}

std::uint64_t hashed(std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char letter : name) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 0x100000001B3U;
  }
  return hash;
}

}  // namespace

std::mt19937_64 random_stream(std::uint64_t seed, std::string_view name) {
  return std::mt19937_64{mixed(mixed(seed) ^ hashed(name))};
}

std::uint64_t seed_of_run(std::uint64_t seed, std::uint64_t index) { return mixed(mixed(seed) + index); }

double normal(std::mt19937_64& rng) {
  for (;;) {
    const double x = 2.0 * uniform(rng) - 1.0;
    const double y = 2.0 * uniform(rng) - 1.0;
    const double s = x * x + y * y;
    if (s > 0.0 && s < 1.0) return x * std::sqrt(-2.0 * std::log(s) / s);
  }
}

int poisson(std::mt19937_64& rng, double mean) {
  const double enough = std::exp(-mean);
  int events = 0;
  for (double product = uniform(rng); product > enough; product *= uniform(rng)) ++events;
  return events;
}

}  // namespace floeplan::core
