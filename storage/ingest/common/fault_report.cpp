#include "storage/ingest/common/fault_report.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t most_faults = 50;  // a report that a person reads

}  // namespace

std::string report_of(std::vector<std::string> faults) {
  const std::size_t more = faults.size() > most_faults ? faults.size() - most_faults : 0;
  faults.resize(faults.size() - more);
  if (more > 0) faults.push_back("and " + std::to_string(more) + " faults more");
  std::string text;
  for (const std::string& fault : faults) text += (text.empty() ? "" : "\n") + fault;
  return text;
}

}  // namespace floeplan::ingest
