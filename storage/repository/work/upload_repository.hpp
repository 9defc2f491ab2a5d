#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::repository {

/// A file that somebody sent and that waits to be ingested.
struct Upload {
  std::string id;    // 128 random bits as 32 hexadecimal digits
  std::string name;  // as a file may be called: letters, digits, '.', '_' and '-' alone
  std::uint64_t bytes{};
  std::string sha256;  // lower-case hexadecimal
  std::string owner;   // who sent it; empty: the user of an open server
  core::UtcTime created;
  core::UtcTime expires;
};

/// The name under which a file from outside is known: no folders, no other characters than letters, digits, '.', '_'
/// and '-', no dot at its begin, at most 100 characters with its ending kept; "upload" when nothing is left.
[[nodiscard]] std::string plain_file_name(const std::string& name);

/// Uploads in a folder of their own, each a folder with the bytes and a description. An upload is there whole or not at
/// all, whenever the process or the machine stops.
/// Errors   std::runtime_error when the folder cannot be read or written
/// Threads  any number at once
class UploadRepository {
 public:
  explicit UploadRepository(std::filesystem::path folder) : folder_{std::move(folder)} {}

  static constexpr core::Seconds lifetime{24.0 * 3600.0};

  /// Takes over a file that lies on the same disk.
  Upload add(const std::filesystem::path& file, const std::string& name, const std::string& sha256,
             const std::string& owner, core::UtcTime now);
  /// Nothing for an id that is unknown or none, or whose description is damaged.
  [[nodiscard]] std::optional<Upload> find(const std::string& id) const;
  /// All, the newest first; ties by id.
  [[nodiscard]] std::vector<Upload> list() const;
  /// Where the bytes of a known upload lie.
  [[nodiscard]] std::filesystem::path file_of(const Upload& upload) const {
    return folder_ / upload.id / "data";
  }
  /// False when there is none.
  bool remove(const std::string& id);
  /// Removes what was not asked to be removed in time, and what a killed process left behind.
  void remove_expired(core::UtcTime now);

 private:
  std::filesystem::path folder_;
};

}  // namespace floeplan::repository
