#include "engine/planning/planner/visiting_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/support/property.hpp"

namespace floeplan::planning::planner::visiting_order_test {
namespace {

using core::Seconds;

struct Place {
  double x;
  double y;
};

/// Places in the plane, a vehicle of speed 1, and a tide that changes with the time. A later departure never arrives earlier:
/// the tide changes a leg's time by less than the delay.
TourLegTime swinging_tour(std::mt19937_64& rng, std::size_t places) {
  std::uniform_real_distribution<double> coordinate{0.0, 100.0};
  std::uniform_real_distribution<double> phase{0.0, 6.28};
  std::vector<Place> all;
  for (std::size_t i = 0; i < places + 2; ++i) all.push_back({coordinate(rng), coordinate(rng)});
  const double first_phase = phase(rng);
  return [all, first_phase](std::size_t from, std::size_t to, Seconds depart) -> std::optional<Seconds> {
    const double dx = all[to].x - all[from].x;
    const double dy = all[to].y - all[from].y;
    const double angle = std::atan2(dy, dx);
    const double swing = 8.0 * std::sin(0.1 * depart.count() + first_phase + angle);  // slope below 1
    return Seconds{std::hypot(dx, dy) + 8.0 + swing};
  };
}

double end_of(const std::vector<std::size_t>& order, const TourLegTime& leg_time) {
  double now = 0.0;
  std::size_t here = 0;
  for (const std::size_t next : order) {
    now += leg_time(here, next, Seconds{now})->count();
    here = next;
  }
  return now + leg_time(here, order.size() + 1, Seconds{now})->count();
}

double best_of_all_orders(std::size_t places, const TourLegTime& leg_time) {
  std::vector<std::size_t> order(places);
  std::iota(order.begin(), order.end(), std::size_t{1});
  double best = INFINITY;
  do {
    best = std::min(best, end_of(order, leg_time));
  } while (std::ranges::next_permutation(order).found);
  return best;
}

TEST(VisitingOrder, EndsAsEarlyAsTheBestOfAllOrders) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    std::uniform_int_distribution<std::size_t> count{0, 7};
    const std::size_t places = count(rng);
    const TourLegTime leg_time = swinging_tour(rng, places);

    const auto found = best_visiting_order(places, Seconds{0.0}, leg_time, {});

    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(found->exact);
    EXPECT_NEAR(found->arrival.count(), best_of_all_orders(places, leg_time), 1e-9);
    EXPECT_NEAR(end_of(found->places, leg_time), found->arrival.count(), 1e-9);
  });
}

/// Law: a lower bound of the legs' times saves work and does not change the order.
TEST(VisitingOrder, IsTheSameWithABoundOnTheTimesOfLegs) {
  int looks_without = 0;
  int looks_with = 0;
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const auto places = static_cast<std::size_t>(support::uniform_int(rng, 1, 8));
    const TourLegTime leg_time = swinging_tour(rng, places);
    const auto counted = [&](int& looks) -> TourLegTime {
      return [&](std::size_t from, std::size_t to, Seconds depart) {
        ++looks;
        return leg_time(from, to, depart);
      };
    };
    const LegEstimates::Estimate least_time = [&](std::size_t from, std::size_t to) {
      constexpr double most_swing_s = 16.0;
      return std::max(Seconds{0.0}, *leg_time(from, to, Seconds{0.0}) - Seconds{most_swing_s});
    };

    const auto without = best_visiting_order(places, Seconds{0.0}, counted(looks_without), {});
    const auto with =
        best_visiting_order(places, Seconds{0.0}, counted(looks_with), {}, {.least = least_time});

    ASSERT_TRUE(without && with);
    EXPECT_EQ(with->places, without->places);
    EXPECT_EQ(with->arrival, without->arrival);
  });
  EXPECT_LT(looks_with, 0.7 * looks_without);
}

TEST(VisitingOrder, VisitsEveryPlaceOnceAndBeatsTheOrderGivenWhenThereAreMany) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    constexpr std::size_t places = 25;
    const TourLegTime leg_time = swinging_tour(rng, places);

    const auto found = best_visiting_order(places, Seconds{0.0}, leg_time, {});

    ASSERT_TRUE(found.has_value());
    EXPECT_FALSE(found->exact);
    std::vector<std::size_t> sorted = found->places;
    std::ranges::sort(sorted);
    std::vector<std::size_t> given(places);
    std::iota(given.begin(), given.end(), std::size_t{1});
    EXPECT_EQ(sorted, given);
    EXPECT_NEAR(end_of(found->places, leg_time), found->arrival.count(), 1e-9);
    EXPECT_LT(found->arrival.count(), end_of(given, leg_time));
  });
}

/// Usual times save legs, and cost at most some percent.
TEST(VisitingOrder, IsAboutAsEarlyWhereUsualTimesSayWhichOrdersAreWorthTiming) {
  int looks_without = 0;
  int looks_with = 0;
  support::for_each_seed(6, [&](std::mt19937_64& rng) {
    constexpr std::size_t places = 20;
    const TourLegTime leg_time = swinging_tour(rng, places);
    const auto counted = [&](int& looks) -> TourLegTime {
      return [&](std::size_t from, std::size_t to, Seconds depart) {
        ++looks;
        return leg_time(from, to, depart);
      };
    };
    const LegEstimates::Estimate usual_time = [&](std::size_t from, std::size_t to) {
      Seconds sum{0.0};
      for (int i = 0; i < 20; ++i) sum += *leg_time(from, to, Seconds{30.0 * i});
      return sum / 20.0;
    };

    const auto without = best_visiting_order(places, Seconds{0.0}, counted(looks_without), {});
    const auto with =
        best_visiting_order(places, Seconds{0.0}, counted(looks_with), {}, {.usual = usual_time});

    ASSERT_TRUE(without && with);
    EXPECT_LT(with->arrival, 1.1 * without->arrival);
  });
  EXPECT_LT(looks_with, 0.5 * looks_without);
}

TEST(VisitingOrder, FindsTheOneOrderWhoseLegsAllHaveAWay) {
  const std::vector<std::size_t> only{3, 1, 4, 2};
  const TourLegTime leg_time = [&](std::size_t from, std::size_t to, Seconds) -> std::optional<Seconds> {
    std::vector<std::size_t> chain{0};
    chain.insert(chain.end(), only.begin(), only.end());
    chain.push_back(only.size() + 1);
    const auto here = std::ranges::find(chain, from);
    if (here + 1 == chain.end() || *(here + 1) != to) return std::nullopt;
    return Seconds{1.0};
  };

  const auto found = best_visiting_order(4, Seconds{10.0}, leg_time, {});

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->places, only);
  EXPECT_EQ(found->arrival, Seconds{15.0});
}

TEST(VisitingOrder, IsEmptyWhereNoOrderLeadsToTheGoal) {
  const TourLegTime no_way = [](std::size_t, std::size_t to, Seconds) -> std::optional<Seconds> {
    if (to == 2) return std::nullopt;
    return Seconds{1.0};
  };

  EXPECT_FALSE(best_visiting_order(3, Seconds{0.0}, no_way, {}).has_value());
  EXPECT_FALSE(best_visiting_order(14, Seconds{0.0}, no_way, {}).has_value());
}

TEST(VisitingOrder, GivesUpOnceItIsToStop) {
  std::stop_source source;
  source.request_stop();
  const TourLegTime one = [](std::size_t, std::size_t, Seconds) { return Seconds{1.0}; };

  EXPECT_FALSE(best_visiting_order(12, Seconds{0.0}, one, source.get_token()).has_value());
  EXPECT_FALSE(best_visiting_order(40, Seconds{0.0}, one, source.get_token()).has_value());
}

/// The same tour with legs that are open only at some times: a later departure may get further.
TourLegTime opening_tour(std::mt19937_64& rng, std::size_t places) {
  const double phase = support::uniform(rng, 0.0, 100.0);
  return [tour = swinging_tour(rng, places), phase](std::size_t from, std::size_t to,
                                                    Seconds depart) -> std::optional<Seconds> {
    const double hour =
        depart.count() + phase + 31.0 * static_cast<double>(from) + 17.0 * static_cast<double>(to);
    if (std::fmod(hour, 100.0) < 40.0) return std::nullopt;
    return tour(from, to, depart);
  };
}

TEST(VisitingOrder, IsTheBestOfAllOrdersAlsoWhereLeavingLaterLeadsFurther) {
  int none = 0;
  support::for_each_seed(100, [&none](std::mt19937_64& rng) {
    const auto places = static_cast<std::size_t>(
        support::uniform_int(rng, 0, static_cast<int>(most_places_tried_in_all_orders)));
    const TourLegTime leg_time = opening_tour(rng, places);
    std::vector<std::size_t> each(places);
    std::iota(each.begin(), each.end(), std::size_t{1});
    std::optional<Seconds> best;
    do {
      const auto end = end_of_tour(each, Seconds{0.0}, leg_time);
      if (end && (!best || *end < *best)) best = end;
    } while (std::ranges::next_permutation(each).found);

    const auto orders = best_visiting_orders_without_fifo(places, Seconds{0.0}, leg_time, 1, {});

    ASSERT_EQ(orders.size(), best ? 1U : 0U);
    none += best ? 0 : 1;
    if (!best) return;
    EXPECT_EQ(orders.front().arrival, *best);
    EXPECT_EQ(end_of_tour(orders.front().places, Seconds{0.0}, leg_time), orders.front().arrival);
    EXPECT_TRUE(orders.front().exact);
  });
  EXPECT_GT(none, 0);
  EXPECT_LT(none, 100);
}

TEST(VisitingOrder, IsFollowedByTheNextBestOfAllOrders) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const auto places = static_cast<std::size_t>(support::uniform_int(rng, 1, 4));
    const TourLegTime leg_time = opening_tour(rng, places);
    std::vector<std::size_t> each(places);
    std::iota(each.begin(), each.end(), std::size_t{1});
    std::vector<Seconds> ends;
    do {
      if (const auto end = end_of_tour(each, Seconds{0.0}, leg_time)) ends.push_back(*end);
    } while (std::ranges::next_permutation(each).found);
    std::ranges::sort(ends);
    ends.resize(std::min<std::size_t>(ends.size(), 4));

    const auto orders = best_visiting_orders_without_fifo(places, Seconds{0.0}, leg_time, 4, {});

    ASSERT_EQ(orders.size(), ends.size());
    for (std::size_t i = 0; i < orders.size(); ++i) {
      EXPECT_EQ(orders[i].arrival, ends[i]);
      EXPECT_EQ(end_of_tour(orders[i].places, Seconds{0.0}, leg_time), ends[i]);
    }
  });
}

TEST(VisitingOrder, OfManyPlacesCanBeTravelledWhereLeavingLaterLeadsFurther) {
  int found = 0;
  support::for_each_seed(40, [&found](std::mt19937_64& rng) {
    const auto places = static_cast<std::size_t>(support::uniform_int(rng, 6, 14));
    const TourLegTime leg_time = opening_tour(rng, places);

    const auto orders = best_visiting_orders_without_fifo(places, Seconds{0.0}, leg_time, 3, {});

    if (orders.empty()) return;
    ++found;
    EXPECT_EQ(end_of_tour(orders.front().places, Seconds{0.0}, leg_time), orders.front().arrival);
    EXPECT_FALSE(orders.front().exact);
  });
  EXPECT_GT(found, 0);
}

TEST(VisitingOrder, IsNoneOnceItIsToStop) {
  std::stop_source stopped;
  stopped.request_stop();
  const TourLegTime leg_time = [](std::size_t, std::size_t, Seconds) { return Seconds{1.0}; };

  EXPECT_TRUE(best_visiting_orders_without_fifo(4, Seconds{0.0}, leg_time, 1, stopped.get_token()).empty());
}

}  // namespace
}  // namespace floeplan::planning::planner::visiting_order_test
