#pragma once

#include <filesystem>

namespace floeplan::ingest {

/// Whether the heaps in which an HDF5 file keeps texts and lists of varying length hold what they say: HDF5 1.10 copies as
/// many bytes as an object claims to have, also from beyond its heap, and dies.
/// Accuracy heaps in the first 64 MB are looked at, where nearly all files have theirs: more would take longer than
///          reading the values
/// Source   HDF5 file format specification 3.0, section III.E, "Disk Format: Level 1E - Global Heap"
[[nodiscard]] bool hdf5_heaps_are_whole(const std::filesystem::path& file);

}  // namespace floeplan::ingest
