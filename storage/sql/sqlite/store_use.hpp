#pragma once

#include <filesystem>

namespace floeplan::sql::sqlite {

/// That a process uses the database of a store, for as long as the object lives. Whoever puts another file in its place has
/// to be alone: SQLite finds the log of a database by its name, so that somebody who had the old file open would write it
/// into the new one. Told by a lock on `<store>/floeplan.use`, which the system takes back from a process that dies.
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
