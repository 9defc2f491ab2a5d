#pragma once

#include <array>
#include <compare>
#include <complex>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/tide/mean_longitudes.hpp"

namespace floeplan::tide {

/// Names a line of the catalogue.
struct Constituent {
  std::uint16_t index{};

  friend auto operator<=>(const Constituent&, const Constituent&) = default;
};

/// The line of a name in any of its usual spellings, upper or lower case: "M2", "nu2", "LAM2" and "lambda2", "RHO" and
/// "rho1", "NO1" and "M1". Lines of shallow water are the sums of their parents: "2MS6" is twice M2 and S2.
/// S1 counts from midnight, Sa from the Sun's longitude alone, as NOAA, TPXO and FES do; programs after Foreman refer
/// both to the perigee of the Sun, and their phases differ.
/// Returns  nullopt for a line that the catalogue does not hold
/// Source   Doodson numbers: Doodson 1921; phases: Schureman 1958, table 2; shallow water: Foreman 1977, table 2, and
///          the list of constituents that NOAA publishes with its stations
[[nodiscard]] std::optional<Constituent> find_constituent(std::string_view name);

/// "M2".
[[nodiscard]] const std::string& constituent_name(Constituent constituent);

/// Every line of the catalogue, by rising index.
[[nodiscard]] std::vector<Constituent> all_constituents();

/// Doodson's six numbers; the fifth counts N'.
[[nodiscard]] std::array<int, 6> doodson_numbers(Constituent constituent);

/// Radians per second.
[[nodiscard]] double angular_speed(Constituent constituent);

/// exp(i V): the line's argument at Greenwich, without nodal corrections.
[[nodiscard]] std::complex<double> equilibrium_phasor(Constituent constituent,
                                                      const MeanLongitudes& longitudes);

/// f exp(i u), of a line of shallow water the product of its parents'.
[[nodiscard]] std::complex<double> nodal_factor(Constituent constituent, const MeanLongitudes& longitudes);

}  // namespace floeplan::tide
