#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/simulation/logs/log_table.hpp"

namespace floeplan::simulation {

/// Columns that tell how the positions of a log are to be read, beside the positions themselves.
[[nodiscard]] std::vector<std::string_view> columns_that_tell_of_positions();

/// Brings the positions of a Slocum's log (m_lat, m_gps_lat, c_wpt_lat and their longitudes) to the vehicle's own
/// notation, packed degrees and minutes (see mission::unpack_degrees). The vehicle's unit "lat" means that notation, but
/// programs that convert logs leave it standing over decimal degrees.
/// Decides, in this order, for each pair of sensors
///  - the unit, where it says degrees or ddmm
///  - values that one notation alone can hold: beyond 90 or 180 no decimal degrees, with 60 minutes or more no packed
///    ones. Both at once are refused
///  - a pair that is decided, where one reading is ten times nearer to it; else one program writes one notation
///  - ways between rows, in one reading 60 times those in the other: against m_x_lmc and m_y_lmc, m_speed over the
///    time, and the fastest glider; x_lmc_utm_zone_digit
/// Edges    only within 2 degrees of 0 N 0 E packed numbers can be taken for others at all
/// Returns  what the pilot must know of positions that were taken for decimal degrees though the log's unit does not
///          say so
/// Errors   nothing decides, or the log contradicts itself
/// Source   masterdata (units lat and lon: DDMM.mmmm); dbdreader, whose decimalLatLon converts these sensors
[[nodiscard]] tl::expected<std::optional<std::string>, core::Violation> settle_positions(LogTable& log);

}  // namespace floeplan::simulation
