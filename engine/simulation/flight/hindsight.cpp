#include "engine/simulation/flight/hindsight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/simulation/vehicle/glider_motion.hpp"

namespace floeplan::simulation {
namespace {

constexpr double look_s = 4.0;
constexpr core::Seconds span{1200.0};
constexpr int headings = 36;
constexpr double heading_step = 2.0 * std::numbers::pi / headings;
constexpr std::array changes_s{60.0, 180.0, 360.0};
/// Time before a collision with the sea bed or ice from which these count as seen. They are always within
/// sonar range, so this time replaces the range: it is as long as an iceberg is in range of a vehicle at its
/// speed.
constexpr core::Seconds bed_is_seen_before{600.0};

/// Tests which evasive routes are clear from one time of a flight on.
class Foresight {
 public:
  Foresight(const World& world, const TrackPoint& from, const ForesightSettings& settings)
      : world_{world}, from_{from}, settings_{settings} {
    const double reach_m = 3.0 * span.count() * settings.through_water.value + settings.sonar_range.value;
    for (const std::uint32_t i : world.bodies_near(from.position, reach_m, from.time, from.time + span))
      bodies_.push_back(&world.bodies()[i]);
  }

  /// Whether the vehicle meets nothing if it steers `first` until `change_s` and then `second`. Headings.
  [[nodiscard]] bool is_clear(double first, double change_s, double second) const {
    Vector place = from_.position;
    double heading = from_.attitude.heading_rad;
    const double speed = settings_.through_water.value;
    const double most_turn = speed / settings_.turn_radius.value * look_s;
    for (double since_s = look_s; since_s <= span.count(); since_s += look_s) {
      const double turn = wrapped_angle((since_s <= change_s ? first : second) - heading);
      heading += std::clamp(turn, -most_turn, most_turn);
      const core::UtcTime time = from_.time + core::Seconds{since_s};
      place.down = 0.5 * (settings_.shallowest.value + settings_.deepest.value);
      const Vector water = world_.current(place, time).value_or(Vector{});
      place = place + look_s * (Vector{speed * std::sin(heading), speed * std::cos(heading), 0.0} + water);
      if (touches(place, time)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool touches(Vector place, core::UtcTime time) const {
    const auto bed_m = world_.bed_depth_m(place.east, place.north);
    if (bed_m && *bed_m <= settings_.shallowest.value) return true;
    const double bottom_m = std::min(settings_.deepest.value, bed_m.value_or(settings_.deepest.value));
    return std::ranges::any_of(bodies_, [&](const Body* body) {
      const BodyPose pose = body->pose_at(time);
      for (const double down :
           {settings_.shallowest.value, 0.5 * (settings_.shallowest.value + bottom_m), bottom_m}) {
        const Vector at{place.east, place.north, down};
        if (body->least_distance(pose, at) <= settings_.hull_reach.value &&
            body->distance(pose, at) <= settings_.hull_reach.value)
          return true;
      }
      return false;
    });
  }

  const World& world_;
  const TrackPoint& from_;
  const ForesightSettings& settings_;
  std::vector<const Body*> bodies_;
};

const Body* touched_body(const World& world, const FlightRecord& record) {
  const auto contact =
      std::ranges::find(record.events.rbegin(), record.events.rend(), EventKind::contact, &FlightEvent::kind);
  if (contact == record.events.rend()) return nullptr;
  const auto body = std::ranges::find(world.bodies(), contact->text, &Body::name);
  return body != world.bodies().end() ? &*body : nullptr;
}

/// The first point of the track at which the touched object was within range.
const TrackPoint* first_seen(const World& world, const FlightRecord& record, core::Metres range) {
  const Body* const body = touched_body(world, record);
  const auto is_seen = [&](const TrackPoint& point) {
    if (body == nullptr) return record.finished - point.time <= bed_is_seen_before;
    const BodyPose pose = body->pose_at(point.time);
    return body->least_distance(pose, point.position) <= range.value &&
           body->distance(pose, point.position) <= range.value;
  };
  const auto seen = std::ranges::find_if(record.track, is_seen);
  return seen != record.track.end() ? &*seen : nullptr;
}

}  // namespace

std::optional<bool> could_be_saved(const World& world, const FlightRecord& record,
                                   const ForesightSettings& settings, const std::stop_token& stop) {
  if (record.end != FlightEnd::collided && record.end != FlightEnd::grounded) return std::nullopt;
  const TrackPoint* const from = first_seen(world, record, settings.sonar_range);
  if (from == nullptr) return false;
  const Foresight foresight{world, *from, settings};
  for (int first = 0; first < headings; ++first) {
    if (foresight.is_clear(first * heading_step, 0.0, first * heading_step)) return true;
  }
  for (const double change_s : changes_s) {
    for (int first = 0; first < headings && !stop.stop_requested(); ++first) {
      for (int second = 0; second < headings; ++second) {
        if (foresight.is_clear(first * heading_step, change_s, second * heading_step)) return true;
      }
    }
  }
  return false;
}

}  // namespace floeplan::simulation
