#pragma once

#include <filesystem>

namespace floeplan::sql::sqlite {

/// Marks the database of a store as in use by this process, as long as the object lives. To replace the file a process must be
/// the only user: SQLite finds the log of a database by its name, so another process with the old file open would write its
/// log into the new one. The mark is a lock on `<store>/floeplan.use`, which the system releases when a process dies.
/// Threads  any
/// Errors   Failure (held_by_another) after ten seconds without the lock; (not_writable) where there can be no lock
class StoreUse {
 public:
  /// Beside others.
  [[nodiscard]] static StoreUse shared(const std::filesystem::path& store);
  /// While nobody else uses it, of this process neither.
  [[nodiscard]] static StoreUse alone(const std::filesystem::path& store);

  StoreUse(StoreUse&& other) noexcept;
  StoreUse& operator=(StoreUse&& other) noexcept;
  ~StoreUse();

 private:
  StoreUse(const std::filesystem::path& store, int kind_of_lock);

  int descriptor_;  // owned
};

}  // namespace floeplan::sql::sqlite
