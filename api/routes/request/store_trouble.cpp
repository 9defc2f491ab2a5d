#include "api/routes/request/store_trouble.hpp"

#include <stdexcept>

#include "api/routes/request/reply.hpp"

namespace floeplan::routes {
namespace {

problems::Problem problem_of(sql::Trouble trouble) {
  switch (trouble) {
    case sql::Trouble::disk_full: return problems::problem<"insufficient-storage">();
    case sql::Trouble::held_by_another: return problems::problem<"store-held">();
    case sql::Trouble::not_writable: return problems::problem<"store-not-writable">();
    case sql::Trouble::damaged: return problems::problem<"store-damaged">();
    case sql::Trouble::other: return problems::problem<"internal-error">();
  }
  throw std::logic_error{"Trouble without a problem"};
}

}  // namespace

Response store_trouble_reply(const Request& request, const sql::Failure& failure) {
  Response response = problem_reply(request, problem_of(failure.trouble()));
  if (failure.trouble() == sql::Trouble::held_by_another)
    response.headers.emplace_back("Retry-After", "5");
  else if (response.status != 500)
    response.headers.emplace_back("Retry-After", "60");
  return response;
}

void name_damaged(nlohmann::json& list, const std::vector<repository::StoredThing>& damaged) {
  for (const repository::StoredThing& thing : damaged) {
    const nlohmann::json id = thing.id.empty() ? nlohmann::json{} : nlohmann::json(thing.id);
    const problems::Problem problem = problems::problem<"entry-damaged">(thing.kind);
    list["damaged"].push_back({{"type", "/problems/" + problem.slug},
                               {"kind", thing.kind},
                               {"id", id},
                               {"detail", problem.detail}});
  }
}

}  // namespace floeplan::routes
