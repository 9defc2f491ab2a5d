#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the grid, mesh or levels of a model.
namespace floeplan::messages {

inline constexpr auto ingest_grid_kinds = std::to_array<Kind>({
    {.code = "table-of-other-dimensions",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has dimensions that the currents do not have, so it cannot be used",
     .hint = "Ask the producer for the model's own output",
     .slots = {{{"variable", "angle"}}}},
    {.code = "grid-without-direction",
     .rank = Rank::caution,
     .text = "the positions in the file do not tell the direction of the model's grid, so its currents "
             "cannot be turned to east and north",
     .hint = "Ask the producer for a file with its tables of longitude and latitude"},
    {.code = "grid-mirrored",
     .rank = Rank::caution,
     .text = "the grid of the currents is mirrored or badly bent, so it is not known to which side its "
             "components point",
     .hint = "Ask the producer for the model's own output"},
    {.code = "grid-angle-contradicts",
     .rank = Rank::caution,
     .text = "the grid angle that the file states contradicts its tables of positions. One of them would "
             "turn the currents in the wrong direction",
     .hint = "Ask the producer which of them is right"},
    {.code = "level-heights-elsewhere",
     .rank = Rank::caution,
     .text = "the heights of the levels (\"{variable}\") are not given at the points and times of the "
             "currents, so the depths of the currents are not known",
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
     .text = "the levels \"{variable}\" are of the type {layout}, which this program does not read{where}",
     .hint = "Interpolate the data to depths in metres first",
     .slots =
         {{{"variable", "s_rho"}, {"layout", "ocean_double_sigma_coordinate"}, {"where", " on a mesh"}}}},
    {.code = "levels-incomplete",
     .rank = Rank::caution,
     .text = "the levels of \"{variable}\" follow the sea bed, but the file does not give {what}. The depths "
             "of its currents are therefore not known",
     .hint = "{advice}",
     .slots =
         {{{"variable", "uo"},
           {"what", "how deep the sea is (h)"},
           {"advice",
            "Give the model's grid file in the same command, or ask the producer for a complete file"}}}},
    {.code = "levels-no-shares",
     .rank = Rank::caution,
     .text = "the levels \"{variable}\" do not run from 0 at the surface to -1 at the sea bed, so their "
             "depths are not known",
     .hint = "Ask the producer for the model's own output",
     .slots = {{{"variable", "s_rho"}}}},
    {.code = "surface-not-stated",
     .rank = Rank::note,
     .text =
         "the file does not give the height of the sea surface, so its levels count from the mean surface"},
    {.code = "surface-impossible",
     .rank = Rank::caution,
     .text = "the sea surface in \"{variable}\" rises to {height} m, more than any tide. Its unit is wrong "
             "or the file is damaged",
     .hint = "Ask the producer",
     .slots = {{{"variable", "zeta"}, {"height", "99"}}}},
    {.code = "bed-impossible",
     .rank = Rank::caution,
     .text = "the sea in \"{variable}\" is {depth} m deep, deeper than any ocean. Its unit is wrong or the "
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
     .text = "the table of the mesh \"{variable}\" names nodes that do not exist, or fewer than three nodes "
             "for a face. The file is damaged",
     .hint = "Copy or download it again",
     .slots = {{{"variable", "nv"}}}},
    {.code = "mesh-not-described",
     .rank = Rank::caution,
     .text = "the file does not describe its mesh in longitude and latitude (the nodes, and the nodes round "
             "each face), so the places of the data are not known",
     .hint = "Ask the producer for a file by the UGRID conventions"},
    {.code = "mesh-too-large",
     .rank = Rank::caution,
     .text = "the mesh has {nodes} nodes, but this program accepts only 1 to {most}",
     .hint = "Cut out your area first",
     .slots = {{{"nodes", 90000000}, {"most", 20000000}}}},
    {.code = "mesh-node-off-the-earth",
     .rank = Rank::caution,
     .text = "a node of the mesh lies at longitude {longitude}, latitude {latitude}. The coordinates are not "
             "degrees, or the file is damaged",
     .hint = "Ask the producer",
     .slots = {{{"longitude", "900000"}, {"latitude", "7000000"}}}},
    {.code = "kept-at-own-points",
     .rank = Rank::note,
     .text = "every value is kept at the model's own {points} points ({layout}). Between these points the "
             "plan interpolates",
     .slots = {{{"points", 12000}, {"layout", "a bent grid"}}}},
    {.code = "cells-overlap",
     .rank = Rank::caution,
     .text =
         "the cells between the model's points overlap many times, so the positions in the file are damaged",
     .hint = "Copy or download the file again"},
    {.code = "staggering-unknown",
     .rank = Rank::caution,
     .text = "the two components of the current lie neither at the same points nor half a cell apart, so "
             "they cannot be combined",
     .hint = "Give two files of the same grid and the same part of it"},
    {.code = "components-of-other-shapes",
     .rank = Rank::caution,
     .text = "the two components of the current have grids of different sizes, and the file does not say "
             "where their points lie. They cannot be combined",
     .hint = "Ask the producer for a file with its tables of longitude and latitude"},
    {.code = "positions-enclose-no-area",
     .rank = Rank::caution,
     .text = "the positions in the file enclose no area, so nothing can be interpolated between them. The "
             "tables of longitude and latitude are empty or damaged",
     .hint = "Ask the producer for a complete file"},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_grid_message(const Given&... given) {
  return make_message<ingest_grid_kinds, code>(given...);
}

}  // namespace floeplan::messages
