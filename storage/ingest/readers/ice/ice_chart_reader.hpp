#pragma once

#include <filesystem>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

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
