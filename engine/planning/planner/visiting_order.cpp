#include "engine/planning/planner/visiting_order.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace floeplan::planning::planner {
namespace {

constexpr double no_arrival = std::numeric_limits<double>::infinity();

double arrival_s(const TourLegTime& leg_time, std::size_t from, std::size_t to, double depart_s) {
  if (!(depart_s < no_arrival)) return no_arrival;
  const auto time = leg_time(from, to, core::Seconds{depart_s});
  return time ? depart_s + time->count() : no_arrival;
}

/// Arrival at the goal in this order, in seconds; `no_arrival` if some leg has no route.
double end_of_tour_s(const std::vector<std::size_t>& order, std::size_t goal, double depart_s,
                     const TourLegTime& leg_time) {
  double now = depart_s;
  std::size_t here = 0;
  for (const std::size_t next : order) {
    now = arrival_s(leg_time, here, next, now);
    here = next;
  }
  return arrival_s(leg_time, here, goal, now);
}

/// For each set of places and each last place in it: the earliest arrival there, and the place visited
/// before.
struct SetTable {
  explicit SetTable(std::size_t n)
      : places{n}, earliest_s(n << n, no_arrival), before(n << n, std::uint8_t{0}) {}

  [[nodiscard]] std::size_t at(std::size_t set, std::size_t last) const { return set * places + last; }

  std::size_t places;
  std::vector<double> earliest_s;    // [set][last]
  std::vector<std::uint8_t> before;  // [set][last]
};

/// Finds the best place to visit before the next one.
class BestBefore {
 public:
  /// All references are borrowed and must outlive this.
  BestBefore(const SetTable& table, const TourLegTime& leg_time, const LegEstimates::Estimate& least_time)
      : table_{table}, leg_time_{leg_time}, least_time_{least_time} {}

  struct Found {
    double arrival_s{no_arrival};
    std::size_t before{};
  };

  /// `set`: the places visited before, as bits, not empty. `next`: number of a place as in TourLegTime.
  [[nodiscard]] Found of(std::size_t set, std::size_t next) {
    candidates_.clear();
    for (std::size_t last = 0; last < table_.places; ++last) {
      const double here_s = table_.earliest_s[table_.at(set, last)];
      if (!(here_s < no_arrival)) continue;
      const double least_s = least_time_ ? least_time_(last + 1, next).count() : 0.0;
      candidates_.push_back({here_s + least_s, last});
    }
    std::ranges::sort(candidates_);
    Found best;
    for (const auto& [earliest_s, last] : candidates_) {
      if (earliest_s > best.arrival_s) break;
      const double next_s = arrival_s(leg_time_, last + 1, next, table_.earliest_s[table_.at(set, last)]);
      const bool is_better =
          next_s < best.arrival_s || (next_s == best.arrival_s && last < best.before && next_s < no_arrival);
      if (is_better) best = {next_s, last};
    }
    return best;
  }

 private:
  const SetTable& table_;
  const TourLegTime& leg_time_;
  const LegEstimates::Estimate& least_time_;
  std::vector<std::pair<double, std::size_t>>
      candidates_;  // lower bounds of arrivals, and the places that they belong to
};

std::optional<VisitingOrder> exact_order(std::size_t n, double depart_s, const TourLegTime& leg_time,
                                         const std::stop_token& stop,
                                         const LegEstimates::Estimate& least_time) {
  const std::size_t goal = n + 1;
  if (n == 0) {
    const double end = arrival_s(leg_time, 0, goal, depart_s);
    return end < no_arrival ? std::optional{VisitingOrder{{}, core::Seconds{end}, true}} : std::nullopt;
  }
  SetTable table{n};
  for (std::size_t first = 0; first < n; ++first) {
    table.earliest_s[table.at(std::size_t{1} << first, first)] = arrival_s(leg_time, 0, first + 1, depart_s);
  }
  const std::size_t all = (std::size_t{1} << n) - 1;
  BestBefore best_before{table, leg_time, least_time};
  for (std::size_t set = 1; set < all; ++set) {
    if (stop.stop_requested()) return std::nullopt;
    for (std::size_t next = 0; next < n; ++next) {
      if ((set >> next & 1) != 0) continue;
      const BestBefore::Found found = best_before.of(set, next + 1);
      const std::size_t entry = table.at(set | std::size_t{1} << next, next);
      table.earliest_s[entry] = found.arrival_s;
      table.before[entry] = static_cast<std::uint8_t>(found.before);
    }
  }

  const auto [best_s, before_goal] = best_before.of(all, goal);
  if (!(best_s < no_arrival)) return std::nullopt;

  VisitingOrder result{{}, core::Seconds{best_s}, true};
  std::size_t last = before_goal;
  for (std::size_t set = all; set != 0;) {
    result.places.push_back(last + 1);
    const std::size_t before = table.before[table.at(set, last)];
    set &= ~(std::size_t{1} << last);
    last = before;
  }
  std::ranges::reverse(result.places);
  return result;
}

/// A tour whose usual time exceeds that of the best tour by this factor is not timed exactly, because the
/// departure changes the time of a tour by a few percent only. The value is a judgement.
constexpr double worth_timing = 1.05;

/// A tour that is being improved.
class Tour {
 public:
  Tour(std::size_t n, double depart_s, const TourLegTime& leg_time, const LegEstimates::Estimate& usual_time,
       const std::stop_token& stop)
      : goal_{n + 1}, depart_s_{depart_s}, leg_time_{leg_time}, usual_time_{usual_time}, stop_{stop} {
    insert_all(n);
  }

  void improve() {
    while (!stop_.stop_requested() && (reverse_a_stretch() || move_neighbours())) {
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  [[nodiscard]] double end_s() const { return end_s_; }

 private:
  /// Inserts the places one by one: each time the place and position with the earliest end of the tour.
  void insert_all(std::size_t n) {
    std::vector<std::size_t> left(n);
    std::iota(left.begin(), left.end(), std::size_t{1});
    while (!left.empty() && !stop_.stop_requested()) {
      std::vector<std::vector<std::size_t>> orders;
      for (const std::size_t place : left) {
        for (std::size_t position = 0; position <= order_.size(); ++position) {
          orders.push_back(order_);
          orders.back().insert(orders.back().begin() + static_cast<std::ptrdiff_t>(position), place);
        }
      }
      double shortest_s = no_arrival;
      for (const auto& order : orders) shortest_s = std::min(shortest_s, usual_length_s(order));
      std::vector<std::size_t> best;
      double best_s = no_arrival;
      for (const auto& order : orders) {
        if (stop_.stop_requested()) return;
        if (usual_length_s(order) > worth_timing * shortest_s) continue;
        const double order_s = end_of_tour_s(order, goal_, depart_s_, leg_time_);
        if (!best.empty() && !(order_s < best_s)) continue;
        best = order;
        best_s = order_s;
      }
      order_ = std::move(best);
      end_s_ = best_s;
      std::erase_if(left, [&](std::size_t place) { return std::ranges::count(order_, place) > 0; });
    }
  }

  /// Length of a tour in this order by the usual times, in seconds; zero if those are unknown.
  [[nodiscard]] double usual_length_s(const std::vector<std::size_t>& order) const {
    if (!usual_time_) return 0.0;
    double sum_s = 0.0;
    std::size_t here = 0;
    for (const std::size_t next : order) sum_s += usual_time_(std::exchange(here, next), next).count();
    return sum_s + usual_time_(here, goal_).count();
  }

  bool adopt(std::vector<std::size_t> tried) {
    if (usual_length_s(tried) > worth_timing * usual_length_s(order_)) return false;
    const double tried_s = end_of_tour_s(tried, goal_, depart_s_, leg_time_);
    if (!(tried_s < end_s_)) return false;
    order_ = std::move(tried);
    end_s_ = tried_s;
    return true;
  }

  bool reverse_a_stretch() {
    for (std::size_t from = 0; from + 1 < order_.size(); ++from) {
      for (std::size_t to = from + 2; to <= order_.size() && !stop_.stop_requested(); ++to) {
        std::vector<std::size_t> tried = order_;
        std::reverse(tried.begin() + static_cast<std::ptrdiff_t>(from),
                     tried.begin() + static_cast<std::ptrdiff_t>(to));
        if (adopt(std::move(tried))) return true;
      }
    }
    return false;
  }

  bool move_neighbours() {
    for (std::size_t count = 1; count <= 3 && count < order_.size(); ++count) {
      for (std::size_t from = 0; from + count <= order_.size(); ++from) {
        for (std::size_t to = 0; to + count <= order_.size() && !stop_.stop_requested(); ++to) {
          if (to == from) continue;
          const auto first = order_.begin() + static_cast<std::ptrdiff_t>(from);
          const std::vector<std::size_t> moved(first, first + static_cast<std::ptrdiff_t>(count));
          std::vector<std::size_t> tried = order_;
          tried.erase(tried.begin() + static_cast<std::ptrdiff_t>(from),
                      tried.begin() + static_cast<std::ptrdiff_t>(from + count));
          tried.insert(tried.begin() + static_cast<std::ptrdiff_t>(to), moved.begin(), moved.end());
          if (adopt(std::move(tried))) return true;
        }
      }
    }
    return false;
  }

  std::size_t goal_;
  double depart_s_;
  const TourLegTime& leg_time_;
  const LegEstimates::Estimate& usual_time_;
  const std::stop_token& stop_;
  std::vector<std::size_t> order_;
  double end_s_{no_arrival};
};

/// Tries every order of visits, place by place. A partial tour that is later than all kept tours is dropped.
class AllOrders {
 public:
  /// `most`: the number of orders to keep, at least one.
  AllOrders(std::size_t places, const TourLegTime& leg_time, std::size_t most, const std::stop_token& stop)
      : leg_time_{leg_time}, most_{most}, stop_{stop}, left_(places) {
    std::iota(left_.begin(), left_.end(), std::size_t{1});
  }

  /// The kept orders, the earliest first.
  std::vector<VisitingOrder> best(core::Seconds depart) && {
    go_on_from(0, depart.count());
    return std::move(best_);
  }

 private:
  [[nodiscard]] double to_beat_s() const {
    return best_.size() < most_ ? no_arrival : best_.back().arrival.count();
  }

  void keep(double end_s) {
    const core::Seconds arrival{end_s};
    if (best_.size() == most_) best_.pop_back();
    const auto later = std::ranges::upper_bound(best_, arrival, {}, &VisitingOrder::arrival);
    best_.insert(later, VisitingOrder{order_, arrival, false});
  }

  void go_on_from(std::size_t here, double now_s) {
    if (stop_.stop_requested() || !(now_s < to_beat_s())) return;
    if (left_.empty()) {
      const double end_s = arrival_s(leg_time_, here, order_.size() + 1, now_s);
      if (end_s < to_beat_s()) keep(end_s);
      return;
    }
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const std::size_t next = left_[i];
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
      order_.push_back(next);
      go_on_from(next, arrival_s(leg_time_, here, next, now_s));
      order_.pop_back();
      left_.insert(left_.begin() + static_cast<std::ptrdiff_t>(i), next);
    }
  }

  const TourLegTime& leg_time_;
  std::size_t most_;
  const std::stop_token& stop_;
  std::vector<std::size_t> left_;
  std::vector<std::size_t> order_;
  std::vector<VisitingOrder> best_;
};

}  // namespace

std::optional<VisitingOrder> best_visiting_order(std::size_t places, core::Seconds depart,
                                                 const TourLegTime& leg_time, const std::stop_token& stop,
                                                 const LegEstimates& estimates) {
  if (places <= most_places_ordered_exactly)
    return exact_order(places, depart.count(), leg_time, stop, estimates.least);
  Tour tour{places, depart.count(), leg_time, estimates.usual, stop};
  tour.improve();
  if (tour.order().size() != places || !(tour.end_s() < no_arrival)) return std::nullopt;
  return VisitingOrder{tour.order(), core::Seconds{tour.end_s()}, false};
}

std::vector<VisitingOrder> best_visiting_orders_without_fifo(std::size_t places, core::Seconds depart,
                                                             const TourLegTime& leg_time, std::size_t most,
                                                             const std::stop_token& stop,
                                                             const LegEstimates& estimates) {
  if (places <= most_places_tried_in_all_orders) {
    std::vector<VisitingOrder> orders = AllOrders{places, leg_time, most, stop}.best(depart);
    if (!orders.empty()) orders.front().exact = true;
    return orders;
  }
  auto order = best_visiting_order(places, depart, leg_time, stop, estimates);
  if (!order) return {};
  order->exact = false;
  return {std::move(*order)};
}

std::optional<core::Seconds> end_of_tour(const std::vector<std::size_t>& places, core::Seconds depart,
                                         const TourLegTime& leg_time) {
  const double end_s = end_of_tour_s(places, places.size() + 1, depart.count(), leg_time);
  return end_s < no_arrival ? std::optional{core::Seconds{end_s}} : std::nullopt;
}

}  // namespace floeplan::planning::planner
