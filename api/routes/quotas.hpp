#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/routes/context.hpp"
#include "api/routes/message.hpp"

namespace floeplan::routes {

/// What an owner has of what its quotas bound.
struct QuotaUse {
  std::size_t uploads{};           // that wait to be ingested
  std::uint64_t waiting_bytes{};   // of them
  std::uint64_t ingested_bytes{};  // of the files of datasets, as they were sent

  [[nodiscard]] std::uint64_t stored_bytes() const { return waiting_bytes + ingested_bytes; }
};

[[nodiscard]] QuotaUse use_of(const Context& context, const std::string& owner);

/// The answer (403) to a file of so many bytes for which the caller's quotas leave no room: which quota, how much is used,
/// how to free some. Nothing when there is room.
[[nodiscard]] std::optional<Response> refuse_upload(const Context& context, const Request& request,
                                                    const QuotaUse& used, std::uint64_t bytes);

/// The same before the body is there, of the length that its header tells.
[[nodiscard]] std::optional<Response> refuse_coming_upload(const Context& context, const Request& request);

/// The same to datasets of these uploads, whose bytes count beside those of the uploads.
[[nodiscard]] std::optional<Response> refuse_ingest(const Context& context, const Request& request,
                                                    const std::vector<std::string>& uploads);

}  // namespace floeplan::routes
