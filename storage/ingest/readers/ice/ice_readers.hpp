#pragma once

#include <filesystem>
#include <memory>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Concentration of sea ice, and its thickness if the file has one, on a regular grid in longitude and
/// latitude or on a projected grid. If there are several estimates, the greatest at each node is used,
/// because more ice is the safer answer; a node is missing where all of them are. A draft of level ice is
/// converted to the thickness of floating ice.
/// Errors   no time in the file or the options; a wrong or unclear unit; all values missing; a grid that is
///          not supported
[[nodiscard]] Checked<PreparedDataset> read_ice(const std::shared_ptr<const NetcdfFile>& file,
                                                const IngestOptions& options,
                                                const core::ProgressCallback& progress);

/// Sea ice from polygons: charts in SIGRID-3, fast ice and ice shelves, or, where the pilot says that they are ice,
/// polygons with their concentration or none (then all of it is ice). Stored on a polar stereographic grid: at each
/// node the most ice of all polygons within one and a half cells of it, so that what is read between nodes is never too
/// little. Where no polygon lies nothing is known. The polygons of charts are kept beside it with their egg codes.
/// The moment is the one that the options state, else the one in the file's name, which is said in a warning.
/// Errors   no moment; every polygon whose codes cannot be read, a message each; what polygon shapes refuse
[[nodiscard]] Checked<PreparedDataset> read_ice_polygons(GDALDataset& dataset,
                                                         const std::filesystem::path& file,
                                                         const IngestOptions& options);

}  // namespace floeplan::ingest
