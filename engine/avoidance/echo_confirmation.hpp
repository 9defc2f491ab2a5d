#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/avoidance/echo.hpp"
#include "engine/core/units.hpp"

namespace floeplan::avoidance {

/// Parts surfaces from false alarms: a surface echoes again from the same place, a false alarm does not. An echo counts
/// once three pings out of five in a row had one within the gate.
/// Rate     with `n` false alarms a ping spread evenly over range and bearing, a false surface arises at most at the
///          rate n * 6 * (n * g)^2 for each ping, g the largest share of the sonar's view that one gate covers; at
///          n = 0.5 and a 200 m sonar, 1 ping a second, that is below one in an hour, and most of those close by
/// Memory   fixed; no member allocates. When full the oldest echo gives way
/// Source   M-out-of-N track initiation: Blackman and Popoli 1999, Design and analysis of modern tracking systems,
///          section 6.4
class EchoConfirmation {
 public:
  static constexpr int needed = 3;
  static constexpr std::uint32_t within_pings = 5;

  /// How far the mean of two echoes of one surface may lie off it, in metres on the plane and in depth.
  static constexpr double gate_m = 6.0;

  void begin_ping() { ++ping_; }
  /// The mean of the echoes that confirm each other, this one the last of them, with the depths that all of them can
  /// come from; empty: not yet.
  [[nodiscard]] std::optional<Echo> take(const Echo& echo);

 private:
  struct Waiting {
    Echo mean{};
    int pings{};  // that it was heard in
    std::uint32_t first_ping{};
    std::uint32_t last_ping{};
  };

  [[nodiscard]] bool is_free(const Waiting& waiting) const;

  std::uint32_t ping_{within_pings};  // so that an unused place is always an old one
  std::array<Waiting, 512> waiting_{};
};

}  // namespace floeplan::avoidance
