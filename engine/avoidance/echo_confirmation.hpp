#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/avoidance/echo.hpp"
#include "engine/core/units.hpp"

namespace floeplan::avoidance {

/// Separates surfaces from false alarms: a surface gives echoes from the same place again, a false alarm does
/// not. An echo is confirmed when three of five consecutive pings had one within the gate.
/// Rate     With `n` false alarms per ping, spread evenly over range and bearing, false surfaces arise at a
///          rate of at most n * 6 * (n * g)^2 per ping, where g is the largest share of the sonar's view that
///          one gate covers. For n = 0.5 and a 200 m sonar with 1 ping per second this is below one per hour,
///          and most of those are close by
/// Memory   fixed; no member allocates. When full, the oldest echo is dropped
/// Source   M-out-of-N track initiation: Blackman and Popoli 1999, Design and analysis of modern tracking
///          systems, section 6.4
class EchoConfirmation {
 public:
  static constexpr int needed = 3;
  static constexpr std::uint32_t within_pings = 5;

  /// Two echoes of one surface may lie this far from each other, in metres in the plane and in depth.
  static constexpr double gate_m = 6.0;

  void begin_ping() { ++ping_; }
  /// The mean of the echoes that confirm each other, including this one, with the depths that all of them can
  /// come from; empty: not confirmed yet.
  [[nodiscard]] std::optional<Echo> take(const Echo& echo);

 private:
  struct Waiting {
    Echo mean{};
    int pings{};  // number of pings with this echo
    std::uint32_t first_ping{};
    std::uint32_t last_ping{};
  };

  [[nodiscard]] bool is_free(const Waiting& waiting) const;

  std::uint32_t ping_{within_pings};  // starts above zero, so that an unused entry counts as old
  std::array<Waiting, 512> waiting_{};
};

}  // namespace floeplan::avoidance
