#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/documents/probe_document.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/ice/sighting_age.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// The place and time of a probe.
struct ProbeQuery {
  geo::LonLat place;
  core::UtcTime time;
  std::optional<core::Metres> depth;  // depth of the currents; default: the shallowest level of the data
  /// Datasets to use. A kind with a named dataset uses only named ones: for currents, wind and ice the first,
  /// for depths the first with a value. By default the newest that covers the place, the finest depths, and
  /// all datasets of other kinds.
  std::vector<std::string> dataset_ids{};
  /// Departure of the vehicle, which decides the icebergs that count (ocean::oldest_that_counts); default:
  /// `time`.
  std::optional<core::UtcTime> departure{};
  core::Seconds max_sighting_age{ocean::max_sighting_age};
};

/// Icebergs farther away than this are not listed.
inline constexpr core::Metres probe_iceberg_range{50'000.0};

/// The stored data at a place and a time; nothing is extrapolated. Common to API and command line.
/// Errors   a violation for each of `dataset_ids` that is unknown or of a kind without values at a place
[[nodiscard]] tl::expected<codec::Probe, core::Violations> probe(sql::Connection& db,
                                                                 const ProbeQuery& query);

}  // namespace floeplan::service
