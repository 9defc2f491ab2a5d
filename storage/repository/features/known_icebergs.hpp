#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/ocean/ice/sighting_age.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Which icebergs somebody wants to know of.
struct SightingQuery {
  DatasetChoice choice;
  geo::BoundingBox area;    // that the datasets are to speak of
  core::Metres reach{0.0};  // bergs as far beyond the area count too: they may drift into it
  core::UtcTime as_of;      // no later sighting counts
  core::UtcTime depart;     // of the vehicle; which sighting is too old then says ocean::oldest_that_counts
  core::Seconds max_age{ocean::max_sighting_age};
  core::Seconds track_age{0.0};  // each with its earlier fixes no older than this; zero: without
  bool also_left_out{
      false};  // list those left out for their age or as seen later, up to ocean::left_out_are_told
};

/// What the store knows of icebergs, as plans obey it and the map shows it.
struct KnownIcebergs {
  std::vector<Dataset> here;              // of the choice those that meet the area; named ones, within reach
  std::vector<Dataset> consulted;         // those that the sightings were taken from
  std::vector<StoredSighting> sightings;  // of each berg the newest, in the order of the datasets
  std::vector<StoredSighting> too_old;    // that nobody has seen since `oldest`, where wanted
  std::vector<StoredSighting>
      later;             // the first after `as_of` of each berg that no sighting here is of; the same
  core::UtcTime oldest;  // the earliest sighting that counts

  [[nodiscard]] bool speaks_here(const DatasetId& dataset) const;
};

/// Without a word on datasets every file with sightings young enough to count is consulted, wherever they lie: a berg
/// may have left the area since the one that saw it here; where none of them speaks of the area, the newest that does
/// as well.
/// What people reported by hand is always consulted.
/// Errors   adds the violations of `candidates`
[[nodiscard]] KnownIcebergs known_icebergs(sql::Connection& db, const std::vector<Dataset>& stored,
                                           const SightingQuery& query, core::Violations& violations);

}  // namespace floeplan::repository
