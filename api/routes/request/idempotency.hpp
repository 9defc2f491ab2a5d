#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "storage/repository/work/kept_answers.hpp"

namespace floeplan::routes {

/// The request's Idempotency-Key, with a digest of everything that determines the answer; empty if it has
/// none.
/// Source   IETF draft-ietf-httpapi-idempotency-key-header-07
/// Errors   the problem for the answer: a key that is empty, longer than 255 characters or not plain ASCII
[[nodiscard]] tl::expected<std::optional<repository::IdempotencyKey>, Response> idempotency_key(
    const Request& request);

/// The refusal of a key that was used for a different request.
[[nodiscard]] Response key_reused(const Request& request);

/// Carries out a request with a key only once. Its effect and its answer are stored together, and the same
/// request with the same key gets this answer again. An error is not stored.
[[nodiscard]] Response answer_once(const Context& context, const Request& request,
                                   const repository::IdempotencyKey& key,
                                   const std::function<Response()>& answer);

}  // namespace floeplan::routes
