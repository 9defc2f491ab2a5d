#include "api/routes/request/remembered.hpp"

#include <string_view>

#include "api/codec/bytes/sha256.hpp"

namespace floeplan::routes {
namespace {

// chosen: compressing it delays other requests unnoticeably
constexpr std::size_t largest = 32UL * 1024;
constexpr std::size_t most_bytes = 4UL * 1024 * 1024;  // chosen; for each connection

std::string key_of(const Request& request) {
  std::string key = request.path;
  for (const auto& [name, value] : request.query) {
    key += '\0';
    key += name;
    key += '\0';
    key += value;
  }
  return key;
}

bool has_tag(const Response& response) {
  for (const auto& [name, value] : response.headers)
    if (name == "ETag") return true;
  return false;
}

/// Whether a path is a feature, "/collections/plans/items/p1", and nothing below it.
bool is_feature(std::string_view path) {
  constexpr std::string_view items = "/items/";
  const auto found = path.find(items);
  return path.starts_with("/collections/") && found != std::string_view::npos &&
         path.find('/', found + items.size()) == std::string_view::npos;
}

}  // namespace

void Remembered::refresh(sql::Connection& db) {
  const sql::Version now = sql::version_of(db);
  if (version_ == now) return;
  answers_.clear();
  bytes_ = 0;
  ever_any_tokens.reset();
  version_ = now;
}

const Response* Remembered::find(const Request& request) const {
  if (answers_.empty()) return nullptr;
  const auto found = answers_.find(key_of(request));
  return found == answers_.end() ? nullptr : &found->second;
}

void Remembered::keep(const Request& request, Response& response) {
  if (response.status != 200 || response.wait || response.streams || response.body.size() > largest) return;
  if (!has_tag(response))
    response.headers.emplace_back("ETag", '"' + codec::sha256(response.body).substr(0, 32) + '"');
  if (bytes_ + response.body.size() > most_bytes) {
    answers_.clear();
    bytes_ = 0;
  }
  if (answers_.emplace(key_of(request), response).second) bytes_ += response.body.size();
}

bool asks_for_job_status(const Request& request) {
  constexpr std::string_view folder = "/jobs/";
  return request.method == "GET" && request.path.starts_with(folder) &&
         request.path.find('/', folder.size()) == std::string::npos;
}

bool follows_from_store(const Request& request) {
  if (request.method != "GET" || request.resumption || request.headers.contains("prefer")) return false;
  return asks_for_job_status(request) || is_feature(request.path);
}

}  // namespace floeplan::routes
