#pragma once

#include <filesystem>

namespace floeplan::sql::sqlite {

/// Marks the database of a store as in use by this process, as long as the object lives. To replace the file a process must be
/// the only user: SQLite finds the log of a database by its name, so another process with the old file open would write its
/// log into the new one. The mark is a lock on `<store>/floeplan.use`, which the system releases when a process dies.
/// Threads  any
/// Errors   Failure (held_by_another) after ten seconds without the lock; (not_writable) if the lock file
///          cannot be made
class StoreUse {
 public:
  /// Marks the store as in use; other processes may use it at the same time.
  [[nodiscard]] static StoreUse shared(const std::filesystem::path& store);
  /// Marks the store as in use by this object only; other users are excluded, also in this process.
  [[nodiscard]] static StoreUse alone(const std::filesystem::path& store);

  StoreUse(StoreUse&& other) noexcept;
  StoreUse& operator=(StoreUse&& other) noexcept;
  ~StoreUse();

 private:
  StoreUse(const std::filesystem::path& store, int kind_of_lock);

  int descriptor_;  // owned
};

}  // namespace floeplan::sql::sqlite
