#include <algorithm>
#include <charconv>
#include <cmath>

#include "api/routes/access/quotas.hpp"
#include "api/routes/request/owner.hpp"
#include "api/routes/request/paging.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/work/uploads_of.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::Upload;

json upload_document(const Upload& upload, const std::string& public_url) {
  return {{"id", upload.id},
          {"name", upload.name},
          {"bytes", upload.bytes},
          {"sha256", upload.sha256},
          {"owner", upload.owner},
          {"created", core::iso8601(upload.created)},
          {"expires", core::iso8601(upload.expires)},
          {"links", json::array({link("self", "application/json", public_url + "/uploads/" + upload.id)})}};
}

core::Violations upload_faults(const Request& request) {
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
    faults.push_back({"?sha256", "the file arrived with another digest, " + request.body_file->sha256 +
                                     "; it was damaged in transfer, or is a different file; send it again"});
  }
  return faults;
}

Response add_upload(const Context& context, const Request& request, const PathParameters&) {
  const auto faults = upload_faults(request);
  if (!faults.empty()) return invalid(request, faults);
  const auto uploads = repository::uploads_of(context.db, context.service.uploads);
  uploads->remove_expired(request.now);
  const std::string owner = owner_of(request);
  const Upload upload = uploads->add(request.body_file->path, request.parameter("name").value_or(""),
                                    request.body_file->sha256, owner, request.now);
  // The quota is checked after storing, so that files sent at the same time are counted together.
  QuotaUse others = use_of(context, owner);
  --others.uploads;
  others.waiting_bytes -= upload.bytes;
  if (auto refusal = refuse_upload(context, request, others, upload.bytes)) {
    uploads->remove(upload.id);
    return std::move(*refusal);
  }
  Response response = json_reply(upload_document(upload, context.service.public_url), 201);
  response.headers.emplace_back("Location", context.service.public_url + "/uploads/" + upload.id);
  return response;
}

/// A position in the list of uploads, newest first.
struct Place {
  std::int64_t created_us{};
  std::string id;

  [[nodiscard]] bool is_before(const Place& other) const {
    return created_us != other.created_us ? created_us > other.created_us : id < other.id;
  }
};

Place place_of(const Upload& upload) {
  return {std::llround(core::unix_seconds(upload.created) * 1e6), upload.id};
}

std::string text_of(const Place& place) { return std::to_string(place.created_us) + "-" + place.id; }

/// Reads a position that `text_of` wrote.
std::optional<Place> parse_place(const std::string& text) {
  Place place;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, place.created_us);
  if (error != std::errc{} || rest == end || *rest != '-') return std::nullopt;
  place.id = {rest + 1, end};
  return place;
}

/// Lists the caller's own uploads; for an admin all uploads.
Response list_uploads(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto limit = static_cast<std::size_t>(std::min(reader.limit(), 1000));
  core::Violations faults = reader.violations();
  const auto before = request.parameter("before");
  const auto last = before ? parse_place(*before) : std::nullopt;
  if (before && !last) faults.push_back({"?before", "must be taken from a next link"});
  if (!faults.empty()) return invalid(request, faults);

  const std::string& url = context.service.public_url;
  const std::string owner = owner_of(request);
  std::vector<Upload> uploads = repository::uploads_of(context.db, context.service.uploads)->list();
  std::erase_if(uploads, [&](const Upload& upload) {
    return upload.expires <= request.now || !may_see_of(request, upload.owner) ||
           (last && !last->is_before(place_of(upload)));
  });
  json links = json::array({link("self", "application/json", address_of(request, url))});
  if (uploads.size() > limit) {
    uploads.resize(limit);
    links.push_back(link("next", "application/json",
                         address_with(request, url, "before", text_of(place_of(uploads.back())))));
  }
  json documents = json::array();
  for (const Upload& upload : uploads) documents.push_back(upload_document(upload, url));
  const Quotas quotas = context.service.quotas->now();
  const QuotaUse used = use_of(context, owner);
  return json_reply({{"uploads", std::move(documents)},
                     {"quotas",
                      {{"uploads", {{"used", used.uploads}, {"most", quotas.uploads}}},
                       {"stored_bytes", {{"used", used.stored_bytes()}, {"most", quotas.stored_bytes}}}}},
                     {"links", std::move(links)}});
}

Response unknown_upload(const Request& request, const PathParameters& path) {
  return problem_reply<"unknown-upload">(request, path.at("upload_id"));
}

Response show_upload(const Context& context, const Request& request, const PathParameters& path) {
  const auto upload = repository::uploads_of(context.db, context.service.uploads)->find(path.at("upload_id"));
  if (!upload || upload->expires <= request.now || !may_see_of(request, upload->owner))
    return unknown_upload(request, path);
  return json_reply(upload_document(*upload, context.service.public_url));
}

Response remove_upload(const Context& context, const Request& request, const PathParameters& path) {
  const auto uploads = repository::uploads_of(context.db, context.service.uploads);
  const auto upload = uploads->find(path.at("upload_id"));
  if (!upload || !may_see_of(request, upload->owner) || !uploads->remove(upload->id))
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
          {"GET", "/uploads", {"limit", "before"}, list_uploads},
          {"GET", "/uploads/{upload_id}", {}, show_upload},
          {"DELETE", "/uploads/{upload_id}", {}, remove_upload}};
}

}  // namespace floeplan::routes
