#pragma once

#include <filesystem>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether all data of an HDF5 file lie in the file itself and are packed by HDF5's own filters. A file may
/// refer to others anywhere on this machine: by external links, virtual datasets, external raw data or
/// plugins. The HDF5 library opens these without notice, and reads fill values where one is missing.
/// Returns  true also for a file that is not HDF5
/// Errors   what the file refers to; a part of the file that is too damaged to be checked
/// Source   HDF5 user guide, 1.10: external links, virtual datasets, H5Pset_external
[[nodiscard]] Checked<bool> check_hdf5_references(const std::filesystem::path& file);

}  // namespace floeplan::ingest
