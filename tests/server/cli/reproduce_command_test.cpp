#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::reproduce_command_test {
namespace {

using nlohmann::json;
using support::Program;
using ::testing::HasSubstr;

json row(const json& table, const std::string& name) {
  const auto found = std::ranges::find_if(table, [&](const json& each) { return each["row"] == name; });
  return found == table.end() ? json() : *found;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

TEST(Reproduce, GivesBothTablesAsOneDocument) {
  const Program program;

  const auto outcome = program.run({"reproduce", "--json"});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json tables = outcome.json();
  EXPECT_NEAR(row(tables["table_2"], "3-sector")["ours_s"].get<double>(), 162.362, 0.0005);
  EXPECT_NEAR(row(tables["table_3"], "optimal control")["ours_s"].get<double>(), 17.159, 0.0005);
  EXPECT_EQ(row(tables["table_3"], "2-sector with obstacles")["vertices"], 816);
  EXPECT_EQ(row(tables["table_3"], "2-sector with obstacles")["paper_edges"], 11195);
  EXPECT_TRUE(row(tables["table_3"], "direct drive")["ours_s"].is_null());
}

TEST(Reproduce, WritesTheFiguresOnceUnlessForced) {
  const Program program;
  const std::filesystem::path folder = program.folder() / "figures";

  const auto first = program.run({"reproduce", "--figures", folder.string(), "--json"});
  const auto second = program.run({"reproduce", "--figures", folder.string()});

  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.json()["files"].size(), 12U);
  for (const json& file : first.json()["files"]) {
    EXPECT_TRUE(std::filesystem::exists(file.get<std::string>()));
  }
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("--force"));
}

TEST(Reproduce, LaysTheFiguresOnTheMapAndKeepsThePlane) {
  const Program program;
  const std::filesystem::path folder = program.folder();
  std::ofstream{folder / "figure_10.svg"} << "an older one";
  ASSERT_EQ(program.run({"reproduce", "--figures", folder.string(), "--force"}).exit_code, 0);

  const json figure = json::parse(text_of(folder / "figure_10.geojson"));

  EXPECT_EQ(figure["type"], "FeatureCollection");
  EXPECT_THAT(figure["note"].get<std::string>(), HasSubstr("nowhere on Earth"));
  const json& start = figure["features"][0];
  EXPECT_EQ(start["properties"]["plane_xy"], json({-8.0, -2.0}));
  EXPECT_NEAR(start["geometry"]["coordinates"][0].get<double>(), -8000.0 / 111'319.49, 1e-6);
  const auto is_obstacle = [](const json& feature) { return feature["properties"]["kind"] == "obstacle"; };
  EXPECT_EQ(std::ranges::count_if(figure["features"], is_obstacle), 8);
  EXPECT_THAT(text_of(folder / "figure_10.svg"), HasSubstr("3-sector with obstacles: 20.9"));
}

}  // namespace
}  // namespace floeplan::cli::reproduce_command_test
