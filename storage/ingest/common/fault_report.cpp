#include "storage/ingest/common/fault_report.hpp"

#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/sentence.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t most_faults = 50;  // a person hardly reads more in a report

}  // namespace

Messages report_of(Messages faults) {
  const std::size_t more = faults.size() > most_faults ? faults.size() - most_faults : 0;
  faults.resize(faults.size() - more);
  if (more > 0) faults.push_back(messages::ingest_file_message<"more-faults">(more));
  return faults;
}

messages::Message about(const std::string& part, messages::Message told) {
  told.text.insert(0, part + ": ");
  told.values.push_back({"part", part});
  return told;
}

std::string reason_of(const Messages& faults) {
  std::string reason;
  for (const messages::Message& fault : faults)
    reason += (reason.empty() ? "" : "; ") + messages::whole_text(fault);
  return reason;
}

}  // namespace floeplan::ingest
