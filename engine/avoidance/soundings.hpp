#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// A measured depth at a place.
struct Sounding {
  geo::PlanePoint place{};
  double depth_m{};
  double time_s{};

  friend bool operator==(const Sounding&, const Sounding&) = default;
};

/// Depths of the sea bed or of the ice's underside around the vehicle, some 15 m apart.
/// Memory   fixed; when full, the oldest is dropped
class Soundings {
 public:
  static constexpr double apart_m = 15.0;

  /// Adds a sounding. If one is near already, only its time is renewed and, if `renews_depth`, its depth.
  void take(const Sounding& found, bool renews_depth);
  void forget_before(double time_s) {
    forget_if([&](const Sounding& sounding) { return sounding.time_s < time_s; });
  }
  template <class Is>
  void forget_if(const Is& is) {
    for (std::size_t i = size_; i-- > 0;) {
      if (is(list_[i])) list_[i] = list_[--size_];
    }
  }
  [[nodiscard]] std::span<const Sounding> all() const { return {list_.data(), size_}; }

 private:
  std::array<Sounding, 96> list_{};
  std::size_t size_{};
};

}  // namespace floeplan::avoidance
