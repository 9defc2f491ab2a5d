#pragma once

#include <filesystem>

namespace floeplan::repository {

/// The right to serve a store, which only one process has at a time. The system releases the lock when the
/// process ends in any way.
/// Errors   std::runtime_error that names the process with the lock, or why the lock file cannot be opened
class StoreLock {
 public:
  explicit StoreLock(const std::filesystem::path& store);
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;
  ~StoreLock();

 private:
  int descriptor_;
};

}  // namespace floeplan::repository
