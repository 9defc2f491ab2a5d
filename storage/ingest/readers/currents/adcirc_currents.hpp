#pragma once

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/files/file_group.hpp"

namespace floeplan::ingest {

/// Currents of ADCIRC averaged over depth, from its fort.64, at the nodes of its fort.14. A node is dry where its fort.63
/// says so; without that file where its current is exactly zero. `options.time` is the start of the run, from which the
/// files count.
/// Errors   fort.14 missing; no start; files of different meshes or times; see AdcircOutput and read_adcirc_mesh
[[nodiscard]] Checked<PreparedDataset> read_adcirc_currents(const FileGroup& files,
                                                            const IngestOptions& options,
                                                            const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
