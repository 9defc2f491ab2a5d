#pragma once

#include "storage/repository/work/upload_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Keeps uploads in the tables `upload` and `upload_block` of a store that a database server keeps.
/// Threads  as the connection
class StoredUploads : public UploadRepository {
 public:
  explicit StoredUploads(sql::Connection& db) : db_{db} {}

  Upload add(const std::filesystem::path& file, const std::string& name, const std::string& sha256,
             const std::string& owner, core::UtcTime now) override;
  [[nodiscard]] std::optional<Upload> find(const std::string& id) const override;
  [[nodiscard]] std::vector<Upload> list() const override;
  [[nodiscard]] std::error_code lay_out(const Upload& upload,
                                        const std::filesystem::path& file) const override;
  bool remove(const std::string& id) override;
  void remove_expired(core::UtcTime now) override;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
