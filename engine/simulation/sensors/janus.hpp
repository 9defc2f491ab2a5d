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

/// How the velocity at one height below the vehicle comes from the beams: each that reaches it is read there between
/// two of its cells (bin mapping), and the velocity fits them best (least squares; exact for three beams).
struct BinMapping {
  struct Reading {
    bool used{};
    int cell{};         // and the next one
    double fraction{};  // of the next one
    double weight_east{};
    double weight_north{};
    double weight_down{};
  };
  std::array<Reading, janus_beams> beams{};
};

/// Empty where fewer than three beams reach, or nothing is there to be heard.
/// `column_m`  height of the vehicle above the sea bed: farther along any beam the echo of the bed in the side lobes
///             covers the water's
[[nodiscard]] std::optional<BinMapping> map_bin(const AdcpSettings& settings, const JanusBeams& beams,
                                                double below_m, double column_m);

/// Height of the middle of a bin below the vehicle.
[[nodiscard]] double bin_below_m(const AdcpSettings& settings, int bin);

}  // namespace floeplan::simulation
