#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/flight/flight_record.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// An object that the hull touches.
struct Contact {
  FlightEnd kind{};  // collided or grounded
  std::string with;
};

/// Records how close a vehicle comes to the sea bed, the ice and the bodies, and detects contacts.
class ContactWatch {
 public:
  /// `world` is borrowed. Bodies that never come within `reach` are not reported.
  ContactWatch(const World& world, core::Metres reach, core::Metres hull_reach);

  /// The first contact at this place and time: bodies before ice before bed; empty: none.
  [[nodiscard]] std::optional<Contact> look(Vector place, core::UtcTime time, NearbyBodies& near);
  /// Closest approaches: sea bed, ice, then each body that was within reach, by index.
  [[nodiscard]] std::vector<ClosestApproach> approaches() const;

 private:
  struct Nearest {
    bool seen{};
    ClosestApproach approach{};
  };
  void note(Nearest& nearest, const std::string& to, double distance_m, Vector place,
            core::UtcTime time) const;

  const World& world_;
  double reach_m_;
  double hull_reach_m_;
  Nearest bed_;
  Nearest ice_;
  std::vector<Nearest> bodies_;
};

}  // namespace floeplan::simulation
