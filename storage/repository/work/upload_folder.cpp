#include "storage/repository/work/upload_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <stdexcept>

#include "engine/messages/store_messages.hpp"
#include "storage/json/json.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void flush_to_disk(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!flushed) throw std::runtime_error{messages::store_text<"upload-not-written">()};
}

core::UtcTime time_of_change(const fs::path& path) {
  const auto changed = std::chrono::file_clock::to_sys(fs::last_write_time(path));
  return std::chrono::time_point_cast<core::Seconds>(changed);
}

/// The upload of a description; nullopt if the description is damaged, so that a list can skip it.
std::optional<Upload> parse_upload(const std::string& id, const json& document) {
  try {
    Upload upload{.id = id,
                  .name = document.at("name"),
                  .bytes = document.at("bytes"),
                  .sha256 = document.at("sha256"),
                  .owner = document.value("owner", ""),  // absent in older versions
                  .created = core::from_unix_seconds(document.at("created_s").get<double>()),
                  .expires = core::from_unix_seconds(document.at("expires_s").get<double>())};
    if (upload.name != plain_file_name(upload.name)) return std::nullopt;
    return upload;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

Upload UploadFolder::add(const fs::path& file, const std::string& name, const std::string& sha256,
                             const std::string& owner, core::UtcTime now) {
  const Upload upload = new_upload(file, name, sha256, owner, now);
  const fs::path unfinished = folder_ / (upload.id + ".new");
  fs::create_directories(unfinished);
  fs::rename(file, unfinished / "data");
  std::ofstream{unfinished / "upload.json"} << json{{"name", upload.name},
                                                    {"bytes", upload.bytes},
                                                    {"sha256", upload.sha256},
                                                    {"owner", upload.owner},
                                                    {"created_s", core::unix_seconds(upload.created)},
                                                    {"expires_s", core::unix_seconds(upload.expires)}};
  flush_to_disk(unfinished / "data");
  flush_to_disk(unfinished / "upload.json");
  flush_to_disk(unfinished);
  fs::rename(unfinished, folder_ / upload.id);
  flush_to_disk(folder_);
  return upload;
}

std::optional<Upload> UploadFolder::find(const std::string& id) const {
  if (!is_upload_id(id)) return std::nullopt;
  std::ifstream in{folder_ / id / "upload.json"};
  return parse_upload(id, json::parse(in, nullptr, false));
}

std::vector<Upload> UploadFolder::list() const {
  std::vector<Upload> uploads;
  std::error_code error;
  for (fs::directory_iterator entry{folder_, error}, end; !error && entry != end; entry.increment(error)) {
    if (auto upload = find(entry->path().filename())) uploads.push_back(std::move(*upload));
  }
  std::ranges::sort(uploads, [](const Upload& a, const Upload& b) {
    return a.created != b.created ? a.created > b.created : a.id < b.id;
  });
  return uploads;
}

std::error_code UploadFolder::lay_out(const Upload& upload, const fs::path& file) const {
  std::error_code error;
  fs::create_hard_link(folder_ / upload.id / "data", file, error);
  return error;
}

bool UploadFolder::remove(const std::string& id) {
  if (!is_upload_id(id)) return false;
  std::error_code error;
  // renamed first, so that it disappears at once, however long the deletion takes
  const fs::path gone = folder_ / (id + ".gone");
  fs::rename(folder_ / id, gone, error);
  if (error) return false;
  fs::remove_all(gone, error);
  return true;
}

void UploadFolder::remove_expired(core::UtcTime now) {
  std::error_code error;
  for (fs::directory_iterator entry{folder_, error}, end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (const auto upload = find(name)) {
      if (upload->expires <= now) remove(name);
      continue;
    }
    std::error_code ignored;
    if (fs::exists(entry->path(), ignored) && time_of_change(entry->path()) + lifetime <= now)
      fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace floeplan::repository
