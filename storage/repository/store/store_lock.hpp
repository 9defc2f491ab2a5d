#pragma once

#include <filesystem>

namespace floeplan::repository {

/// The right to serve a store, which one process has at a time. It goes with the process, however that ends; nothing is
/// left to clean up.
/// Errors   std::runtime_error that names the process which has it, or why the lock file cannot be opened
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
