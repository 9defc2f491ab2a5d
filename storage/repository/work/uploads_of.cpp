#include "storage/repository/work/uploads_of.hpp"

#include "storage/repository/work/stored_uploads.hpp"
#include "storage/repository/work/upload_folder.hpp"

namespace floeplan::repository {

std::unique_ptr<UploadRepository> uploads_of(sql::Connection& db, const std::filesystem::path& folder) {
  if (sql::is_shared(db)) return std::make_unique<StoredUploads>(db);
  return std::make_unique<UploadFolder>(folder);
}

}  // namespace floeplan::repository
