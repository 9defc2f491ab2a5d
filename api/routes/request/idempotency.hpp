#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "storage/repository/work/kept_answers.hpp"

namespace floeplan::routes {

/// The request's Idempotency-Key with a digest of all that its answer follows from; empty: it has none.
/// Source   IETF draft-ietf-httpapi-idempotency-key-header-07
/// Errors   the problem to answer with: a key that is empty, longer than 255 characters or not plain ASCII
[[nodiscard]] tl::expected<std::optional<repository::IdempotencyKey>, Response> idempotency_key(
    const Request& request);

/// The answer to a key that another request had.
[[nodiscard]] Response key_reused(const Request& request);

/// Answers a request that has a key once: what it does and its answer are stored together, and the same request with
/// the same key gets that answer again. An answer that is an error is not kept.
[[nodiscard]] Response answer_once(const Context& context, const Request& request,
                                   const repository::IdempotencyKey& key,
                                   const std::function<Response()>& answer);

}  // namespace floeplan::routes
