#include "engine/graph/arrival_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tests/support/property.hpp"

namespace floeplan::graph::arrival_queue_test {
namespace {

TEST(ArrivalQueue, TakesEqualKeysByTheNumberOfTheVertex) {
  ArrivalQueue queue{10};
  for (const Vertex v : {7U, 2U, 9U, 4U}) queue.insert(v, 1.0);

  EXPECT_EQ(queue.extract_min(), 2U);
  EXPECT_EQ(queue.extract_min(), 4U);
  EXPECT_EQ(queue.extract_min(), 7U);
  EXPECT_EQ(queue.extract_min(), 9U);
  EXPECT_TRUE(queue.empty());
}

TEST(ArrivalQueue, TakesBackAVertexThatItHadGivenOut) {
  ArrivalQueue queue{2};
  queue.insert(1, 5.0);
  (void)queue.extract_min();
  EXPECT_FALSE(queue.holds(1));

  queue.insert(1, 3.0);

  EXPECT_TRUE(queue.holds(1));
  EXPECT_EQ(queue.smallest_key(), 3.0);
}

TEST(ArrivalQueue, DoesWhatASortedSetDoes) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    constexpr int vertices = 60;
    ArrivalQueue queue{vertices};
    std::set<std::pair<double, Vertex>> model;
    std::vector<double> key_of(vertices);
    const auto random_key = [&] { return static_cast<double>(support::uniform_int(rng, 0, 30)); };

    for (int i = 0; i < 400; ++i) {
      const auto v = static_cast<Vertex>(support::uniform_int(rng, 0, vertices - 1));
      if (support::uniform_int(rng, 0, 3) == 0 && !model.empty()) {
        ASSERT_EQ(queue.smallest_key(), model.begin()->first);
        ASSERT_EQ(queue.extract_min(), model.begin()->second);
        model.erase(model.begin());
      } else if (!queue.holds(v)) {
        key_of[v] = random_key();
        queue.insert(v, key_of[v]);
        model.insert({key_of[v], v});
      } else {
        model.erase({key_of[v], v});
        key_of[v] = std::min(key_of[v], random_key());
        queue.decrease_key(v, key_of[v]);
        model.insert({key_of[v], v});
      }
      ASSERT_EQ(queue.empty(), model.empty());
    }
  });
}

}  // namespace
}  // namespace floeplan::graph::arrival_queue_test
