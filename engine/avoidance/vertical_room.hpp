#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "engine/avoidance/echo.hpp"
#include "engine/avoidance/echo_confirmation.hpp"
#include "engine/avoidance/object_map.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/soundings.hpp"

namespace floeplan::avoidance {

/// The depths left for the saw-tooth between the ice and the sea bed, and which echoes need no evasion
/// because the vehicle passes above or below their source.
/// Sonar    an echo may come from anywhere within the height of its beam. If the sea bed or the underside of
///          ice is known nearby and lies within that height, the echo counts as theirs
/// Shoals   if the altimeter finds the bed rising towards less than the least water, the edge of the shoal
///          becomes an obstacle; no other sensor detects a bed close below
/// Frame    water
/// Memory   fixed; no member allocates
class VerticalRoom {
 public:
  /// Places in a row across the vehicle's course, as patches of a surface.
  using ShoalEdge = std::array<Echo, 5>;

  /// How the vehicle passes the source of an echo without going round it.
  enum class Pass : std::uint8_t { no, above, below };

  explicit VerticalRoom(const AvoidanceSettings& settings) : settings_{settings} {}

  /// Takes the vehicle's place, and the altimeter's echo or its absence.
  void sound(const OwnState& own, geo::PlanePoint own_in_water);
  /// Begins a ping with these echoes, which are borrowed until the next ping. Precondition: `sound` was
  /// called for this step.
  void begin_ping(std::span<const Echo> ping);
  /// Whether the vehicle passes the source of the echo without going round it. It does so:
  /// - if the echo comes from below the saw-tooth;
  /// - if it comes from a sea bed over which a shallower saw-tooth passes, and the vehicle can change to that
  ///   saw-tooth in time. A bed rises by at most 1 in 5 from the nearest sounding (of the altimeter, or an echo
  ///   from steeply below); a wall rises more steeply;
  /// - if it comes from the underside of an ice cover under which a deeper saw-tooth passes. A cover is told from
  ///   a wall in the same way. Its first soundings are echoes from steeply above with nothing below them, and
  ///   covers recognised from afar.
  /// A bed or cover that leaves no room must be gone round. One that does limits the depth from then on, once
  /// its echoes have confirmed each other.
  [[nodiscard]] Pass passes(const Echo& echo);
  /// Recognises ice covers among the objects and removes them from the map. A cover is at least as wide as
  /// the largest bergs; the sonar has looked below its keel for long enough and seen no bed below it; a
  /// saw-tooth has room under it; and the vehicle gets below it in time.
  void take_covers(ObjectMap& objects);

  /// Removes objects that turn out to be a sea bed that the vehicle passes over. Some are parts of a known bed
  /// that were seen before the first sounding. Others are steep rises whose top lies below the vehicle: the
  /// sonar has looked over them for long enough.
  void take_beds(ObjectMap& objects);

  /// The edge of a shoal ahead, if the altimeter has just found one.
  [[nodiscard]] std::optional<ShoalEdge> take_shoal() { return std::exchange(shoal_, std::nullopt); }

  /// Limits of the depth, for climbs and dives; empty: as in the mission. If ice and bed leave less than the
  /// least band, or seem to, that band half-way between them.
  [[nodiscard]] std::optional<core::Metres> shallowest() const { return band().top; }
  [[nodiscard]] std::optional<core::Metres> deepest() const { return band().bottom; }

 private:
  [[nodiscard]] bool has_room_under(double ice_m) const;
  [[nodiscard]] bool has_room_over(double bed_m) const;
  struct Band {
    std::optional<core::Metres> top;
    std::optional<core::Metres> bottom;
  };

  [[nodiscard]] Band band() const;
  [[nodiscard]] std::optional<core::Metres> below_ice() const;
  [[nodiscard]] std::optional<core::Metres> above_bed() const;
  void read_altimeter(const OwnState& own);
  void look_for_shoal(const Sounding& below);
  [[nodiscard]] bool is_passed_above(geo::PlanePoint place, double bed_m) const;
  void unlearn_bed();
  [[nodiscard]] bool is_known_bed(geo::PlanePoint place, double depth_m) const;
  [[nodiscard]] bool is_bed_throughout(const TrackedObject& object) const;
  [[nodiscard]] bool ends_below(const TrackedObject& object) const;
  void limit_by(const Sounding& bed);
  [[nodiscard]] bool is_bed(const Echo& echo);
  [[nodiscard]] bool is_roof(const Echo& echo);
  [[nodiscard]] bool is_overhead(const Echo& echo) const;
  [[nodiscard]] bool is_cover(const TrackedObject& object) const;

  AvoidanceSettings settings_;
  double now_s_{};
  double depth_m_{};
  geo::PlanePoint place_{};
  Soundings bed_{};
  Soundings roof_{};
  EchoConfirmation bed_confirmation_{};
  EchoConfirmation underfoot_confirmation_{};
  EchoConfirmation roof_confirmation_{};
  std::span<const Echo> ping_{};
  std::optional<Sounding> shallowest_bed_{};  // shown by a recent echo
  std::optional<Sounding> sounded_{};         // by the altimeter, some distance back
  std::optional<ShoalEdge> shoal_{};
  double before_s_{};                      // time of the step before
  double silent_s_{};                      // time without an altimeter echo while diving
  std::optional<double> beds_sought_s_{};  // time of the last search among the objects
};

}  // namespace floeplan::avoidance
