#include "tests/engine/avoidance/light/random_icebergs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "engine/avoidance/guidance.hpp"

namespace floeplan::avoidance::random_icebergs_test {
namespace {

using support::could_be_saved;
using support::Ending;
using support::Flight;
using support::FlightResult;
using support::random_icebergs;

/// FLOEPLAN_ICEBERG_FIELDS sets the number of fields, usually a few; FLOEPLAN_ICEBERG_SEED sets the first
/// seed, usually 1.
std::uint64_t asked(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}
std::uint64_t fields() { return asked("FLOEPLAN_ICEBERG_FIELDS", 8); }
std::uint64_t first_seed() { return asked("FLOEPLAN_ICEBERG_SEED", 1); }

/// With fewer fields a share has no meaning.
constexpr std::uint64_t telling_fields = 200;

std::string told(std::uint64_t seed, const FlightResult& result) {
  return "seed " + std::to_string(seed) + " after " + std::to_string(result.time_s) + " s at " +
         std::to_string(result.last.east_m) + " " + std::to_string(result.last.north_m) + ", " +
         std::string{text(result.reason)};
}

/// Whether the vehicle would have arrived in the same water without icebergs.
bool arrives_in_empty_sea(Flight flight) {
  flight.sea.bodies.clear();
  flight.avoids = false;
  return support::fly(flight).ending == Ending::arrived;
}

TEST(RandomIcebergs, AreSafeWithTheSystemOn) {
  std::vector<double> ways_m;
  std::uint64_t beyond_help = 0;
  std::uint64_t not_there = 0;
  for (std::uint64_t seed = first_seed(); seed < first_seed() + fields(); ++seed) {
    const Flight flight = random_icebergs(seed);
    const FlightResult result = support::fly(flight);
    switch (result.ending) {
      case Ending::arrived: ways_m.push_back(result.way_m); break;
      case Ending::collided:
        if (could_be_saved(flight, result)) {
          ADD_FAILURE() << "collided: " << told(seed, result);
        } else {
          ++beyond_help;
          std::cout << "beyond help: " << told(seed, result) << "\n";
        }
        break;
      case Ending::too_long:
      case Ending::gave_up:
        ++not_there;
        std::cout << "not there: " << told(seed, result)
                  << (arrives_in_empty_sea(flight) ? ", held up by the bergs"
                                                   : ", nor in an empty sea: the current")
                  << "\n";
    }
  }
  std::cout << fields() << " fields: " << ways_m.size() << " arrived, " << beyond_help << " beyond help, "
            << not_there << " not there\n";

  EXPECT_GE(static_cast<double>(ways_m.size()), 0.95 * static_cast<double>(fields() - beyond_help));
  ASSERT_FALSE(ways_m.empty());
  std::ranges::nth_element(ways_m, ways_m.begin() + static_cast<std::ptrdiff_t>(ways_m.size() / 2));
  const double detour = ways_m[ways_m.size() / 2] / random_icebergs(1).waypoints.back().x_m - 1.0;
  std::cout << "median detour " << 100.0 * detour << " %\n";
  EXPECT_LE(detour, 0.15);
}

TEST(RandomIcebergs, AreDangerousWithoutIt) {
  std::uint64_t collided = 0;
  for (std::uint64_t seed = first_seed(); seed < first_seed() + fields(); ++seed) {
    Flight flight = random_icebergs(seed);
    flight.avoids = false;
    if (support::fly(flight).ending == Ending::collided) ++collided;
  }
  std::cout << "without the system " << collided << " of " << fields() << " collided\n";
  EXPECT_GE(collided, fields() < telling_fields ? 1 : fields() * 15 / 100);
}

}  // namespace
}  // namespace floeplan::avoidance::random_icebergs_test
