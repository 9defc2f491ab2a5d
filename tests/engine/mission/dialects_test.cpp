#include <gmock/gmock.h>

#include "engine/mission/document/document_text.hpp"
#include "engine/mission/reading/read_document.hpp"

namespace floeplan::mission::dialects_test {
namespace {

const std::string list =
    "behavior_name=goto_list\n# c\n<start:b_arg>\n\tb_arg: num_legs_to_run(nodim) -2\n"
    "\tb_arg: start_when(enum) 0\n\tb_arg: list_when_wpt_dist(m) 500\n\tb_arg: initial_wpt(enum) 0\n"
    "\tb_arg: num_waypoints(nodim) 2\n<end:b_arg>\n<start:waypoints>\n-7348.0000\t3917.0000\n"
    "-7329.0000\t3818.0000\n<end:waypoints>\n";
const std::string mission =
    "sensor: u_use_current_correction(nodim) 1\nbehavior: abend\n  b_arg: overdepth(m) 200\n"
    "behavior: goto_list\n  b_arg: args_from_file(enum) 10\nbehavior: yo\n  b_arg: args_from_file(enum) 10\n";

/// The text with every occurrence of one part replaced.
std::string with(std::string text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
    text.replace(at, part.size(), by);
  return text;
}

std::string rows(int count) {
  std::string text = with(list, "num_waypoints(nodim) 2", "num_waypoints(nodim) " + std::to_string(count));
  std::string more;
  for (int i = 2; i < count; ++i) more += "-7300 3900\n";
  return with(text, "<end:waypoints>", more + "<end:waypoints>");
}

struct Dialect {
  const char* what;
  std::string text;
  Verdict verdict;
  const char* code{nullptr};  // among the messages; null: nothing but the verdict is asked
  const char* name{"goto_l10.ma"};
};

/// Variants in real files, correct ones and faulty ones. The verdicts follow the notes on the format: unknown
/// names, other units and a missing radius give a note, unusual but defined text a warning; everything else
/// is rejected.
const std::vector<Dialect> dialects{
    {"as the vendor writes it", list, Verdict::ok},
    {"CRLF", with(list, "\n", "\r\n"), Verdict::ok},
    {"CR alone", with(list, "\n", "\r"), Verdict::warn, "carriage_return_alone"},
    {"tabs for blanks", with(list, " ", "\t\t"), Verdict::ok},
    {"no blank after the colon", with(list, "b_arg: ", "b_arg:"), Verdict::ok},
    {"two blanks before the value", with(list, ") -2", ")  -1"), Verdict::ok},
    {"no units", with(list, "(nodim)", ""), Verdict::warn, "unit_missing"},
    {"another unit", with(list, "(m)", "(meters)"), Verdict::ok, "unit_differs"},
    {"a blank before the unit", with(list, "dist(m)", "dist (m)"), Verdict::warn, "blank_before_unit"},
    {"capital keywords", with(with(list, "b_arg", "B_ARG"), "behavior_name", "BEHAVIOR_NAME"), Verdict::ok},
    {"a capital behavior", with(list, "goto_list", "GOTO_LIST"), Verdict::ok, "capital_letters"},
    {"a capital argument", with(list, "num_waypoints", "NUM_WAYPOINTS"), Verdict::ok, "capital_letters"},
    {"a comment glued to the value", with(list, ") 500", ") 500# m"), Verdict::ok},
    {"words after the value", with(list, ") 500", ") 500 metres"), Verdict::warn, "extra_tokens"},
    {"7.", with(list, ") 500", ") 500."), Verdict::ok},
    {"1e3", with(list, ") 500", ") 5E+02"), Verdict::ok},
    {"+5", with(with(list, ") 500", ") +500"), "3917.0000", "+3917"), Verdict::ok},
    {"a leading zero", with(list, "-7348.0000", "-07348.0"), Verdict::ok},
    {"degrees and a bit of the south west", with(list, "-7348.0000\t3917.0000", "-0030.5 -0000.5"),
     Verdict::ok},
    {"a byte order mark", "\xEF\xBB\xBF" + list, Verdict::warn, "byte_order_mark"},
    {"ISO-8859-1 in a comment", with(list, "# c", "# r\xE9gion 5\xB0"), Verdict::ok},
    {"UTF-8 in a comment", with(list, "# c", "# r\xC3\xA9gion"), Verdict::ok},
    {"control-Z at the end", list + "\x1A", Verdict::ok},
    {"control-Z and a line end", with(list, "\n", "\r\n") + "\x1A\r\n", Verdict::ok},
    {"no newline at the end", list.substr(0, list.size() - 1), Verdict::ok},
    {"words after a section's tag", with(list, "<end:b_arg>", "<end:b_arg> done"), Verdict::warn,
     "extra_tokens"},
    {"a comment after a section's tag", with(list, "<end:b_arg>", "  <end:b_arg>\t# done"), Verdict::ok},
    {"blanks around the equals sign", with(list, "name=", "name = "), Verdict::warn, "blanks_around_equals"},
    {"the name at the end", with(list, "behavior_name=goto_list\n", "") + "behavior_name=goto_list\n",
     Verdict::warn, "unusual_order"},
    {"no radius", with(list, "\tb_arg: list_when_wpt_dist(m) 500\n", ""), Verdict::ok,
     "list_when_wpt_dist_not_given"},
    {"a radius below the minimum", with(list, ") 500", ") 5"), Verdict::warn, "radius_below_minimum"},
    {"an unknown argument", with(list, "start_when(enum) 0", "new_in_11(nodim) 0"), Verdict::ok,
     "unknown_b_arg"},
    {"an unknown code", with(list, "initial_wpt(enum) 0", "list_stop_when(enum) 44"), Verdict::ok,
     "unknown_code"},
    {"a code of other behaviors", with(list, "initial_wpt(enum) 0", "list_stop_when(enum) 12"), Verdict::ok,
     "unknown_code"},
    {"60.0000 minutes", with(list, "3917.0000", "3960.0000"), Verdict::warn, "minutes_60_or_more"},
    {"decimal degrees",
     with(with(list, "-7348.0000\t3917.0000", "-118.5687 33.4120"), "-7329.0000\t3818.0000", "-118.4 33.1"),
     Verdict::warn, "decimal_degrees"},
    {"fewer declared than listed", with(list, "num_waypoints(nodim) 2", "num_waypoints(nodim) 1"),
     Verdict::warn, "waypoint_count_mismatch"},
    {"71 rows", rows(71), Verdict::ok},
    {"a list in a yo's file", list, Verdict::warn, "file_name_of_another_behavior", "yo10.ma"},
    {"rows with commas", with(list, "\t3917", ", 3917"), Verdict::reject, "bad_waypoint_row"},
    {"hemisphere letters", with(list, "3917.0000", "3917.0000N"), Verdict::reject, "bad_waypoint_row"},
    {"degrees, minutes and seconds", with(list, "3917.0000", "39:17:00"), Verdict::reject,
     "bad_waypoint_row"},
    {"a decimal comma", with(list, "3917.0000", "3917,0000"), Verdict::reject, "bad_waypoint_row"},
    {"columns swapped", with(list, "-7348.0000\t3917.0000", "3917.0\t-12348.0"), Verdict::reject,
     "out_of_range"},
    {"no count", with(list, "\tb_arg: num_waypoints(nodim) 2\n", ""), Verdict::reject,
     "num_waypoints_not_given"},
    {"more declared than listed", with(list, "num_waypoints(nodim) 2", "num_waypoints(nodim) 3"),
     Verdict::reject, "waypoint_count_mismatch"},
    {"question marks", with(list, ") 500", ") ??"), Verdict::reject, "value_not_a_number"},
    {"a hexadecimal number", with(list, ") 500", ") 0x1F4"), Verdict::reject, "value_not_a_number"},
    {"the end cut off", with(list, "<end:waypoints>\n", ""), Verdict::reject, "section_not_closed_at_eof"},
    {"no name", with(list, "behavior_name=goto_list\n", ""), Verdict::reject, "no_behavior_name"},
    {"another comment sign", with(list, "# c", "// c"), Verdict::reject, "unknown_line"},
    {"10000 rows", rows(10000), Verdict::reject, "file_too_large"},
    {"1001 short rows", rows(1001), Verdict::reject, "too_many_waypoints"},
    {"UTF-16",
     std::string{"\xFF\xFE"
                 "b\0e\0h\0",
                 8},
     Verdict::reject, "binary_file"},
    {"binary junk", "\x89PNG\r\n\x1A\n\x01\x02\x03", Verdict::reject, "unknown_line"},
    {"nothing", "", Verdict::reject, "no_behavior_name"},
    {"a mission", mission, Verdict::ok, nullptr, "plan.mi"},
    {"a mission with CRLF in capital letters", with(with(mission, "behavior", "BEHAVIOR"), "\n", "\r\n"),
     Verdict::ok, nullptr, "PLAN.MI"},
    {"a mission without abend", mission.substr(mission.find("behavior: goto_list")), Verdict::ok, "no_abend",
     "plan.mi"},
    {"a file number of three digits", with(mission, ") 10", ") 100"), Verdict::warn, "file_number_above_99",
     "plan.mi"},
    {"an argument before any behavior", "b_arg: x(m) 1\n" + mission, Verdict::reject, "b_arg_before_behavior",
     "plan.mi"},
    {"a list that is named as a mission", list, Verdict::reject, "unknown_line", "plan.mi"},
};

TEST(Dialects, HaveTheirVerdictAndSayWhy) {
  for (const Dialect& dialect : dialects) {
    const Document read = read_document(dialect.name, dialect.text);
    EXPECT_EQ(verdict_name(read.verdict()), verdict_name(dialect.verdict)) << dialect.what;
    const auto said = [&](const Message& message) { return message.code == dialect.code; };
    EXPECT_TRUE(dialect.code == nullptr || std::ranges::any_of(read.messages, said))
        << dialect.what << ": no " << (dialect.code == nullptr ? "" : dialect.code);
  }
}

TEST(Dialects, ThatAreTakenAreWrittenTheSameForEver) {
  for (const Dialect& dialect : dialects) {
    const Document read = read_document(dialect.name, dialect.text);
    if (read.verdict() == Verdict::reject) continue;
    const std::string written = write_document(read);
    const Document again = read_document(dialect.name, written);
    EXPECT_EQ(write_document(again), written) << dialect.what;
    ASSERT_EQ(again.waypoints.size(), read.waypoints.size()) << dialect.what;
    for (std::size_t i = 0; i < read.waypoints.size(); ++i)
      EXPECT_EQ(again.waypoints[i].place, read.waypoints[i].place) << dialect.what;
  }
}

}  // namespace
}  // namespace floeplan::mission::dialects_test
