#include "api/routes/access/client_address.hpp"

namespace floeplan::routes {

std::string address_behind_proxy(const Request& request) {
  const std::string hops = request.header("x-forwarded-for");
  if (hops.empty()) return request.peer;
  const auto begin =
      hops.find_first_not_of(", ", hops.find_last_of(',') == std::string::npos ? 0 : hops.find_last_of(','));
  return begin == std::string::npos
             ? request.peer
             : hops.substr(begin, hops.find_last_not_of(' ') - begin + 1).substr(0, 64);
}

}  // namespace floeplan::routes
