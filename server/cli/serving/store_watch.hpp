#pragma once

#include <filesystem>
#include <thread>

namespace floeplan::cli {

/// Watches over the files of an open store, once a second. When somebody has removed or replaced the database or its log
/// under the running server, whatever is acknowledged from then on would be lost: the process ends at once, with code 1 and
/// a line in the log. It closes nothing first, since that would remove by name a log that is no longer its own. Every ten
/// seconds what the log holds is moved to the database, where its pages have checksums.
/// Edges  made when the store is open, so that the log is there
class StoreWatch {
 public:
  explicit StoreWatch(const std::filesystem::path& store);

 private:
  std::jthread thread_;
};

}  // namespace floeplan::cli
