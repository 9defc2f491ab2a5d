#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/avoidance/echo.hpp"
#include "engine/avoidance/echo_confirmation.hpp"
#include "engine/avoidance/object_map.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/soundings.hpp"

namespace floeplan::avoidance {

/// The depths left to the saw-tooth between ice above and the sea bed below, and which echoes the vehicle need not go
/// round because it passes above or below what they come from.
/// Sonar    an echo counts as from the axis of its beam. A cover that beams 20 degrees high meet at a shallow angle looks as
///          if it reached down to the axis, and is gone round like a wall until it is overhead
/// Frame    water
/// Memory   fixed; no member allocates
class VerticalRoom {
 public:
  explicit VerticalRoom(const AvoidanceSettings& settings) : settings_{settings} {}

  /// Takes up the vehicle's place, and what the altimeter has found below it.
  void sound(const OwnState& own, geo::PlanePoint own_in_water);
  void begin_ping();
  /// Whether the echo is none to go round:
  /// - from below the saw-tooth;
  /// - from a sea bed that a lower saw-tooth passes over. A bed is told from a wall by the altimeter's soundings: it
  ///   rises by no more than 1 in 5 from the nearest;
  /// - from the underside of a cover of ice that a deeper saw-tooth passes under, told from a wall in the same way. Its
  ///   first soundings are echoes from steeply above, and covers recognised from afar.
  /// A bed or a cover that leaves no room is a thing to go round. One that does limits the depth from now on,
  /// once its echoes have confirmed each other.
  [[nodiscard]] bool passes(const Echo& echo);
  /// Recognises covers of ice among the objects and takes them out. A cover is as wide as the greatest bergs at least,
  /// the sonar has looked below its keel for long enough, a saw-tooth has room under it, and the vehicle gets below it
  /// in time.
  void take_covers(ObjectMap& objects);

  /// Where to inflect at the latest, climbing and diving; empty: as the mission says.
  [[nodiscard]] std::optional<core::Metres> shallowest() const;
  [[nodiscard]] std::optional<core::Metres> deepest() const;

 private:
  [[nodiscard]] bool has_room_under(double ice_m) const;
  [[nodiscard]] bool has_room_over(double bed_m) const;
  [[nodiscard]] bool is_bed(const Echo& echo);
  [[nodiscard]] bool is_roof(const Echo& echo);
  [[nodiscard]] bool is_cover(const TrackedObject& object) const;

  AvoidanceSettings settings_;
  double now_s_{};
  double depth_m_{};
  geo::PlanePoint place_{};
  Soundings bed_{};
  Soundings roof_{};
  EchoConfirmation bed_confirmation_{};
  EchoConfirmation roof_confirmation_{};
  std::optional<Sounding> shallowest_bed_{};  // that an echo showed lately
};

}  // namespace floeplan::avoidance
