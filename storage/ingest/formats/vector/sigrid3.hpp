#pragma once

#include <optional>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/features/ice_chart_repository.hpp"

class OGRFeature;

namespace floeplan::ingest {

/// The most ice that the codes of a polygon allow.
struct IceOfPolygon {
  double concentration{};  // share of the sea surface, 0 to 1
  std::optional<double>
      thickness_m;  // of level ice; empty where there is ice without an upper bound: old ice
};

/// A level ice so thick that no glider dives below its keels: an ice shelf is closed to them, whatever its thickness.
inline constexpr double ice_shelf_thickness_m = 1000.0;

/// Whether a feature has the attributes of the WMO's exchange format of ice charts.
[[nodiscard]] bool states_ice_codes(const OGRFeature& feature);

/// Reads total concentration (CT), stages of development (SA, SB, SC, SD, CD, CN) and kind of polygon (POLY_TYPE). Of a
/// range its upper end, and of single tenths, which are rounded, half a tenth more.
/// Source   SIGRID-3: A Vector Archive Format for Sea Ice Georeferenced Information and Data, JCOMM Technical Report
///          23, code tables for concentration and stage of development
/// Returns  nothing of land and of what was not looked at
/// Errors   codes that the tables do not have
[[nodiscard]] Checked<std::optional<IceOfPolygon>> read_ice_codes(const OGRFeature& feature);

/// The egg code of a polygon as the chart has it: concentration, stage of development and form of all the ice and of its
/// parts, in the order of the egg, without those that the chart leaves open.
[[nodiscard]] std::vector<repository::IceCode> egg_code(const OGRFeature& feature);

}  // namespace floeplan::ingest
