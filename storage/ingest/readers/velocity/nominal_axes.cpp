#include "storage/ingest/readers/velocity/nominal_axes.hpp"

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double bent_above_lat_deg = 60.0;  // with a margin of some degrees

}  // namespace

std::optional<std::string> doubt_in_nominal_axes(const VelocityPair& pair, double northernmost_deg) {
  if (pair.axes != VelocityAxes::grid || northernmost_deg <= bent_above_lat_deg) return std::nullopt;
  return "the components \"" + pair.first->name() + "\" and \"" + pair.second->name() +
         "\" point along the axes of the model's grid, and up to latitude " + number(northernmost_deg) +
         " the grid of a global model is bent round poles on land, so that its axes are not east and north; "
         "give "
         "the model's file of positions (geolon_c and geolat_c, or nav_lon and nav_lat) in the same command, "
         "or "
         "cut out the part south of " +
         number(bent_above_lat_deg) + " degrees";
}

}  // namespace floeplan::ingest
