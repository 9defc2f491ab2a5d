#include "engine/mission/reading/read_document.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "engine/mission/document/document_text.hpp"
#include "tests/support/property.hpp"

namespace floeplan::mission::read_document_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

/// A sound list with these rows; `count` of them declared.
std::string list_of(const std::string& rows, int count) {
  return "behavior_name=goto_list\n<start:b_arg>\nb_arg: list_when_wpt_dist(m) 500\nb_arg: "
         "num_waypoints(nodim) " +
         std::to_string(count) + "\n<end:b_arg>\n<start:waypoints>\n" + rows + "<end:waypoints>\n";
}

Document read_list(const std::string& rows, int count = 1) {
  return read_document("goto_l10.ma", list_of(rows, count));
}

auto has(const std::string& code, Severity severity, int line) {
  return Contains(
      AllOf(Field(&Message::code, code), Field(&Message::severity, severity), Field(&Message::line, line)));
}

TEST(ReadDocument, TakesASoundListWithoutAWord) {
  const Document list = read_list("-7348.0000\t3917.0000\n");

  EXPECT_EQ(list.verdict(), Verdict::ok);
  EXPECT_THAT(list.messages, IsEmpty());
  ASSERT_EQ(list.waypoints.size(), 1U);
  EXPECT_DOUBLE_EQ(list.waypoints[0].place.lon_deg, -73.8);
}

TEST(ReadDocument, TakesEveryWayOfWritingANumber) {
  const Document list =
      read_list("  -07318.8 \t 801 # west, north\n713.000 -0.5\n+054. 4500\n-0030.5 0\n", 4);

  ASSERT_EQ(list.verdict(), Verdict::ok);
  ASSERT_EQ(list.waypoints.size(), 4U);
  EXPECT_DOUBLE_EQ(list.waypoints[0].place.lon_deg, -(73.0 + 18.8 / 60.0));
  EXPECT_DOUBLE_EQ(list.waypoints[0].place.lat_deg, 8.0 + 1.0 / 60.0);
  EXPECT_DOUBLE_EQ(list.waypoints[1].place.lat_deg, -0.5 / 60.0);
  EXPECT_DOUBLE_EQ(list.waypoints[2].place.lon_deg, 0.9);
  EXPECT_DOUBLE_EQ(list.waypoints[3].place.lon_deg, -30.5 / 60.0);
}

TEST(ReadDocument, RejectsRowsThatAreNotTwoNumbers) {
  for (const char* row : {"-7348.0, 3917.0\n", "7348.0W 3917.0N\n", "-7348.0\n", "nan 3917\n", "inf 3917\n",
                          "?? ??\n", "0x10 0x10\n", "1e999 0\n",
                          "\xE2\x88\x92"
                          "7348 3917\n"}) {
    const Document list = read_list(row);
    EXPECT_EQ(list.verdict(), Verdict::reject) << row;
    EXPECT_THAT(list.messages, has("bad_waypoint_row", Severity::error, 7)) << row;
  }
}

TEST(ReadDocument, RejectsPlacesOffTheEarthAndAsksForTheColumns) {
  const Document swapped = read_list("3917.0 -12406.0\n");
  EXPECT_THAT(swapped.messages, has("out_of_range", Severity::error, 7));
  EXPECT_THAT(swapped.messages, Contains(Field(&Message::text, HasSubstr("swapped"))));
  EXPECT_EQ(read_list("-18000.1 3917\n").verdict(), Verdict::reject);
  EXPECT_EQ(read_list("18000.0000 9000\n").verdict(), Verdict::ok);
}

TEST(ReadDocument, WarnsOfDecimalDegreesAndLeavesThemAsTheVehicleReadsThem) {
  const Document list = read_list("-118.5687 33.4120\n-118.6 33.5\n", 2);

  EXPECT_EQ(list.verdict(), Verdict::warn);
  EXPECT_THAT(list.messages, has("decimal_degrees", Severity::warning, 7));
  EXPECT_NEAR(list.waypoints[0].place.lon_deg, -1.30948, 1e-5);
  EXPECT_EQ(read_list("-0030.5000 0015.2500\n").verdict(), Verdict::ok) << "a list near 0 N 0 E";
}

TEST(ReadDocument, JudgesTheNumberOfWaypoints) {
  EXPECT_THAT(read_list("-7348 3917\n", 2).messages, has("waypoint_count_mismatch", Severity::error, 4));
  EXPECT_THAT(read_list("-7348 3917\n-7349 3917\n", 1).messages,
              has("waypoint_count_mismatch", Severity::warning, 4));
  const Document undeclared = read_document("goto_l10.ma",
                                            "behavior_name=goto_list\n<start:b_arg>\n<end:b_arg>\n<start:"
                                            "waypoints>\n-7348 3917\n<end:waypoints>\n");
  EXPECT_THAT(undeclared.messages, has("num_waypoints_not_given", Severity::error, 1));
}

TEST(ReadDocument, StopsAtAThousandWaypointsAndAt64KiB) {
  std::string rows;
  for (int i = 0; i < 1001; ++i) rows += "-7348.0000\t3917.0000\n";
  EXPECT_THAT(read_list(rows, 1001).messages, has("too_many_waypoints", Severity::error, 1007));
  for (int i = 0; i < 9000; ++i) rows += "-7348.0000\t3917.0000\n";
  EXPECT_THAT(read_list(rows, 10001).messages,
              ElementsAre(Field(&Message::code, std::string{"file_too_large"})));
}

TEST(ReadDocument, RejectsJunk) {
  EXPECT_EQ(read_document("a.ma", "").verdict(), Verdict::reject);
  EXPECT_EQ(read_document("a.mi", "").verdict(), Verdict::reject);
  EXPECT_EQ(read_document("a.mi", std::string{"\x7f"
                                              "ELF\0\1",
                                              6})
                .verdict(),
            Verdict::reject);
  EXPECT_EQ(read_document("a.ma", "\xff\xfe\xfd\x01\n").verdict(), Verdict::reject);
  const Document long_junk = read_document("a.mi", [] {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += "x\n";
    return text;
  }());
  EXPECT_LE(long_junk.messages.size(), 110U) << "reading stops";
}

TEST(ReadDocument, TakesBlanksAndCapitalsAsTheyComeAndWarnsOfOddOnes) {
  const Document odd = read_document("surfac10.ma",
                                     "# first a comment\nBehavior_Name = Surface\n<START:B_ARG>\n"
                                     "b_arg:start_when (enum) 12\nb_arg: when_secs 1200\n<end:b_arg>\n");

  EXPECT_EQ(odd.verdict(), Verdict::warn);
  ASSERT_EQ(odd.behaviors.size(), 1U);
  EXPECT_EQ(odd.behaviors[0].name, "surface");
  EXPECT_THAT(odd.messages, has("blanks_around_equals", Severity::warning, 2));
  EXPECT_THAT(odd.messages, has("blank_before_unit", Severity::warning, 4));
  EXPECT_THAT(odd.messages, has("unit_missing", Severity::warning, 5));
}

TEST(ReadDocument, RejectsSectionsThatDoNotMatch) {
  const auto codes_of = [](const std::string& text) {
    std::vector<std::string> codes;
    for (const Message& message : read_document("yo10.ma", "behavior_name=yo\n" + text).messages)
      if (message.severity == Severity::error) codes.push_back(message.code);
    return codes;
  };
  EXPECT_THAT(codes_of(""), ElementsAre("no_b_arg_section"));
  EXPECT_THAT(codes_of("<start:b_arg>\n"), ElementsAre("section_not_closed_at_eof"));
  EXPECT_THAT(codes_of("<start:b_arg>\n<end:b_arg>\n<end:b_arg>\n"), ElementsAre("section_not_open"));
  EXPECT_THAT(codes_of("<start:b_arg>\n<end:b_arg>\n<start:b_arg>\n<end:b_arg>\n"),
              ElementsAre("section_twice"));
  EXPECT_THAT(codes_of("b_arg: start_when(enum) 2\n<start:b_arg>\n<end:b_arg>\n"),
              ElementsAre("b_arg_outside_section"));
  EXPECT_THAT(codes_of("<start:stuff>\n<start:b_arg>\n<end:b_arg>\n"), ElementsAre("unknown_section"));
}

TEST(ReadDocument, WarnsOfArgumentsOfAnotherBehaviorAndNotesUnknownOnes) {
  const Document yo = read_document("yo10.ma",
                                    "behavior_name=yo\n<start:b_arg>\nb_arg: target_deadband(m) 5\n"
                                    "b_arg: shiny_new(enum) 1\nb_arg: when_secs(s) 1\n<end:b_arg>\n");

  EXPECT_THAT(yo.messages, has("b_arg_of_another_behavior", Severity::warning, 3));
  EXPECT_THAT(yo.messages, has("unknown_b_arg", Severity::note, 4));
  EXPECT_THAT(yo.messages, has("unit_differs", Severity::note, 5));
}

TEST(ReadDocument, AsksBackWhereAnArgumentIsMisspelt) {
  const Document yo =
      read_document("yo10.ma", "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depht(m) 5\n<end:b_arg>\n");

  EXPECT_EQ(yo.verdict(), Verdict::warn);
  ASSERT_THAT(yo.messages, has("misspelt_b_arg", Severity::warning, 3));
  EXPECT_THAT(yo.messages.front().text, HasSubstr("did you mean d_target_depth?"));
}

TEST(ReadDocument, WarnsOfAFileNamedAfterAnotherBehavior) {
  const std::string yo = "behavior_name=yo\n<start:b_arg>\n<end:b_arg>\n";
  EXPECT_THAT(read_document("SURFAC10.MA", yo).messages,
              has("file_name_of_another_behavior", Severity::warning, 1));
  EXPECT_THAT(read_document("yo10.ma", yo).messages, IsEmpty());
  EXPECT_THAT(read_document("Line 90.ma", yo).messages, IsEmpty());
  EXPECT_THAT(read_document("yo100.ma", yo).messages, has("file_number_above_99", Severity::warning, 0));
}

TEST(ReadDocument, JudgesFileNumbersOfAMission) {
  const Document mission =
      read_document("a.mi",
                    "behavior: abend\nbehavior: surface\nb_arg: args_from_file(enum) 100\n"
                    "behavior: goto_list\nb_arg: args_from_file(enum) 98\n"
                    "behavior: yo\nb_arg: args_from_file(enum) 5\n");

  EXPECT_THAT(mission.messages, has("file_number_above_99", Severity::warning, 3));
  EXPECT_THAT(mission.messages, has("file_number_of_firmware", Severity::note, 5));
  EXPECT_THAT(files_referenced(mission), ElementsAre("goto_l98.ma", "yo05.ma"));
}

TEST(ReadDocument, FindsPlacesThatAMissionGivesInline) {
  const Document mission = read_document(
      "a.mi",
      "behavior: abend\nbehavior: goto_list\nb_arg: num_waypoints(nodim) 2\n"
      "b_arg: wpt_units_0(enum) 2\nb_arg: wpt_x_0(X) -7348\nb_arg: wpt_y_0(X) 3917\n"
      "b_arg: wpt_units_1(enum) 0\nb_arg: wpt_x_1(X) 30\nb_arg: wpt_y_1(X) 30\n"
      "behavior: goto_wpt\nb_arg: wpt_units(enum) 2\nb_arg: wpt_x(X) -12406\nb_arg: wpt_y(X) 9900\n");

  ASSERT_EQ(mission.waypoints.size(), 2U);
  EXPECT_DOUBLE_EQ(mission.waypoints[0].place.lon_deg, -73.8);
  EXPECT_THAT(mission.messages, has("local_coordinates", Severity::note, 8));
  EXPECT_THAT(mission.messages, has("out_of_range", Severity::error, 12));
}

TEST(ReadDocument, JudgesTheValueOfAThrusterByItsMode) {
  const auto noted = [](const std::string& mode, const std::string& value) {
    const Document yo =
        read_document("yo10.ma", "behavior_name=yo\n<start:b_arg>\nb_arg: d_use_thruster(enum) " + mode +
                                     "\nb_arg: d_thruster_value(X) " + value + "\n<end:b_arg>\n");
    return std::ranges::any_of(
        yo.messages, [](const Message& message) { return message.code == "value_out_of_dictionary_range"; });
  };

  for (const char* power : {"1", "6.28", "9"}) EXPECT_FALSE(noted("4", power)) << power;
  for (const char* power : {"0", "0.9", "9.5", "62.8"}) EXPECT_TRUE(noted("4", power)) << power;
  for (const char* share : {"1", "2"}) {
    EXPECT_FALSE(noted(share, "62.8"));
    EXPECT_TRUE(noted(share, "101"));
    EXPECT_TRUE(noted(share, "-1"));
  }
  EXPECT_FALSE(noted("3", "-0.05")) << "a depth rate has a sign";
  EXPECT_FALSE(noted("4", "1000006")) << "takes its value from a mission parameter";
  EXPECT_TRUE(noted("6", "0")) << "no such mode";
}

TEST(ReadDocument, TakesAVehiclesConfiguration) {
  const Document autoexec = read_document("autoexec.mi", "name unit_1\ninstalled gps\nsensor: F_MAX(m) 10\n");

  EXPECT_EQ(autoexec.verdict(), Verdict::ok);
  EXPECT_THAT(autoexec.messages, has("no_abend", Severity::note, 0));
}

TEST(ReadDocument, TellsTheKindOfAFileWithoutAnEnding) {
  EXPECT_EQ(read_document("upload", list_of("-7348 3917\n", 1)).kind, DocumentKind::arguments);
  EXPECT_EQ(read_document("upload", "behavior: abend\n").kind, DocumentKind::mission);
}

/// Good files, damaged by a few random edits as by transfers and editors.
TEST(ReadDocument, SurvivesWhateverIsDoneToAFile) {
  const std::vector<std::string> sound{
      list_of("-7348.0000\t3917.0000\n-12460.1 5.\n", 2),
      "# a mission\r\nsensor: u_use_current_correction(nodim) 1\r\nbehavior: abend\r\n  b_arg: overdepth(m) "
      "200#deep\r\nbehavior: goto_list\r\n\tb_arg: args_from_file(enum) 10\r\n"};
  const std::string letters = "#:()<>= \t\r\n-+.0123456789eExXbn_\xEF\xBB\xBF\x1A\0";
  support::for_each_seed(3000, [&](std::mt19937_64& rng) {
    std::string text = sound[static_cast<std::size_t>(support::uniform_int(rng, 0, 1))];
    for (int edits = support::uniform_int(rng, 1, 12); edits > 0; --edits) {
      const auto at =
          static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(text.size()) - 1));
      switch (support::uniform_int(rng, 0, 3)) {
        case 0: text.erase(at, static_cast<std::size_t>(support::uniform_int(rng, 1, 30))); break;
        case 1: text.insert(at, 1, static_cast<char>(support::uniform_int(rng, 0, 255))); break;
        case 2:
          text.insert(at, 1,
                      letters[static_cast<std::size_t>(
                          support::uniform_int(rng, 0, static_cast<int>(letters.size()) - 1))]);
          break;
        default: text.insert(at, text.substr(at / 2, 40)); break;
      }
      if (text.empty()) text = "\n";
    }

    for (const char* name : {"goto_l10.ma", "a.mi", "x"}) {
      const Document read = read_document(name, text);
      if (read.verdict() == Verdict::reject) continue;
      const std::string written = write_document(read);
      const Document again = read_document(name, written);
      ASSERT_NE(again.verdict(), Verdict::reject) << written;
      ASSERT_EQ(write_document(again), written);
      ASSERT_EQ(again.waypoints.size(), read.waypoints.size());
    }
  });
}

}  // namespace
}  // namespace floeplan::mission::read_document_test
