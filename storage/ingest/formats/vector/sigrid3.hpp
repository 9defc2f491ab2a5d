#pragma once

#include <optional>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/features/ice_chart_repository.hpp"

class OGRFeature;

namespace floeplan::ingest {

/// The largest amount of ice that the codes of a polygon allow.
struct IceOfPolygon {
  double concentration{};  // share of the sea surface, 0 to 1
  std::optional<double>
      thickness_m;  // of level ice; empty for ice without an upper limit of thickness, as old ice
};

/// An ice shelf counts as level ice of this thickness, so that no glider can dive below its keels. Chosen.
inline constexpr double ice_shelf_thickness_m = 1000.0;

/// Whether a feature has attributes of SIGRID-3, the WMO's exchange format for ice charts.
[[nodiscard]] bool states_ice_codes(const OGRFeature& feature);

/// Reads total concentration (CT), stages of development (SA, SB, SC, SD, CD, CN) and polygon type
/// (POLY_TYPE). A range counts as its upper end. A single tenth is a rounded number and counts as half a
/// tenth more.
/// Source   SIGRID-3: A Vector Archive Format for Sea Ice Georeferenced Information and Data, JCOMM Technical Report
///          23, code tables for concentration and stage of development
/// Returns  nullopt for land and for areas without observation
/// Errors   a code that is not in the tables
[[nodiscard]] Checked<std::optional<IceOfPolygon>> read_ice_codes(const OGRFeature& feature);

/// The egg code of a polygon as in the chart: concentration, stage of development and form of all ice and of
/// its parts, in the order of the egg. Codes that the chart leaves open are missing.
[[nodiscard]] std::vector<repository::IceCode> egg_code(const OGRFeature& feature);

}  // namespace floeplan::ingest
