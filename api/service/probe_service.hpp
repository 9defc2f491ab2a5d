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

/// Where and when to look.
struct ProbeQuery {
  geo::LonLat place;
  core::UtcTime time;
  std::optional<core::Metres> depth;  // for currents; default: the shallowest level of the data
  /// Of a kind that one of them is of no other dataset counts; of currents, wind and ice the first tells, of depths the
  /// first that knows any. By default the newest of these kinds that covers the place, the finest depths, and all else.
  std::vector<std::string> dataset_ids{};
  /// Icebergs as a vehicle that leaves then obeys them (ocean::oldest_that_counts); default: at `time`.
  std::optional<core::UtcTime> departure{};
  core::Seconds max_sighting_age{ocean::max_sighting_age};
};

/// Icebergs farther away than this are not listed.
inline constexpr core::Metres probe_iceberg_range{50'000.0};

/// What the stored data say of a place and a time; nothing is extrapolated. One function for API and command
/// line.
/// Errors   a violation for each of `dataset_ids` that is unknown or of a kind that has no values at a place
[[nodiscard]] tl::expected<codec::Probe, core::Violations> probe(sql::Connection& db,
                                                                 const ProbeQuery& query);

}  // namespace floeplan::service
