#pragma once

#include <array>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/demo/flat_earth.hpp"

/// Places in Disko Bay and Ilulissat Icefjord around which the demonstration data are invented.
namespace floeplan::demo::disko {

constexpr geo::BoundingBox area{-54.5, 68.4, -50.5, 69.6};

/// The area of the coastline file. It is larger than the invented data, so that the land does not seem to end
/// with them.
constexpr geo::BoundingBox coast_area{-56.5, 67.9, -49.0, 70.1};
constexpr FlatEarth earth{69.0};

/// The moraine that closes the icefjord.
constexpr geo::LonLat sill{-51.10, 69.163};

/// The trough from the sill across the bay and past Aasiaat to the shelf.
constexpr std::array<geo::LonLat, 7> trough{{{-51.18, 69.165},
                                             {-51.70, 69.13},
                                             {-52.40, 69.02},
                                             {-53.05, 68.94},
                                             {-53.55, 68.86},
                                             {-54.00, 68.80},
                                             {-54.60, 68.70}}};
constexpr geo::LonLat egedesminde_deep{-53.85, 68.82};

/// A second trough: it leaves `trough` northwards into Vaigat.
constexpr std::array<geo::LonLat, 4> vaigat_trough{
    {{-51.75, 69.13}, {-51.75, 69.30}, {-51.70, 69.45}, {-51.66, 69.70}}};

/// Line of the outflow: the melt water leaves the fjord westwards, turns right and follows the coast into
/// Vaigat.
constexpr std::array<geo::LonLat, 11> outflow{{{-50.40, 69.180},
                                               {-50.75, 69.170},
                                               {-50.90, 69.155},
                                               {-51.00, 69.150},
                                               {-51.10, 69.162},
                                               {-51.30, 69.185},
                                               {-51.55, 69.235},
                                               {-51.72, 69.320},
                                               {-51.77, 69.420},
                                               {-51.70, 69.520},
                                               {-51.65, 69.700}}};

/// Middle of the field of drift ice at the start, south of where pilots usually fly.
constexpr geo::LonLat ice_field{-52.45, 68.96};

/// Where pilots usually fly; the invented icebergs leave it passable.
constexpr std::array<geo::LonLat, 2> corridor{{{-53.20, 69.20}, {-51.60, 69.20}}};

}  // namespace floeplan::demo::disko
