#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/repository/store/damage.hpp"

namespace floeplan::repository {

/// Writes what can be read of a database into a new one with checksums: the same schema, rows with the same numbers, all
/// indices anew. A thing of which any part is damaged is left out as a whole, for half of the icebergs or of a field would
/// pass for all of it. The database is one file afterwards, without a log, not yet flushed to the disk.
/// Parameters  from    a database that nobody writes meanwhile
///             folder  gets the database; what is there is removed
/// Returns     what was left out
/// Errors      sql::Failure when either fails otherwise than by damage of things, or the schema cannot be read
std::vector<StoredThing> rebuild(const std::filesystem::path& from, const std::filesystem::path& folder,
                                 const core::ProgressCallback& progress = {});

}  // namespace floeplan::repository
