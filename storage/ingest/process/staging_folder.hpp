#pragma once

#include <filesystem>

namespace floeplan::ingest {

/// A new folder below `parent`, for this process alone, that is removed with everything in it at the end.
/// Those that killed processes left behind are removed, too, told by the lock that a living process holds on its own.
/// Errors   std::system_error when it cannot be created
class StagingFolder {
 public:
  explicit StagingFolder(const std::filesystem::path& parent);
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;
  ~StagingFolder();

  /// Removes those below `parent` whose process was killed; does nothing where there is no such folder.
  static void remove_abandoned(const std::filesystem::path& parent);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_;
};

}  // namespace floeplan::ingest
