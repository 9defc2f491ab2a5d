#pragma once

#include <filesystem>

namespace floeplan::ingest {

/// Whether a file has the ending of a file that only supplements another one: ".dbf", ".prj", ...
[[nodiscard]] bool is_sidecar(const std::filesystem::path& file);

/// Whether `sidecar` supplements `file`: "bed.prj" and "bed.asc.aux.xml" supplement "bed.asc".
[[nodiscard]] bool is_sidecar_of(const std::filesystem::path& sidecar, const std::filesystem::path& file);

}  // namespace floeplan::ingest
