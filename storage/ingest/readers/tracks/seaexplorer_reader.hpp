#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/files/file_group.hpp"

namespace floeplan::ingest {

/// Whether a text begins as the navigation (gli) or the payload (pld1) of a SeaExplorer does.
[[nodiscard]] bool is_seaexplorer_text(std::string_view head);

/// Which file of a glider's mission a file is, by its name: "sea035.6.gli.sub.12".
struct SeaexplorerName {
  std::string glider;  // "sea035"
  std::string mission{};  // "sea035.6.gli": the same of all files of one kind; empty: the name does not say
  int dive{};
};
[[nodiscard]] SeaexplorerName seaexplorer_name_of(const std::filesystem::path& file);

/// One track from the navigation or the payload of a SeaExplorer, its dives in any order. Columns are separated by
/// semicolons: Timestamp or PLD_REALTIMECLOCK (DD/MM/YYYY HH:MM:SS in UTC), Lat and Lon or NAV_LATITUDE and
/// NAV_LONGITUDE in packed degrees, Depth or NAV_DEPTH in metres, NavState or NAV_RESOURCE.
/// Places   where the vehicle is at the surface (state 116) its fixes; below, what it reckons, where the position
///          changes: firmware that does not reckon repeats its last fix, which is no place there
/// Currents none: these files hold none
/// Source   states: dankelley/oceanglider, navState; columns: c-proof/pyglider, seaexplorer.py
/// Errors   no time, latitude or longitude among the columns; no row with a place
[[nodiscard]] Checked<PreparedDataset> read_seaexplorer_texts(const FileGroup& files,
                                                              const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
