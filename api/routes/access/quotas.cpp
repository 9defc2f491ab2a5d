#include "api/routes/access/quotas.hpp"

#include "api/codec/bytes/text_values.hpp"
#include "api/routes/request/owner.hpp"
#include "api/routes/request/reply.hpp"
#include "storage/repository/access/owners.hpp"
#include "storage/repository/work/uploads_of.hpp"

namespace floeplan::routes {
namespace {

constexpr std::uint64_t megabyte = 1'000'000;

std::uint64_t megabytes(std::uint64_t bytes) { return (bytes + megabyte - 1) / megabyte; }

Response over_uploads(const Request& request, const Quotas& quotas) {
  return problem_reply<"quota-uploads">(request, quotas.uploads);
}

Response over_bytes(const Request& request, const Quotas& quotas, std::uint64_t used, std::uint64_t bytes) {
  return problem_reply<"quota-stored-bytes">(request, megabytes(used), megabytes(quotas.stored_bytes),
                                             megabytes(bytes));
}

}  // namespace

QuotaUse use_of(const Context& context, const std::string& owner) {
  QuotaUse use{.kept_bytes = repository::Owners{context.db}.bytes_of(owner)};
  for (const auto& upload : repository::uploads_of(context.db, context.service.uploads)->list()) {
    if (upload.owner != owner) continue;
    ++use.uploads;
    use.waiting_bytes += upload.bytes;
  }
  return use;
}

std::optional<Response> refuse_upload(const Context& context, const Request& request, const QuotaUse& used,
                                      std::uint64_t bytes) {
  const Quotas quotas = context.service.quotas->now();
  if (used.uploads >= quotas.uploads) return over_uploads(request, quotas);
  if (used.stored_bytes() + bytes > quotas.stored_bytes)
    return over_bytes(request, quotas, used.stored_bytes(), bytes);
  return std::nullopt;
}

std::optional<Response> refuse_coming_upload(const Context& context, const Request& request) {
  const auto told = codec::parse_integer(request.header("content-length"));
  const std::uint64_t bytes = told && *told > 0 ? static_cast<std::uint64_t>(*told) : 0;
  return refuse_upload(context, request, use_of(context, owner_of(request)), bytes);
}

std::optional<Response> refuse_ingest(const Context& context, const Request& request,
                                      const std::vector<std::string>& uploads) {
  const auto waiting = repository::uploads_of(context.db, context.service.uploads);
  std::uint64_t bytes = 0;
  for (const std::string& id : uploads)
    if (const auto upload = waiting->find(id)) bytes += upload->bytes;
  const std::uint64_t used = use_of(context, owner_of(request)).kept_bytes;
  const Quotas quotas = context.service.quotas->now();
  if (used + bytes > quotas.stored_bytes) return over_bytes(request, quotas, used, bytes);
  return std::nullopt;
}

std::optional<Response> refuse_document(const Context& context, const Request& request) {
  const Quotas quotas = context.service.quotas->now();
  const std::uint64_t used = use_of(context, owner_of(request)).stored_bytes();
  if (used >= quotas.stored_bytes) return over_bytes(request, quotas, used, megabyte);
  return std::nullopt;
}

}  // namespace floeplan::routes
