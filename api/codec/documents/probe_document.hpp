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

/// The data of the sea at one place and time. A missing value has its reason beside it.
struct Probe {
  struct Velocity {
    std::optional<geo::VelocityEn> velocity;
    std::string reason;  // why there is no velocity; otherwise empty
    std::string dataset_id;
    std::string dataset_name;
    std::optional<core::UtcTime> run;          // start of the model run; empty: unknown
    std::optional<core::UtcTime> time_before;  // steps of the data before and after the requested time
    std::optional<core::UtcTime> time_after;
  };
  struct Ice {
    std::optional<ocean::IceState> state;
    std::string reason;  // why there is no state; otherwise empty
    std::string dataset_id;
    std::string dataset_name;
    std::optional<core::UtcTime> run;          // start of the model run; empty: unknown
    std::optional<core::UtcTime> time_before;  // steps of the data before and after the requested time
    std::optional<core::UtcTime> time_after;
  };
  struct Tide {
    std::optional<core::Metres> elevation;    // elevation of the sea surface above its mean
    std::optional<geo::VelocityEn> velocity;  // velocity of the tidal current alone
    std::string reason;                       // why there is neither elevation nor velocity; otherwise empty
    std::vector<std::string> dataset_ids;     // datasets whose constants were used
    std::vector<std::string> dataset_names;
    std::vector<std::string> constituents;  // constituents used, including inferred ones
    // distance of the tide station in words, "12 km away"; empty: from a grid
    std::string station;
  };
  struct WaterLevel {
    std::optional<core::Metres> height;  // of the sea surface above the datum; below it if negative
    std::string datum;                   // in words: "lowest astronomical tide"
    std::string reason;                  // why there is no height; otherwise empty
    std::string dataset_id;
    std::string dataset_name;
    std::string station;  // name and distance of the station, "Miami, 12 km away"; empty: from a grid
    std::optional<core::UtcTime> time_before;  // steps of the data before and after the requested time
    std::optional<core::UtcTime> time_after;
  };
  struct HereZone {
    ocean::Zone zone;
    bool in_force{};  // at the requested time
    std::string dataset_id;
    std::string dataset_name;
  };
  struct NearIceberg {
    ocean::Iceberg iceberg;
    core::Metres distance;  // distance from the place to the sighted position
  };

  geo::LonLat place;
  core::UtcTime time;
  std::optional<core::Metres> depth;           // depth of the sea bed
  std::optional<core::Metres> shoalest_depth;  // least known depth around the place
  std::string depth_reason;                    // why there is no depth; otherwise empty
  std::optional<bool> land;                    // empty: no coastline and no bathymetry here
  std::string coastline;  // name of the dataset by which the place is land; empty: none says so
  Velocity currents;
  Velocity wind;  // 10 m above the sea; direction towards which the wind blows
  Ice ice;
  Tide tide;
  WaterLevel water_level;
  std::vector<NearIceberg> icebergs;  // nearest first
  std::vector<HereZone> zones;        // zones that contain the place, whether in force or not
};

[[nodiscard]] nlohmann::json probe_document(const Probe& probe);

}  // namespace floeplan::codec
