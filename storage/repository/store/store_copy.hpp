#pragma once

#include <cstdint>

#include "engine/core/progress.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The result of copying a store.
struct CopiedStore {
  std::int64_t rows{};
  std::int64_t datasets{};
  std::int64_t plans{};
  std::int64_t jobs{};
};

/// Copies a whole store, as it is at one moment, into an empty one, whichever engines keep them. Rows keep their numbers,
/// and numbers go on from the highest that was ever given. Afterwards both are read and compared by digests. The copy
/// is complete or nothing. Uploads that wait to be ingested are not part of it.
/// Errors   std::runtime_error when `to` is not empty, or differs from `from` afterwards; sql::Failure
[[nodiscard]] CopiedStore copy_store(sql::Connection& from, sql::Connection& to,
                                     const core::ProgressCallback& progress);

}  // namespace floeplan::repository
