#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/demo/disko_bathymetry.hpp"
#include "storage/demo/stream_function.hpp"

namespace floeplan::demo {

/// Invented currents of Disko Bay: a tide that turns about every 6.2 hours (M2 with some S2), an
/// anticlockwise circulation of the bay, the outflow of the icefjord in the upper 70 m with a weak return
/// flow below, and drifting eddies. Every part follows a stream function that is constant along the coasts,
/// so no water crosses them.
/// Frame    east-north, m/s; depth positive down
/// Threads  const members may be called from several threads at once
class DiskoCurrents {
 public:
  DiskoCurrents(const Relief& relief, const std::vector<geo::Polygon>& land, std::uint64_t seed,
                core::UtcTime start);

  [[nodiscard]] static RasterFrame frame();
  /// True on land and where the bed is shallower than the depth.
  [[nodiscard]] bool is_masked(std::size_t at, double depth_m) const;
  /// The whole frame at one depth and time; zero where masked.
  [[nodiscard]] Flow at(double depth_m, core::UtcTime time) const;

 private:
  std::vector<bool> land_;
  std::vector<double> bed_m_;
  Flow fjord_tide_;  // in and out of the icefjord, amplitude
  Flow bay_tide_;    // through the bay into Vaigat, amplitude
  Flow circulation_;
  Flow outflow_;
  Flow eddies_early_;  // where the eddies are at the start
  Flow eddies_late_;   // and six days later
  double outflow_phase_rad_{};
  core::UtcTime start_;
};

}  // namespace floeplan::demo
