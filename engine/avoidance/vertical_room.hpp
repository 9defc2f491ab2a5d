#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/avoidance/echo.hpp"
#include "engine/avoidance/object_map.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"

namespace floeplan::avoidance {

/// The depths left to the saw-tooth between ice above and the sea bed below, and which echoes the vehicle need not go
/// round because it passes above or below what they come from.
/// Frame    water
/// Memory   fixed; no member allocates
class VerticalRoom {
 public:
  explicit VerticalRoom(const AvoidanceSettings& settings) : settings_{settings} {}

  /// Remembers what the altimeter has found below the vehicle.
  void sound(const OwnState& own, geo::PlanePoint own_in_water);
  /// Whether the echo is none to go round: from below the saw-tooth, or from a sea bed that a lower saw-tooth passes
  /// over. A sea bed is told from a wall by the altimeter: it rises by no more than 1 in 5 from the nearest sounding.
  /// A bed without room above it is a thing to go round. A bed that is one limits the depth from now on.
  [[nodiscard]] bool passes_over(const Echo& echo, double now_s);
  /// Whether the object is a cover of ice that the vehicle passes under: wider than any berg, the sonar has looked below
  /// its keel for long enough, and a saw-tooth has room under it. Bergs are gone round.
  [[nodiscard]] bool passes_under(const TrackedObject& object) const;

  /// Where to inflect at the latest, climbing and diving; empty: as the mission says.
  [[nodiscard]] std::optional<core::Metres> shallowest(const ObjectMap& objects,
                                                       geo::PlanePoint own_in_water) const;
  [[nodiscard]] std::optional<core::Metres> deepest(double now_s) const;

 private:
  struct Sounding {
    geo::PlanePoint place{};
    double depth_m{};
    double time_s{};
  };

  [[nodiscard]] std::optional<double> bed_near(geo::PlanePoint place, double now_s) const;

  AvoidanceSettings settings_;
  std::array<Sounding, 32> soundings_{};
  std::size_t sounded_{};
  std::size_t next_{};
  Sounding shallowest_bed_{};  // that an echo showed lately
};

}  // namespace floeplan::avoidance
