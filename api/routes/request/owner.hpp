#pragma once

#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// The owner to whom the jobs and keys of the request belong; empty on a server without tokens.
[[nodiscard]] inline std::string owner_of(const Request& request) {
  const bool is_known = request.caller && request.caller->name != local_caller.name;
  return is_known ? request.caller->name : std::string{};
}

/// Whether the caller may see an object of `owner`: only the owner and admins may. For all others it does not
/// exist.
[[nodiscard]] inline bool may_see_of(const Request& request, const std::string& owner) {
  const bool sees_all = request.caller && request.caller->role == repository::Role::admin;
  return sees_all || owner == owner_of(request);
}

}  // namespace floeplan::routes
