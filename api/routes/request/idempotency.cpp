#include "api/routes/request/idempotency.hpp"

#include <algorithm>

#include "api/codec/bytes/sha256.hpp"
#include "api/routes/request/owner.hpp"
#include "api/routes/request/reply.hpp"
#include "storage/json/json.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

std::string digest_of(const Request& request) {
  codec::Sha256 digest;
  digest.add(request.method + '\n' + request.path + '\n');
  for (const auto& [name, value] : request.query) digest.add(json{name, value}.dump(-1, ' ', true));
  digest.add('\n' + request.header("content-type") + '\n');
  digest.add(request.body_file ? request.body_file->sha256 : request.body);
  return digest.text();
}

std::string to_text(const Response& response) {
  return json{{"status", response.status},
              {"content_type", response.content_type},
              {"headers", response.headers},
              {"body", response.body}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

Response from_text(const std::string& text) {
  const json kept = json::parse(text);
  Response response;
  response.status = kept.at("status").get<int>();
  response.content_type = kept.at("content_type").get<std::string>();
  for (const json& header : kept.at("headers"))
    response.headers.emplace_back(header.at(0).get<std::string>(), header.at(1).get<std::string>());
  response.body = kept.at("body").get<std::string>();
  return response;
}

}  // namespace

tl::expected<std::optional<repository::IdempotencyKey>, Response> idempotency_key(const Request& request) {
  if (!request.headers.contains("idempotency-key")) return std::optional<repository::IdempotencyKey>{};
  constexpr std::size_t longest = 255;
  const std::string key = request.header("idempotency-key");
  const bool plain = std::all_of(key.begin(), key.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (key.empty() || key.size() > longest || !plain) {
    return tl::unexpected(problem_reply<"invalid-idempotency-key">(request));
  }
  return repository::IdempotencyKey{owner_of(request), key, digest_of(request)};
}

Response key_reused(const Request& request) { return problem_reply<"idempotency-key-reused">(request); }

Response answer_once(const Context& context, const Request& request, const repository::IdempotencyKey& key,
                     const std::function<Response()>& answer) {
  sql::Transaction transaction{context.db};
  repository::KeptAnswers answers{context.db};
  answers.remove_expired(request.now);
  if (const auto kept = answers.find(key)) {
    const bool same = kept->request_sha256 == key.request_sha256 && kept->answer;
    return same ? from_text(*kept->answer) : key_reused(request);
  }
  Response response = answer();
  constexpr int first_error = 400;
  if (response.status < first_error) answers.insert(key, std::nullopt, to_text(response), request.now);
  transaction.commit();
  return response;
}

}  // namespace floeplan::routes
