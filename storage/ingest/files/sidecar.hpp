#pragma once

#include <filesystem>

namespace floeplan::ingest {

/// Whether a file is of those that mean something only beside another one, by its ending: ".dbf", ".prj", ...
[[nodiscard]] bool is_sidecar(const std::filesystem::path& file);

/// Whether it lies beside that very file: "bed.prj" and "bed.asc.aux.xml" belong to "bed.asc".
[[nodiscard]] bool is_sidecar_of(const std::filesystem::path& sidecar, const std::filesystem::path& file);

}  // namespace floeplan::ingest
