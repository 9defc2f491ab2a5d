#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "storage/demo/stream_function.hpp"

namespace floeplan::demo {

/// The same stretch of the frame's edge with another share of the inflow.
[[nodiscard]] Gate with_inflow(Gate gate, double inflow);

/// A tide that carries volume from gate to gate, of arbitrary scale. It is a stream function of transport,
/// divided by the depth, so the water is fastest where the passage is narrowest and shallowest.
/// Shape    `land` and `bed_m` (depth, positive down) over `frame`
[[nodiscard]] Flow tidal_flow(const RasterFrame& frame, const std::vector<bool>& land,
                              const std::vector<double>& bed_m, const std::vector<Gate>& gates);

/// Scales a flow so that only the share `exempt` of the nodes at sea exceeds `speed_m_s`, and reduces the
/// speed at those nodes to little more.
void scale_to_speed(Flow& flow, double speed_m_s, double exempt);

/// Strength of a semidiurnal tide, from -1 to 1, a time after its maximum: M2 with a quarter as much S2, both
/// highest at time zero. The tide turns about every 6.2 hours and changes from springs to neaps in 7.4 days.
[[nodiscard]] double springs_and_neaps(core::Seconds since_highest);

}  // namespace floeplan::demo
