#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/simulation/logs/log_table.hpp"

namespace floeplan::simulation {

/// Columns, besides the positions themselves, from which their notation can be decided.
[[nodiscard]] std::vector<std::string_view> columns_that_tell_of_positions();

/// Converts the positions of a Slocum's log (m_lat, m_gps_lat, c_wpt_lat and their longitudes) to the
/// vehicle's own notation, packed degrees and minutes (see mission::unpack_degrees). The vehicle's unit "lat"
/// means that notation, but programs that convert logs leave this unit above decimal degrees.
/// Decides, for each pair of sensors, by the first of these that applies:
/// - the unit, if it says degrees or ddmm
/// - values possible in only one notation: beyond 90 or 180 they are not decimal degrees, with 60 minutes or
///   more not packed. If both occur, the log is refused
/// - another pair that is decided: the reading that is ten times nearer to it; otherwise its notation,
///   because one program writes one notation
/// - distances between rows, which differ between the readings by a factor of 60: compared with m_x_lmc and
///   m_y_lmc, with m_speed times the time, and with the fastest glider; x_lmc_utm_zone_digit
/// Edges    packed numbers can be mistaken only within 2 degrees of 0 N 0 E
/// Returns  a note for the pilot if positions were taken for decimal degrees although the log's unit does not
///          say so
/// Errors   nothing decides, or the log contradicts itself
/// Source   masterdata (units lat and lon: DDMM.mmmm); dbdreader, whose decimalLatLon converts these sensors
[[nodiscard]] tl::expected<std::optional<std::string>, core::Violation> settle_positions(LogTable& log);

}  // namespace floeplan::simulation
