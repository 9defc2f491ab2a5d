#pragma once

#include "storage/repository/work/upload_repository.hpp"

namespace floeplan::repository {

/// Keeps uploads in one folder. Each is a folder with the bytes and a description.
/// Threads  any number at once
class UploadFolder : public UploadRepository {
 public:
  explicit UploadFolder(std::filesystem::path folder) : folder_{std::move(folder)} {}

  Upload add(const std::filesystem::path& file, const std::string& name, const std::string& sha256,
             const std::string& owner, core::UtcTime now) override;
  [[nodiscard]] std::optional<Upload> find(const std::string& id) const override;
  [[nodiscard]] std::vector<Upload> list() const override;
  [[nodiscard]] std::error_code lay_out(const Upload& upload,
                                        const std::filesystem::path& file) const override;
  bool remove(const std::string& id) override;
  void remove_expired(core::UtcTime now) override;

 private:
  std::filesystem::path folder_;
};

}  // namespace floeplan::repository
