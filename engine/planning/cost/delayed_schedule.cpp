#include "engine/planning/cost/delayed_schedule.hpp"

#include <algorithm>

#include "engine/planning/cost/loiter.hpp"

namespace floeplan::planning::cost {
namespace {

constexpr int most_delays = 8;  // of one route: a strait each

class Delays {
 public:
  Delays(const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart)
      : sea_{sea}, route_{route}, schedule_{{depart}, std::vector<core::Seconds>(route.size())} {}

  std::optional<Schedule> find() && {
    int delays = 0;
    while (schedule_.arrivals.size() < route_.size()) {
      const std::size_t head = schedule_.arrivals.size();
      const auto leg = next_leg(head);
      if (leg) {
        schedule_.waits[head - 1] += leg->wait;
        schedule_.arrivals.push_back(schedule_.leaves(head - 1) + leg->time);
        continue;
      }
      if (leg.error() != motion::EdgeClosed::current_too_strong || delays++ == most_delays ||
          !wait_before(head))
        return std::nullopt;
    }
    return std::move(schedule_);
  }

 private:
  /// To the point `head`, after the wait that was settled at its beginning or else the least that opens it.
  [[nodiscard]] tl::expected<WaitedLeg, motion::EdgeClosed> next_leg(std::size_t head) const {
    const core::Seconds leaves = schedule_.leaves(head - 1);
    if (schedule_.waits[head - 1].count() <= 0.0)
      return leg_when_open(sea_, route_[head - 1], route_[head], leaves);
    return sea_.leg_time(route_[head - 1], route_[head], leaves).map([](core::Seconds time) {
      return WaitedLeg{core::Seconds{0.0}, time};
    });
  }

  /// Settles a wait at an earlier point that leads through the leg to `head`, and goes back there.
  bool wait_before(std::size_t head) {
    for (std::size_t back = 2;; back = 2 * back - 1) {
      const std::size_t point = back < head ? head - back : 0;
      if (const auto wait = wait_at(point, head)) {
        schedule_.arrivals.resize(point + 1);
        std::fill(schedule_.waits.begin() + static_cast<std::ptrdiff_t>(point), schedule_.waits.end(),
                  core::Seconds{0.0});
        schedule_.waits[point] = *wait;
        return true;
      }
      if (point == 0) return false;
    }
  }

  [[nodiscard]] std::optional<core::Seconds> wait_at(std::size_t point, std::size_t head) const {
    const core::Seconds arrives = schedule_.arrivals[point];
    const core::Seconds stays =
        can_stay_until(sea_, route_[point], arrives, arrives + sea_.longest_wait()) - arrives;
    const core::Seconds between = between_tries(sea_, stays);
    core::Seconds closed = schedule_.waits[point];
    while (closed < stays) {
      core::Seconds open = std::min(closed + between, stays);
      if (!leads_to(head, point, arrives + open)) {
        closed = open;
        continue;
      }
      while (open - closed > punctual) {
        const core::Seconds middle = 0.5 * (closed + open);
        (leads_to(head, point, arrives + middle) ? open : closed) = middle;
      }
      return open;
    }
    return std::nullopt;
  }

  /// Whether the vehicle comes from one point to another without a wait on the way.
  [[nodiscard]] bool leads_to(std::size_t head, std::size_t point, core::Seconds leaves) const {
    for (; point < head; ++point) {
      const auto time = sea_.leg_time(route_[point], route_[point + 1], leaves);
      if (!time) return false;
      leaves += *time;
    }
    return true;
  }

  const Sea& sea_;
  const std::vector<geo::PlanePoint>& route_;
  Schedule schedule_;
};

}  // namespace

std::optional<Schedule> delayed_schedule(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                         core::Seconds depart) {
  const bool currents_change = sea.currents() != nullptr && sea.currents()->time_step();
  if (!currents_change || sea.longest_wait().count() <= 0.0 || route.size() < 3) return std::nullopt;
  return Delays{sea, route, depart}.find();
}

}  // namespace floeplan::planning::cost
