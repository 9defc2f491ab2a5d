#pragma once

#include <filesystem>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether all data of an HDF5 file lie in the file itself and are packed by HDF5's own methods. A file may name others,
/// anywhere on this machine: external links, virtual datasets, raw data in external files, plugins. The HDF5 library opens
/// them without a word, and takes what it does not find as fill values.
/// Returns  true also of a file that is no HDF5
/// Errors   what the file refers to; damage that keeps any part of it from being looked at
/// Source   HDF5 user guide, 1.10: external links, virtual datasets, H5Pset_external
[[nodiscard]] Checked<bool> check_hdf5_references(const std::filesystem::path& file);

}  // namespace floeplan::ingest
