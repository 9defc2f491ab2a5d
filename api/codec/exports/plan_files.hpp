#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/mission/writing/shoals.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::codec {

/// The plan's waypoints as a table for spreadsheets (RFC 4180 without quoting, LF): a header whose names
/// state the units, then one row per waypoint, the start first. Unknown values are empty cells.
[[nodiscard]] std::string plan_csv(const planning::Plan& plan);

/// A stored plan for map programs: a GeoJSON FeatureCollection of the route (from plan_feature), followed by
/// its waypoints as Points, in order, whose properties are their rows in the plan document.
/// Errors   std::runtime_error or nlohmann::json::exception when the stored document is not a plan
[[nodiscard]] nlohmann::json plan_geojson(const repository::PlanRecord& plan);

/// The plan as a GPX 1.1 route for chart plotters: every waypoint, including the start, with its time of
/// arrival. UTF-8; control characters in the name are dropped, because XML cannot represent them.
/// Frame    WGS84 degrees, seven decimals (1 cm), longitudes in [-180, 180)
/// Source   Topografix, GPX 1.1 schema
[[nodiscard]] std::string plan_gpx(const planning::Plan& plan, const std::string& plan_id,
                                   const std::string& name);

/// The plan as KML 2.2: the route as a line on the sea's surface and a placemark for each waypoint with its time of
/// arrival. UTF-8.
/// Frame    WGS84 degrees, seven decimals, longitude first; longitudes continue beyond 180 across the
///          antimeridian
/// Source   Open Geospatial Consortium 12-007r2, KML 2.3; only parts that exist in KML 2.2 are used
[[nodiscard]] std::string plan_kml(const planning::Plan& plan, const std::string& plan_id,
                                   const std::string& name);

/// The plan as an IMC message PlanSpecification in JSON, which Neptus and related programs read. It has a Goto for
/// every place but the start; the next manoeuvre follows when one is done. Where the plan holds and the vehicle may
/// surface, it has a StationKeeping, which brings the vehicle to the surface.
/// Units    latitude and longitude in radians (WGS84), z as depth in metres, speed in m/s, timeouts in seconds
/// Depth    the depth to which the vehicle dives. Where the shoalest place of a leg is known, the depth is at
///          least the vehicle's altimeter margin above the sea bed there
/// `shoals` shoalest place of each leg, from mission::shoals_along; empty: only the depths at the waypoints are
///          known
/// Timeout  twice as long as the plan takes; legs of more than 8 h are divided, as IMC's timeouts end at 65535 s
/// `hold_radius` radius of the circle in which the vehicle holds
/// Source   LSTS, IMC message definitions (Goto, StationKeeping, PlanManeuver, PlanTransition, PlanSpecification; enumerations ZUnits
///          and SpeedUnits), and the plan of two Gotos in LSTS's description of how vehicles and Neptus talk
[[nodiscard]] std::string plan_imc(const planning::Plan& plan, const vehicle::GliderProfile& vehicle,
                                   const std::vector<std::optional<mission::Shoal>>& shoals,
                                   core::Metres hold_radius, const std::string& plan_id,
                                   const std::string& name, core::UtcTime generated);

}  // namespace floeplan::codec
