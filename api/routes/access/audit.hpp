#pragma once

#include <optional>
#include <string>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// What was done, and to what.
struct Deed {
  std::string action;
  std::string target;
};

/// What an answered request did that somebody may have to answer for: jobs that it started (by the process' name),
/// files it took ("export") or brought ("upload"), what it changed or removed, and logouts. Nothing when it failed or
/// only looked. Logins are the ledger's.
[[nodiscard]] std::optional<Deed> deed_of(const Request& request, const Response& response);

/// Stores the deed, if there was one. A store that cannot take it is logged and does not take back what was done.
void write_down(const Context& context, const Request& request, const Response& response);

}  // namespace floeplan::routes
