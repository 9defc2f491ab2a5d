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

/// A constituent (line) of the tide, as an index into the catalogue.
struct Constituent {
  std::uint16_t index{};

  friend auto operator<=>(const Constituent&, const Constituent&) = default;
};

/// The constituent with this name, in any usual spelling, upper or lower case: "M2", "nu2", "LAM2" and
/// "lambda2", "RHO" and "rho1", "NO1" and "M1". Names of shallow-water constituents state their parents:
/// "2MS6" is twice M2 plus S2. S1 counts from midnight, and Sa from the Sun's longitude alone, as in NOAA,
/// TPXO and FES. Programs after Foreman refer both to the Sun's perigee, so their phases differ.
/// Returns  nullopt for a constituent that is not in the catalogue
/// Source   Doodson numbers: Doodson 1921; phases: Schureman 1958, table 2; shallow water: Foreman 1977,
///          table 2, and the list of constituents that NOAA publishes with its stations
[[nodiscard]] std::optional<Constituent> find_constituent(std::string_view name);

/// Name of the constituent, such as "M2".
[[nodiscard]] const std::string& constituent_name(Constituent constituent);

/// All constituents of the catalogue, ascending by index.
[[nodiscard]] std::vector<Constituent> all_constituents();

/// Doodson's six numbers, the multipliers of the six astronomical longitudes. The fifth multiplies N' = -N,
/// where N is the longitude of the moon's ascending node.
[[nodiscard]] std::array<int, 6> doodson_numbers(Constituent constituent);

/// Angular speed in radians per second.
[[nodiscard]] double angular_speed(Constituent constituent);

/// exp(i V): V is the constituent's argument at Greenwich, without nodal corrections.
[[nodiscard]] std::complex<double> equilibrium_phasor(Constituent constituent,
                                                      const MeanLongitudes& longitudes);

/// f exp(i u), the nodal correction; for a shallow-water constituent the product of its parents' corrections.
[[nodiscard]] std::complex<double> nodal_factor(Constituent constituent, const MeanLongitudes& longitudes);

}  // namespace floeplan::tide
