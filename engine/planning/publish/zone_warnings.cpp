#include <cmath>
#include <utility>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/publish/warnings.hpp"

namespace floeplan::planning::publish {
namespace {

/// Standard deviation of a glider's true speed through the water, as a share of the assumed speed.
/// Source  Claus and Bachmayer 2015, Terrain-aided navigation for an underwater glider, J. Field Robotics 32,
///         doi:10.1002/rob.21563, as for simulated flights (NavigationErrors)
constexpr double unknown_share_of_speed = 0.05;
constexpr core::Metres between_looks{100.0};  // distance between samples; narrower areas may be overlooked

/// A place of the route, and the nearest time at which an area there opens or closes.
struct Passing {
  cost::Sea::Passage at;
  core::Seconds changes;

  [[nodiscard]] bool opens() const { return changes <= at.time; }
  [[nodiscard]] core::Seconds spare() const { return opens() ? at.time - changes : changes - at.time; }
  /// The spare time as a share of the time under way.
  [[nodiscard]] double share() const { return spare() / at.time; }
};

class Tightest {
 public:
  explicit Tightest(const cost::Sea& sea) : sea_{sea} {}

  void look(const cost::Sea::Passage& at) {
    if (at.time.count() <= 0.0) return;
    for (const TimeSpan& closed : sea_.domain().closures().closed_times_by_zones(at.point)) {
      const Passing passing{at, closed.until <= at.time ? closed.until : closed.from};
      if (std::isfinite(passing.changes.count()) && (!found || passing.share() < found->share()))
        found = passing;
    }
  }

  std::optional<Passing> found;

 private:
  const cost::Sea& sea_;
};

}  // namespace

std::optional<messages::Message> zone_warning(const cost::Sea& sea, const PlanRequest& request,
                                              const std::vector<geo::PlanePoint>& route,
                                              const cost::Schedule& schedule,
                                              const std::vector<vehicle::Drive>& drives) {
  if (sea.domain().closures().timed_zones().empty()) return std::nullopt;
  Tightest tightest{sea};
  for (std::size_t i = 1; i < route.size(); ++i) {
    tightest.look({route[i - 1], schedule.leaves(i - 1)});
    for (const cost::Sea::Passage& passage :
         sea.passages(route[i - 1], route[i], schedule.leaves(i - 1), between_looks, drives[i - 1]))
      tightest.look(passage);
  }
  if (!tightest.found || tightest.found->share() >= unknown_share_of_speed) return std::nullopt;
  const Passing& passing = *tightest.found;
  const geo::LonLat place = sea.domain().projection().to_lon_lat(passing.at.point);
  const core::UtcTime changes = request.depart + passing.changes;
  const double spare_min = passing.spare().count() / 60.0;
  const double under_way_h = passing.at.time.count() / 3600.0;
  constexpr double error_pct = 100.0 * unknown_share_of_speed;
  auto message = passing.opens()
                     ? messages::plan_message<"area-opens-just-before">(
                           place.lon_deg, place.lat_deg, spare_min, changes, under_way_h, error_pct)
                     : messages::plan_message<"area-closes-just-after">(
                           place.lon_deg, place.lat_deg, spare_min, changes, under_way_h, error_pct);
  return std::move(message).at(place);
}

}  // namespace floeplan::planning::publish
