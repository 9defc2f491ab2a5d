#pragma once

#include <filesystem>
#include <thread>

#include "api/service/ingest_service.hpp"
#include "server/jobs/worker_pool.hpp"

namespace floeplan::jobs {

/// A folder whose files are ingested as they come. A file is taken when its size and its time of change have stayed the
/// same for a while; those that are complete together are ingested together, so that parts of one dataset find each
/// other. Then it is moved to `done` or `refused` in the folder, with the report beside it as NAME.report.json.
/// Names that begin with a dot, or end as browsers and copying programs name unfinished files, are left alone; so are
/// the parts of a shapefile until their .shp is there.
/// Restart  a file that was being read when the process was killed lies where it lay and is read again; what was stored
///          of it already is not stored twice
/// Errors   std::system_error from the constructor when the folder cannot be created; later ones are logged and the
///          folder is looked at again
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
