#pragma once

#include <chrono>
#include <cmath>
#include <compare>
#include <numbers>

namespace floeplan::core {

/// A double in the SI unit that its alias is named after. Only operators with a right dimension exist.
template <class Tag>
struct Quantity {
  double value{};

  friend constexpr auto operator<=>(Quantity, Quantity) = default;
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return {a.value + b.value}; }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return {a.value - b.value}; }
  friend constexpr Quantity operator-(Quantity a) { return {-a.value}; }
  friend constexpr Quantity operator*(double factor, Quantity a) { return {factor * a.value}; }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value / b.value; }
};

using Metres = Quantity<struct MetresTag>;
using MetresPerSecond = Quantity<struct MetresPerSecondTag>;
using Radians = Quantity<struct RadiansTag>;
using CubicMetres = Quantity<struct CubicMetresTag>;
using Joules = Quantity<struct JoulesTag>;
using Watts = Quantity<struct WattsTag>;

using Seconds = std::chrono::duration<double>;   // a length of time
using UtcTime = std::chrono::sys_time<Seconds>;  // an instant; adding two instants does not compile

constexpr Seconds operator/(Metres distance, MetresPerSecond speed) {
  return Seconds{distance.value / speed.value};
}

constexpr Joules operator*(Watts power, Seconds duration) { return {power.value * duration.count()}; }

constexpr double degrees_to_radians(double angle_deg) { return angle_deg * (std::numbers::pi / 180.0); }
constexpr double radians_to_degrees(double angle_rad) { return angle_rad * (180.0 / std::numbers::pi); }

/// Seconds since 1970-01-01T00:00:00Z, leap seconds not counted (POSIX time).
constexpr double unix_seconds(UtcTime time) { return time.time_since_epoch().count(); }
constexpr UtcTime from_unix_seconds(double seconds) { return UtcTime{Seconds{seconds}}; }

}  // namespace floeplan::core
