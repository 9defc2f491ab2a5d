#include "api/routes/store_trouble.hpp"

#include <stdexcept>

#include "api/routes/reply.hpp"

namespace floeplan::routes {
namespace {

constexpr const char* damage_slug = "store-damaged";

codec::Problem problem_of(sqlite::Trouble trouble) {
  switch (trouble) {
    case sqlite::Trouble::disk_full:
      return {507,
              "insufficient-storage",
              "Insufficient storage",
              "The server's disk is full. Nothing of the request was done; what was stored before is safe.",
              {}};
    case sqlite::Trouble::held_by_another:
      return {503, "store-held", "Busy", "Another program holds the store; send the request again.", {}};
    case sqlite::Trouble::not_writable:
      return {
          503,
          "store-not-writable",
          "The store cannot be written",
          "The server cannot write to its disk. Nothing of the request was done; its operator has to look.",
          {}};
    case sqlite::Trouble::damaged:
      return {
          503,
          damage_slug,
          "The store is damaged",
          "What was asked for is damaged in the server's store and cannot be read; the rest can. Its "
          "operator sees "
          "what is damaged with floeplan verify, saves the rest with floeplan repair, or puts back a backup.",
          {}};
    case sqlite::Trouble::other:
      return {500,
              "internal-error",
              "Internal error",
              "The server could not answer; its log says why. The request may be sent again.",
              {}};
  }
  throw std::logic_error{"Trouble without a problem"};
}

}  // namespace

Response store_trouble_reply(const Request& request, const sqlite::Failure& failure) {
  Response response = problem_reply(request, problem_of(failure.trouble()));
  if (failure.trouble() == sqlite::Trouble::held_by_another)
    response.headers.emplace_back("Retry-After", "5");
  else if (response.status != 500)
    response.headers.emplace_back("Retry-After", "60");
  return response;
}

void name_damaged(nlohmann::json& list, const std::vector<repository::StoredThing>& damaged) {
  for (const repository::StoredThing& thing : damaged) {
    const nlohmann::json id = thing.id.empty() ? nlohmann::json{} : nlohmann::json(thing.id);
    list["damaged"].push_back(
        {{"type", std::string{"/problems/"} + damage_slug},
         {"kind", thing.kind},
         {"id", id},
         {"detail", "This " + thing.kind +
                        " is damaged in the server's store and cannot be read; the list lacks it. The "
                        "server's operator saves the rest with floeplan repair, or puts back a backup."}});
  }
}

}  // namespace floeplan::routes
