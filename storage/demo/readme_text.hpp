#pragma once

#include <string_view>

/// Texts of the file README.txt that is written beside the data.
namespace floeplan::demo {

inline constexpr std::string_view disko_readme =
    R"(Demonstration data: Disko Bay and Ilulissat Icefjord, West Greenland
=====================================================================
NOT FOR NAVIGATION. The depths, the currents, the sea ice and the icebergs are invented.

Real
  disko-coastline.geojson           GSHHG 2.3.7, full resolution, cut to 54.5W-50.5W, 68.4N-69.6N.
                                    Wessel and Smith 1996, doi:10.1029/96JB00104. Licence: LGPL.
                                    Glacier fronts have moved since it was drawn.

Invented ("synthetic" in every name and in the metadata of every file)
  disko-synthetic-bathymetry.tif    GeoTIFF, EPSG:4326, about 280 m, metres, positive up. Shaped from
                                    the distance to the real coast, with a trough across the bay, a
                                    sill before the icefjord and random roughness. It follows the big
                                    features of the bay by design; no sounding was used.
  disko-synthetic-currents.nc       NetCDF-4, CF-1.8, hourly for six days, about 1 km, six depths from
                                    0 to 400 m. A tide that turns every 6.2 hours, an anticlockwise
                                    circulation, the outflow of the icefjord and eddies, from stream
                                    functions. No ocean model was run.
  disko-synthetic-ice.nc            NetCDF-4, CF-1.8, daily for six days, about 1 km: concentration and
                                    thickness of a field of drift ice in the south of the bay, with a
                                    patch of open water in its middle. No ice was observed.
  disko-synthetic-icebergs.geojson  Sixty icebergs drawn at random. None of them was ever seen.

The invented files are in the public domain (CC0-1.0). The same seed and start time give the same bytes.

To use them:  floeplan ingest disko-synthetic-* disko-coastline.geojson
)";

inline constexpr std::string_view strait_readme =
    R"(Demonstration data: a tidal strait
===================================
NOT FOR NAVIGATION. Everything here is invented; there is no land in this place.

Two shores in the open water of Davis Strait, at 58.5W 64.2N, leave a narrows 5 km wide between two
basins. The tide in the narrows runs at up to 0.5 m/s, one and a half times the speed of a glider,
towards the east two hours after the start and towards the west six hours later; in the basins it is
weak. A plan through the narrows holds until the tide lets the vehicle through.

  strait-synthetic-bathymetry.tif     GeoTIFF, EPSG:4326, about 260 m, metres, positive up
  strait-synthetic-currents.nc        NetCDF-4, CF-1.8, hourly for six days, about 500 m: M2 and S2 from
                                      a stream function. No tide was predicted.
  strait-synthetic-coastline.geojson  the two shores

The files are in the public domain (CC0-1.0). The same seed and start time give the same bytes.

To use them:  floeplan ingest strait-synthetic-*
)";

inline constexpr std::string_view pack_ice_readme =
    R"(Demonstration data: below pack ice
===================================
NOT FOR NAVIGATION. Everything here is invented.

A belt of closed ice 80 km wide in Baffin Bay, at 64W 73N, with open water in the east and in the west.
A glider takes about three days from one side to the other. In three leads, 14 km by 28 km, it can surface
on the way. The ice and its leads drift southwards. Two icebergs lie on the straight line. South of them
the route is shortest, but the ice is closed for a whole day. A plan with a limit on the time between
surfacings (--max-time-without-surfacing PT12H) passes north of them, through the third lead.

  pack-ice-synthetic-bathymetry.tif     GeoTIFF, EPSG:4326, about 1 km, metres, positive up
  pack-ice-synthetic-currents.nc        NetCDF-4, CF-1.8, hourly for six days, about 1 km: a weak drift
                                        and four eddies from formulas. No forecast model was run.
  pack-ice-synthetic-ice.nc             NetCDF-4, CF-1.8, daily for six days: concentration and thickness.
                                        No ice was observed.
  pack-ice-synthetic-icebergs.geojson   Two icebergs. None of them was ever seen.
  pack-ice-synthetic-coastline.geojson  An island in the north-east. There is no land in this place.

The files are in the public domain (CC0-1.0). The same seed and start time give the same bytes.

To use them:  floeplan ingest pack-ice-synthetic-*
)";

inline constexpr std::string_view paper_readme =
    R"(Demonstration data: a current field of Eichhorn 2009 at sea scale
=================================================================
NOT FOR NAVIGATION. Everything here is invented.

The paper's test fields have no place on the map. Here their origin lies in Davis Strait at 57.0W
66.0N, the x axis points east, and they are enlarged to distances and speeds of a glider; the
comment in the NetCDF file states the scale.
  river  one unit of length is 100 m and one of speed 0.15 m/s: 30 km wide, steady, at most 0.27 m/s
         northwards
  jet    one unit of length is 5 km and one of speed 0.7 m/s: 110 km long, meandering, hourly for six
         days
The paper's vehicle makes 2.2 and 0.5 of its units: 0.33 m/s in the river, 0.35 m/s in the jet.
The sea bed is flat at 500 m.

The files are in the public domain (CC0-1.0). Source of the formulas: Eichhorn 2009, equations (1) to (4).

To use them:  floeplan ingest *-synthetic-*
)";

}  // namespace floeplan::demo
