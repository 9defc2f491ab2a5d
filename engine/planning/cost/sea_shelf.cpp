#include "engine/planning/cost/currents_shelf.hpp"

#include <algorithm>
#include <utility>

#include "engine/planning/cost/sea_layout.hpp"

namespace floeplan::planning::cost {

CurrentsShelf::Key CurrentsShelf::key_of(const PlanRequest& request, const geo::LocalProjection& projection,
                                         const plane::PlaneBox& area) const {
  Key key{.origin = projection.origin(),
          .area = area,
          .epoch = request.depart,
          .limits = request.vehicle.dive_limits(),
          .below_ice = {}};
  if (environment_.ice) {
    key.below_ice = {.max_concentration_to_surface = request.under_ice.max_concentration_to_surface,
                     .margin = request.under_ice.margin_below_ice,
                     .draft_if_unknown = request.under_ice.draft_if_unknown};
  }
  return key;
}

bool CurrentsShelf::holds(const PlanRequest& request, const geo::LocalProjection& projection,
                          const plane::PlaneBox& area) const {
  return std::ranges::find(kept_, key_of(request, projection, area), &Kept::key) != kept_.end();
}

std::shared_ptr<const currents::PlaneCurrents> CurrentsShelf::take(
    const PlanRequest& request, const currents::FlownDepths& depths, const ice::UnderIce* ice,
    const geo::LocalProjection& projection, const plane::PlaneBox& area, const std::stop_token& stop) {
  Kept taken{.key = key_of(request, projection, area), .currents = {}};
  const auto found = std::ranges::find(kept_, taken.key, &Kept::key);
  if (found != kept_.end()) {
    taken = std::move(*found);
    kept_.erase(found);
  } else {
    taken.currents = lay_out_currents(environment_, request, depths, ice, projection, area, stop);
    if (stop.stop_requested()) return taken.currents;  // incomplete: must not be kept
    if (kept_.size() == most_kept) kept_.pop_back();
  }
  kept_.push_front(taken);
  return taken.currents;
}

}  // namespace floeplan::planning::cost
