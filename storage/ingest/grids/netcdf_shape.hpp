#pragma once

#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/velocity_source.hpp"

namespace floeplan::ingest {

/// Times and levels of a source, from the layout of a NetCDF file. The caller adds the horizontal shape.
/// `follows_bed`  whether levels without depths can be placed relative to the sea bed
[[nodiscard]] inline SourceShape shape_in_time_and_depth(const NetcdfLayout& layout, bool follows_bed) {
  SourceShape shape;
  if (layout.times_s) shape.times_s = layout.times_s->nodes;
  if (layout.depths_m) {
    shape.depths_m = layout.depths_m->nodes;
    shape.levels = shape.depths_m->size();
  } else if (follows_bed) {
    shape.levels = layout.bed_levels;
    shape.levels_follow_bed = true;
  }
  return shape;
}

}  // namespace floeplan::ingest
