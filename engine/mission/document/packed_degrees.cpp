#include "engine/mission/document/packed_degrees.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace floeplan::mission {
namespace {

constexpr long long units_per_minute = 10'000;  // four decimals
constexpr long long units_per_degree = 60 * units_per_minute;
constexpr double most_packed_lon = 18'000.0;

}  // namespace

std::string packed_degrees(double angle_deg) {
  if (!(std::abs(angle_deg) <= 180.0))
    throw std::invalid_argument{"packed_degrees: angle beyond 180 degrees"};

  // Rounded once, to whole units. After that, integer arithmetic carries from minutes to degrees.
  const long long units = std::llround(std::abs(angle_deg) * static_cast<double>(units_per_degree));
  const long long degrees = units / units_per_degree;
  const long long minute_units = units % units_per_degree;
  const bool negative = angle_deg < 0.0 && units > 0 && units < 180 * units_per_degree;

  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%s%04lld.%04lld", negative ? "-" : "",
                degrees * 100 + minute_units / units_per_minute, minute_units % units_per_minute);
  return text.data();
}

UnpackedAngle unpack_degrees(double packed) {
  const double size = std::abs(packed);
  const double degrees = std::floor(size / 100.0);
  const double minutes = size - 100.0 * degrees;
  return {std::copysign(degrees + minutes / 60.0, packed), minutes >= 60.0};
}

std::optional<geo::LonLat> unpack_place(double packed_lon, double packed_lat) {
  const geo::LonLat place{unpack_degrees(packed_lon).degrees, unpack_degrees(packed_lat).degrees};
  const bool is_place = std::abs(packed_lon) <= most_packed_lon && geo::is_valid(place);
  return is_place ? std::optional{place} : std::nullopt;
}

}  // namespace floeplan::mission
