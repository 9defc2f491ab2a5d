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

/// The depths left to the saw-tooth between ice above and the sea bed below, and which echoes the vehicle need not go
/// round because it passes above or below what they come from.
/// Sonar    an echo comes from anywhere within the height of its beam. Where the sea bed or the underside of ice is known near by
///          and lies within that height, the echo counts as an echo of it
/// Shoals   where the altimeter finds the bed rising towards less than the least water, the edge of the shoal is a
///          thing to go round; nothing else hears a bed that lies close below
/// Frame    water
/// Memory   fixed; no member allocates
class VerticalRoom {
 public:
  /// Places in a row across the way, as patches of a surface.
  using ShoalEdge = std::array<Echo, 5>;

  /// How the vehicle gets past what an echo comes from, without going round it.
  enum class Pass : std::uint8_t { no, above, below };

  explicit VerticalRoom(const AvoidanceSettings& settings) : settings_{settings} {}

  /// Takes up the vehicle's place, and what the altimeter has found below it, or not found.
  void sound(const OwnState& own, geo::PlanePoint own_in_water);
  /// The echoes of one ping, borrowed until the next. Precondition: `sound` has been told where the vehicle is.
  void begin_ping(std::span<const Echo> ping);
  /// Whether the echo is one to go round. It is not:
  /// - from below the saw-tooth;
  /// - from a sea bed that a lower saw-tooth passes over, and that the vehicle is above by the time it gets there. A
  /// bed is
  ///   told from a wall by soundings, the altimeter's and echoes from steeply below: it rises by no more than 1 in 5
  ///   from the nearest;
  /// - from the underside of a cover of ice that a deeper saw-tooth passes under, told from a wall in the same way. Its
  ///   first soundings are echoes from steeply above that nothing stands below, and covers recognised from afar.
  /// A bed or a cover that leaves no room is a thing to go round. One that does limits the depth from now on,
  /// once its echoes have confirmed each other.
  [[nodiscard]] Pass passes(const Echo& echo);
  /// Recognises covers of ice among the objects and takes them out. A cover is as wide as the greatest bergs at least,
  /// the sonar has looked below its keel for long enough and seen no bed that it stands on, a saw-tooth has room under
  /// it, and the vehicle gets below it in time.
  void take_covers(ObjectMap& objects);

  /// Takes out the objects that turn out to be a bed that is passed over: what the sonar saw of a known bed before
  /// there was a sounding, and what rises steeply but ends below, the sonar having looked over its top for long enough.
  void take_beds(ObjectMap& objects);

  /// The edge of a shoal ahead, when the altimeter has just found one.
  [[nodiscard]] std::optional<ShoalEdge> take_shoal() { return std::exchange(shoal_, std::nullopt); }

  /// Where to inflect at the latest, climbing and diving; empty: as the mission says. Where ice and bed leave less than
  /// the least band, or seem to, that band midway between them.
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
  std::optional<Sounding> shallowest_bed_{};  // that an echo showed lately
  std::optional<Sounding> sounded_{};         // by the altimeter, some way back
  std::optional<ShoalEdge> shoal_{};
  double before_s_{};                      // of the step before
  double silent_s_{};                      // that the altimeter has heard nothing while diving
  std::optional<double> beds_sought_s_{};  // among the objects
};

}  // namespace floeplan::avoidance
