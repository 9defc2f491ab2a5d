#include "storage/repository/store/store_mark.hpp"

#include <fstream>

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

fs::path mark_in(const fs::path& folder) { return folder / "floeplan.use"; }

}  // namespace

void mark_as_store(const fs::path& folder) {
  if (!is_marked_as_store(folder)) std::ofstream{mark_in(folder), std::ios::app} << "a store of Floeplan\n";
}

bool is_marked_as_store(const fs::path& folder) {
  std::error_code none;
  const auto bytes = fs::file_size(mark_in(folder), none);
  return !none && bytes > 0;
}

}  // namespace floeplan::repository
