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

/// The refusal (403) of a file of this size that exceeds the caller's quotas. It states the quota, its use,
/// and how to free space. nullopt if there is space.
[[nodiscard]] std::optional<Response> refuse_upload(const Context& context, const Request& request,
                                                    const QuotaUse& used, std::uint64_t bytes);

/// The same before the body is read, by the length in its header.
[[nodiscard]] std::optional<Response> refuse_coming_upload(const Context& context, const Request& request);

/// The same for ingesting these uploads; their size counts in addition to that of the stored uploads.
[[nodiscard]] std::optional<Response> refuse_ingest(const Context& context, const Request& request,
                                                    const std::vector<std::string>& uploads);

/// The same for a plan or a simulation. Its size is not known yet, so it is refused only if no space is left.
[[nodiscard]] std::optional<Response> refuse_document(const Context& context, const Request& request);

}  // namespace floeplan::routes
