#pragma once

#include <memory>
#include <vector>

#include "engine/geo/polygon.hpp"
#include "engine/messages/message.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "engine/ocean/ice/ice_field.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "engine/ocean/zone.hpp"

namespace floeplan::ocean {

/// All that is known of the sea in an area and a period: an immutable snapshot for one job.
/// A missing part (null, empty) means that nothing is known or that the request left it out; the plan then
/// warns.
struct Environment {
  std::shared_ptr<const CurrentGrid> currents{};  // null: still water
  bool steady_currents{false};                    // `currents` holds one time, meant for every time
  std::vector<std::shared_ptr<const CurrentGrid>> members{};  // of an ensemble, `currents` first; else empty
  /// The same currents over a wider area, from which icebergs may drift in, and down to their keels; null:
  /// `currents` carry icebergs.
  std::shared_ptr<const CurrentGrid> drift_currents{};
  std::vector<std::shared_ptr<const CurrentGrid>> drift_members{};  // one for each of `members`, or empty
  /// Velocity of the air 10 m above the sea, towards which it blows, on a grid without depths; null: not known. Its
  /// dataset stands among the others, as kind "wind".
  std::shared_ptr<const CurrentGrid> wind{};
  std::shared_ptr<const Bathymetry> bathymetry{};
  std::shared_ptr<const IceField> ice{};  // null: nothing is known of sea ice, open water is assumed
  /// Ice of other products, the preferred one first. It counts where and when `ice` has no value.
  std::vector<std::shared_ptr<const IceField>> further_ice{};
  std::vector<geo::Polygon> land{};
  std::vector<Iceberg> icebergs{};  // the latest sighting of each berg, none after the moment asked for
  std::vector<Zone> zones{};        // of stored datasets, all obeyed
  std::vector<DatasetRef> datasets{};
  std::vector<messages::Message> messages{};  // what the choice of data implies, for the pilot
};

}  // namespace floeplan::ocean
