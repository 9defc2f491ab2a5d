#include "api/routes/access/login_ledger.hpp"

#include <bit>

#include "api/log/log.hpp"
#include "storage/repository/access/audit_repository.hpp"

namespace floeplan::routes {
namespace {

std::string text_of(std::uint64_t times) {
  return times == 1 ? "once" : "at least " + std::to_string(times) + " times within 10 minutes";
}

}  // namespace

void LoginLedger::note(const Context& context, const Request& request, const std::string& action,
                       const std::string& caller) {
  const std::lock_guard lock{mutex_};
  const bool over = request.now - began_ >= period || request.now < began_;  // a clock may be set back
  if (over) {
    tallies_.clear();
    began_ = request.now;
  }
  std::string peer = request.peer;
  if (tallies_.size() >= most_addresses && !tallies_.contains(action + " " + caller + " " + peer))
    peer = "other addresses";
  Tally& tally = tallies_[action + " " + (peer == request.peer ? caller : "") + " " + peer];
  if (!std::has_single_bit(++tally.times)) return;
  try {
    repository::AuditRepository audit{context.db};
    if (tally.row != 0) {
      audit.restate(tally.row, text_of(tally.times));
    } else {
      tally.row = audit.add({.at = request.now,
                             .caller = peer == request.peer ? caller : "",
                             .peer = peer,
                             .action = action,
                             .target = text_of(tally.times),
                             .request_id = request.id});
    }
  } catch (const std::exception& error) {
    log::error({"request=", request.id, " what was tried could not be written down: ", error.what()});
  }
}

}  // namespace floeplan::routes
