#include "storage/ingest/process/staging_folder.hpp"

#include <fcntl.h>
#include <stdlib.h>  // NOLINT: mkdtemp is POSIX, not in <cstdlib>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

int open_folder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

}  // namespace

StagingFolder::StagingFolder(const fs::path& parent) {
  fs::create_directories(parent);
  remove_abandoned(parent);
  while (true) {
    std::string name = (parent / "XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::system_error{errno, std::generic_category(), "cannot create a folder in " + parent.string()};
    path_ = name;
    lock_ = open_folder(path_);
    std::error_code ignored;
    if (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) == 0 && fs::is_directory(path_, ignored)) return;
    if (lock_ >= 0) close(lock_);
  }
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  close(lock_);
}

// A folder that is not yet locked may be removed as if it were abandoned; its creator then creates another
// one.
void StagingFolder::remove_abandoned(const fs::path& parent) {
  std::error_code error;
  for (fs::directory_iterator entry{parent, error}, end; !error && entry != end; entry.increment(error)) {
    const int folder = open_folder(entry->path());
    if (folder < 0) continue;
    std::error_code ignored;
    if (flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry->path(), ignored);
    close(folder);
  }
}

}  // namespace floeplan::ingest
