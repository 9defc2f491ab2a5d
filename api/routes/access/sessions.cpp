#include "api/codec/bytes/credential.hpp"
#include "api/routes/access/shown_credential.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/access/token_repository.hpp"

namespace floeplan::routes {
namespace {

constexpr core::Seconds lifetime{12.0 *
                                 // length of a pilot's watch; the token itself is valid until it is revoked
                                 3600.0};

nlohmann::json caller_document(const Caller& caller) {
  return {{"name", caller.name}, {"role", repository::role_name(caller.role)}};
}

/// Logs in with the token in the header or the body, which was checked before.
Response log_in(const Context& context, const Request& request, const PathParameters&) {
  if (request.caller->token_key.empty()) {
    return problem_reply<"no-token">(request);
  }
  const codec::Credential credential = codec::new_credential();
  const repository::LoginRecord login{.key = credential.key,
                                      .digest = codec::digest_of(credential),
                                      .created = request.now,
                                      .expires = request.now + lifetime};
  if (!repository::TokenRepository{context.db}.log_in(request.caller->token_key, login))
    return problem_reply<"token-just-revoked">(request);
  auto document = caller_document(*request.caller);
  document["expires"] = core::iso8601(login.expires);
  Response response = json_reply(document);
  const int seconds = static_cast<int>(lifetime.count());
  response.headers.emplace_back(
      "Set-Cookie", login_cookie(codec::credential_text(credential), seconds, context.service.secure));
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

Response show_caller(const Context&, const Request& request, const PathParameters&) {
  Response response = json_reply(caller_document(*request.caller));
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

Response log_out(const Context& context, const Request& request, const PathParameters&) {
  const auto shown = shown_credential(request);
  if (shown && shown->by_cookie) {
    const auto credential = codec::parse_credential(shown->text);
    if (credential && request.caller) repository::TokenRepository{context.db}.log_out(credential->key);
  }
  Response response;
  response.status = 204;
  response.headers.emplace_back("Set-Cookie", login_cookie("", 0, context.service.secure));
  return response;
}

}  // namespace

std::vector<Route> session_routes() {
  return {{"POST", "/session", {}, log_in, Access::viewer, true},
          {"GET", "/session", {}, show_caller},
          {"DELETE", "/session", {}, log_out, Access::everybody}};
}

}  // namespace floeplan::routes
