#include "engine/core/near_word.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::core {
namespace {

const std::vector<std::string> commands{"plan",    "evaluate", "reach",   "compare",
                                        "recheck", "ingest",   "datasets"};

TEST(NearWord, IsTheWordWithTheFewestSlips) {
  EXPECT_EQ(near_word("paln", commands), "plan");
  EXPECT_EQ(near_word("recheck", commands), "recheck");
  EXPECT_EQ(near_word("datasts", commands), "datasets");
  EXPECT_EQ(near_word("simulate", commands), "");
  EXPECT_EQ(near_word("", commands), "");
}

/// Law: one slip in a word of at least four letters is understood.
TEST(NearWord, UnderstandsOneSlip) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const std::string& word = commands[rng() % commands.size()];
    std::string slipped = word;
    const std::size_t at = rng() % (word.size() - 1);
    switch (rng() % 4) {
      case 0: slipped.erase(at, 1); break;
      case 1: slipped.insert(at, 1, 'x'); break;
      case 2: slipped[at] = 'x'; break;
      default: std::swap(slipped[at], slipped[at + 1]);
    }
    EXPECT_EQ(near_word(slipped, commands), word) << slipped;
  });
}

}  // namespace
}  // namespace floeplan::core
