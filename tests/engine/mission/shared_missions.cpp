#include "tests/engine/mission/shared_missions.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/support/places.hpp"

namespace floeplan::support {

namespace fs = std::filesystem;

fs::path shared_missions() { return fs::path{support::source_folder()} / "../shared/data/gliderdos"; }

std::vector<fs::path> shared_mission_files() {
  std::vector<fs::path> files;
  if (!fs::exists(shared_missions())) return files;
  for (const auto& entry : fs::recursive_directory_iterator{shared_missions()}) {
    if (fs::exists(entry.path().string() + ".expected.json")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

}  // namespace floeplan::support
