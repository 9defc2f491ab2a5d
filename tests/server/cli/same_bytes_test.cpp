#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <regex>
#include <set>
#include <sstream>

#include "tests/server/cli/program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::same_bytes_test {
namespace {

namespace fs = std::filesystem;
using support::Program;

/// Two seas: a river of the paper, which is small, with a tide, and the demonstration's bay with depths, ice and icebergs. $river and
/// so on stand for a start, a goal and what goes with them, $plan for the id of the first plan. No request ends with its
/// computing time, or it would not even be the same twice: what is refined has time enough to converge.
const std::vector<std::pair<std::string, std::string>>& abbreviations() {
  static const std::vector<std::pair<std::string, std::string>> all{
      {"$river", "--from=-56.90,66.00 --to=-56.60,66.05 --depart 2026-11-22T06:00:00Z $grid"},
      {"$back", "--from=-56.60,66.05 --to=-56.90,66.00 --depart 2026-11-22T06:00:00Z $grid"},
      {"$bay", "--from=-53.20,69.20 --to=-53.05,69.18 --depart 2026-11-22T06:00:00Z $grid"},
      {"$bergs", "--from=-52.00,69.20 --to=-51.80,69.18 --depart 2026-11-22T06:00:00Z $grid"},
      {"$ice",
       "--from=-53.15,68.95 --to=-51.75,69.0 --depart 2026-11-22T00:00:00Z --currents none --icebergs none"
       " --spacing 3000 --no-refine"},
      {"$refined",
       "--from=-56.98,66.00 --to=-56.36,66.02 --depart 2026-11-22T06:00:00Z --spacing 2000"
       " --refine-seconds 60"},
      {"$grid", "--spacing 1500 --no-refine"},
      {"$errors", "--members 4 --current-error 0.05 --error-length 20000 --error-time PT12H"},
      {"$thruster", "--vehicle slocum-g3-200-thruster"}};
  return all;
}

constexpr std::array in_the_river{
    "plan $river",
    "plan $river --method tve",
    "plan $river --method dijkstra",
    "plan $river --method frozen",
    "plan $river --method direct",
    "plan $river --sectors 5 --steady",
    "plan $river --sectors 1",
    "plan $river --speed 0.4 --dive-depth 100",
    "plan $river --pitch 24 --climb-to 10",
    "plan $river --max-leg 3000 --max-waypoints 9",
    "plan $river --currents none",
    "plan $refined",
    "plan $refined --max-waypoints 6",
    "plan $refined --objective energy",
    "plan $back",
    "plan $back --method tve",
    "plan $river --objective energy",
    "plan $back --objective energy --battery 4000000 --require-battery",
    "plan $river --objective energy $thruster",
    "plan $river --objective weighted:0.01",
    "plan $back --objective weighted:0.05 $thruster",
    "plan $back --thruster on $thruster",
    "plan $river --depart-until 2026-11-22T18:00:00Z --depart-step PT3H",
    "plan $back --depart-until 2026-11-22T12:00:00Z --depart-step PT3H --objective energy",
    "plan $back --arrive-by 2026-11-24T00:00:00Z",
    "plan $river --arrive-by 2026-11-23T12:00:00Z --method tve",
    "plan $river $errors",
    "plan $back $errors --arrive-before 2026-11-23T18:00:00Z",
    "plan $river $errors --robust mean",
    "plan $river $errors --robust 0.9",
    "plan $river $errors --robust mean --depart-until 2026-11-22T09:00:00Z --depart-step PT3H",
    "plan $river --via=-56.75,66.03",
    "plan $back --via=-56.8,66.03 --via=-56.7,66.00 --best-order",
    "plan $back --via=-56.8,66.03 --via=-56.7,66.00 --via=-56.75,66.04 --best-order --objective energy",
    "plan $river --speed 0.1",
    "plan $river --tides newest --tides-mode add",
    "plan $back --tides newest --tides-mode only --objective energy",
    "evaluate $plan --depart 2026-11-22T12:00:00Z --tides newest --tides-mode only",
    "evaluate $plan --depart 2026-11-22T12:00:00Z",
    "evaluate $plan --depart 2026-11-22T12:00:00Z --speed 0.4",
    "evaluate $plan --depart 2026-11-22T12:00:00Z --steady $thruster",
    "reach --from=-56.8,66.0 --depart 2026-11-22T06:00:00Z --hours 3,6 --spacing 1000",
    "reach --from=-56.8,66.0 --depart 2026-11-22T06:00:00Z --hours 6 --spacing 1000 --speed 0.2",
    "reach --to=-56.7,66.02 --arrive-by 2026-11-23T12:00:00Z --hours 6 --spacing 1000",
    "recheck $plan",
    "probe --at=-56.7,66.02 --time 2026-11-23T01:30:00Z",
    "simulate $plan --seed 7",
    "simulate $plan --runs 2 --seed 8 --current-error 0.05 --workers 1",
};

constexpr std::array in_the_bay{
    "plan $bay",
    "plan $bay --objective energy --no-optimality-gap",
    "plan $bay --arrive-by 2026-11-23T12:00:00Z --no-optimality-gap",
    "plan $bay --depart-until 2026-11-22T12:00:00Z --depart-step PT3H --no-optimality-gap",
    "plan $bergs",
    "plan $bergs --max-loiter 7200",
    "plan $bergs --no-iceberg-drift --max-inflation 1000",
    "plan $bergs --pass-under --keel-clearance 10 --vehicle slocum-g3-1000",
    "plan $bergs --encounter-weight 7200",
    "plan $ice",
    "plan $ice --surfacing-interval PT4H",
    "plan $ice --margin-below-ice 30 --max-concentration-to-surface 0.3",
    "plan $ice --max-time-without-surfacing 50400 --escape-plan",
    "plan $ice --objective energy --escape-plan",
    "probe --at=-52.6,68.96 --time 2026-11-22T12:00:00Z",
    "probe --at=-52.95,69.19 --time 2026-11-22T09:30:00Z",
};

const char* const without_fma = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F";

/// A diurnal tide about the river, by ncgen.
const char* const tide_file = R"(netcdf k1 {
dimensions: lat = 2; lon = 2;
variables:
  double lat(lat); lat:units = "degrees_north";
  double lon(lon); lon:units = "degrees_east";
  double Ua(lat, lon); Ua:units = "cm/s";
  double Ug(lat, lon); Ug:units = "degrees";
  double Va(lat, lon); Va:units = "cm/s";
  double Vg(lat, lon); Vg:units = "degrees";
data:
  lat = 65, 67; lon = -58, -56;
  Ua = 10, 8, 12, 9; Ug = 100, 120, 140, 160;
  Va = 5, 6, 7, 8; Vg = 30, 10, 350, 330;
})";

/// How the program is run for all requests.
struct Manner {
  std::string environment;
  std::string flags;
};

std::string output_of(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "no pipe";
  std::string text;
  std::array<char, 65536> buffer{};
  while (const std::size_t read = fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), read);
  const int status = pclose(pipe);
  return text + "\nended with " + std::to_string(status);
}

std::string spelled_out(std::string request, const std::string& plan) {
  const auto replace = [&request](const std::string& what, const std::string& with) {
    if (const auto at = request.find(what); at != std::string::npos) request.replace(at, what.size(), with);
  };
  replace("$plan", plan);
  for (const auto& [name, words] : abbreviations()) replace(name, words);
  return request;
}

/// `answer` without its computing time, and without the id of a simulation, which depends on that time.
std::string timeless(const std::string& answer) {
  static const std::regex of_computing{
      R"re(("(seconds|real_time_factor|simulation_id)": ?)("s[0-9a-f]+"|[-+.e0-9]+))re"};
  return std::regex_replace(answer, of_computing, "$1-");
}

/// The answers of the program to all requests, on a copy of the store, in which the plans are stored.
template <class Requests>
std::vector<std::string> answers(const Requests& requests, const fs::path& store, const fs::path& copy,
                                 const Manner& manner) {
  fs::copy(store, copy, fs::copy_options::recursive);
  const std::string program = manner.environment + " '" + support::program_folder() + "/floeplan' --data '" +
                              copy.string() + "' " + manner.flags + ' ';
  std::vector<std::string> result;
  std::string plan{"none"};
  for (const char* const request : requests) {
    result.push_back(timeless(output_of(program + spelled_out(request, plan) + " --json 2>&1")));
    if (result.size() > 1) continue;
    const auto key = result.front().find("\"plan_id\": \"");
    if (key != std::string::npos)
      plan = result.front().substr(key + 12, result.front().find('"', key + 12) - key - 12);
  }
  return result;
}

/// How the program is run: as it is, without fused multiply-add in the C library, and with each instruction set of
/// the searches.
std::vector<Manner> manners() {
  std::vector<Manner> all{
      {"", ""}, {without_fma, ""}, {"", "--instructions reference"}, {"", "--instructions baseline"}};
  if (__builtin_cpu_supports("avx2")) all.push_back({"", "--instructions avx2"});
  return all;
}

std::string contents(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

class SameBytes : public testing::Test {
 protected:
  /// The demonstration data of this scenario, ingested.
  void ingest(const std::string& scenario) {
    const fs::path demo = program_.folder() / "demo";
    const fs::path again = program_.folder() / "again";
    ASSERT_EQ(
        program_.run({"demo", demo.string(), "--scenario", scenario, "--start", "2026-11-22"}).exit_code, 0);
    output_of(std::string{without_fma} + " '" + support::program_folder() + "/floeplan' demo '" +
              again.string() + "' --start 2026-11-22 --scenario " + scenario);
    for (const auto& entry : fs::directory_iterator{demo})
      EXPECT_EQ(contents(entry.path()), contents(again / entry.path().filename())) << entry.path();
    std::vector<std::string> words{"ingest"};
    for (const auto& entry : fs::directory_iterator{demo}) {
      if (entry.path().extension() != ".txt") words.push_back(entry.path());
    }
    ASSERT_EQ(program_.run(words).exit_code, 0);
  }

  template <class Requests>
  void expect_same_answers(const Requests& requests) {
    std::vector<std::future<std::vector<std::string>>> passes;
    for (const Manner& manner : manners()) {
      const fs::path copy = program_.folder() / ("store" + std::to_string(passes.size()));
      passes.push_back(std::async(std::launch::async, [&requests, manner, copy, store = program_.store()] {
        return answers(requests, store, copy, manner);
      }));
    }
    const std::vector<std::string> plainly = passes.front().get();
    for (std::size_t i = 0; i < requests.size(); ++i) {
      EXPECT_THAT(plainly[i], testing::Not(testing::AnyOf(testing::HasSubstr("not expected"),
                                                          testing::HasSubstr("no plan has"))))
          << requests[i];
    }
    for (std::size_t pass = 1; pass < passes.size(); ++pass) {
      const std::vector<std::string> otherwise = passes[pass].get();
      const Manner manner = manners()[pass];
      for (std::size_t i = 0; i < requests.size(); ++i) {
        EXPECT_EQ(plainly[i], otherwise[i]) << requests[i] << " with " << manner.environment << manner.flags;
      }
    }
  }

  const Program program_;
};

TEST_F(SameBytes, ComeFromEveryProcessorInTheRiver) {
  ingest("river");
  std::ofstream{program_.folder() / "k1.cdl"} << tide_file;
  const std::string tide = (program_.folder() / "k1.nc").string();
  output_of("ncgen -k nc4 -o '" + tide + "' '" + (program_.folder() / "k1.cdl").string() + "'");
  ASSERT_EQ(program_.run({"ingest", tide}).exit_code, 0);
  expect_same_answers(in_the_river);
}

TEST_F(SameBytes, ComeFromEveryProcessorAmongIceAndIcebergs) {
  if (!fs::exists("/usr/share/gmt-gshhg/binned_GSHHS_f.nc"))
    GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  ingest("disko");
  expect_same_answers(in_the_bay);
}

/// The functions of <math.h> that the program takes from the C library. Each of them has only one version
/// there, or returns the exact value (tests/engine/elementary compares their bits).
TEST(ProgramsImports, OfTheMathematicsLibraryDoNotVaryByProcessor) {
  const std::set<std::string> alike{
      "cabs",      "cabsf", "cbrt",   "ceil",   "ceilf",   "feraiseexcept", "floor",      "floorf",
      "fmod",      "hypot", "hypotf", "ldexp",  "llround", "lround",        "nextafterf", "nextafter",
      "remainder", "rint",  "round",  "roundf", "sqrt",    "sqrtf",         "trunc",      "truncf"};
  std::istringstream imports{output_of("readelf -W --dyn-syms '" + support::program_folder() + "/floeplan'")};
  std::istringstream library{output_of("readelf -W --dyn-syms \"$(ldd '" + support::program_folder() +
                                       "/floeplan' | sed -n 's/.*libm.so.6 => \\([^ ]*\\).*/\\1/p')\"")};
  const auto names = [](std::istringstream& table, bool undefined) {
    std::set<std::string> result;
    for (std::string line; std::getline(table, line);) {
      std::istringstream words{line};
      std::vector<std::string> columns{std::istream_iterator<std::string>{words}, {}};
      if (columns.size() < 8 || (columns[6] == "UND") != undefined) continue;
      result.insert(columns[7].substr(0, columns[7].find('@')));
    }
    return result;
  };
  const std::set<std::string> wanted = names(imports, true);
  const std::set<std::string> offered = names(library, false);

  ASSERT_TRUE(offered.contains("sin"));
  ASSERT_TRUE(wanted.contains("hypot"));
  for (const std::string& name : wanted) EXPECT_TRUE(!offered.contains(name) || alike.contains(name)) << name;
}

}  // namespace
}  // namespace floeplan::cli::same_bytes_test
