#include "storage/repository/features/iceberg_track_repository.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::iceberg_track_repository_test {
namespace {

/// By a look at every sighting.
std::vector<IcebergTrack> slow_tracks(const std::vector<StoredSighting>& sightings,
                                      const TrackFilter& filter) {
  std::map<std::pair<std::string, std::string>, std::vector<StoredSighting>> of_berg;
  for (const auto& sighting : sightings) {
    if (!sighting.iceberg.id.empty())
      of_berg[{sighting.dataset.value, sighting.iceberg.id}].push_back(sighting);
  }
  std::vector<IcebergTrack> tracks;
  for (const auto& [berg, seen] : of_berg) {
    std::map<core::UtcTime, geo::LonLat> fixes;
    for (const auto& sighting : seen) fixes[sighting.iceberg.observed] = sighting.iceberg.place;
    const bool meets = !filter.area || std::ranges::any_of(seen, [&](const auto& sighting) {
      return geo::contains(*filter.area, sighting.iceberg.place);
    });
    if (fixes.size() < 2 || !meets || (filter.berg_id && *filter.berg_id != berg.second) ||
        (filter.from && fixes.rbegin()->first < *filter.from) ||
        (filter.to && fixes.begin()->first > *filter.to))
      continue;
    tracks.push_back({seen.front().row, {berg.first}, berg.second, {}});
    for (const auto& [time, place] : fixes) tracks.back().fixes.push_back({place, time});
  }
  std::ranges::sort(tracks, {}, &IcebergTrack::first_row);
  return tracks;
}

void expect_same(const IcebergTrack& found, const IcebergTrack& wanted) {
  EXPECT_EQ(found.first_row, wanted.first_row);
  EXPECT_EQ(found.dataset, wanted.dataset);
  EXPECT_EQ(found.berg_id, wanted.berg_id);
  ASSERT_EQ(found.fixes.size(), wanted.fixes.size());
  for (std::size_t i = 0; i < found.fixes.size(); ++i) {
    EXPECT_EQ(found.fixes[i].place, wanted.fixes[i].place);
    EXPECT_EQ(found.fixes[i].time, wanted.fixes[i].time);
  }
}

TrackFilter random_filter(std::mt19937_64& rng) {
  TrackFilter filter;
  const auto hour = [&] { return sample_time + core::Seconds{3600.0 * support::uniform_int(rng, 0, 12)}; };
  if (support::uniform_int(rng, 0, 1) == 1)
    filter.berg_id = "B-" + std::to_string(support::uniform_int(rng, 0, 5));
  if (support::uniform_int(rng, 0, 1) == 1) filter.from = hour();
  if (support::uniform_int(rng, 0, 1) == 1) filter.to = hour();
  if (support::uniform_int(rng, 0, 1) == 1) {
    const double west = support::uniform_int(rng, -180, 179);
    filter.area = {west, -5.0, geo::wrap_longitude(west + support::uniform_int(rng, 1, 200)), 5.0};
  }
  return filter;
}

TEST(IcebergTracks, AreThoseOfEverySightingPageByPage) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    sql::Connection db = support::empty_store();
    IcebergRepository icebergs{db};
    for (const char* id : {"ice-1", "ice-2"}) {
      DatasetRepository{db}.insert(sample_dataset(id, DatasetKind::icebergs));
      std::vector<ocean::Iceberg> sightings;
      for (int i = support::uniform_int(rng, 0, 30); i > 0; --i) {
        const int number = support::uniform_int(rng, -1, 5);
        ocean::Iceberg berg = sample_berg(number < 0 ? "" : "B-" + std::to_string(number),
                                          {static_cast<double>(support::uniform_int(rng, -180, 180)),
                                           static_cast<double>(support::uniform_int(rng, -9, 9))});
        berg.observed = sample_time + core::Seconds{3600.0 * support::uniform_int(rng, 0, 12)};
        sightings.push_back(berg);
      }
      icebergs.insert({id}, sightings);
    }
    const TrackFilter filter = random_filter(rng);
    const auto wanted = slow_tracks(icebergs.list({}, 0, 1000), filter);

    const IcebergTrackRepository tracks{db};
    std::vector<IcebergTrack> found;
    for (bool more = true; more;) {
      const TrackPage page = tracks.list(filter, found.empty() ? 0 : found.back().first_row, 2);
      found.insert(found.end(), page.tracks.begin(), page.tracks.end());
      more = page.more;
    }

    EXPECT_EQ(tracks.count(filter), std::ssize(wanted));
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) expect_same(found[i], wanted[i]);
    const auto all = slow_tracks(icebergs.list({}, 0, 1000), {});
    for (std::int64_t row = 0; row <= 60; ++row) {
      const auto track = std::ranges::find(all, row, &IcebergTrack::first_row);
      const auto alone = tracks.find(row);
      ASSERT_EQ(alone.has_value(), track != all.end()) << "a track is named by its first sighting alone";
      if (alone) expect_same(*alone, *track);
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::iceberg_track_repository_test
