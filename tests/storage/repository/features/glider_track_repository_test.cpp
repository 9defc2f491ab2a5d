#include "storage/repository/features/glider_track_repository.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/dataset_transfer.hpp"
#include "storage/repository/datasets/retention.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/statement.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::glider_track_repository_test {
namespace {

ocean::GliderTrack random_track(std::mt19937_64& rng, const std::string& glider, int count) {
  ocean::GliderTrack track{.glider = glider, .points = {}, .currents = {}};
  geo::LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -70.0, 70.0)};
  core::UtcTime time = sample_time + hour * support::uniform_int(rng, 0, 100);
  for (int i = 0; i < count; ++i) {
    place = {geo::wrap_longitude(place.lon_deg + support::uniform(rng, -1.0, 1.0)),
             place.lat_deg + support::uniform(rng, -0.5, 0.5)};
    track.points.push_back(
        {.time = time, .place = place, .depth = {}, .fixed = support::uniform_int(rng, 0, 1) == 1});
    if (support::uniform_int(rng, 0, 2) > 0)
      track.points.back().depth = core::Metres{support::uniform(rng, 0.0, 1000.0)};
    time += core::Seconds{support::uniform(rng, 1.0, 600.0)};
    if (support::uniform_int(rng, 0, 4) == 0)
      track.currents.push_back({time, place, {{support::uniform(rng, -1.0, 1.0)}, {0.25}}});
  }
  track.frame = static_cast<ocean::CurrentFrame>(support::uniform_int(rng, 0, 2));
  if (track.frame == ocean::CurrentFrame::turned)
    track.turned_from = {{support::uniform_int(rng, 1, 60), {support::uniform(rng, -1.0, 1.0)}},
                         static_cast<ocean::VariationSource>(support::uniform_int(rng, 0, 2))};
  return track;
}

class GliderTracks : public testing::Test {
 protected:
  void store(const std::string& id, const std::vector<ocean::GliderTrack>& tracks) {
    DatasetRepository{db_}.insert(sample_dataset(id, DatasetKind::glider_tracks));
    tracks_.insert({id}, tracks);
  }

  std::int64_t rows(const std::string& table) {
    sql::Statement query{db_, "SELECT count(*) FROM " + table};
    return query.step() ? query.integer(0) : -1;
  }

  sql::Connection db_{support::empty_store()};
  GliderTrackRepository tracks_{db_};
};

/// A way of three points off Greenland.
ocean::GliderTrack short_track() {
  return {.glider = "amadeus",
          .points = {{.time = sample_time, .place = {-52.0, 69.0}},
                     {.time = sample_time + hour, .place = {-51.9, 69.0}, .depth = core::Metres{180.0}},
                     {.time = sample_time + 2.0 * hour, .place = {-51.8, 69.1}}},
          .currents = {{sample_time + hour, {-51.9, 69.0}, {{0.1}, {-0.2}}}}};
}

TEST_F(GliderTracks, ComeBackToTheLastBit) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const std::string id = "tracks-" + std::to_string(rng());
    const std::vector tracks{random_track(rng, "amadeus", support::uniform_int(rng, 1, 400)),
                             random_track(rng, "comet", 2)};
    store(id, tracks);

    const auto page = tracks_.list({.dataset = DatasetId{id}}, 0, 10);

    ASSERT_EQ(page.tracks.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto found = tracks_.find(page.tracks[i].row);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->track, tracks[i]);
      EXPECT_EQ(found->dataset.value, id);
      EXPECT_EQ(found->deepest, ocean::deepest(tracks[i].points));
      EXPECT_EQ(found->mean_current, ocean::mean_current(tracks[i].currents));
    }
  });
}

TEST_F(GliderTracks, AreThoseThatALookAtEveryPointFindsPageByPage) {
  support::for_each_seed(15, [&](std::mt19937_64& rng) {
    std::vector<ocean::GliderTrack> all;
    for (int i = 0; i < 12; ++i)
      all.push_back(random_track(rng, i % 2 == 0 ? "amadeus" : "comet", support::uniform_int(rng, 1, 40)));
    const std::string id = "tracks-" + std::to_string(rng());
    store(id, all);
    GliderTrackFilter filter{.dataset = DatasetId{id}};
    if (support::uniform_int(rng, 0, 1) == 1) filter.glider = "comet";
    if (support::uniform_int(rng, 0, 1) == 1) filter.from = sample_time + 50.0 * hour;
    if (support::uniform_int(rng, 0, 1) == 1) filter.to = sample_time + 60.0 * hour;
    if (support::uniform_int(rng, 0, 1) == 1) filter.area = {150.0, -40.0, -60.0, 60.0};
    std::vector<std::string> wanted;
    for (const auto& track : all) {
      const bool meets = !filter.area || std::ranges::any_of(track.points, [&](const auto& point) {
        return geo::contains(*filter.area, point.place);
      });
      if (meets && (!filter.glider || track.glider == *filter.glider) &&
          (!filter.from || track.points.back().time >= *filter.from) &&
          (!filter.to || track.points.front().time <= *filter.to))
        wanted.push_back(std::to_string(core::unix_seconds(track.points.front().time)));
    }

    std::vector<std::string> found;
    std::int64_t after = 0;
    for (bool more = true; more;) {
      const auto page = tracks_.list(filter, after, 5);
      for (const auto& stored : page.tracks) {
        found.push_back(std::to_string(core::unix_seconds(stored.track.points.front().time)));
        after = stored.row;
      }
      more = page.more;
    }

    // A way between two points may cut the corner of the area.
    EXPECT_EQ(std::ssize(found), tracks_.count(filter));
    EXPECT_LE(found.size(), wanted.size() + (filter.area ? 3 : 0));
    for (const auto& each : wanted) EXPECT_NE(std::ranges::find(found, each), found.end());
  });
}

TEST_F(GliderTracks, OfManyPointsAreThinnedInAListAlone) {
  std::mt19937_64 rng{7};
  const auto track = random_track(rng, "amadeus", 4'000);
  store("tracks-1", {track});

  const auto listed = tracks_.list({}, 0, 1).tracks.at(0);

  EXPECT_LE(listed.track.points.size(), GliderTrackRepository::most_listed);
  EXPECT_LE(listed.track.currents.size(), GliderTrackRepository::most_listed);
  EXPECT_EQ(listed.point_count, 4'000);
  EXPECT_EQ(listed.current_count, std::ssize(track.currents));
  EXPECT_EQ(listed.mean_current, ocean::mean_current(track.currents));
  EXPECT_EQ(tracks_.find(listed.row)->track.points.size(), 4'000U);
}

TEST_F(GliderTracks, AreFoundWhereTheyPassBetweenTwoPoints) {
  store("tracks-1", {short_track()});

  EXPECT_EQ(tracks_.count({.area = geo::BoundingBox{-51.97, 68.99, -51.95, 69.01}}), 1);
  EXPECT_EQ(tracks_.count({.area = geo::BoundingBox{-51.79, 68.99, -51.0, 69.01}}), 0);
}

TEST_F(GliderTracks, GoWithTheirDataset) {
  store("tracks-1", {short_track()});
  store("tracks-2", {short_track(), short_track()});

  EXPECT_TRUE(DatasetRepository{db_}.remove({"tracks-2"}));

  EXPECT_EQ(rows("glider_track"), 1);
  EXPECT_EQ(rows("glider_track_box"), 1);
  EXPECT_EQ(rows("glider_current"), 1);
}

TEST_F(GliderTracks, ComeOverFromAnotherStoreWithTheirCurrents) {
  const support::TemporaryFolder arrived;
  store("tracks-1", {short_track()});
  {
    auto scratch = open_scratch_store(arrived.path());
    DatasetRepository{scratch}.insert(sample_dataset("tracks-2", DatasetKind::glider_tracks));
    GliderTrackRepository{scratch}.insert({"tracks-2"}, {short_track(), short_track()});
  }

  EXPECT_EQ(take_over_datasets(db_, arrived.path()), std::vector{DatasetId{"tracks-2"}});

  const auto page = tracks_.list({.area = geo::BoundingBox{-53.0, 68.0, -51.0, 70.0}}, 0, 10);
  ASSERT_EQ(page.tracks.size(), 3U);
  for (const auto& stored : page.tracks) EXPECT_EQ(stored.track, short_track());
  EXPECT_TRUE(DatasetRepository{db_}.remove({"tracks-2"}));
  EXPECT_EQ(rows("glider_current"), 1);
}

TEST_F(GliderTracks, TakeRoomThatRetentionCounts) {
  store("tracks-1", {short_track()});

  EXPECT_GT(stored_sizes(db_).at(0).bytes, 0);
}

TEST_F(GliderTracks, HaveAPointAtLeast) {
  DatasetRepository{db_}.insert(sample_dataset("tracks-1", DatasetKind::glider_tracks));

  EXPECT_THROW(tracks_.insert({"tracks-1"}, {{}}), std::invalid_argument);
  EXPECT_EQ(rows("glider_track"), 0);
}

}  // namespace
}  // namespace floeplan::repository::glider_track_repository_test
