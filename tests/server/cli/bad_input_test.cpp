#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::bad_input_test {
namespace {

using support::Outcome;
using support::Program;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> plan(std::vector<std::string> more) {
  std::vector<std::string> words{"plan", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream{file} << text; }

/// Ends with code 3, says this, and leaves the store empty.
void expect_refused_file(const Program& program, const std::filesystem::path& file,
                         const std::string& reason) {
  const Outcome outcome = program.run({"ingest", file.string(), "--json"});

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr(reason));
  EXPECT_EQ(outcome.json()["datasets"][0]["status"], "refused");
  EXPECT_EQ(program.run({"datasets", "--json"}).json()["datasets"].size(), 0U);
}

TEST(BadInput, AnEmptyFileIsRefused) {
  const Program program;
  write(program.folder() / "empty.nc", "");
  expect_refused_file(program, program.folder() / "empty.nc", "empty");
}

TEST(BadInput, TextWithTheNameOfANetcdfIsRefused) {
  const Program program;
  write(program.folder() / "notes.nc", "currents will follow tomorrow\n");
  expect_refused_file(program, program.folder() / "notes.nc", "notes.nc");
}

TEST(BadInput, AFileThatIsNotThereIsRefused) {
  const Program program;
  expect_refused_file(program, program.folder() / "missing.tif", "missing.tif");
}

TEST(BadInput, AnEndlessFileOfAreasIsRefusedUnread) {
  const Program program;
  const std::filesystem::path file = program.folder() / "areas.geojson";
  write(file, "{");
  std::filesystem::resize_file(file, 1'000'000'000);  // takes no room: it has no content

  const Outcome outcome = program.run(plan({"--areas", file.string()}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("longer than 16 MB"));
}

TEST(BadInput, ARequestFileThatIsNotJsonSaysWhere) {
  const Program program;
  write(program.folder() / "half.json", R"({"from": [-53, 69], "to": )");
  write(program.folder() / "large.json", R"({"from": [-53, 1e999]})");

  const Outcome half = program.run(plan({"--request", (program.folder() / "half.json").string()}));
  const Outcome large = program.run(plan({"--request", (program.folder() / "large.json").string()}));

  EXPECT_EQ(half.exit_code, 3);
  EXPECT_THAT(half.err, HasSubstr("is not JSON from byte"));
  EXPECT_EQ(large.exit_code, 3);
  EXPECT_THAT(large.err, HasSubstr("too large"));
}

/// Law: every fault inside a file of input data gives the same exit code, however early it is found.
TEST(BadInput, ARequestFileOfAnotherShapeIsBadData) {
  const Program program;
  const std::filesystem::path file = program.folder() / "request.json";
  for (const std::string& text : {std::string{"[1, 2]"}, std::string{"not json"}, std::string{},
                                  std::string(10'000, '['), std::string{R"({"via": [[[1]]]})"}}) {
    write(file, text);
    for (const char* command : {"plan", "reach"})
      EXPECT_EQ(program.run({command, "--request", file.string()}).exit_code, 3) << text.substr(0, 20);
    EXPECT_EQ(program.run(plan({"--areas", file.string()})).exit_code, 3) << text.substr(0, 20);
  }

  write(file, R"({"type": 1, "uncertainty": 1, "current_error": 1, "mission_files": 1})");
  const std::string name = file.string();
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"plan", "--request", name, "--members", "2", "--robust", "0.9"},
           {"simulate", "p0", "--request", name, "--current-error", "0.1", "--mission", name},
           {"evaluate", name}}) {
    EXPECT_EQ(program.run(words).exit_code, 3) << words.front();
  }

  const std::string missing = (program.folder() / "missing.json").string();
  EXPECT_EQ(program.run(plan({"--request", missing})).exit_code, 1) << "nothing is known of its data";
}

TEST(BadInput, ARequestFileThatNamesAnInputTwiceSaysWhich) {
  const Program program;
  write(program.folder() / "twice.json", R"({"from": [-53, 69], "speed_m_s": 0.3, "speed_m_s": 0.6})");

  const std::string file = (program.folder() / "twice.json").string();
  const Outcome planned = program.run(plan({"--request", file}));
  const Outcome simulated = program.run({"simulate", "p0123456789ab", "--request", file});

  EXPECT_EQ(planned.exit_code, 3);
  EXPECT_THAT(planned.err, HasSubstr("speed_m_s"));
  EXPECT_EQ(simulated.exit_code, 3);
  EXPECT_THAT(simulated.err, HasSubstr("speed_m_s"));
}

TEST(BadInput, ASpeedThatIsNotFiniteIsNamedAsSuch) {
  const Outcome outcome = Program{}.run(
      plan({"--from=-53,69", "--to=-52,69", "--depart", "2026-11-22T06:00:00Z", "--speed", "inf"}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("floeplan: --speed"));
  EXPECT_THAT(outcome.err, HasSubstr("not finite"));
}

TEST(BadInput, ALatitudeOf95NamesItsFlagAndTheOrder) {
  const Outcome outcome =
      Program{}.run(plan({"--from=-53,95", "--to=-52,69", "--depart", "2026-11-22T06:00:00Z"}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("floeplan: --from"));
  EXPECT_EQ(outcome.json()["status"], "invalid");
}

TEST(BadInput, AStartThatIsTheGoalIsRefused) {
  const Outcome outcome =
      Program{}.run(plan({"--from=-53,69", "--to=-53,69", "--depart", "2026-11-22T06:00:00Z"}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("floeplan: --to"));
}

TEST(BadInput, EveryViolationIsNamedAtOnce) {
  const Outcome outcome = Program{}.run(plan({"--from=-53,69", "--sectors", "9", "--method", "guess"}));

  EXPECT_EQ(outcome.exit_code, 3);
  for (const char* field : {"--to is ", "--depart is ", "--sectors must ", "--method must "})
    EXPECT_THAT(outcome.err, HasSubstr(field));
}

TEST(BadInput, NotANumberInAFlagIsWrongUsage) {
  const Outcome outcome =
      Program{}.run(plan({"--from=nan,69", "--to=-52,69", "--depart", "2026-11-22T06:00:00Z"}));

  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--from"));
}

/// The names of the flags of a command whose help says that they take a number; of several names the first, as messages do.
std::vector<std::string> flags_with_a_number(const Program& program,
                                             const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  words.push_back("--help-all");
  const std::string help = program.run(words).out;
  static const std::regex form{R"((--[a-z-]+)(,--[a-z-]+)* (NUMBER|INTEGER))"};
  std::vector<std::string> flags;
  for (std::sregex_iterator at{help.begin(), help.end(), form}; at != std::sregex_iterator{}; ++at)
    flags.push_back((*at)[1]);
  return flags;
}

/// Law: a flag that takes a number does not count as absent if its value is empty, for example from an unset
/// variable of a script.
TEST(BadInput, AnEmptyNumberInAnyFlagIsWrongUsage) {
  const Program program;
  std::size_t flags = 0;
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"plan"},
                                             {"evaluate", "a.csv"},
                                             {"reach"},
                                             {"simulate", "p0"},
                                             {"export", "p0"},
                                             {"serve", "--behind-proxy"},
                                             {"ingest", "a"},
                                             {"probe", "--at=0,0"},
                                             {"check", "a.mi"},
                                             {"audit"},
                                             {"datasets", "prune"},
                                             {"demo", (program.folder() / "demo").string()}}) {
    for (const std::string& flag : flags_with_a_number(program, command)) {
      std::vector<std::string> words = command;
      words.insert(words.end(), {flag, ""});
      const Outcome outcome = program.run(words);
      EXPECT_EQ(outcome.exit_code, 2) << command.front() << ' ' << flag;
      EXPECT_THAT(outcome.err, HasSubstr(flag));
      ++flags;
    }
  }
  EXPECT_GT(flags, 80U);
}

TEST(BadInput, AnEmptyNumberInAFileOfOptionsIsWrongUsage) {
  const Program program;
  write(program.folder() / "floeplan.toml", "[plan]\nmargin = \"\"\n");

  const Outcome outcome = program.run({"--config", (program.folder() / "floeplan.toml").string(), "plan"});

  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--margin"));
}

TEST(BadInput, AnUnknownDatasetIsNamed) {
  const Outcome outcome = Program{}.run(plan({"--from=-53,69", "--to=-52,69", "--depart",
                                              "2026-11-22T06:00:00Z", "--currents", "currents-00000000"}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("currents-00000000"));
}

TEST(BadInput, AnUnknownKeyOfARequestFileIsAnError) {
  const Program program;
  write(program.folder() / "request.json",
        R"({"from":[-53,69],"to":[-52,69],"depart":"2026-11-22T06:00:00Z","sped":1})");

  const Outcome outcome = program.run(plan({"--request", (program.folder() / "request.json").string()}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("sped"));
}

TEST(BadInput, ARequestFileThatIsWrongThroughoutIsAnsweredShortly) {
  const Program program;
  nlohmann::json request;
  for (int i = 0; i < 100'000; ++i) request["k" + std::to_string(i)] = 1;
  write(program.folder() / "request.json", request.dump());

  const Outcome outcome = program.run(plan({"--request", (program.folder() / "request.json").string()}));

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_LT(outcome.err.size(), 20'000U);
  EXPECT_THAT(outcome.err, HasSubstr("floeplan: there are more faults than these 100"));
  EXPECT_EQ(outcome.json()["errors"].size(), 101U);
}

TEST(BadInput, AnUnknownFlagOrCommandIsWrongUsage) {
  EXPECT_EQ(Program{}.run({"plan", "--fast"}).exit_code, 2);
  EXPECT_EQ(Program{}.run({"dance"}).exit_code, 2);
  EXPECT_EQ(Program{}.run({}).exit_code, 2);
}

TEST(Options, MayComeFromAFile) {
  const Program program;
  write(program.folder() / "floeplan.toml",
        "[plan]\nfrom = \"-53,95\"\nto = \"-52,69\"\ndepart = \"2026-11-22T06:00:00Z\"\n");

  const Outcome outcome = program.run({"--config", (program.folder() / "floeplan.toml").string(), "plan"});

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("floeplan: --from"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("--depart")));
}

/// Otherwise a plan with a mistyped path would lead through a sea without data.
TEST(BadInput, AFolderThatIsNotThereIsNoStore) {
  const Program program;
  std::filesystem::remove(program.store());

  for (const std::vector<std::string>& words :
       {plan({"--from=-53,69", "--to=-52,69", "--depart", "2026-11-22T06:00:00Z"}),
        std::vector<std::string>{"datasets"}}) {
    const Outcome outcome = program.run(words);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("there is no store in " + program.store().string()));
  }
  EXPECT_FALSE(std::filesystem::exists(program.store()));
}

/// Law: every command that takes the id of a plan gives the same answer if no plan has this id.
TEST(BadInput, APlanThatIsNotStoredIsNamed) {
  const Program program;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"export", "p000000000000", "--format", "gliderdos"},
           {"recheck", "p000000000000"},
           {"compare", "p000000000000", "p000000000001"},
           {"evaluate", "p000000000000", "--depart", "2026-11-22T06:00:00Z"},
           {"simulate", "p000000000000"}}) {
    const Outcome outcome = program.run(words);

    EXPECT_EQ(outcome.exit_code, 1) << words.front();
    EXPECT_THAT(outcome.err, HasSubstr("no plan has the id p000000000000")) << words.front();
  }
}

}  // namespace
}  // namespace floeplan::cli::bad_input_test
