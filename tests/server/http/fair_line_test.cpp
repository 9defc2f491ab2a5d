#include "server/http/fair_line.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <random>
#include <vector>

#include "server/http/client_counts.hpp"
#include "tests/support/property.hpp"

namespace floeplan::http::fair_line_test {
namespace {

using testing::ElementsAre;

/// Named requests, and the order in which they got their threads.
class FairLineTest : public testing::Test {
 protected:
  void come(const std::string& client, const std::string& request) {
    places_[request] =
        std::make_unique<FairLine::Place>(line_, client, [this, request] { begun_.push_back(request); });
    if (places_[request]->has_begun()) begun_.push_back(request);
  }
  void end(const std::string& request) { places_.erase(request); }

  FairLine line_{3};
  std::vector<std::string> begun_;
  std::map<std::string, std::unique_ptr<FairLine::Place>> places_;
};

TEST_F(FairLineTest, LeavesAThreadForAnotherClient) {
  for (const char* request : {"a1", "a2", "a3", "a4"}) come("ann", request);
  EXPECT_THAT(begun_, ElementsAre("a1", "a2"));

  come("bob", "b1");

  EXPECT_THAT(begun_, ElementsAre("a1", "a2", "b1")) << "at once";
}

TEST_F(FairLineTest, ServesWhoHasLeastAtWork) {
  for (const char* request : {"a1", "a2", "a3", "a4"}) come("ann", request);
  for (const char* request : {"b1", "b2"}) come("bob", request);
  come("cy", "c1");
  begun_.clear();

  end("a1");  // ann has one at work now, bob one, cy none
  end("a2");
  end("b1");

  EXPECT_THAT(begun_, ElementsAre("c1", "a3", "b2"));
}

TEST_F(FairLineTest, ServesEqualClientsInTheOrderInWhichTheyCame) {
  for (const char* request : {"a1", "a2"}) come("ann", request);
  come("bob", "b1");
  for (const char* client : {"z", "y", "x"}) come(client, client);
  begun_.clear();

  for (const char* request : {"a1", "a2", "b1"}) end(request);

  EXPECT_THAT(begun_, ElementsAre("z", "y", "x"));
}

TEST_F(FairLineTest, ForgetsARequestThatIsGivenUp) {
  for (const char* request : {"a1", "a2", "a3"}) come("ann", request);
  end("a3");
  end("a1");
  EXPECT_THAT(begun_, ElementsAre("a1", "a2"));
}

TEST(FairLine, OfOneThreadServesAll) {
  FairLine line{1};
  auto first = std::make_unique<FairLine::Place>(line, "ann", [] {});
  bool begun = false;
  const FairLine::Place second{line, "ann", [&begun] { begun = true; }};
  EXPECT_FALSE(begun);

  first.reset();

  EXPECT_TRUE(begun);
}

TEST(FairLine, NeverHasIdleThreadsWhileSomebodyMayHaveThem) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const auto threads = static_cast<std::size_t>(support::uniform_int(rng, 1, 5));
    const std::size_t most = std::max<std::size_t>(threads, 2) - 1;
    FairLine line{threads};
    std::vector<std::pair<std::string, std::unique_ptr<FairLine::Place>>> places;
    for (int step = 0; step < 200; ++step) {
      if (places.empty() || support::uniform_int(rng, 0, 9) < 6) {
        const std::string client(1, static_cast<char>('a' + support::uniform_int(rng, 0, 3)));
        places.emplace_back(client, std::make_unique<FairLine::Place>(line, client, [] {}));
      } else {
        places.erase(places.begin() + support::uniform_int(rng, 0, static_cast<int>(places.size()) - 1));
      }

      std::map<std::string, std::size_t> at_work;
      std::map<std::string, std::size_t> waiting;
      std::size_t all_at_work = 0;
      for (const auto& [client, place] : places) {
        ++(place->has_begun() ? at_work : waiting)[client];
        all_at_work += place->has_begun() ? 1U : 0U;
      }
      ASSERT_LE(all_at_work, threads);
      for (const auto& [client, count] : at_work) ASSERT_LE(count, most);
      for (const auto& [client, count] : waiting)
        ASSERT_TRUE(all_at_work == threads || at_work[client] == most) << client << " waits for nothing";
    }
  });
}

TEST(ClientCounts, CountWhatLives) {
  ClientCounts counts;
  {
    const ClientCounts::One a{counts, "ann"};
    const ClientCounts::One again{counts, "ann"};
    const ClientCounts::One b{counts, "bob"};
    EXPECT_EQ(counts.of("ann"), 2U);
    EXPECT_EQ(counts.of("bob"), 1U);
    EXPECT_EQ(counts.all(), 3U);
  }
  EXPECT_EQ(counts.of("ann"), 0U);
  EXPECT_EQ(counts.all(), 0U);
}

}  // namespace
}  // namespace floeplan::http::fair_line_test
