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

/// What the dives of a way are taken from that is metered: the sea bed itself, or its map for searches; see
/// `EnergyMap`.
enum class Dives : std::uint8_t { over_bed, over_map };

/// Adds up what a drive along an edge draws: the power at each place over the time spent there, for currents make a
/// vehicle slow over one bank and fast over the next deep. Looks at each piece of the drive in turn.
/// Accuracy  where the vehicle is to a five-hundredth of the cells of the bathymetry or the map; what is above it is
///           looked at every `look()` of the overhead, at most 4,096 times a piece
class EnergyMeter {
 public:
  /// `energy`, `overhead` and `edge` are borrowed.
  EnergyMeter(const energy::EnergyMap& energy, const Overhead& overhead, const motion::PlaneEdge& edge,
              core::Seconds depart, vehicle::Drive drive, Dives dives);

  /// The next piece of the drive.
  void add(const motion::EdgePiece& piece);
  /// All that is drawn until then: what the pieces leave of the way is travelled evenly in what they leave of the time.
  [[nodiscard]] EnergyUse until(core::Seconds end) const;

 private:
  [[nodiscard]] EnergyUse use(const motion::EvenMove& move) const;
  /// Where no dive turns above `upper_turn`.
  [[nodiscard]] EnergyUse use(const motion::EvenMove& move, core::Metres upper_turn) const;
  /// Of a place on the edge, as a share of its length.
  [[nodiscard]] double share(geo::PlanePoint place) const;

  const energy::EnergyMap& energy_;
  const Overhead& overhead_;
  const motion::PlaneEdge& edge_;
  double length_m_;  // in the plane
  vehicle::Drive drive_;
  bool looks_up_;                          // something may be above the edge
  std::optional<energy::DiveLine> dives_;  // empty: by the map
  bool is_even_;  // every place on the edge costs the same: how the time is spread makes no difference
  double most_deviation_m_;
  geo::PlanePoint here_;
  double now_s_;
  EnergyUse drawn_;
};

}  // namespace floeplan::planning::cost
