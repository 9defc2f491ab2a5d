#include "engine/simulation/logs/segment_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/messages/flight_fault_messages.hpp"
#include "engine/simulation/flight/flight.hpp"

namespace floeplan::simulation {
namespace {

/// Radius of a waypoint if the log gives none, because the vehicle did not reach it.
constexpr core::Metres unknown_radius{10.0};
/// A simulated flight that has not surfaced by this multiple of the logged time has failed.
constexpr double longest_share = 3.0;

MissionOrders orders_of(const LoggedSegment& segment) {
  MissionOrders orders;
  orders.name = "segment";
  for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
    GotoOrders list;
    list.waypoints = {segment.waypoints[i].place};
    list.radius = segment.waypoints[i].reached_within.value_or(unknown_radius);
    list.rows.legs = i + 1 < segment.waypoints.size() ? -2 : -1;
    list.next_on_board = true;
    orders.lists.push_back(list);
  }
  orders.yo.dive = {.depth = segment.turns_down_at,
                    .altitude = {},
                    .pitch_rad = segment.dive_pitch.value,
                    .buoyancy_m3 = segment.dive_buoyancy.value};
  orders.yo.climb = {.depth = segment.turns_up_at,
                     .altitude = {},
                     .pitch_rad = segment.climb_pitch.value,
                     .buoyancy_m3 = segment.climb_buoyancy.value};
  orders.surfaces.push_back({.cause = SurfaceOrders::Cause::every,
                             .interval = segment.until_ascent,
                             .ends_mission = true,
                             .climb = orders.yo.climb});
  return orders;
}

/// The parasite drag for which the steady glide has the log's vertical speed (root mean square of climb and
/// dive).
std::optional<double> fitting_drag(const LoggedSegment& segment, const vehicle::GliderProfile& vehicle) {
  constexpr double least = 0.02;
  constexpr double most = 1.0;
  const double rate_m_s = std::sqrt(
      0.5 * (segment.sinks.value * segment.sinks.value + segment.rises.value * segment.rises.value));
  const core::Radians pitch{0.5 * (segment.climb_pitch.value - segment.dive_pitch.value)};
  const core::CubicMetres buoyancy{0.5 * (segment.climb_buoyancy.value - segment.dive_buoyancy.value)};
  const auto too_fast = [&](double drag) {
    vehicle::Hydrodynamics hydrodynamics = vehicle.hydrodynamics;
    hydrodynamics.parasite_drag = drag;
    const auto glide = vehicle::steady_glide(hydrodynamics, pitch, buoyancy);
    return glide && glide->vertical.value > rate_m_s;
  };
  if (!too_fast(least) || too_fast(most)) return std::nullopt;
  double low = least;
  double high = most;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (too_fast(middle) ? low : high) = middle;
  }
  return low;
}

double net_speed(Vector way, core::Seconds duration, geo::VelocityEn current) {
  return std::hypot(way.east / duration.count() - current.east.value,
                    way.north / duration.count() - current.north.value);
}

const FlightEvent* first_of(const FlightRecord& record, EventKind kind) {
  const auto found = std::ranges::find(record.events, kind, &FlightEvent::kind);
  return found == record.events.end() ? nullptr : &*found;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

double median_deviation(std::span<const SegmentComparison> comparisons,
                        Compared SegmentComparison::* quantity) {
  std::vector<double> shares;
  for (const SegmentComparison& comparison : comparisons)
    shares.push_back(std::abs((comparison.*quantity).deviation_share()));
  return median(std::move(shares));
}

}  // namespace

double Compared::deviation_share() const { return (simulated - logged) / logged; }

tl::expected<SegmentComparison, core::Violations> compare_segment(const LoggedSegment& segment,
                                                                  const vehicle::GliderProfile& vehicle,
                                                                  const HullMotion& hull, DragOf drag) {
  const geo::LocalProjection projection{segment.start};
  const geo::PlaneVelocity current = projection.to_plane(segment.depth_averaged, segment.start);
  const World world{{.origin = segment.start,
                     .bed = {},
                     .ice = {},
                     .current = TrueCurrent{Vector{current.x_m_s, current.y_m_s, 0.0}, {}},
                     .bodies = {}}};
  const MissionOrders orders = orders_of(segment);
  FlightRequest request{.world = world,
                        .orders = orders,
                        .vehicle = vehicle,
                        .start = segment.start,
                        .departure = segment.dived,
                        .settings = {},
                        .seed = 0};
  if (drag == DragOf::log) {
    if (const auto fitting = fitting_drag(segment, vehicle))
      request.vehicle.hydrodynamics.parasite_drag = *fitting;
  }
  request.settings.hull = hull;
  request.settings.hull.trim = hull.trim + segment.trim();
  request.settings.navigation = {.compass = {0.0}, .speed_share = 0.0, .fix = {0.0}, .current = {0.0}};
  request.settings.first_fix = segment.fixed - segment.surfaced;
  request.settings.longest = longest_share * segment.under_water();
  request.settings.known_current = segment.reckoned_with;
  request.settings.record_every = core::Seconds{3600.0};  // the events contain all that is compared
  if (auto found = violations(request); !found.empty()) return tl::unexpected(std::move(found));
  BareVehicle bare;
  const FlightRecord record = fly(request, bare);

  const FlightEvent* surfacing = first_of(record, EventKind::surfacing);
  const FlightEvent* fix = first_of(record, EventKind::fix);
  if (surfacing == nullptr || fix == nullptr)
    return tl::unexpected(
        core::Violations{messages::flight_fault<"did-not-come-up">("/segment", record.end_reason)});
  const Vector end = world.to_frame(segment.end);
  const core::Seconds simulated = surfacing->time - segment.dived;
  const auto turns = std::ranges::count(record.events, EventKind::inflection, &FlightEvent::kind);

  // The distance to the first fix is covered under water and then drifting at the surface, in the same
  // current.
  const core::Seconds logged_way = segment.fixed - segment.dived;
  const core::Seconds simulated_way = fix->time - segment.dived;
  const double over_ground_m = std::hypot(end.east, end.north);
  SegmentComparison comparison;
  comparison.under_water_s = {segment.under_water().count(), simulated.count()};
  comparison.dives = {static_cast<double>(segment.dives), 1.0 + std::floor(0.5 * static_cast<double>(turns))};
  comparison.speed_m_s = {net_speed(end, logged_way, segment.depth_averaged),
                          net_speed(fix->position, simulated_way, segment.depth_averaged)};
  comparison.over_ground_m = {over_ground_m, std::hypot(fix->position.east, fix->position.north)};
  comparison.apart_m = std::hypot(fix->position.east - end.east, fix->position.north - end.north);
  comparison.apart_share = comparison.apart_m / over_ground_m;
  comparison.parasite_drag = request.vehicle.hydrodynamics.parasite_drag;
  comparison.ended = record.end_reason;
  return comparison;
}

bool ComparisonSummary::within_a_tenth() const {
  return std::max({under_water_share, dives_share, speed_share, apart_share}) <= 0.1;
}

ComparisonSummary summary_of(std::span<const SegmentComparison> comparisons) {
  std::vector<double> apart;
  std::vector<double> drags;
  for (const SegmentComparison& comparison : comparisons) {
    apart.push_back(comparison.apart_share);
    drags.push_back(comparison.parasite_drag);
  }
  return {.under_water_share = median_deviation(comparisons, &SegmentComparison::under_water_s),
          .dives_share = median_deviation(comparisons, &SegmentComparison::dives),
          .speed_share = median_deviation(comparisons, &SegmentComparison::speed_m_s),
          .apart_share = median(std::move(apart)),
          .parasite_drag = median(std::move(drags))};
}

}  // namespace floeplan::simulation
