#include "storage/repository/fields/current_grid_cache.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace floeplan::repository::current_grid_cache_test {
namespace {

constexpr std::size_t bytes_of_one = 2 * 4 * sizeof(float);

std::shared_ptr<const ocean::CurrentGrid> grid(float east_m_s) {
  return std::make_shared<const ocean::CurrentGrid>(ocean::CurrentGrid::Samples{
      .grid = {geo::GeographicFrame{}, ocean::Axis{{0.0, 1.0}}, ocean::Axis{{0.0, 1.0}}},
      .depths_m = std::nullopt,
      .times_s = ocean::Axis{{0.0}},
      .u = std::vector<float>(4, east_m_s),
      .v = std::vector<float>(4, 0.0F)});
}

CurrentGridCache::Key key(std::int64_t row) {
  return {.parts = {{row, 0.0, 3600.0}}, .area = {0.0, 0.0, 1.0, 1.0}, .from_s = 0.0, .deepest_m = 200.0};
}

TEST(CurrentGridCache, GivesBackTheVeryGrid) {
  CurrentGridCache cache{4 * bytes_of_one};
  const auto kept = grid(0.1F);

  cache.keep(key(1), kept);

  EXPECT_EQ(cache.find(key(1)), kept);
}

TEST(CurrentGridCache, TakesNothingElseForTheSame) {
  CurrentGridCache cache{4 * bytes_of_one};
  cache.keep(key(1), grid(0.1F));
  CurrentGridCache::Key deeper = key(1);
  deeper.deepest_m = 1000.0;
  CurrentGridCache::Key later = key(1);
  later.from_s = 3600.0;
  CurrentGridCache::Key wider = key(1);
  wider.area.east_deg = 2.0;
  CurrentGridCache::Key longer = key(1);
  longer.parts.front().last_s = 7200.0;

  for (const auto& other : {key(2), deeper, later, wider, longer}) EXPECT_EQ(cache.find(other), nullptr);
}

TEST(CurrentGridCache, DropsWhatWasUsedLongestAgo) {
  CurrentGridCache cache{2 * bytes_of_one};
  cache.keep(key(1), grid(0.1F));
  cache.keep(key(2), grid(0.2F));
  EXPECT_TRUE(cache.find(key(1)));

  cache.keep(key(3), grid(0.3F));

  EXPECT_TRUE(cache.find(key(1)));
  EXPECT_FALSE(cache.find(key(2)));
  EXPECT_TRUE(cache.find(key(3)));
}

TEST(CurrentGridCache, KeepsNoGridThatIsLargerThanItMayBe) {
  CurrentGridCache cache{bytes_of_one - 1};

  cache.keep(key(1), grid(0.1F));

  EXPECT_FALSE(cache.find(key(1)));
}

TEST(CurrentGridCache, ServesSeveralThreadsAtOnce) {
  CurrentGridCache cache{2 * bytes_of_one};
  const auto work = [&cache](std::int64_t first) {
    for (std::int64_t i = 0; i < 500; ++i) {
      const std::int64_t row = (first + i) % 4;
      const auto found = cache.find(key(row));
      if (found) {
        EXPECT_EQ(found->samples().u.front(), static_cast<float>(row));
      } else {
        cache.keep(key(row), grid(static_cast<float>(row)));
      }
    }
  };

  std::jthread one{work, 0};
  std::jthread other{work, 2};
}

}  // namespace
}  // namespace floeplan::repository::current_grid_cache_test
