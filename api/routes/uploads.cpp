#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/upload_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::Upload;
using repository::UploadRepository;

json upload_document(const Upload& upload, const std::string& public_url) {
  return {{"id", upload.id},
          {"name", upload.name},
          {"bytes", upload.bytes},
          {"sha256", upload.sha256},
          {"created", core::iso8601(upload.created)},
          {"expires", core::iso8601(upload.expires)},
          {"links", json::array({link("self", "application/json", public_url + "/uploads/" + upload.id)})}};
}

core::Violations faults_of(const Request& request) {
  constexpr std::size_t longest_name = 200;
  core::Violations faults;
  const auto sha256 = request.parameter("sha256");
  const bool is_digest = sha256 && sha256->size() == 64 &&
                         core::lower_case(*sha256).find_first_not_of("0123456789abcdef") == std::string::npos;
  if (sha256 && !is_digest) faults.push_back({"?sha256", "must be 64 hexadecimal digits"});
  if (request.parameter("name").value_or("").size() > longest_name)
    faults.push_back({"?name", "must be a file name of at most 200 characters"});
  if (!request.body_file) {
    faults.push_back({"", "must have the file as its body"});
  } else if (is_digest && core::lower_case(*sha256) != request.body_file->sha256) {
    faults.push_back(
        {"?sha256", "the file arrived with another digest, " + request.body_file->sha256 +
                        "; it was damaged on its way or is not the one that was meant; send it again"});
  }
  return faults;
}

Response add_upload(const Context& context, const Request& request, const PathParameters&) {
  const auto faults = faults_of(request);
  if (!faults.empty()) return invalid(request, faults);
  UploadRepository uploads{context.service.uploads};
  uploads.remove_expired(request.now);
  const Upload upload = uploads.add(request.body_file->path, request.parameter("name").value_or(""),
                                    request.body_file->sha256, request.now);
  Response response = json_reply(upload_document(upload, context.service.public_url), 201);
  response.headers.emplace_back("Location", context.service.public_url + "/uploads/" + upload.id);
  return response;
}

Response unknown_upload(const Request& request, const PathParameters& path) {
  return not_found(request, "unknown-upload",
                   "No upload has the id " + path.at("upload_id") + "; it was removed or has expired.");
}

Response show_upload(const Context& context, const Request& request, const PathParameters& path) {
  const auto upload = UploadRepository{context.service.uploads}.find(path.at("upload_id"));
  if (!upload || upload->expires <= request.now) return unknown_upload(request, path);
  return json_reply(upload_document(*upload, context.service.public_url));
}

Response remove_upload(const Context& context, const Request& request, const PathParameters& path) {
  if (!UploadRepository{context.service.uploads}.remove(path.at("upload_id")))
    return unknown_upload(request, path);
  Response response;
  response.status = 204;
  return response;
}

}  // namespace

bool streams_body(const std::string& method, const std::string& path) {
  return method == "POST" && (path == "/uploads" || path == "/uploads/");
}

std::vector<Route> upload_routes() {
  return {{"POST", "/uploads", {"name", "sha256"}, add_upload},
          {"GET", "/uploads/{upload_id}", {}, show_upload},
          {"DELETE", "/uploads/{upload_id}", {}, remove_upload}};
}

}  // namespace floeplan::routes
