#include "engine/planning/cost/planning_domain.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/planning/cost/sea_layout.hpp"

namespace floeplan::planning::cost {

PlanningDomain::PlanningDomain(const ocean::Environment& environment, const PlanRequest& request,
                               const geo::LocalProjection& projection, const plane::PlaneBox& area,
                               core::Metres cell, const std::stop_token& stop, SeaShelf* shelf)
    : PlanningDomain{environment,
                     request,
                     lay_out_zones(environment, request),
                     projection,
                     area,
                     cell,
                     stop,
                     shelf != nullptr ? *shelf : *std::make_unique<SeaShelf>()} {}

PlanningDomain::PlanningDomain(const ocean::Environment& environment, const PlanRequest& request,
                               obstacles::ZoneRules zones, const geo::LocalProjection& projection,
                               const plane::PlaneBox& area, core::Metres cell, const std::stop_token& stop,
                               SeaShelf& shelf)
    : projection_{projection},
      lengths_{projection, area},
      bed_{shelf.bed_below(environment, request, projection, area, cell, stop)},
      safety_{environment,
              request.vehicle.least_water(),
              std::move(zones.standing),
              projection,
              area,
              cell,
              bed_.get(),
              stop},
      timed_zones_{lay_out_timed_zones(zones.timed, request, projection, area)},
      overhead_{lay_out_ice(environment, request, projection, area, cell, bed_, stop),
                shelf.icebergs(environment, request, projection, area, bed_, stop),
                request.under_ice.max_time_without_surfacing},
      depths_{request.vehicle.dive_limits(), environment.bathymetry},
      currents_{
          shelf.currents(environment, request, depths_, ice() ? &*ice() : nullptr, projection, area, stop)} {
  if (!request.icebergs.pass_under && !(ice() && ice()->has_dense_ice())) bed_.reset();
}

bool PlanningDomain::currents_known_to_end(geo::PlanePoint point, core::Seconds from) const {
  constexpr int looks = 64;
  if (!currents_) return true;
  const core::Seconds end = currents_->end().value_or(from);
  for (int i = 0; i <= looks; ++i) {
    const double share = static_cast<double>(i) / looks;
    if (!(*currents_)(point, from + share * std::max(core::Seconds{0.0}, end - from))) return false;
  }
  return true;
}

bool PlanningDomain::is_steady() const {
  // Ice changes with time; even a single ice map is valid for some days only.
  const bool ice_matters = ice() && (ice()->has_dense_ice() || overhead_.bounds_surfacing());
  return !closures().any_timed() && (!currents_ || !currents_->end()) && !ice_matters;
}

std::size_t PlanningDomain::bytes() const {
  const std::size_t of_bed = bed_ ? bed_->bytes() : 0;
  return safety_.bytes() + icebergs().bytes() + of_bed + (ice() ? ice()->bytes() : 0) +
         (currents_ ? currents_->bytes() : 0);
}

}  // namespace floeplan::planning::cost
