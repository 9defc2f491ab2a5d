#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "api/codec/documents/probe_document.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/ice/sighting_age.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Where and when to look.
struct ProbeQuery {
  geo::LonLat place;
  core::UtcTime time;
  std::optional<core::Metres> depth;  // for currents; default: the shallowest level of the data
  std::optional<std::string>
      dataset_id;  // currents, wind, bathymetry, ice or tides; default: the newest of each kind that covers the
                   // place, and all tide models there together
  /// Icebergs as a vehicle that leaves then obeys them (ocean::oldest_that_counts); default: at `time`.
  std::optional<core::UtcTime> departure{};
  core::Seconds max_sighting_age{ocean::max_sighting_age};
};

/// Icebergs farther away than this are not listed.
inline constexpr core::Metres probe_iceberg_range{50'000.0};

/// What the stored data say of a place and a time; nothing is extrapolated. One function for API and command
/// line.
/// Errors   a violation when `dataset_id` is unknown or of a kind that has no values at a place
[[nodiscard]] tl::expected<codec::Probe, core::Violations> probe(sql::Connection& db,
                                                                 const ProbeQuery& query);

}  // namespace floeplan::service
