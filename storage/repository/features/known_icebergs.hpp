#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/ocean/ice/sighting_age.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Conditions for the icebergs that a caller needs.
struct SightingQuery {
  DatasetChoice choice;
  geo::BoundingBox area;    // area that the datasets must intersect
  core::Metres reach{0.0};  // bergs up to this far outside the area count too, because they may drift into it
  core::UtcTime as_of;      // the latest time of a sighting that counts
  // departure of the vehicle; ocean::oldest_that_counts gives the oldest sighting for it
  core::UtcTime depart;
  core::Seconds max_age{ocean::max_sighting_age};
  core::Seconds track_age{0.0};  // age of earlier fixes to return with each sighting; zero: none
  bool also_left_out{
      // also return sightings that are ignored for their age or as too late, up to ocean::left_out_are_told
      false};
};

/// The stored icebergs that plans avoid and the map shows. Every berg is in only one of the three lists of
/// sightings, so their sizes add up to the number of bergs.
struct KnownIcebergs {
  // datasets of the choice that intersect the area; named ones: that are within reach
  std::vector<Dataset> here;
  std::vector<Dataset> consulted;         // datasets that were searched for sightings
  std::vector<StoredSighting> sightings;  // the newest of each berg, in the order of the datasets
  std::vector<StoredSighting> too_old;    // bergs not seen since `oldest`, not even later; only if requested
  std::vector<StoredSighting>
      // first sighting after `as_of` of each berg that has none in `sightings`; only if requested
      later;
  core::UtcTime oldest;  // the earliest time of a sighting that counts

  [[nodiscard]] bool speaks_here(const DatasetId& dataset) const;
  [[nodiscard]] std::size_t bergs() const { return sightings.size() + too_old.size() + later.size(); }
};

/// Finds the icebergs. By default every dataset with sightings young enough is searched, wherever it lies,
/// because a berg seen in the area by one may have left it according to another. If none of these intersects
/// the area, the newest that does is searched too. Reports by hand are always searched.
/// Errors   adds the violations of `candidates`
[[nodiscard]] KnownIcebergs known_icebergs(sql::Connection& db, const std::vector<Dataset>& stored,
                                           const SightingQuery& query, core::Violations& violations);

}  // namespace floeplan::repository
