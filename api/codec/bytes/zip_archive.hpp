#pragma once

#include <string>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::codec {

/// A file inside an archive.
struct ArchivedFile {
  std::string name;
  std::string content;
};

/// A ZIP archive of the files, in their order, all with the modification time `modified`.
/// Errors  std::runtime_error when the archive library fails
[[nodiscard]] std::string zip_archive(const std::vector<ArchivedFile>& files, core::UtcTime modified);

}  // namespace floeplan::codec
