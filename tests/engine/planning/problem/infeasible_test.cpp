#include "engine/planning/problem/infeasible.hpp"

#include <gtest/gtest.h>

#include "engine/core/packed.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::infeasible_test {
namespace {

std::string some_text(std::mt19937_64& rng) {
  std::string text(rng() % 20, '\0');
  for (char& each : text) each = static_cast<char>(rng());
  return text;
}

messages::Message some_message(std::mt19937_64& rng) {
  messages::Message message{.code = some_text(rng), .rank = messages::Rank::caution};
  if (rng() % 2 == 0) message.place = geo::LonLat{support::uniform(rng, -180.0, 180.0), 69.0};
  message.values = {
      {"hours", support::uniform(rng, 0.0, 1.0)}, {"count", std::int64_t{-3}}, {"name", some_text(rng)}};
  message.text = some_text(rng);
  message.hint = some_text(rng);
  return message;
}

Change some_change(std::mt19937_64& rng, int depth) {
  Change change{.input = some_text(rng),
                .from = support::uniform(rng, 0.0, 1.0),
                .to = std::array{0.1, 0.2},
                .text = some_text(rng)};
  if (rng() % 3 == 0) change.from = Change::Nothing{};
  if (rng() % 3 == 0) change.to = core::from_unix_seconds(1.8e9);
  if (depth > 0) change.with.push_back(some_change(rng, depth - 1));
  return change;
}

/// Law: what is packed and unpacked is the same to the last bit; packed once more it gives the same bytes.
TEST(Infeasible, IsTheSameAfterItWasPacked) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    Infeasible before{.reason = Reason::no_surfacing,
                      .at = {support::uniform(rng, -180.0, 180.0), support::uniform(rng, -90.0, 90.0)},
                      .when = core::from_unix_seconds(support::uniform(rng, 0.0, 2e9)),
                      .why = some_message(rng)};
    before.besides = {some_message(rng), some_message(rng)};
    before.changes = {some_change(rng, 2)};
    before.search_cut_short = rng() % 2 == 0;
    if (rng() % 2 == 0) before.postponed = core::Seconds{0.1};

    const std::string bytes = core::packed(before);
    const auto after = core::unpacked<Infeasible>(bytes);

    EXPECT_EQ(core::packed(after), bytes);
    EXPECT_EQ(after.reason, before.reason);
    EXPECT_EQ(after.at, before.at);
    EXPECT_EQ(after.when, before.when);
    EXPECT_EQ(after.why, before.why);
    EXPECT_EQ(after.besides, before.besides);
    EXPECT_EQ(after.changes.at(0).with.at(0).text, before.changes.at(0).with.at(0).text);
    EXPECT_EQ(after.changes.at(0).to, before.changes.at(0).to);
    EXPECT_EQ(after.search_cut_short, before.search_cut_short);
    EXPECT_EQ(after.postponed, before.postponed);
  });
}

}  // namespace
}  // namespace floeplan::planning::infeasible_test
