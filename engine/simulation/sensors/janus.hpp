#pragma once

#include <array>
#include <optional>

#include "engine/simulation/sensors/adcp_settings.hpp"
#include "engine/simulation/vehicle/true_state.hpp"

namespace floeplan::simulation {

inline constexpr std::size_t janus_beams = 4;

/// Directions of the four beams, forward, aft, starboard and port, in the frame of the flight.
using JanusBeams = std::array<Vector, janus_beams>;
[[nodiscard]] JanusBeams janus_beams_of(const AdcpSettings& settings, const Attitude& attitude);

/// Range along a beam to the middle of a cell.
[[nodiscard]] double cell_range_m(const AdcpSettings& settings, double cell);

/// How the velocity at one depth below the vehicle follows from the beams. Each beam that reaches that depth
/// is interpolated there between two of its cells (bin mapping). The velocity fits the beams by least
/// squares; exact for three beams.
struct BinMapping {
  struct Reading {
    bool used{};
    int cell{};         // interpolated between this cell and the next
    double fraction{};  // weight of the next cell
    double weight_east{};
    double weight_north{};
    double weight_down{};
  };
  std::array<Reading, janus_beams> beams{};
};

/// The mapping of one bin; empty if fewer than three beams reach it or have an echo there.
/// `column_m`  height of the vehicle above the sea bed: beyond it, along any beam, the bed's echo in the side
/// lobes hides that of the water
[[nodiscard]] std::optional<BinMapping> map_bin(const AdcpSettings& settings, const JanusBeams& beams,
                                                double below_m, double column_m);

/// Depth of the middle of a bin below the vehicle.
[[nodiscard]] double bin_below_m(const AdcpSettings& settings, int bin);

}  // namespace floeplan::simulation
