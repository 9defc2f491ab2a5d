#pragma once

#include <vector>

#include "storage/repository/features/iceberg_repository.hpp"

namespace floeplan::repository {

/// The newest word of several datasets on each iceberg, so that a file with two bergs hides none of the sixty that came
/// before it. Datasets of one source (the same columns) speak of the same bergs: of a berg the newest sighting by
/// `as_of` counts, and its track is that of all of them. What people reported by hand, sightings without a name and
/// those of other sources stand for themselves: one berg twice is safer than none.
/// Two sightings under one name that lie farther apart than a berg drifts in the time between them are of two bergs;
/// feeds number theirs anew.
/// `max_age`  of sightings before `as_of`
/// Returns    in the order of the datasets, then by row; those in the area; with `earlier` fixes no older than
///            `track_age` before each, none where that is zero
[[nodiscard]] std::vector<StoredSighting> joined_sightings(sql::Connection& db,
                                                           const std::vector<Dataset>& datasets,
                                                           const geo::BoundingBox& area, core::UtcTime as_of,
                                                           core::Seconds max_age,
                                                           core::Seconds track_age = core::Seconds{0.0});

/// The first sighting in the area after `as_of`, up to `until`, of each berg that none of `counted` is of, by the same
/// rule of which sightings are of one berg. In the order of the datasets, then by row.
[[nodiscard]] std::vector<StoredSighting> first_seen_after(sql::Connection& db,
                                                           const std::vector<Dataset>& datasets,
                                                           const geo::BoundingBox& area, core::UtcTime as_of,
                                                           core::UtcTime until,
                                                           const std::vector<StoredSighting>& counted);

}  // namespace floeplan::repository
