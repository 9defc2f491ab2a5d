#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Whether a header line is that of a table of icebergs other than the International Ice Patrol's.
[[nodiscard]] bool is_iceberg_table_header(const std::string& line);
/// Whether a JSON text begins like the list of positions of Brigham Young University (BYU).
[[nodiscard]] bool is_iceberg_list_json(std::string_view head);

/// Icebergs out of a table, told by its columns:
///  - the list of the US National Ice Center, with and without areas and remarks: lengths in nautical miles, one
///  position
///    for each berg, dates M/D/YYYY. A berg that its remarks call grounded has the shape "grounded"
///  - a consolidated track of BYU and the Ice Center: one berg, named by the file; days YYYYDDD; for each sensor
///  latitude,
///    longitude and whether it was seen (1) or interpolated (0), all zero where missing. A day makes one sighting: seen
///    before interpolated, then in the order of the sensors. A size holds until the next one is stated
///  - a beacon's track of the Canadian Ice Service: times with their zone, and the class of the Argos position
/// A bad row is left out and counted.
/// Source   accuracy of Argos classes 3, 2 and 1: Argos User's Manual (CLS), 250, 500 and 1500 m; worse ones count as
///          1500 m, the least they can be
[[nodiscard]] Checked<PreparedDataset> read_iceberg_table(const std::filesystem::path& file);

/// The list of current positions of BYU: degrees and minutes as text, dates MM/DD/YY. It states no sizes; its bergs are
/// those that the US National Ice Center names, at least 10 nautical miles long, and are taken to be that long.
[[nodiscard]] Checked<PreparedDataset> read_iceberg_list_json(const std::filesystem::path& file);

}  // namespace floeplan::ingest
