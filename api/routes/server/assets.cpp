#include "api/routes/server/assets.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>

#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"

namespace floeplan::routes {
namespace {

std::string media_type(const std::filesystem::path& file) {
  static const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
                                                        {".css", "text/css; charset=utf-8"},
                                                        {".json", "application/json"},
                                                        {".webmanifest", "application/manifest+json"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".jpg", "image/jpeg"},
                                                        {".webp", "image/webp"},
                                                        {".ico", "image/x-icon"},
                                                        {".woff2", "font/woff2"},
                                                        {".txt", "text/plain; charset=utf-8"},
                                                        {".map", "application/json"},
                                                        {".wasm", "application/wasm"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

/// Whether a name is safe: no part leads upwards, begins with a dot or contains another separator.
bool is_safe(const std::string& name) {
  if (name.empty() || name.find('\\') != std::string::npos || name.find("//") != std::string::npos)
    return false;
  return name.front() != '/' && name.front() != '.' && name.find("/.") == std::string::npos;
}

/// Whether a name contains a hash from the bundler, "main-3f2a9c1d.js". Such a name changes with the content.
bool has_hash(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const auto dash = stem.find_last_of("-.");
  if (dash == std::string::npos || stem.size() - dash - 1 < 8) return false;
  return std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(dash) + 1, stem.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

Response show_asset(const Context& context, const Request& request, const PathParameters& path) {
  auto asset = read_asset(context.service.web, path.at("path"));
  if (!asset) return problem_reply<"unknown-path">(request, request.path);
  const bool immutable = has_hash(path.at("path"));
  asset->headers.emplace_back("Cache-Control", immutable ? "max-age=31536000, immutable" : "no-cache");
  return *asset;
}

/// Answers with a page of the guide, or with a file that its pages use.
Response show_guide(const Context& context, const Request& request, const PathParameters& path) {
  const auto given = path.find("path");
  const std::filesystem::path name = given == path.end() ? "index" : given->second;
  auto file =
      read_asset(context.service.web, "guide/" + name.string() + (name.has_extension() ? "" : ".html"));
  if (!file) return problem_reply<"unknown-path">(request, request.path);
  file->headers.emplace_back("Cache-Control", "no-cache");
  return *file;
}

}  // namespace

std::optional<Response> read_asset(const std::filesystem::path& folder, const std::string& name) {
  if (folder.empty() || !is_safe(name)) return std::nullopt;
  std::error_code error;
  const auto file = folder / name;
  const auto real = std::filesystem::canonical(file, error);
  const auto root = error ? std::filesystem::path{} : std::filesystem::canonical(folder, error);
  if (error || !real.string().starts_with(root.string() + "/")) return std::nullopt;
  if (!std::filesystem::is_regular_file(real, error)) return std::nullopt;

  std::ifstream stream{real, std::ios::binary};
  if (!stream) return std::nullopt;
  Response response;
  response.content_type = media_type(real);
  response.body.assign(std::istreambuf_iterator<char>{stream}, {});
  return response;
}

std::vector<Route> asset_routes() {
  return {{"GET", "/app/{path...}", {}, show_asset, Access::everybody},
          {"GET", "/guide", {}, show_guide, Access::everybody},
          {"GET", "/guide/{path...}", {}, show_guide, Access::everybody}};
}

}  // namespace floeplan::routes
