#pragma once

#include <vector>

#include "storage/repository/features/iceberg_repository.hpp"

namespace floeplan::repository {

/// The newest sightings of all icebergs in several datasets. Joining them keeps a new file with two bergs
/// from hiding the sixty of an older file. Datasets of one source (with the same columns) use the same names:
/// for each berg the newest sighting up to `as_of` counts, and its track has the sightings of all of them.
/// Reports by hand, sightings without a name and other sources are not joined: a berg counted twice is safer
/// than a berg missed. Two sightings with one name are of different bergs if they are farther apart than a
/// berg drifts in the time between, because some feeds reuse numbers.
/// `max_age`  oldest sighting that counts, before `as_of`
/// Returns    the sightings in the area, in the order of the datasets, then by row; each with its `earlier`
///            fixes from up to `track_age` before it; none if that is zero
[[nodiscard]] std::vector<StoredSighting> joined_sightings(sql::Connection& db,
                                                           const std::vector<Dataset>& datasets,
                                                           const geo::BoundingBox& area, core::UtcTime as_of,
                                                           core::Seconds max_age,
                                                           core::Seconds track_age = core::Seconds{0.0});

/// For each berg that is not in `counted`, the first sighting in the area after `as_of`, up to `until`.
/// Whether two sightings are of one berg is decided as in `joined_sightings`. In the order of the datasets,
/// then by row.
[[nodiscard]] std::vector<StoredSighting> first_seen_after(sql::Connection& db,
                                                           const std::vector<Dataset>& datasets,
                                                           const geo::BoundingBox& area, core::UtcTime as_of,
                                                           core::UtcTime until,
                                                           const std::vector<StoredSighting>& counted);

/// The sightings of bergs that have no sighting among `others`. Whether two sightings are of one berg is
/// decided as in `joined_sightings`.
[[nodiscard]] std::vector<StoredSighting> without_bergs_of(sql::Connection& db,
                                                           std::vector<StoredSighting> sightings,
                                                           const std::vector<StoredSighting>& others);

}  // namespace floeplan::repository
