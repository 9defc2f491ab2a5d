#include "engine/mission/writing/file_origin.hpp"

#include "engine/core/utc_text.hpp"
#include "engine/mission/document/comment_text.hpp"

namespace floeplan::mission {

namespace {

/// A comment line with a label and a user's text; empty if no safe text is left.
std::string comment_line(const std::string& label, const std::string& text, std::size_t max_length) {
  const std::string safe = comment_text(text, max_length);
  return safe.empty() ? "" : "# " + label + " " + safe + "\n";
}

}  // namespace

std::string origin_comments(const planning::Plan& plan, const FileOrigin& origin) {
  std::string text = comment_line("plan", origin.plan_name, 80);
  text += comment_line("plan id", origin.plan_id, 70);
  text += comment_line("vehicle", plan.vehicle, 70);
  text += "# departure " + core::iso8601(plan.departure) + ", arrival " + core::iso8601(plan.arrival) + "\n";
  for (const ocean::DatasetRef& dataset : plan.datasets) {
    text += comment_line("data", comment_text(dataset.id, 60) + " sha256 " + comment_text(dataset.sha256, 12),
                         90);
  }
  text += comment_line("written by",
                       comment_text(origin.written_by, 40) + " at " + core::iso8601(origin.generated), 80);
  text += "# No exported file has been tried on a vehicle. Check it before use.\n";
  return text;
}

}  // namespace floeplan::mission
