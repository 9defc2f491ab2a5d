#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/ocean/ice/ice_field.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "engine/ocean/zone.hpp"

namespace floeplan::codec {

/// What is known of the sea at one place and time. A value that is not known has a reason beside it.
struct Probe {
  struct Velocity {
    std::optional<geo::VelocityEn> velocity;
    std::string reason;  // empty when there is a velocity
    std::string dataset_id;
    std::string dataset_name;
    std::optional<core::UtcTime> run;          // when the model run began; empty: the data do not say
    std::optional<core::UtcTime> time_before;  // steps of the data around the time asked for
    std::optional<core::UtcTime> time_after;
  };
  struct Ice {
    std::optional<ocean::IceState> state;
    std::string reason;  // empty when there is a state
    std::string dataset_id;
    std::string dataset_name;
    std::optional<core::UtcTime> run;          // when the model run began; empty: the data do not say
    std::optional<core::UtcTime> time_before;  // steps of the data around the time asked for
    std::optional<core::UtcTime> time_after;
  };
  struct Tide {
    std::optional<core::Metres> elevation;    // of the sea surface above its mean
    std::optional<geo::VelocityEn> velocity;  // of the tidal current alone
    std::string reason;                       // empty when there is an elevation or a velocity
    std::vector<std::string> dataset_ids;     // whose constants were used
    std::vector<std::string> dataset_names;
    std::vector<std::string> constituents;  // that took part, inferred ones included
    std::string station;                    // "12 km away" in words: empty when from a grid
  };
  struct HereZone {
    ocean::Zone zone;
    bool in_force{};  // at the time asked for
    std::string dataset_id;
    std::string dataset_name;
  };
  struct NearIceberg {
    ocean::Iceberg iceberg;
    core::Metres distance;  // from the place to the sighted position
  };

  geo::LonLat place;
  core::UtcTime time;
  std::optional<core::Metres> depth;           // of the sea bed
  std::optional<core::Metres> shoalest_depth;  // the least depth known around the place
  std::string depth_reason;                    // empty when there is a depth
  std::optional<bool> land;                    // empty: no coastline and no bathymetry here
  std::string coastline;  // name of the dataset by which the place is land; empty: none says so
  Velocity currents;
  Velocity wind;  // 10 m above the sea, towards which it blows
  Ice ice;
  Tide tide;
  std::vector<NearIceberg> icebergs;  // nearest first
  std::vector<HereZone> zones;        // that hold the place, whenever they are in force
};

[[nodiscard]] nlohmann::json probe_document(const Probe& probe);

}  // namespace floeplan::codec
