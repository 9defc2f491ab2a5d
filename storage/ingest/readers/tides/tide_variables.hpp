#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/currents/tide_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// One quantity of a tide in a file.
struct TideVariables {
  ocean::TideQuantity quantity{};
  const NetcdfVariable* first{nullptr};   // real part, or amplitude
  const NetcdfVariable* second{nullptr};  // imaginary part of A exp(-i g), or Greenwich phase lag in degrees
  bool amplitude_and_phase{false};
  bool transport{false};  // of the whole column, m2/s: to be divided by the depth
  double factor{1.0};     // metres, m/s or m2/s in one unit of the amplitude
};

/// Whether the file holds harmonic constants of a tide.
[[nodiscard]] bool holds_tides(const NetcdfFile& file);

/// Whether it holds tidal currents as transports of the water column, without the depths that make them speeds.
[[nodiscard]] bool needs_tide_depths(const NetcdfFile& file);

/// Whether it is the grid file of such a model: depths at the nodes of u and v (hu, hv), and no tide.
[[nodiscard]] bool holds_tide_depths_alone(const NetcdfFile& file);

/// The component of a tidal current that a file holds without the other; nullopt: both, or none.
[[nodiscard]] std::optional<ocean::TideQuantity> lone_tide_component(const NetcdfFile& file);

/// What a file holds, elevations first. Known are the names of TPXO and OTIS (hRe, hIm, uRe, uIm, vRe, vIm), TMD 3
/// (URe, ...), FES (amplitude, phase, Ua, Ug, Va, Vg), FES2012 (Ha, Hg) and HAMTIDE (AMPL, PHAS, UAMP, UPHA, VAMP,
/// VPHA).
/// One component of the current may stand alone: the other is then in a file of its own.
/// Errors   a tidal forcing of ROMS; half of a pair; a unit that is none; a component that says it is the other one
[[nodiscard]] Checked<std::vector<TideVariables>> find_tides(const NetcdfFile& file);

}  // namespace floeplan::ingest
