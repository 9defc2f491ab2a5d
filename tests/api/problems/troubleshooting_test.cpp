#include <gtest/gtest.h>

#include <span>

#include "api/problems/problem_catalogue.hpp"
#include "engine/messages/command_messages.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/messages/flight_messages.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "engine/messages/ingest_current_messages.hpp"
#include "engine/messages/ingest_depth_messages.hpp"
#include "engine/messages/ingest_feature_messages.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_grib_messages.hpp"
#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "engine/messages/ingest_ice_messages.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "engine/messages/ingest_netcdf_messages.hpp"
#include "engine/messages/ingest_tide_messages.hpp"
#include "engine/messages/ingest_time_messages.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "engine/messages/ingest_velocity_messages.hpp"
#include "engine/messages/ingest_zarr_messages.hpp"
#include "engine/messages/mission_check_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/messages/mission_file_messages.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/messages/request_messages.hpp"
#include "engine/messages/seaglider_file_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/messages/store_messages.hpp"
#include "tests/support/written_out.hpp"

namespace floeplan::problems::troubleshooting_test {
namespace {

using messages::Kind;

/// Markdown whose rendered text is this text.
std::string plain(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view{"*<`["}.find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string heading(std::string_view code) { return "\n### `" + std::string{code} + "`\n\n"; }

std::string entries(std::span<const Kind> kinds) {
  std::string text;
  for (const Kind& kind : kinds) {
    text += heading(kind.code) + "**" + std::string{messages::rank_name(kind.rank)} + "** " +
            plain(messages::whole_text(messages::example_of(kind))) + '\n';
  }
  return text;
}

std::string problem_entries() {
  std::string text;
  for (const ProblemKind& kind : problem_kinds) {
    text += heading(kind.code) + "**" + std::to_string(kind.status) + "** " + std::string{kind.title} + ". " +
            plain(messages::example_of(kind.words()).text) + '\n';
  }
  return text;
}

TEST(Troubleshooting, HasEveryMessageAndProblemByItsCode) {
  const std::string part =
      "## Messages of plans\n" + entries(messages::plan_kinds) + "\n## Messages of data\n" +
      entries(messages::data_kinds) + "\n## Why there is no plan\n" + entries(messages::refusal_kinds) +
      "\n## Messages of exports and checks\n" + entries(messages::export_kinds) +
      "\n## Files that are read\n" + entries(messages::ingest_file_kinds) +
      entries(messages::ingest_netcdf_kinds) + entries(messages::ingest_zarr_kinds) +
      entries(messages::ingest_hdf5_kinds) + entries(messages::ingest_time_kinds) +
      entries(messages::ingest_grid_kinds) + entries(messages::ingest_grib_kinds) +
      entries(messages::ingest_feature_kinds) + "\n## Files: depths and charts\n" +
      entries(messages::ingest_depth_kinds) + "\n## Files: currents and wind\n" +
      entries(messages::ingest_velocity_kinds) + entries(messages::ingest_current_kinds) +
      "\n## Files: tides\n" + entries(messages::ingest_tide_kinds) + "\n## Files: sea ice\n" +
      entries(messages::ingest_ice_kinds) + "\n## Files: icebergs\n" +
      entries(messages::ingest_iceberg_kinds) + "\n## Files: zones and coastlines\n" +
      entries(messages::ingest_area_kinds) + "\n## Files: tracks of gliders\n" +
      entries(messages::ingest_track_kinds) +
      "\n## Faults of requests and routes\n\nEach follows the name of the field, parameter or line that it "
      "is "
      "about.\n" +
      entries(messages::request_kinds) +
      "\n## Faults of mission files\n\nEach follows the name of the field or file that it is about.\n" +
      entries(messages::mission_fault_kinds) +
      "\n## Faults of simulated flights and logs\n\nEach follows the name of the field, file or column that "
      "it is about.\n" +
      entries(messages::flight_fault_kinds) +
      "\n## Simulated flights\n" + entries(messages::flight_kinds) +
      "\n## Findings of check\n\nA danger is an error, a caution a warning. The code of a finding ends "
      "before the slash.\n" +
      entries(messages::mission_file_kinds) + entries(messages::seaglider_file_kinds) +
      entries(messages::mission_check_kinds) +
      "\n## The command line\n\nAn entry of a flag follows the flag's name.\n" +
      entries(messages::command_kinds) +
      "\n## The store\n" + entries(messages::store_kinds) +
      "\n## Problems of the API\n\nThe type of a problem ends in its code, or "
      "in that of a group of problems.\n" +
      problem_entries();
  support::expect_written_part("web/guide/troubleshooting.md", "messages", part, "problems_test");
  const std::string page = support::text_of_tree("web/guide/troubleshooting.md");
  EXPECT_NE(page.find(heading(messages::refusal_kinds[0].code)), std::string::npos);
  EXPECT_NE(page.find(heading(problem_kinds[0].code)), std::string::npos);
}

}  // namespace
}  // namespace floeplan::problems::troubleshooting_test
