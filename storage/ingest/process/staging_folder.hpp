#pragma once

#include <filesystem>

namespace floeplan::ingest {

/// A new folder below `parent` for this process alone; the destructor removes it with everything in it. The
/// constructor also removes folders of killed processes: a living process holds a lock on its folder.
/// Errors   std::system_error when the folder cannot be created
class StagingFolder {
 public:
  explicit StagingFolder(const std::filesystem::path& parent);
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;
  ~StagingFolder();

  /// Removes the folders below `parent` whose process was killed. Does nothing if `parent` does not exist.
  static void remove_abandoned(const std::filesystem::path& parent);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_;
};

}  // namespace floeplan::ingest
