#pragma once

#include "engine/messages/kind.hpp"

/// What a pilot is told of the grid, mesh or levels of a model.
namespace floeplan::messages {

inline constexpr auto ingest_grid_kinds = std::to_array<Kind>({
    {.code = "table-of-other-dimensions",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has dimensions that the currents do not have: it cannot be used",
     .hint = "Ask the producer for the model's own output",
     .slots = {{{"variable", "angle"}}}},
    {.code = "grid-without-direction",
     .rank = Rank::caution,
     .text = "the positions in the file tell no direction of the model's grid: its currents cannot be "
             "turned to east and north",
     .hint = "Ask the producer for a file with its tables of positions"},
    {.code = "grid-mirrored",
     .rank = Rank::caution,
     .text = "the grid of the currents is mirrored or badly bent: its second axis does not lie to the left "
             "of its first. It is not known to which side its components point",
     .hint = "Ask the producer for the model's own output"},
    {.code = "grid-angle-contradicts",
     .rank = Rank::caution,
     .text = "the angle of the grid that the file states contradicts its own tables of positions: the drift "
             "would be turned by the difference",
     .hint = "Ask the producer which of them is right"},
    {.code = "level-heights-elsewhere",
     .rank = Rank::caution,
     .text = "the heights of the levels (\"{variable}\") do not lie on the points and times of the "
             "currents, so their depths are not known",
     .hint = "Ask the producer for the model's own output",
     .slots = {{{"variable", "zcor"}}}},
    {.code = "level-heights-without-length",
     .rank = Rank::caution,
     .text = "the heights of the levels (\"{variable}\") have the unit \"{unit}\", which is not a known "
             "length",
     .hint = "Ask for a file in metres",
     .slots = {{{"variable", "zcor"}, {"unit", "furlong"}}}},
    {.code = "levels-of-unknown-layout",
     .rank = Rank::caution,
     .text = "the levels \"{variable}\" are an {layout}, which this program does not read{where}",
     .hint = "Interpolate the data to depths in metres first",
     .slots =
         {{{"variable", "s_rho"}, {"layout", "ocean_double_sigma_coordinate"}, {"where", " on a mesh"}}}},
    {.code = "levels-incomplete",
     .rank = Rank::caution,
     .text = "the levels of \"{variable}\" follow the sea bed, but the file does not tell {what}, so the "
             "depths of its currents are not known",
     .hint = "{advice}",
     .slots =
         {{{"variable", "uo"},
           {"what", "how deep the sea is (h)"},
           {"advice",
            "Give the model's grid file in the same command, or ask the producer for a complete file"}}}},
    {.code = "levels-no-shares",
     .rank = Rank::caution,
     .text = "the levels \"{variable}\" do not run from 0 at the surface to -1 at the bed: they cannot be "
             "placed",
     .hint = "Ask the producer for the model's own output",
     .slots = {{{"variable", "s_rho"}}}},
    {.code = "surface-not-stated",
     .rank = Rank::note,
     .text = "the file does not give the surface of the sea; its levels were placed below the mean surface"},
    {.code = "surface-impossible",
     .rank = Rank::caution,
     .text = "the surface of the sea in \"{variable}\" rises to {height} m, more than any tide: its unit is "
             "wrong or the file is damaged",
     .hint = "Ask the producer",
     .slots = {{{"variable", "zeta"}, {"height", "99"}}}},
    {.code = "bed-impossible",
     .rank = Rank::caution,
     .text = "the sea in \"{variable}\" is {depth} m deep, deeper than any ocean: its unit is wrong or the "
             "file is damaged",
     .hint = "Ask the producer",
     .slots = {{{"variable", "h"}, {"depth", "99999"}}}},
    {.code = "mesh-of-many-corners",
     .rank = Rank::caution,
     .text =
         "the mesh \"{variable}\" has faces of more than {most} corners, which this program does not read",
     .hint = "Interpolate the data to a regular grid, or split such faces into triangles first",
     .slots = {{{"variable", "nv"}, {"most", 12}}}},
    {.code = "mesh-damaged",
     .rank = Rank::caution,
     .text = "the table of the mesh \"{variable}\" names nodes that do not exist or has not three or more "
             "for each face: the file is damaged",
     .hint = "Copy or download it again",
     .slots = {{{"variable", "nv"}}}},
    {.code = "mesh-not-described",
     .rank = Rank::caution,
     .text = "the file does not describe its mesh in longitude and latitude (nodes, and the nodes round "
             "each face): the data cannot be placed",
     .hint = "Ask the producer for a file by the UGRID conventions"},
    {.code = "mesh-too-large",
     .rank = Rank::caution,
     .text = "the mesh has {nodes} nodes; this program accepts 1 to {most}",
     .hint = "Cut out your area first",
     .slots = {{{"nodes", 90000000}, {"most", 20000000}}}},
    {.code = "mesh-node-off-the-earth",
     .rank = Rank::caution,
     .text = "a node of the mesh lies at longitude {longitude}, latitude {latitude}: the coordinates are "
             "not degrees or the file is damaged",
     .hint = "Ask the producer",
     .slots = {{{"longitude", "900000"}, {"latitude", "7000000"}}}},
    {.code = "kept-at-own-points",
     .rank = Rank::note,
     .text = "every value is kept at the model's own {points} points ({layout}); between them values are "
             "interpolated when they are used",
     .slots = {{{"points", 12000}, {"layout", "a bent grid"}}}},
    {.code = "cells-overlap",
     .rank = Rank::caution,
     .text = "the cells between the model's points lie over one another many times over: its positions are "
             "damaged",
     .hint = "Copy or download the file again"},
    {.code = "staggering-unknown",
     .rank = Rank::caution,
     .text = "the points of the two components of the current fit no known arrangement (both at the same "
             "points, or each half a cell beside the other): they cannot be put together",
     .hint = "Give the two files of the same grid and the same part of it"},
    {.code = "components-of-other-shapes",
     .rank = Rank::caution,
     .text = "the two components of the current have shapes that do not fit each other, and the file does "
             "not say where their points lie: they cannot be put together",
     .hint = "Ask the producer for a file with its tables of positions"},
    {.code = "positions-enclose-no-area",
     .rank = Rank::caution,
     .text = "the positions in the file enclose no area, so nothing can be interpolated between them: the "
             "tables of longitude and latitude are empty or damaged",
     .hint = "Ask the producer for a complete file"},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message ingest_grid_message(const Given&... given) {
  return make_message<ingest_grid_kinds, code>(given...);
}

}  // namespace floeplan::messages
