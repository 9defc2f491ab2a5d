#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "storage/demo/disko_bathymetry.hpp"
#include "storage/demo/ice_file.hpp"
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
  /// True on land and where the sea is shallower than `depth_m`. `at` is the cell's index in the frame.
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
  Flow eddies_early_;  // the eddies at the start
  Flow eddies_late_;   // the eddies six days later
  double outflow_phase_rad_{};
  core::UtcTime start_;
};

/// Invented drift ice in the south of Disko Bay: a field of closed first-year ice that drifts slowly
/// westwards, with open water around it and one patch of open water in its middle. A vehicle that crosses the
/// field can surface only in this patch.
[[nodiscard]] IceLayer make_disko_ice(const Relief& relief, const RasterFrame& frame, std::uint64_t seed,
                                      core::Seconds since_start);

/// Sixty invented icebergs: most in the icefjord, on its sill and in the outflow, the others scattered over
/// the bay. Lengths are log-normal between 20 and 600 m. Drafts follow from the length and are never deeper
/// than the sea. The last sightings are up to 20 h before `start`. Apart from one small berg, the corridor
/// between 53.20W and 51.60W on 69.20N is clear by 7 km on both sides.
/// Source   draft: Barker et al. 2004 up to 160 m length, Hotzel and Miller 1983 above
[[nodiscard]] std::vector<ocean::Iceberg> make_disko_icebergs(const Relief& relief, std::uint64_t seed,
                                                              core::UtcTime start);

}  // namespace floeplan::demo
