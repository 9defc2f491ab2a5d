#include "engine/mission/document/flown_rows.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "engine/geo/geodesic.hpp"
#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "tests/support/property.hpp"

namespace floeplan::mission::flown_rows_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The settings of a list about its rows; for a setting that is not given, the default of the dictionary
/// counts.
struct Said {
  std::optional<int> legs;
  std::optional<int> initial;
};

std::string packed(double degrees) {
  const int whole = static_cast<int>(degrees);
  char text[32];
  std::snprintf(text, sizeof text, "%s%d%07.4f", degrees < 0.0 ? "-" : "", std::abs(whole),
                60.0 * std::abs(degrees - whole));
  return text;
}

Document list_of(const std::vector<geo::LonLat>& rows, const Said& said, const std::string& count = "") {
  std::string text = "behavior_name=goto_list\n<start:b_arg>\n";
  if (said.legs) text += "b_arg: num_legs_to_run(nodim) " + std::to_string(*said.legs) + "\n";
  if (said.initial) text += "b_arg: initial_wpt(enum) " + std::to_string(*said.initial) + "\n";
  text += "b_arg: num_waypoints(nodim) " + (count.empty() ? std::to_string(rows.size()) : count) +
          "\n<end:b_arg>\n<start:waypoints>\n";
  for (const geo::LonLat& place : rows) text += packed(place.lon_deg) + " " + packed(place.lat_deg) + "\n";
  return read_document("goto_l10.ma", text + "<end:waypoints>\n");
}

/// The rows in the order in which a vehicle flies them, up to `most` legs.
std::vector<std::size_t> followed(const Said& said, std::size_t rows, std::size_t closest, std::size_t most) {
  const int legs = said.legs.value_or(-1);
  const int initial = said.initial.value_or(-2);
  std::size_t row = 0;
  if (initial == -2) row = closest;
  if (initial >= 0) row = static_cast<std::size_t>(initial);
  std::vector<std::size_t> achieved;
  while (achieved.size() < most) {
    achieved.push_back(row);
    if (legs > 0 && achieved.size() == static_cast<std::size_t>(legs)) break;
    if (legs == -2 && row + 1 == rows) break;
    row = row + 1 == rows ? 0 : row + 1;
  }
  return achieved;
}

const std::vector<geo::LonLat> three{{-7.5, 52.0}, {-7.0, 52.5}, {-6.0, 52.0}};

/// Law: the check finds every number of legs for which the flown rows are not defined.
TEST(FlownRows, OfWhichNobodyKnowsAreFoundByTheCheck) {
  for (const int legs : {-3, -2, -1, 0, 1, 4, 1000, 1001, 2147483647}) {
    const Document list = list_of(three, {.legs = legs, .initial = 0});
    const bool is_refused = !flown_waypoints(list, std::nullopt).faults.empty();
    const bool is_found = std::ranges::any_of(
        list.messages, [](const Message& message) { return message.code == "illegal_legs"; });
    EXPECT_EQ(is_refused, is_found) << legs;
  }
}

std::vector<int> flown(const Said& said, std::optional<geo::LonLat> from = std::nullopt) {
  const FlownWaypoints route = flown_waypoints(list_of(three, said), from);
  std::vector<int> rows;
  for (const WaypointRow& row : route.rows)
    for (int i = 0; i < 3; ++i)
      if (geo::geodesic_between(row.place, three[static_cast<std::size_t>(i)]).length.value < 1.0)
        rows.push_back(i);
  return rows;
}

TEST(FlownRows, AreThoseThatTheVehicleFlies) {
  EXPECT_THAT(flown({-2, 0}), ElementsAre(0, 1, 2));
  EXPECT_THAT(flown({-2, 1}), ElementsAre(1, 2));
  EXPECT_THAT(flown({1, 0}), ElementsAre(0));
  EXPECT_THAT(flown({5, 0}), ElementsAre(0, 1, 2, 0, 1));
  EXPECT_THAT(flown({-1, 2}), ElementsAre(2, 0, 1)) << "one round of many";
  EXPECT_THAT(flown({-2, -1}), ElementsAre(0, 1, 2)) << "a fresh mission has achieved none";
  EXPECT_THAT(flown({2, 2}), ElementsAre(2, 0));
}

TEST(FlownRows, BeginWithTheClosestToWhereTheVehicleIs) {
  EXPECT_THAT(flown({-2, -2}, geo::LonLat{-6.9, 52.4}), ElementsAre(1, 2));
  EXPECT_THAT(flown({}, geo::LonLat{-6.1, 52.0}), ElementsAre(2, 0, 1)) << "the dictionary's defaults";
  EXPECT_THAT(flown({-2, -2}), ElementsAre(0, 1, 2)) << "nobody knows where it is";
}

std::string note(const Said& said, std::optional<geo::LonLat> from = std::nullopt) {
  const auto notes = flown_waypoints(list_of(three, said), from).notes;
  return notes.empty() ? "" : notes.front();
}

TEST(FlownRows, SayWhatIsLeftOutRepeatedOrFlownOnce) {
  EXPECT_EQ(note({-2, 0}), "");
  EXPECT_EQ(note({3, 0}), "");
  EXPECT_THAT(note({-2, 1}), HasSubstr("flies rows 1 and 2 and leaves out row 0"));
  EXPECT_THAT(note({1, 0}), HasSubstr("flies row 0 and leaves out rows 1 and 2"));
  EXPECT_THAT(note({5, 0}), HasSubstr("flown are rows 0, 1, 2, 0 and 1"));
  EXPECT_THAT(note({-1, 2}), HasSubstr("one round is flown here (rows 2, 0 and 1)"));
  EXPECT_THAT(note({-2, -2}), HasSubstr("without a start, row 0 is taken"));
  EXPECT_EQ(note({-2, -2}, three.front()), "");
  EXPECT_THAT(note({-2, -1}), HasSubstr("a fresh mission, as here, begins with row 0"));
}

TEST(FlownRows, AreNotKnownOfAListThatAsksForNoneThatThereIs) {
  for (const Said& said : {Said{0, 0}, Said{-3, 0}, Said{1001, 0}, Said{1'000'003, 0}}) {
    const FlownWaypoints route = flown_waypoints(list_of(three, said), std::nullopt);
    ASSERT_THAT(route.faults, SizeIs(1)) << *said.legs;
    EXPECT_EQ(route.faults.front().field, "num_legs_to_run");
    EXPECT_THAT(route.rows, SizeIs(3)) << "all, for whoever looks at them";
  }
  for (const int initial : {3, -3, 2'000'000'000})
    EXPECT_EQ(list_of(three, {-2, initial}).verdict(), Verdict::reject) << initial;
}

/// Law: for any list, the rows are those of a vehicle that goes from row to row. A list without end gives one
/// round. A list that is not flown once from its first row to its last gets a note.
TEST(FlownRows, AreThoseOfAVehicleThatGoesFromRowToRow) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const int count = support::uniform_int(rng, 1, 9);
    std::vector<geo::LonLat> rows;
    for (int i = 0; i < count; ++i)
      rows.push_back({support::uniform(rng, -60.0, -50.0), support::uniform(rng, 60.0, 70.0)});
    Said said;
    if (rng() % 5 != 0) {
      const int legs = support::uniform_int(rng, -2, 25);
      said.legs = legs == 0 ? 1 : legs;
    }
    if (rng() % 5 != 0) said.initial = support::uniform_int(rng, -2, count - 1);
    std::optional<geo::LonLat> from;
    if (rng() % 2 == 0) from = geo::LonLat{support::uniform(rng, -60.0, -50.0), 65.0};
    const Document list = list_of(rows, said);
    std::size_t closest = 0;
    for (std::size_t i = 0; from && i < list.waypoints.size(); ++i)
      if (geo::geodesic_between(*from, list.waypoints[i].place).length <
          geo::geodesic_between(*from, list.waypoints[closest].place).length)
        closest = i;

    const FlownWaypoints route = flown_waypoints(list, from);

    ASSERT_THAT(route.faults, IsEmpty());
    const bool for_ever = said.legs.value_or(-1) == -1;
    EXPECT_EQ(route.goes_round, for_ever);
    const auto wanted = followed(said, rows.size(), closest, for_ever ? rows.size() : 1000);
    ASSERT_EQ(route.rows.size(), wanted.size());
    bool in_order = wanted.size() == rows.size() && (!for_ever || rows.size() == 1);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(route.rows[i].line, list.waypoints[wanted[i]].line) << "leg " << i;
      in_order = in_order && wanted[i] == i;
    }
    EXPECT_TRUE(in_order || route.notes.size() == 1);
    const auto further = followed(said, rows.size(), closest, 2 * rows.size());
    if (for_ever) {
      for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(further[rows.size() + i], further[i]);
    }
  });
}

TEST(FlownRows, OfAMissionAreThoseOfItsInlineList) {
  const std::string text =
      "behavior: abend\nbehavior: goto_list\nb_arg: num_legs_to_run(nodim) -2\nb_arg: initial_wpt(enum) 1\n"
      "b_arg: num_waypoints(nodim) 2\nb_arg: wpt_units_0(enum) 2\nb_arg: wpt_x_0(X) -0730.0\n"
      "b_arg: wpt_y_0(X) 5200.0\nb_arg: wpt_units_1(enum) 2\nb_arg: wpt_x_1(X) -0700.0\n"
      "b_arg: wpt_y_1(X) 5230.0\n";

  const FlownWaypoints route = flown_waypoints(read_document("a.mi", text), std::nullopt);

  ASSERT_THAT(route.rows, SizeIs(1));
  EXPECT_DOUBLE_EQ(route.rows.front().place.lat_deg, 52.5);
  EXPECT_THAT(route.notes, ElementsAre(HasSubstr("leaves out row 0")));
}

TEST(GotoListCheck, RejectsEveryCountThatIsNotThatOfItsRows) {
  for (const char* count : {"0", "-1", "-2147483648", "2.5", "4", "1000000", "2147483648", "4294967299",
                            "1e300", "1e999", "nan", "NaN", "-nan", "inf"})
    EXPECT_EQ(list_of(three, {-2, 0}, count).verdict(), Verdict::reject) << count;
  EXPECT_EQ(list_of(three, {-2, 0}, "3").verdict(), Verdict::ok);
  EXPECT_EQ(list_of(three, {-2, 0}, "2").verdict(), Verdict::warn) << "all rows are kept";
}

}  // namespace
}  // namespace floeplan::mission::flown_rows_test
