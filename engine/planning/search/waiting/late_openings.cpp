#include "engine/planning/search/waiting/late_openings.hpp"

#include <algorithm>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/loiter.hpp"

namespace floeplan::planning::search {
namespace {

constexpr std::size_t most_legs = 128;
constexpr int halvings_of_a_span = 10;  // of the span in which a leg opens
constexpr double least_gain_s = 60;     // below it nothing would be planned otherwise
constexpr std::size_t legs_between_looks = 4;

/// A refused leg that may matter, and the latest arrival at its end that would.
struct Suspect {
  RefusedEdge refused;
  double latest_s{};
  double promise_s{};  // earliest conceivable arrival at the goal
};

std::vector<Suspect> suspects(const OpenGrid& open, const graph::SearchTree& tree,
                              const RefusedEdges& refused, const StraightBound& bound) {
  const double goal_s = tree.arrival_s(open.grid.goal);
  std::vector<Suspect> result;
  for (const RefusedEdge& leg : refused.edges) {
    const double rest_s = bound.remaining(leg.edge.head).count();
    const double latest_s = std::min(tree.arrival_s(leg.edge.head), goal_s - rest_s);
    const double earliest_s = (leg.when + bound.least_time(leg.edge)).count();
    if (earliest_s + least_gain_s < latest_s) result.push_back({leg, latest_s, earliest_s + rest_s});
  }
  std::ranges::stable_sort(result, {}, &Suspect::promise_s);
  if (result.size() > most_legs) result.resize(most_legs);
  return result;
}

/// The leg of one suspect at later departures.
class LaterDepartures {
 public:
  LaterDepartures(const cost::Sea& sea, const cost::RouteGrid& grid, const Suspect& suspect)
      : sea_{sea},
        from_{grid.point(suspect.refused.edge.tail)},
        to_{grid.point(suspect.refused.edge.head)},
        refused_{suspect.refused.when},
        latest_{std::min(core::Seconds{suspect.latest_s}, *sea.currents()->end())},
        step_{cost::between_tries(sea, latest_ - refused_)} {}

  /// The earliest departure that gets through and its arrival, when this is in time.
  struct Opening {
    core::Seconds depart;
    core::Seconds arrival;
  };
  [[nodiscard]] std::optional<Opening> first() const {
    for (core::Seconds depart = refused_ + step_; depart < latest_; depart += step_) {
      if (arrival(depart)) return sharpen(depart - step_, depart);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<core::Seconds> arrival(core::Seconds depart) const {
    const auto time = sea_.leg_time(from_, to_, depart, latest_);
    if (!time || depart + *time > latest_) return std::nullopt;
    return depart + *time;
  }

  [[nodiscard]] Opening sharpen(core::Seconds closed, core::Seconds open) const {
    for (int i = 0; i < halvings_of_a_span; ++i) {
      const core::Seconds middle = 0.5 * (closed + open);
      (arrival(middle) ? open : closed) = middle;
    }
    return {open, *arrival(open)};
  }

  const cost::Sea& sea_;
  geo::PlanePoint from_;
  geo::PlanePoint to_;
  core::Seconds refused_;
  core::Seconds latest_;
  core::Seconds step_;
};

bool gains_more(const LateOpening& a, const LateOpening& b) {
  const core::Seconds never{graph::SearchTree::never};
  return a.gain.value_or(never) > b.gain.value_or(never);
}

}  // namespace

std::vector<LateOpening> find_late_openings(const cost::Sea& sea, core::UtcTime epoch, const OpenGrid& open,
                                            const graph::SearchTree& tree, const RefusedEdges& refused,
                                            const StraightBound& bound, const std::stop_token& stop) {
  std::vector<LateOpening> found;
  if (!sea.currents() || !sea.currents()->time_step()) return found;

  const std::vector<Suspect> all = suspects(open, tree, refused, bound);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % legs_between_looks == 0 && stop.stop_requested()) break;
    const graph::Edge edge = all[i].refused.edge;
    const auto opening = LaterDepartures{sea, open.grid, all[i]}.first();
    if (!opening) continue;
    LateOpening late{.place = sea.projection().to_lon_lat(open.grid.point(edge.tail)),
                     .refused = epoch + all[i].refused.when,
                     .opens = epoch + opening->depart,
                     .gain = std::nullopt};
    if (tree.is_reached(edge.head)) late.gain = core::Seconds{tree.arrival_s(edge.head)} - opening->arrival;
    if (!late.gain || late.gain->count() >= least_gain_s) found.push_back(late);
  }
  return found;
}

std::optional<LateOpening> worse_of(const std::optional<LateOpening>& a,
                                    const std::optional<LateOpening>& b) {
  if (!a || !b) return a ? a : b;
  return gains_more(*b, *a) ? b : a;
}

messages::Message message_of(const LateOpening& opening) {
  const auto [lon_deg, lat_deg] = opening.place;
  if (!opening.gain) {
    return messages::plan_message<"leg-opens-later">(lon_deg, lat_deg, opening.refused, opening.opens)
        .at(opening.place);
  }
  return messages::plan_message<"leg-opens-later-and-is-faster">(
             lon_deg, lat_deg, opening.refused, opening.opens, opening.gain->count() / 3600.0)
      .at(opening.place);
}

}  // namespace floeplan::planning::search
