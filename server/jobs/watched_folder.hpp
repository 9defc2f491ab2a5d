#pragma once

#include <filesystem>
#include <thread>

#include "api/service/ingest_service.hpp"
#include "server/jobs/worker_pool.hpp"

namespace floeplan::jobs {

/// A folder in which new files are ingested. A file counts as complete when its size and time of change have
/// not changed for a while. Files that are complete at the same time are ingested together, so that parts of
/// one dataset are joined. Afterwards a file is moved to the subfolder `done` or `refused`, with its report
/// as NAME.report.json. Files with a dot at the beginning of their name, or with an ending of unfinished
/// files, are ignored; so are the parts of a shapefile without their .shp file.
/// Restart  a file that was being read when the process was killed is still in the folder and is read again;
///          data stored before are not stored twice
/// Errors   std::system_error from the constructor when the folder cannot be created; later errors are
///          logged, and the folder is checked again
class WatchedFolder {
 public:
  WatchedFolder(const std::filesystem::path& folder, OpenStore open_store, ingest::Guard guard);
  WatchedFolder(const WatchedFolder&) = delete;
  WatchedFolder& operator=(const WatchedFolder&) = delete;
  ~WatchedFolder() = default;  // stops within a second

 private:
  void watch(const std::stop_token& stop);

  std::filesystem::path folder_;
  OpenStore open_store_;
  ingest::Guard guard_;
  std::jthread thread_;
};

}  // namespace floeplan::jobs
