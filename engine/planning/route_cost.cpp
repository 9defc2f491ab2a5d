#include "engine/planning/route_cost.hpp"

namespace floeplan::planning {
namespace {

constexpr int pieces_to_locate = 256;  // of a closed leg, to tell the pilot where on it the trouble begins

RouteClosed locate(const Sea& sea, geo::PlanePoint from, geo::PlanePoint to, core::Seconds depart,
                   core::Seconds since_surfacing, motion::EdgeClosed reason) {
  geo::PlanePoint here = from;
  core::Seconds now = depart;
  for (int i = 1; i <= pieces_to_locate; ++i) {
    const double share = static_cast<double>(i) / pieces_to_locate;
    const geo::PlanePoint next{from.x_m + share * (to.x_m - from.x_m),
                               from.y_m + share * (to.y_m - from.y_m)};
    const auto leg = sea.leg(here, next, now, since_surfacing);
    if (!leg) {
      const bool out_of_time = leg.error() == motion::EdgeClosed::outside_data &&
                               !sea.safety().closed_between(here, next) && sea.currents_known(next, now);
      return {leg.error(), here, now, out_of_time};
    }
    here = next;
    now += leg->time;
    since_surfacing = leg->since_surfacing;
  }
  return {reason, here, now, false};
}

}  // namespace

tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing) {
  std::vector<core::Seconds> arrivals{depart};
  for (std::size_t i = 1; i < route.size(); ++i) {
    const auto leg = sea.leg(route[i - 1], route[i], arrivals.back(), since_surfacing);
    if (!leg) {
      return tl::unexpected(
          locate(sea, route[i - 1], route[i], arrivals.back(), since_surfacing, leg.error()));
    }
    arrivals.push_back(arrivals.back() + leg->time);
    since_surfacing = leg->since_surfacing;
  }
  return arrivals;
}

}  // namespace floeplan::planning
