#include "engine/simulation/flight/contact_watch.hpp"

namespace floeplan::simulation {

ContactWatch::ContactWatch(const World& world, core::Metres reach, core::Metres hull_reach)
    : world_{world}, reach_m_{reach.value}, hull_reach_m_{hull_reach.value}, bodies_(world.bodies().size()) {}

void ContactWatch::note(Nearest& nearest, const std::string& to, double distance_m, Vector place,
                        core::UtcTime time) const {
  if (nearest.seen && distance_m >= nearest.approach.distance_m) return;
  if (!nearest.seen) nearest.approach.to = to;
  nearest.seen = true;
  nearest.approach.distance_m = distance_m;
  nearest.approach.time = time;
  nearest.approach.position = place;
}

std::optional<Contact> ContactWatch::look(Vector place, core::UtcTime time, NearbyBodies& near) {
  std::optional<Contact> touched;
  for (const NearbyBodies::Posed& posed : near.at(place, time)) {
    Nearest& nearest = bodies_[posed.index];
    const double bound_m = nearest.seen ? nearest.approach.distance_m : reach_m_;
    if (posed.body->least_distance(posed.pose, place) >= bound_m) continue;
    const double distance_m = posed.body->distance(posed.pose, place);
    if (distance_m >= bound_m) continue;
    note(nearest, posed.body->name(), distance_m, place, time);
    if (distance_m <= hull_reach_m_ && !touched) touched = Contact{FlightEnd::collided, posed.body->name()};
  }
  const double ice_m = world_.ice_draft_m(place.east, place.north, time);
  if (ice_m > 0.0) {
    note(ice_, "sea ice", place.down - ice_m, place, time);
    if (place.down <= ice_m && !touched) touched = Contact{FlightEnd::collided, "sea ice"};
  }
  if (const auto bed_m = world_.bed_depth_m(place.east, place.north)) {
    note(bed_, "sea bed", *bed_m - place.down, place, time);
    if (place.down >= *bed_m && !touched) touched = Contact{FlightEnd::grounded, "sea bed"};
  }
  return touched;
}

std::vector<ClosestApproach> ContactWatch::approaches() const {
  std::vector<ClosestApproach> all;
  if (bed_.seen) all.push_back(bed_.approach);
  if (ice_.seen) all.push_back(ice_.approach);
  for (const Nearest& nearest : bodies_) {
    if (nearest.seen) all.push_back(nearest.approach);
  }
  return all;
}

}  // namespace floeplan::simulation
