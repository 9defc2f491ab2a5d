#include "server/cli/output/violation_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/inputs/reach_inputs.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli::violation_output_test {
namespace {

using nlohmann::json;
using testing::Each;
using testing::Not;

std::string said(const core::Violation& violation) {
  return in_words_of_flags(violation, flags_of(fields::Process::plan_route));
}

TEST(WordsOfFlags, StandInThePlaceOfPointersMembersAndArrays) {
  EXPECT_EQ(said({"/from", "is required: the start as [longitude, latitude]"}),
            "--from is required: the start as LON,LAT");
  EXPECT_EQ(said({"/uncertainty/current_error_m_s", "is required with \"members\": the error, m/s"}),
            "--current-error is required with --members: the error, m/s");
  EXPECT_EQ(
      said({"/spacing_m", "must be a distance from 10 to 100000 m, or two as [along, across], not 1.0"}),
      "--spacing must be a distance from 10 to 100000 m, or two as along,across, not 1.0");
  EXPECT_EQ(said({"/via/1", "must be a place"}), "--via 2 must be a place");
  EXPECT_EQ(said({"/objective/energy", "must be a number"}), "--objective (energy) must be a number");
  EXPECT_EQ(said({"/uncertainty/quantile", "must be a number from 0.01 to 0.99, not 2.0"}),
            "--robust must be a number from 0.01 to 0.99, not 2.0");
  EXPECT_EQ(said({"/currents", "no dataset has the id nosuch"}), "--currents: no dataset has the id nosuch");
}

TEST(WordsOfFlags, LeaveWhatWasGivenAsItWasWritten) {
  EXPECT_EQ(said({"/method", "must be \"tve\" or \"direct\", not \"from\""}),
            "--method must be \"tve\" or \"direct\", not \"from\"");
  EXPECT_EQ(in_words_of_flags({"/files/0", "is empty"}, {}), "/files/0: is empty")
      << "a command without fields";
}

/// Law: no message to a user who wrote flags has a JSON pointer, an array or a member in quotes.
TEST(WordsOfFlags, HoldNoJson) {
  std::vector<std::string> sentences;
  for (const char* text :
       {"{}", R"({"from": [1], "to": 2, "via": [3]})", R"({"uncertainty": {"members": 3}})",
        R"({"uncertainty": {"current_error_m_s": 0.1}})", R"({"spacing_m": 1, "max_leg_m": "x"})",
        R"({"goals_file": {"name": "a.gpx", "text": ""}, "to": [1, 2], "depart": 5})",
        R"({"from": [69, -53], "to": [-52, 69], "depart": "2026-11-22T06:00:00Z"})"}) {
    const auto inputs = codec::parse_plan_inputs(json::parse(text));
    ASSERT_FALSE(inputs) << text;
    for (const core::Violation& violation : inputs.error()) sentences.push_back(said(violation));
  }
  const auto reach = codec::parse_reach_inputs(json::object());
  ASSERT_FALSE(reach);
  for (const core::Violation& violation : reach.error())
    sentences.push_back(in_words_of_flags(violation, flags_of(fields::Process::reach)));

  EXPECT_THAT(sentences, Each(Not(testing::ContainsRegex("(^|[ (])/[a-z]|[][]|\"(members|from|to|via)\""))));
}

}  // namespace
}  // namespace floeplan::cli::violation_output_test
