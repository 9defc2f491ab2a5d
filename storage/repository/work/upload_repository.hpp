#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
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

/// The description of a file that arrives, with a random id, so that nobody can guess that of another user's upload.
[[nodiscard]] Upload new_upload(const std::filesystem::path& file, const std::string& name,
                                const std::string& sha256, const std::string& owner, core::UtcTime now);
/// Whether a text is an id. Only ids become part of a path.
[[nodiscard]] bool is_upload_id(const std::string& text);

/// Keeps uploads until they are ingested. An upload exists completely or not at all, even if the process or the
/// machine stops.
/// Errors   std::runtime_error when it cannot be written
class UploadRepository {
 public:
  static constexpr core::Seconds lifetime{24.0 * 3600.0};

  virtual ~UploadRepository() = default;

  /// Stores a file. It is moved away from its present place.
  virtual Upload add(const std::filesystem::path& file, const std::string& name, const std::string& sha256,
                     const std::string& owner, core::UtcTime now) = 0;
  /// The upload with this id; nullopt if the id is unknown or invalid, or the description is damaged.
  [[nodiscard]] virtual std::optional<Upload> find(const std::string& id) const = 0;
  /// All uploads, newest first; ties by id.
  [[nodiscard]] virtual std::vector<Upload> list() const = 0;
  /// Gives the bytes of an upload to a new file, which must only be read.
  /// Returns  the error; none if it succeeded
  [[nodiscard]] virtual std::error_code lay_out(const Upload& upload,
                                                const std::filesystem::path& file) const = 0;
  /// Removes an upload. False if the upload does not exist.
  virtual bool remove(const std::string& id) = 0;
  /// Removes uploads whose lifetime has ended, and unfinished files of killed processes.
  virtual void remove_expired(core::UtcTime now) = 0;
};

}  // namespace floeplan::repository
