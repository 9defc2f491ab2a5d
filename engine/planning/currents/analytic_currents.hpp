#pragma once

#include <optional>

#include "engine/motion/sloped_current.hpp"

namespace floeplan::planning::currents {

/// The river of the paper: a parabolic profile across x in [0, width], flowing along y. Steady.
/// Outside  empty beyond the banks. The derivatives continue for a hundredth of the width, because an
///          iterated extremal may end slightly beyond the bank
/// Source   Eichhorn 2009, equation (1)
struct RiverCurrent {
  double width_m{300.0};
  double peak_m_s{1.8};

  std::optional<motion::CurrentXy> operator()(geo::PlanePoint point, core::Seconds) const;
  [[nodiscard]] std::optional<motion::SlopedCurrent> slopes_at(geo::PlanePoint point, core::Seconds) const;
};

/// The meandering jet of the paper, eastward, dimensionless.
/// Source   Eichhorn 2009, equations (2) to (4) and the parameter set printed below (3); after Cencini et al.
///          1999, Mixing in a meandering jet, J. Phys. Oceanogr. 29
struct MeanderingJet {
  double b_0{1.2};
  double epsilon{0.3};
  double omega{0.4};
  double theta{1.5707963267948966};  // pi / 2
  double k{0.84};
  double c{0.12};

  std::optional<motion::CurrentXy> operator()(geo::PlanePoint point, core::Seconds time) const;
  [[nodiscard]] std::optional<motion::SlopedCurrent> slopes_at(geo::PlanePoint point,
                                                               core::Seconds time) const;
};

}  // namespace floeplan::planning::currents
