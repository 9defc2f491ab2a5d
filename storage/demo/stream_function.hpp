#pragma once

#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "storage/demo/raster_frame.hpp"

namespace floeplan::demo {

/// East and north components over a frame.
struct Flow {
  std::vector<double> east;
  std::vector<double> north;
};

/// A stretch of the frame's edge through which water enters, and its share of the total inflow; the share is
/// negative where water leaves.
struct Gate {
  geo::BoundingBox stretch;  // the gate is the nodes of the edge inside this box that are not land
  double inflow{};
};

/// Horizontal flow without sources, of arbitrary scale. It enters and leaves only through the gates and does
/// not cross coasts. It prefers places of small resistance, and turns anticlockwise where `spin` is positive.
/// Shape    every array over `frame`; resistance must be positive and is ignored on land
/// Method   solves
///          div(resistance grad psi) = spin with land as an almost perfect conductor of psi, so that psi is
///          constant along each coast and each island; the flow is (-d psi/dy, d psi/dx)
/// Errors   std::invalid_argument when the inflows of the gates do not add up to zero
[[nodiscard]] Flow stream_flow(const RasterFrame& frame, const std::vector<bool>& land,
                               const std::vector<double>& resistance, const std::vector<Gate>& gates,
                               const std::vector<double>& spin);

}  // namespace floeplan::demo
