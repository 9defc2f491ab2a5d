#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// What an owner has of what its quotas bound.
struct QuotaUse {
  std::size_t uploads{};          // that wait to be ingested
  std::uint64_t waiting_bytes{};  // of them
  std::uint64_t kept_bytes{};     // of the files of datasets, of plans and of simulations

  [[nodiscard]] std::uint64_t stored_bytes() const { return waiting_bytes + kept_bytes; }
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

/// The same to a plan or a simulation, whose size is not known before: it is begun where there is any room left.
[[nodiscard]] std::optional<Response> refuse_document(const Context& context, const Request& request);

}  // namespace floeplan::routes
