#pragma once

#include <optional>
#include <string>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// An action for the audit log, and its object.
struct Deed {
  std::string action;
  std::string target;
};

/// The action of a request that was answered, for the audit log: jobs started (by the name of the process),
/// files exported ("export") or uploaded ("upload"), changes, removals and logouts. nullopt if the request
/// failed or only read. Logins are recorded by LoginLedger.
[[nodiscard]] std::optional<Deed> deed_of(const Request& request, const Response& response);

/// Stores the action, if there was one. A failure of the store is logged; it does not undo the action.
void write_down(const Context& context, const Request& request, const Response& response);

}  // namespace floeplan::routes
