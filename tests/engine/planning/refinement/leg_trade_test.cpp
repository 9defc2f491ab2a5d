#include "engine/planning/refinement/leg_trade.hpp"

#include <gtest/gtest.h>

namespace floeplan::planning::refinement::leg_trade_test {
namespace {

cost::Itinerary itinerary(std::size_t legs, double travel_time_s) {
  return {{std::vector<geo::PlanePoint>(legs + 1), std::vector<bool>(legs + 1)},
          {core::Seconds{0.0}, core::Seconds{travel_time_s}},
          {0.0, travel_time_s}};
}

LegTradeOff trade_off() {
  LegTradeOff result;
  for (const auto& [legs, time_s] : {std::pair{std::size_t{8}, 1020.0},
                                     {std::size_t{4}, 1100.0},
                                     {std::size_t{16}, 1000.0},
                                     {std::size_t{8}, 1010.0},
                                     {std::size_t{12}, 1015.0},
                                     {std::size_t{32}, 999.9}}) {
    result.offer(itinerary(legs, time_s));
  }
  return result;
}

TEST(LegTradeOff, ListsTheFastestOfEachNumberAndOnlyWhatMoreLegsGain) {
  EXPECT_EQ(trade_off().trade(), (std::vector<LegTrade>{{4, core::Seconds{1100.0}},
                                                        {8, core::Seconds{1010.0}},
                                                        {16, core::Seconds{1000.0}},
                                                        {32, core::Seconds{999.9}}}));
}

TEST(LegTradeOff, ChoosesTheFewestLegsOfWhichTwiceAsManyGainTooLittle) {
  EXPECT_EQ(trade_off().choose(5e-4, std::nullopt).route.legs(), 16U);
  EXPECT_EQ(trade_off().choose(0.05, std::nullopt).route.legs(), 8U);
  EXPECT_EQ(trade_off().choose(0.0, std::nullopt).route.legs(), 32U);
}

TEST(LegTradeOff, TakesNoMoreLegsThanAskedForUnlessThereIsNoOther) {
  EXPECT_EQ(trade_off().choose(0.0, 15).route.legs(), 8U);
  EXPECT_EQ(trade_off().choose(0.0, 3).route.legs(), 4U);
}

TEST(LegTradeOff, KnowsTheFewestLegsThatCostAtMostSoMuch) {
  EXPECT_EQ(trade_off().fewest(1099.0)->route.legs(), 8U);
  EXPECT_EQ(trade_off().fewest(1100.0)->route.legs(), 4U);
  EXPECT_EQ(trade_off().fewest(999.95)->route.legs(), 32U);
  EXPECT_FALSE(trade_off().fewest(999.0).has_value());
}

TEST(LegTradeOff, ReachesOverANumberOfLegsThatGainsNothing) {
  LegTradeOff found;
  found.offer(itinerary(4, 1100.0));
  found.offer(itinerary(8, 1100.0));
  found.offer(itinerary(16, 1000.0));

  EXPECT_EQ(found.choose(5e-4, std::nullopt).route.legs(), 16U);
}

}  // namespace
}  // namespace floeplan::planning::refinement::leg_trade_test
