#pragma once

#include <string>

#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The plan as KML 2.2: the route as a line on the sea's surface and a placemark for each waypoint with its time of
/// arrival. UTF-8.
/// Frame    WGS84 degrees, seven decimals, longitude first; longitudes run on past 180 where the route does
/// Source   Open Geospatial Consortium 12-007r2, KML 2.3, of which this is the part that 2.2 has too
[[nodiscard]] std::string plan_kml(const planning::Plan& plan, const std::string& plan_id,
                                   const std::string& name);

}  // namespace floeplan::codec
