#include "engine/planning/route_cost.hpp"

namespace floeplan::planning {
namespace {

constexpr int pieces_to_locate = 256;  // of a closed leg, to tell the pilot where on it the trouble begins

RouteClosed locate(const Sea& sea, geo::PlanePoint from, geo::PlanePoint to, core::Seconds depart,
                   motion::EdgeClosed reason) {
  geo::PlanePoint here = from;
  core::Seconds now = depart;
  for (int i = 1; i <= pieces_to_locate; ++i) {
    const double share = static_cast<double>(i) / pieces_to_locate;
    const geo::PlanePoint next{from.x_m + share * (to.x_m - from.x_m),
                               from.y_m + share * (to.y_m - from.y_m)};
    const auto time = sea.leg_time(here, next, now);
    if (!time) {
      const bool out_of_time = time.error() == motion::EdgeClosed::outside_data &&
                               !sea.safety().closed_between(here, next) && sea.currents_known(next, now);
      return {time.error(), here, now, out_of_time};
    }
    here = next;
    now += *time;
  }
  return {reason, here, now, false};
}

}  // namespace

tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart) {
  std::vector<core::Seconds> arrivals{depart};
  for (std::size_t i = 1; i < route.size(); ++i) {
    const auto time = sea.leg_time(route[i - 1], route[i], arrivals.back());
    if (!time) {
      return tl::unexpected(locate(sea, route[i - 1], route[i], arrivals.back(), time.error()));
    }
    arrivals.push_back(arrivals.back() + *time);
  }
  return arrivals;
}

}  // namespace floeplan::planning
