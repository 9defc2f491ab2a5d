#pragma once

#include <optional>

#include "engine/motion/disc_encounter.hpp"
#include "engine/motion/edge_piece.hpp"
#include "engine/motion/plane_edge.hpp"
#include "engine/planning/cost/overhead.hpp"
#include "engine/planning/energy/dive_line.hpp"
#include "engine/planning/energy/energy_map.hpp"
#include "engine/planning/problem/energy_use.hpp"

namespace floeplan::planning::cost {

/// Source of the water depth for the dives: the sea bed itself, or the coarser map that searches use; see
/// `EnergyMap`.
enum class Dives : std::uint8_t { over_bed, over_map };

/// Adds up the energy of a drive along an edge: the power at each place times the time spent there. A current
/// can slow the vehicle over a bank and speed it up over deep water, so the time at each place matters. `add`
/// takes the pieces of the drive in order.
/// Accuracy  the position of the vehicle is known to 1/500 of a cell of the bathymetry or map. Ice above the
///           vehicle is checked every `Overhead::look()` metres, at most 4,096 times per piece
class EnergyMeter {
 public:
  /// `energy`, `overhead` and `edge` are borrowed.
  EnergyMeter(const energy::EnergyMap& energy, const Overhead& overhead, const motion::PlaneEdge& edge,
              core::Seconds depart, vehicle::Drive drive, Dives dives);

  /// Adds the next piece of the drive.
  void add(const motion::EdgePiece& piece);
  /// The energy from the departure until `end`. Any rest of the edge without a piece is travelled at constant
  /// speed until `end`.
  [[nodiscard]] EnergyUse until(core::Seconds end) const;

 private:
  [[nodiscard]] EnergyUse use(const motion::EvenMove& move) const;
  /// Energy of a move at constant speed whose dives turn no higher than `upper_turn`.
  [[nodiscard]] EnergyUse use(const motion::EvenMove& move, core::Metres upper_turn) const;
  /// Position of a place on the edge as a share of its length.
  [[nodiscard]] double share(geo::PlanePoint place) const;

  const energy::EnergyMap& energy_;
  const Overhead& overhead_;
  const motion::PlaneEdge& edge_;
  double length_m_;  // in the plane
  vehicle::Drive drive_;
  bool looks_up_;                          // ice or icebergs may be above the edge
  std::optional<energy::DiveLine> dives_;  // empty: depths come from the map
  bool is_even_;                           // power is constant along the edge, so only the total time matters
  double most_deviation_m_;
  geo::PlanePoint here_;
  double now_s_;
  EnergyUse drawn_;
};

}  // namespace floeplan::planning::cost
