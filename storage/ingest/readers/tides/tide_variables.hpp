#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/currents/tide_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The variables of one quantity of a tide in a file.
struct TideVariables {
  ocean::TideQuantity quantity{};
  const NetcdfVariable* first{nullptr};   // real part, or amplitude
  const NetcdfVariable* second{nullptr};  // imaginary part of A exp(-i g), or Greenwich phase lag in degrees
  bool amplitude_and_phase{false};
  bool transport{false};  // m2/s over the whole water column; to be divided by the depth
  double factor{1.0};     // metres, m/s or m2/s per unit of the amplitude
};

/// Whether the file holds harmonic constants of a tide.
[[nodiscard]] bool holds_tides(const NetcdfFile& file);

/// Whether a file has tidal currents as transports of the water column, without the depths that convert them
/// to speeds.
[[nodiscard]] bool needs_tide_depths(const NetcdfFile& file);

/// Whether a file is the grid file of such a model: depths at the nodes of u and v (hu, hv), and no tide.
[[nodiscard]] bool holds_tide_depths_alone(const NetcdfFile& file);

/// The component of a tidal current that a file holds without the other; nullopt: both, or none.
[[nodiscard]] std::optional<ocean::TideQuantity> lone_tide_component(const NetcdfFile& file);

/// The quantities in a file, elevations first. Known names are those of TPXO and OTIS (hRe, hIm, uRe, uIm,
/// vRe, vIm), TMD 3 (URe, ...), FES (amplitude, phase, Ua, Ug, Va, Vg), FES2012 (Ha, Hg) and HAMTIDE (AMPL,
/// PHAS, UAMP, UPHA, VAMP, VPHA). A single component of the current is accepted; the other is then in another
/// file.
/// Errors   a tidal forcing of ROMS; half of a pair; an unknown unit; a component that describes itself as
///          the other one
[[nodiscard]] Checked<std::vector<TideVariables>> find_tides(const NetcdfFile& file);

}  // namespace floeplan::ingest
