#pragma once

#include <filesystem>
#include <thread>

namespace floeplan::cli {

/// Checks the files of an open store once a second. If somebody has removed or replaced the database or its
/// log while the server runs, all later commits would be lost. The process then ends at once with code 1 and
/// a line in the log. It closes nothing, because closing would remove by name a log that is not its own any
/// more. Every ten seconds the content of the log is moved to the database, whose pages have checksums.
/// Edges  create it after opening the store, so that the log exists
class StoreWatch {
 public:
  explicit StoreWatch(const std::filesystem::path& store);

 private:
  std::jthread thread_;
};

}  // namespace floeplan::cli
