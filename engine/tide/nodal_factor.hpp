#pragma once

#include <complex>

#include "engine/tide/mean_longitudes.hpp"

namespace floeplan::tide {

/// Groups of constituents with the same nodal correction. Spectral neighbours, too close to be separated
/// within a year, modulate them over the 18.6 years of the lunar node (M1 and L2 also over the 8.85 years of
/// the perigee).
enum class NodalClass { none, mm, mf, q1, o1, beta1, m1, chi1, k1, j1, oo1, m2, m3, l2, k2, eta2 };

/// f exp(i u): the factor that corrects a constituent's amplitude and phase at a time.
/// Source   amplitude ratios of the neighbours from the expansion of the tidal potential: Doodson 1921, The
///          harmonic development of the tide-generating potential, Proc. R. Soc. A 100, in the form that Pugh
///          1987, Tides, surges and mean sea-level, table 4:3, and the programs of OTIS and TPXO use. M1 and
///          chi1: Foreman 1977, Manual for tidal heights analysis and prediction; m3 as the power 3/2 of m2:
///          Schureman 1958, Manual of harmonic analysis and prediction of tides, C&GS SP 98, formula (149)
[[nodiscard]] std::complex<double> nodal_factor(NodalClass nodal, const MeanLongitudes& longitudes);

}  // namespace floeplan::tide
