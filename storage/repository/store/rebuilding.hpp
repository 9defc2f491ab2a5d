#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/repository/store/damage.hpp"

namespace floeplan::repository {

/// Copies the readable part of a database to a new one with checksums: the same schema and row numbers, new
/// indices. A thing with any damaged part is omitted completely, because half of the icebergs, or of a field,
/// would look like all of it. The new database is a single file without a log and not yet flushed to the
/// disk.
/// Parameters  from    a database that nobody writes to meanwhile folder  folder of the new database; its
///             present contents are removed
/// Returns     the omitted things
/// Errors      sql::Failure when either database fails for another reason than damaged things, or the schema
///             is unreadable
std::vector<StoredThing> rebuild(const std::filesystem::path& from, const std::filesystem::path& folder,
                                 const core::ProgressCallback& progress = {});

}  // namespace floeplan::repository
