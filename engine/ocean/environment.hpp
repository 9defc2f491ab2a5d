#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/messages/message.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "engine/ocean/ice/ice_field.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "engine/ocean/zone.hpp"

namespace floeplan::ocean {

/// All data on the sea in an area and a period: an immutable snapshot for one job.
/// A missing part (null, empty) means that there are no data or that the request left them out; the plan then
/// warns.
struct Environment {
  std::shared_ptr<const CurrentGrid> currents{};  // null: still water
  bool steady_currents{false};                    // `currents` has a single time that counts for every time
  /// First time of the stored currents; `currents` may hold only their later part. Empty: unknown, or steady.
  std::optional<core::UtcTime> currents_begin{};
  std::vector<std::shared_ptr<const CurrentGrid>> members{};  // of an ensemble, `currents` first; or empty
  /// The same currents over a wider area, from which icebergs may drift in, and down to the depth of their
  /// keels. Null:
  /// `currents` move the icebergs.
  std::shared_ptr<const CurrentGrid> drift_currents{};
  std::vector<std::shared_ptr<const CurrentGrid>> drift_members{};  // one for each of `members`, or empty
  /// Velocity of the air 10 m above the sea, towards which it blows, on a grid without depths; null: unknown.
  /// Its dataset is listed with kind "wind".
  std::shared_ptr<const CurrentGrid> wind{};
  std::shared_ptr<const Bathymetry> bathymetry{};
  std::shared_ptr<const IceField> ice{};  // null: no ice data, open water is assumed
  /// Ice of other products, the preferred one first. Used where and when `ice` has no value.
  std::vector<std::shared_ptr<const IceField>> further_ice{};
  std::vector<geo::Polygon> land{};
  std::vector<Iceberg> icebergs{};  // latest sighting of each berg, none later than requested
  std::vector<Zone> zones{};        // of stored datasets; all must be obeyed
  std::vector<DatasetRef> datasets{};
  std::vector<messages::Message> messages{};  // consequences of the choice of data, for the pilot
};

}  // namespace floeplan::ocean
