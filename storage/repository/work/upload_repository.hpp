#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::repository {

/// A file that a user has sent, to be ingested later.
struct Upload {
  std::string id;    // 128 random bits as 32 hexadecimal digits
  std::string name;  // a safe file name: only letters, digits, '.', '_' and '-'
  std::uint64_t bytes{};
  std::string sha256;  // lower-case hexadecimal
  std::string owner;   // the user who sent it; empty: a server without tokens
  core::UtcTime created;
  core::UtcTime expires;
};

/// A safe file name for a file from outside: no folders, only letters, digits, '.', '_' and '-', no dot at
/// the beginning, at most 100 characters with the ending kept; "upload" if nothing is left.
[[nodiscard]] std::string plain_file_name(const std::string& name);

/// Stores uploads in one folder. Each upload is a folder with the bytes and a description. An upload exists
/// completely or not at all, even if the process or the machine stops.
/// Threads  any number at once
class UploadRepository {
 public:
  explicit UploadRepository(std::filesystem::path folder) : folder_{std::move(folder)} {}

  static constexpr core::Seconds lifetime{24.0 * 3600.0};

  /// Moves a file into the store of uploads. Precondition: the file is on the same disk as the store.
  Upload add(const std::filesystem::path& file, const std::string& name, const std::string& sha256,
             const std::string& owner, core::UtcTime now);
  /// The upload with this id; nullopt if the id is unknown or invalid, or the description is damaged.
  [[nodiscard]] std::optional<Upload> find(const std::string& id) const;
  /// All uploads, newest first; ties by id.
  [[nodiscard]] std::vector<Upload> list() const;
  /// The file with the bytes of an upload.
  [[nodiscard]] std::filesystem::path file_of(const Upload& upload) const {
    return folder_ / upload.id / "data";
  }
  /// Removes an upload. False if the upload does not exist.
  bool remove(const std::string& id);
  /// Removes uploads whose lifetime has ended, and unfinished files of killed processes.
  void remove_expired(core::UtcTime now);

 private:
  std::filesystem::path folder_;
};

}  // namespace floeplan::repository
