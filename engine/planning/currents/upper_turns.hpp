#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/planning/ice/under_ice.hpp"

namespace floeplan::planning::currents {

/// The upper turns that dives need below ice at some places, at a series of times. Rounded to whole metres,
/// so that small changes of the ice make no difference.
/// Threads  const members may be called from several threads at once
class UpperTurns {
 public:
  /// No ice anywhere.
  UpperTurns() = default;
  /// Once `stop` is requested the object stays incomplete and must not be used.
  UpperTurns(const ice::UnderIce& ice, const std::vector<geo::PlanePoint>& places,
             const std::vector<core::Seconds>& times, const std::stop_token& stop);

  /// Zero if the vehicle may surface or the ice is unknown. `time` and `place` are indices.
  [[nodiscard]] core::Metres at(std::size_t time, std::size_t place) const {
    return core::Metres{metres_.empty() ? 0.0 : static_cast<double>(metres_[time * places_ + place])};
  }
  /// Whether a place lies below ice at some time.
  [[nodiscard]] bool ever_below(std::size_t place) const {
    return !ever_below_.empty() && ever_below_[place];
  }

 private:
  std::size_t places_{};
  std::vector<std::uint16_t> metres_;  // [time][place]; empty: zero everywhere
  std::vector<bool> ever_below_;       // [place]
};

}  // namespace floeplan::planning::currents
