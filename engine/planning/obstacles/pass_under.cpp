#include "engine/planning/obstacles/pass_under.hpp"

#include <algorithm>
#include <utility>

#include "engine/ocean/ice/iceberg_draft.hpp"

namespace floeplan::planning::obstacles {
namespace {

bool is_size_known(const ocean::Iceberg& iceberg) {
  const bool has_class =
      iceberg.size != ocean::IcebergSize::unknown && iceberg.size != ocean::IcebergSize::radar_target;
  return iceberg.draft || iceberg.length || has_class;
}

}  // namespace

PassUnder::PassUnder(const IcebergRules& rules, const vehicle::GliderProfile& vehicle,
                     std::shared_ptr<const BedCells> bed)
    : rules_{rules},
      bed_{std::move(bed)},
      needed_below_{vehicle.least_water_below_turn()},
      dive_room_{needed_below_ - vehicle.altimeter_margin},
      dive_depth_{vehicle.dive_depth} {}

std::optional<Keel> PassUnder::keel_of(const ocean::Iceberg& iceberg) const {
  if (!rules_.pass_under || !is_size_known(iceberg)) return std::nullopt;
  const core::Metres draft = ocean::safe_draft(iceberg);
  const core::Metres deepest{(1.0 + rules_.draft_uncertainty) * draft.value};
  const core::Metres upper_turn = deepest + rules_.keel_clearance;
  if (upper_turn + dive_room_ > dive_depth_) return std::nullopt;
  return Keel{draft, iceberg.draft.has_value(), deepest, upper_turn};
}

bool PassUnder::has_room(geo::PlanePoint point, core::Metres upper_turn) const {
  return !bed_ || bed_->is_deep_at(point, upper_turn + needed_below_);
}

bool PassUnder::has_room_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres upper_turn) const {
  return !bed_ || bed_->is_deep_along(a, b, upper_turn + needed_below_);
}

}  // namespace floeplan::planning::obstacles
