#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "engine/core/shown_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/ocean/iceberg_drift.hpp"
#include "engine/planning/obstacles/drifting_disc.hpp"
#include "engine/planning/obstacles/iceberg_track.hpp"
#include "engine/planning/publish/route_moves.hpp"
#include "engine/planning/publish/warnings.hpp"

namespace floeplan::planning::publish {
namespace {

struct BasedBerg {
  const ocean::Iceberg* iceberg;  // element of the environment's icebergs
  ocean::DriftBasis basis;

  [[nodiscard]] core::Seconds known() const {
    return basis.known.empty() ? core::Seconds{0.0} : basis.known.back().time - basis.known.front().time;
  }
  [[nodiscard]] bool is_mostly_known() const { return known() > basis.unknown; }
};

core::Metres distance(const ocean::IcebergFix& a, const ocean::IcebergFix& b) {
  return geo::geodesic_between(a.place, b.place).length;
}

/// The farthest displacement of the iceberg in any period of this length with known currents.
/// Precondition  the known period is longer than `span`
core::Metres farthest_in(const std::vector<ocean::IcebergFix>& known, core::Seconds span) {
  core::Metres farthest{0.0};
  std::size_t end = 0;
  for (const ocean::IcebergFix& from : known) {
    while (end < known.size() && known[end].time - from.time < span) ++end;
    if (end == known.size()) break;
    farthest = std::max(farthest, distance(from, known[end]));
  }
  return farthest;
}

/// Mean speed along a straight line of the icebergs whose currents are known most of the time; empty if there is none.
std::optional<core::MetresPerSecond> mean_speed(const std::vector<BasedBerg>& bergs) {
  core::Metres drifted{0.0};
  core::Seconds time{0.0};
  for (const BasedBerg& berg : bergs) {
    if (!berg.is_mostly_known()) continue;
    drifted = drifted + distance(berg.basis.known.front(), berg.basis.known.back());
    time += berg.known();
  }
  if (time.count() <= 0.0) return std::nullopt;
  return core::MetresPerSecond{drifted.value / time.count()};
}

}  // namespace

std::vector<messages::Message> drift_warnings(const cost::Sea& sea, const ocean::Environment& environment,
                                              const PlanRequest& request,
                                              const std::vector<geo::PlanePoint>& route,
                                              const cost::Schedule& schedule,
                                              const std::vector<vehicle::Drive>& drives,
                                              const std::stop_token& stop) {
  if (!request.icebergs.drift || !environment.currents) return {};
  const core::Seconds arrival = schedule.arrivals.back();
  std::vector<BasedBerg> bergs;
  for (const ocean::Iceberg& iceberg : environment.icebergs) {
    if (stop.stop_requested()) return {};
    if (ocean::is_too_old(iceberg, request.depart)) continue;
    bergs.push_back({&iceberg, ocean::drift_basis(iceberg, environment, request.depart + arrival, stop)});
  }

  std::vector<motion::EvenMove> moves;
  for_each_move(sea, route, schedule, drives,
                [&](std::size_t, const motion::EvenMove& move) { moves.push_back(move); });
  const auto mean_of_all = mean_speed(bergs);
  const auto is_near = [&](const BasedBerg& berg) {
    if (!berg.is_mostly_known() && !mean_of_all) return true;
    const double unknown_m = berg.is_mostly_known() ? farthest_in(berg.basis.known, berg.basis.unknown).value
                                                    : mean_of_all->value * berg.basis.unknown.count();
    const auto track = obstacles::track_of(*berg.iceberg, environment, request.icebergs,
                                           sea.domain().projection(), request.depart, arrival, stop);
    const obstacles::DriftingDisc disc{track, core::Metres{0.5 * ocean::safe_length(*berg.iceberg).value},
                                       request.icebergs.margin};
    double scale = 1.0;
    for (const obstacles::TrackPoint& point : track) scale = std::max(scale, point.scale);
    return std::ranges::any_of(moves, [&](const motion::EvenMove& move) {
      return disc.first_touch(move, scale * unknown_m).has_value();
    });
  };
  std::vector<std::string> near;
  std::size_t elsewhere = 0;
  for (const BasedBerg& berg : bergs) {
    if (stop.stop_requested()) return {};
    if (berg.basis.unknown.count() <= 0.0) continue;
    if (is_near(berg)) {
      near.push_back(berg.iceberg->id.empty() ? "one without a name" : berg.iceberg->id);
    } else {
      ++elsewhere;
    }
  }

  std::vector<messages::Message> told;
  if (!near.empty()) {
    told.push_back(messages::plan_message<"drift-unknown-near-route">(
        near.size(), environment.icebergs.size(), core::shortened_list(near)));
  }
  if (elsewhere > 0) {
    told.push_back(messages::plan_message<"drift-unknown-elsewhere">(elsewhere, environment.icebergs.size()));
  }
  return told;
}

std::vector<messages::Message> messages_beside_drift(const ocean::Environment& environment) {
  std::vector<messages::Message> told;
  std::ranges::copy_if(environment.messages, std::back_inserter(told), [](const messages::Message& message) {
    return message.code != "sightings-before-currents" && message.code != "icebergs-beyond-currents";
  });
  return told;
}

}  // namespace floeplan::planning::publish
