#include "server/cli/serving/store_watch.hpp"

#include <sys/stat.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "api/log/log.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/upkeep.hpp"

namespace floeplan::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds between_looks{1};
constexpr int looks_between_checkpoints = 10;

/// Identifies the file behind a name; empty: no file.
using Identity = std::optional<std::pair<dev_t, ino_t>>;

Identity identity_of(const fs::path& file) {
  struct stat found{};
  if (stat(file.c_str(), &found) != 0) return std::nullopt;
  return std::pair{found.st_dev, found.st_ino};
}

struct WatchedFile {
  fs::path path;
  Identity identity;
};

std::vector<WatchedFile> watched_files(const fs::path& store) {
  std::vector<WatchedFile> files;
  for (fs::path& path : sql::database_files_in(store)) {
    auto identity = identity_of(path);
    files.push_back({std::move(path), identity});
  }
  return files;
}

[[noreturn]] void end_at_once(const fs::path& file) {
  log::error({"store file=\"", file.string(),
              "\" was removed or replaced under the running server; it ends, so that nothing more is "
              "acknowledged that "
              "would be lost; put the file back or restore a backup, and start it again"});
  std::_Exit(1);
}

void watch(const std::stop_token& stop, const std::vector<WatchedFile>& files, sql::Connection db) {
  std::mutex mutex;
  std::condition_variable_any woken;
  for (int looks = 1;; ++looks) {
    std::unique_lock lock{mutex};
    if (woken.wait_for(lock, stop, between_looks, [&] { return stop.stop_requested(); })) return;
    for (const WatchedFile& file : files)
      if (file.identity && identity_of(file.path) != file.identity) end_at_once(file.path);
    if (looks % looks_between_checkpoints != 0) continue;
    try {
      sql::shorten_log(db);
    } catch (const std::runtime_error& error) {
      log::warn({"store log not moved to the database: ", error.what()});
    }
  }
}

}  // namespace

/// The files are identified before the thread starts, so that a replacement between the server's first answer
/// and the first check is noticed.
StoreWatch::StoreWatch(const fs::path& store)
    : thread_{[db = repository::open_store(store), files = watched_files(store)](
                  const std::stop_token& stop) mutable { watch(stop, files, std::move(db)); }} {}

}  // namespace floeplan::cli
