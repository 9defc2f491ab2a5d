#include "tests/engine/mission/shared_missions.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "engine/mission/document/document_text.hpp"
#include "engine/mission/reading/read_document.hpp"

namespace floeplan::mission::shared_missions_test {
namespace {

using nlohmann::json;
using support::bytes_of;
using support::shared_mission_files;

constexpr double printed_places = 0.51e-7;  // the expectations have seven decimals

void expect_settings(const json& wanted, const std::vector<Argument>& found) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].name, wanted[i]["name"]);
    EXPECT_EQ(found[i].unit, wanted[i]["unit"]);
    EXPECT_EQ(found[i].raw, wanted[i]["raw"]);
    EXPECT_EQ(found[i].value, wanted[i]["value"].get<double>());
    EXPECT_EQ(found[i].line, wanted[i]["line"]);
  }
}

void expect_waypoints(const json& wanted, const std::vector<WaypointRow>& found) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].lon_raw, wanted[i]["lon_raw"]);
    EXPECT_EQ(found[i].lat_raw, wanted[i]["lat_raw"]);
    EXPECT_NEAR(found[i].place.lon_deg, wanted[i]["lon"].get<double>(), printed_places);
    EXPECT_NEAR(found[i].place.lat_deg, wanted[i]["lat"].get<double>(), printed_places);
    EXPECT_EQ(found[i].line, wanted[i]["line"]);
  }
}

void expect_argument_file(const json& wanted, const Document& found) {
  EXPECT_EQ(found.kind, DocumentKind::arguments);
  ASSERT_EQ(found.behaviors.size(), 1U);
  EXPECT_EQ(found.behaviors[0].name, wanted["behavior"]);
  EXPECT_EQ(found.behaviors[0].written, wanted["behavior_raw"]);
  expect_settings(wanted["b_args"], found.behaviors[0].arguments);
  if (wanted["verdict"] != "reject")
    expect_waypoints(wanted.value("waypoints", json::array()), found.waypoints);
  if (wanted.contains("num_waypoints_declared")) {
    EXPECT_EQ(found.waypoints_declared, wanted["num_waypoints_declared"].get<int>());
  }
}

void expect_mission(const json& wanted, const Document& found) {
  EXPECT_EQ(found.kind, DocumentKind::mission);
  expect_settings(wanted["sensors"], found.sensors);
  ASSERT_EQ(found.behaviors.size(), wanted["behaviors"].size());
  for (std::size_t i = 0; i < found.behaviors.size(); ++i) {
    EXPECT_EQ(found.behaviors[i].name, wanted["behaviors"][i]["name"]);
    EXPECT_EQ(found.behaviors[i].line, wanted["behaviors"][i]["line"]);
    expect_settings(wanted["behaviors"][i]["b_args"], found.behaviors[i].arguments);
  }
  EXPECT_EQ(json(files_referenced(found)), wanted["mafiles_referenced"]);
}

void expect_messages(const json& wanted, const Messages& found) {
  for (const json& warning : wanted) {
    const bool there = std::ranges::any_of(found, [&](const Message& message) {
      return message.code == warning["code"] &&
             (!warning.contains("line") || message.line == warning["line"]);
    });
    EXPECT_TRUE(there) << warning;
  }
}

std::string all_of(const Messages& messages) {
  std::string text;
  for (const Message& m : messages)
    text += std::to_string(m.line) + " " + severity_name(m.severity) + " " + m.code + ": " + m.text + "\n";
  return text;
}

TEST(SharedMissions, AreReadAsExpected) {
  if (shared_mission_files().empty()) GTEST_SKIP() << "the shared sample files are not here";
  for (const auto& file : shared_mission_files()) {
    SCOPED_TRACE(file.filename());
    const json wanted = json::parse(bytes_of(file.string() + ".expected.json"));

    const Document found = read_document(file.filename().string(), bytes_of(file));

    EXPECT_EQ(verdict_name(found.verdict()), wanted["verdict"]) << all_of(found.messages);
    EXPECT_EQ(found.format.bytes, wanted["bytes"]);
    EXPECT_EQ(found.format.encoding, wanted["encoding"]);
    EXPECT_EQ(found.format.line_endings, wanted["line_endings"]);
    EXPECT_EQ(found.format.ends_with_newline, wanted["ends_with_newline"]);
    expect_messages(wanted["warnings"], found.messages);
    wanted["kind"] == "ma" ? expect_argument_file(wanted, found) : expect_mission(wanted, found);
  }
}

TEST(SharedMissions, WrittenAgainSayTheSame) {
  if (shared_mission_files().empty()) GTEST_SKIP() << "the shared sample files are not here";
  for (const auto& file : shared_mission_files()) {
    SCOPED_TRACE(file.filename());
    const Document read = read_document(file.filename().string(), bytes_of(file));
    if (read.verdict() == Verdict::reject) continue;

    const std::string written = write_document(read);
    const Document again = read_document(read.name, written);

    EXPECT_EQ(write_document(again), written);
    ASSERT_EQ(again.behaviors.size(), read.behaviors.size());
    for (std::size_t i = 0; i < read.behaviors.size(); ++i) {
      ASSERT_EQ(again.behaviors[i].arguments.size(), read.behaviors[i].arguments.size());
      for (std::size_t k = 0; k < read.behaviors[i].arguments.size(); ++k) {
        EXPECT_EQ(again.behaviors[i].arguments[k].value, read.behaviors[i].arguments[k].value);
      }
    }
    ASSERT_EQ(again.waypoints.size(), read.waypoints.size());
    for (std::size_t i = 0; i < read.waypoints.size(); ++i)
      EXPECT_EQ(again.waypoints[i].place, read.waypoints[i].place);
  }
}

}  // namespace
}  // namespace floeplan::mission::shared_missions_test
