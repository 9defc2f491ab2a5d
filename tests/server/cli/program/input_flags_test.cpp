#include "server/cli/program/input_flags.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/fields/process_fields.hpp"

namespace floeplan::cli::input_flags_test {
namespace {

using fields::Field;
using fields::Kind;
using fields::Process;
using nlohmann::json;
using testing::HasSubstr;

/// A valid value of the flag on the command line; empty if it takes none.
std::string written(const Field& field) {
  switch (field.kind) {
    case Kind::number:
    case Kind::whole_number: return std::to_string(static_cast<int>(field.most));
    case Kind::boolean: return "";
    case Kind::word: return field.flag_sets.empty() ? std::string{field.words.front().name} : "";
    case Kind::place:
    case Kind::places: return "-53,69";
    default: return "6";
  }
}

/// Whether the flag takes a file.
bool is_file(const Field& field) { return field.name == "goals_file" || field.name == "areas"; }

json inputs_of(const std::vector<Field>& fields, std::vector<std::string> words) {
  CLI::App app;
  InputFlags flags;
  flags.add(app, fields);
  std::ranges::reverse(words);  // in the order that the parser expects
  app.parse(words);
  return flags.inputs();
}

/// Each flag sets its own field and no other; without flags no field is set.
TEST(InputFlags, GiveTheFieldsThatTheyAreFor) {
  for (const Process process : {Process::plan_route, Process::evaluate_route, Process::reach}) {
    const std::vector<Field> fields = fields::fields_of(process);
    EXPECT_EQ(inputs_of(fields, {}), json::object());
    for (const Field& field : fields) {
      if (field.flag.empty() || is_file(field)) continue;
      std::vector<std::string> words{"--" + std::string{field.flag}};
      if (const std::string text = written(field); !text.empty()) words.back() += "=" + text;
      SCOPED_TRACE(words.back());

      const json inputs = inputs_of(fields, words);

      EXPECT_EQ(inputs.size(), 1U);
      const json::json_pointer pointer{pointer_of(field)};
      ASSERT_TRUE(inputs.contains(pointer)) << inputs;
      const bool is_turned =
          field.kind != Kind::boolean || inputs.at(pointer).get<bool>() != std::get<bool>(*field.usual);
      EXPECT_TRUE(is_turned);
    }
  }
}

TEST(InputFlags, TakeSecondsAsADuration) {
  const json inputs = inputs_of(fields::fields_of(Process::plan_route),
                                {"--max-loiter", "PT2H", "--surfacing-interval", "7200"});

  EXPECT_EQ(inputs, (json{{"max_loiter_s", 7200.0}, {"under_ice", {{"surfacing_interval_s", 7200.0}}}}));
}

TEST(InputFlags, HaveOneForNoneAndKeepTheNameThatTheyHadBefore) {
  const auto inputs_by = [](const std::vector<std::string>& flags) {
    return inputs_of(fields::fields_of(Process::plan_route), flags);
  };

  EXPECT_EQ(inputs_by({"--no-hold"}), (json{{"max_loiter_s", 0.0}}));
  EXPECT_EQ(inputs_by({"--max-hold", "PT2H"}), inputs_by({"--max-loiter", "PT2H"}));
  EXPECT_THROW(inputs_by({"--no-hold", "--max-hold", "PT2H"}), CLI::Error);
}

TEST(InputFlags, AreExplainedWithUnitRangeAndWhatIsUsual) {
  CLI::App app;
  InputFlags flags;
  flags.add(app, fields::fields_of(Process::plan_route));

  const std::string help = app.help();

  EXPECT_THAT(help, HasSubstr("when passing under; metres, 0 to 1000; default 20"));
  EXPECT_THAT(help, HasSubstr("seconds or as PT2H, 0 to 864000; default 864000"));
  EXPECT_THAT(help, HasSubstr("Do not let icebergs drift"));
  EXPECT_THAT(help, HasSubstr("astar, frozen, direct; default astar"));
}

}  // namespace
}  // namespace floeplan::cli::input_flags_test
