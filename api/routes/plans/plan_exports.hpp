#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/messages/message.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// A format of a plan as one file. The table is common to API and command line.
struct ExportFormat {
  std::string name;  // "gpx": value of the command line flag and end of the URL
  std::string content_type;
  std::string file_name;  // of the file; empty: what the plan is called and the format's name
  bool is_brief{false};   // a page to read, which says the dangers itself; no vehicle flies it
};

/// All formats except mission files, in a fixed order.
[[nodiscard]] std::span<const ExportFormat> export_formats();

/// `stem`  name for the plan, used if the format does not have a fixed file name
[[nodiscard]] std::string export_file_name(const ExportFormat& format, const std::string& stem);

/// A file name that helps to find a downloaded plan: its name (with characters that are allowed in file
/// names), its departure and its id, "Kangia-20261122T0600Z-p1c2d3e4f5a6".
[[nodiscard]] std::string download_stem(const repository::PlanRecord& record);

/// A plan in a format, with messages for the pilot about the file.
struct ExportedPlan {
  std::string bytes;
  std::vector<messages::Message> messages;
};

/// The plan in one of these formats. The printed page also shows the safe places and `told`, the messages of the
/// check before the export.
/// Ice      adds a warning if the plan passes below ice or icebergs and the format cannot state the upper turns
/// Errors   a violation for a plan that the format cannot hold, and for targets of a Seaglider that pass below ice or
///          icebergs
[[nodiscard]] tl::expected<ExportedPlan, core::Violations> export_plan(
    sql::Connection& db, const repository::PlanRecord& record, const ExportFormat& format,
    const std::vector<messages::Message>& told, const std::vector<geo::LonLat>& safe_places,
    core::UtcTime now);

}  // namespace floeplan::routes
