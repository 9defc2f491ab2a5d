#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/avoidance/echo_confirmation.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/tracked_object.hpp"

namespace floeplan::avoidance {

/// The objects that the sonar has detected: confirmed echoes near to each other form one object, which is
/// tracked over time.
/// Frame    water
/// Memory   fixed; no member allocates. When full, the object not seen for the longest time is dropped
class ObjectMap {
 public:
  static constexpr std::size_t most_objects = 24;

  explicit ObjectMap(const AvoidanceSettings& settings) : settings_{settings} {}

  /// Moves every object to the time `now_s`, and drops objects not seen for too long.
  void advance(double now_s);
  /// Takes the echoes of one ping. Precondition: `advance` was called for the ping's time.
  void take(std::span<const Echo> ping, const OwnState& own, geo::PlanePoint own_in_water);

  /// Takes an echo of the sea bed. An object just above the echo stands on the bed, so the vehicle cannot
  /// pass below the object.
  void stand_on(const Echo& bed);
  /// Adds a patch of an object's surface from an echo that is already confirmed. Precondition: `advance` was
  /// called for the echo's time.
  void add(const Echo& confirmed, geo::PlanePoint vehicle);
  /// Removes the object with index `i`; the last object gets this index.
  void remove(std::size_t i);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const TrackedObject& operator[](std::size_t i) const { return objects_[i]; }

 private:
  void look_past(const OwnState& own, geo::PlanePoint own_in_water);

  AvoidanceSettings settings_;
  EchoConfirmation confirmation_;
  std::array<TrackedObject, most_objects> objects_{};
  std::size_t size_{};
  std::uint32_t next_id_{1};
  std::size_t pings_{};
  double now_s_{};
};

}  // namespace floeplan::avoidance
