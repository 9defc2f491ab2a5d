#include "api/routes/access/doorkeeper.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "api/codec/bytes/credential.hpp"
#include "api/log/log.hpp"
#include "api/routes/access/audit.hpp"
#include "api/routes/access/client_address.hpp"
#include "api/routes/access/quotas.hpp"
#include "api/routes/access/shown_credential.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/site.hpp"
#include "storage/repository/access/audit_repository.hpp"

namespace floeplan::routes {
namespace {

std::string text_of(std::uint64_t times) {
  return times == 1 ? "once" : "at least " + std::to_string(times) + " times within 10 minutes";
}

bool only_reads(const Request& request) {
  return request.method == "GET" || request.method == "HEAD" || request.method == "OPTIONS";
}

bool opens_login(const Request& request) { return request.method == "POST" && request.path == "/session"; }

bool ever_any_tokens(const Context& context) {
  const repository::TokenRepository tokens{context.db};
  if (context.remembered == nullptr) return tokens.ever_any();
  std::optional<bool>& known = context.remembered->ever_any_tokens;
  if (!known) known = tokens.ever_any();
  return *known;
}

Response wrong_credential(const Request& request) {
  Response response = problem_reply<"unknown-token">(request);
  response.headers.emplace_back("WWW-Authenticate", R"(Bearer realm="floeplan", error="invalid_token")");
  return response;
}

Response slow_down(Response response, core::Seconds wait) {
  response.headers.emplace_back("Retry-After", std::to_string(static_cast<long>(std::ceil(wait.count()))));
  return response;
}

Response foreign_page(const Request& request) { return problem_reply<"foreign-page">(request); }

Response preflight() {
  Response response;
  response.status = 204;
  response.headers = {{"Access-Control-Allow-Methods", "GET, HEAD, POST, PUT, PATCH, DELETE"},
                      {"Access-Control-Allow-Headers",
                       "Authorization, Content-Type, Content-Crs, Idempotency-Key, If-Match, If-None-Match, "
                       "Last-Event-ID, Prefer"},
                      {"Access-Control-Max-Age", "600"}};
  return response;
}

}  // namespace

void LoginLedger::note(const Context& context, const Request& request, const std::string& action,
                       const std::string& caller) {
  const std::lock_guard lock{mutex_};
  // the clock may have been set back
  const bool over = request.now - began_ >= period || request.now < began_;
  if (over) {
    tallies_.clear();
    began_ = request.now;
  }
  std::string peer = request.peer;
  if (tallies_.size() >= most_addresses && !tallies_.contains(action + " " + caller + " " + peer))
    peer = "other addresses";
  Tally& tally = tallies_[action + " " + (peer == request.peer ? caller : "") + " " + peer];
  if (!std::has_single_bit(++tally.times)) return;
  try {
    repository::AuditRepository audit{context.db};
    if (tally.row != 0) {
      audit.restate(tally.row, text_of(tally.times));
    } else {
      tally.row = audit.add({.at = request.now,
                             .caller = peer == request.peer ? caller : "",
                             .peer = peer,
                             .action = action,
                             .target = text_of(tally.times),
                             .request_id = request.id});
    }
  } catch (const std::exception& error) {
    log::error({"request=", request.id, " what was tried could not be written down: ", error.what()});
  }
}

bool Doorkeeper::is_allowed_origin(const std::string& origin) const {
  return std::find(doors_.origins.begin(), doors_.origins.end(), origin) != doors_.origins.end();
}

/// Whether the request comes from a page of this server. Browsers state the page's site in Origin when a
/// request may change data.
bool Doorkeeper::is_own_page(const Request& request, const std::string& public_url) const {
  const std::string origin = request.header("origin");
  if (origin.empty()) {
    const std::string site = request.header("sec-fetch-site");
    return site == "same-origin" || site == "none";
  }
  return authority_of(origin) == request.header("host") || authority_of(origin) == authority_of(public_url);
}

void Doorkeeper::allow_origin(const Request& request, Response& response) const {
  if (doors_.origins.empty()) return;
  vary_by(response, "Origin");
  const std::string origin = request.header("origin");
  if (!is_allowed_origin(origin)) return;
  response.headers.emplace_back("Access-Control-Allow-Origin", origin);
  response.headers.emplace_back(
      "Access-Control-Expose-Headers",
      "Content-Crs, ETag, Link, Location, Preference-Applied, Retry-After, WWW-Authenticate, X-Request-Id");
}

/// Records the caller in the request; returns a refusal if the credential is wrong.
std::optional<Response> Doorkeeper::identify(const Context& context, Request& request) {
  const repository::TokenRepository tokens{context.db};
  if (doors_.open_without_tokens && !ever_any_tokens(context)) {
    request.caller = local_caller;
    return std::nullopt;
  }
  const auto shown = shown_credential(request);
  if (!shown) return std::nullopt;

  const auto credential = codec::parse_credential(shown->text);
  const GuessGuard::Shown guess{.address = request.peer,
                                .key = credential ? credential->key : std::string{},
                                .digest = credential ? codec::digest_of(*credential) : std::string{}};
  if (const core::Seconds wait = guard_.wait(guess, request.now); wait > core::Seconds{0.0}) {
    ledger_.note(context, request, "log-in-refused", "");
    return slow_down(problem_reply<"too-many-wrong-tokens">(request), wait);
  }

  std::optional<repository::TokenRecord> token;
  if (credential) {
    token = shown->by_cookie ? tokens.find_login(credential->key, request.now) : tokens.find(credential->key);
  }
  if (!token || !codec::proves(*credential, token->digest)) {
    guard_.note_wrong(guess, request.now);
    ledger_.note(context, request, "log-in-refused", token ? token->name : "");
    if (shown->by_cookie) return std::nullopt;  // the cookie of an expired login counts as none
    return wrong_credential(request);
  }
  guard_.note_right(guess, request.now);
  if (!shown->by_cookie && opens_login(request)) {
    if (const core::Seconds wait = guard_.wait_to_log_in(guess, request.now); wait > core::Seconds{0.0}) {
      ledger_.note(context, request, "log-in-refused", token->name);
      return slow_down(problem_reply<"too-many-logins">(request), wait);
    }
    ledger_.note(context, request, "log-in", token->name);
  }
  request.caller = Caller{token->name, token->role, shown->by_cookie ? std::string{} : token->key};
  const bool may_be_forged = shown->by_cookie && !only_reads(request);
  if (may_be_forged && !is_own_page(request, context.service.public_url)) return foreign_page(request);
  return std::nullopt;
}

/// Without this check, every page in a browser on this machine could do what its user may do.
std::optional<Response> Doorkeeper::refuse_foreign_page(const Context& context,
                                                        const Request& request) const {
  const std::string& own = context.service.public_url;
  if (could_be_rebound(request.header("host"), authority_of(own))) {
    return problem_reply<"unknown-host">(request, request.header("host"));
  }
  const std::string origin = request.header("origin");
  const bool foreign = !origin.empty() && !is_allowed_origin(origin) && !is_own_page(request, own);
  if (foreign && !only_reads(request)) return foreign_page(request);
  return std::nullopt;
}

/// Records the caller in the request; returns a refusal if the caller has no access at all.
std::optional<Response> Doorkeeper::let_in(const Context& context, Request& request) {
  if (doors_.behind_proxy) request.peer = address_behind_proxy(request);
  if (auto refusal = identify(context, request)) return refusal;
  const bool open = request.caller && request.caller->name == local_caller.name;
  return open ? refuse_foreign_page(context, request) : std::nullopt;
}

std::optional<Response> Doorkeeper::refuse(const Context& context, Request request) {
  if (auto refusal = let_in(context, request)) return refusal;
  if (auto refusal = router_.refusal(request)) return refusal;
  return refuse_coming_upload(context, request);
}

Response Doorkeeper::answer(const Context& context, Request request) {
  const bool asks_for_leave = request.method == "OPTIONS" && is_allowed_origin(request.header("origin")) &&
                              !request.header("access-control-request-method").empty();
  auto refusal = asks_for_leave ? std::optional{preflight()} : let_in(context, request);
  Response response = refusal ? std::move(*refusal) : router_.answer(context, request);
  if (response.status == 401 && shown_credential(request) && shown_credential(request)->by_cookie)
    response.headers.emplace_back("Set-Cookie", login_cookie("", 0, doors_.secure));
  allow_origin(request, response);
  if (request.caller) {
    response.caller = request.caller->name;
    write_down(context, request, response);
  }
  return response;
}

}  // namespace floeplan::routes
