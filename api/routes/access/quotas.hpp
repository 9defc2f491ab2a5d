#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// Use of the quotas by an owner.
struct QuotaUse {
  std::size_t uploads{};          // uploads that were not ingested yet
  std::uint64_t waiting_bytes{};  // size of these uploads
  std::uint64_t kept_bytes{};     // size of the owner's dataset files, plans and simulations

  [[nodiscard]] std::uint64_t stored_bytes() const { return waiting_bytes + kept_bytes; }
};

[[nodiscard]] QuotaUse use_of(const Context& context, const std::string& owner);

/// The refusal (403) of an upload of `bytes` that exceeds the caller's quotas. The refusal states the quota,
/// its use, and how to free space. nullopt if there is space.
[[nodiscard]] std::optional<Response> refuse_upload(const Context& context, const Request& request,
                                                    const QuotaUse& used, std::uint64_t bytes);

/// The refusal (403) of an upload before its body is read, by the length in its header. nullopt if there is
/// space.
[[nodiscard]] std::optional<Response> refuse_coming_upload(const Context& context, const Request& request);

/// The refusal (403) to ingest `uploads`, if their size and that of the caller's dataset files, plans and
/// simulations together exceed the quota. nullopt if there is space.
[[nodiscard]] std::optional<Response> refuse_ingest(const Context& context, const Request& request,
                                                    const std::vector<std::string>& uploads);

/// The refusal (403) of a plan or a simulation. Its size is not known yet, so it is refused only if no space
/// is left. nullopt if there is space.
[[nodiscard]] std::optional<Response> refuse_document(const Context& context, const Request& request);

}  // namespace floeplan::routes
