#pragma once

#include <filesystem>
#include <memory>

#include "storage/repository/work/upload_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The uploads of a store: at a database server they are in the store, so that each node can read them; else in
/// this folder.
/// `db`      is borrowed
/// `folder`  on the same disk as the files that are added
[[nodiscard]] std::unique_ptr<UploadRepository> uploads_of(sql::Connection& db,
                                                           const std::filesystem::path& folder);

}  // namespace floeplan::repository
