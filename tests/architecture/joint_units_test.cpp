#include <gmock/gmock.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/places.hpp"

namespace floeplan::support::joint_units_test {
namespace {

namespace fs = std::filesystem;

/// The name of the function whose declaration begins on this line, which must not be indented; otherwise
/// empty.
std::string function_in(const std::string& line) {
  for (const char* const other : {"namespace", "using", "struct", "class", "enum", "template", "}", "#", "/"})
    if (line.starts_with(other)) return "";
  const auto parameters = line.find('(');
  if (line.empty() || std::isspace(static_cast<unsigned char>(line[0])) != 0 ||
      parameters == std::string::npos)
    return "";
  if (line.find_first_of("={") < parameters) return "";  // a variable
  auto begin = parameters;
  while (begin > 0 &&
         (std::isalnum(static_cast<unsigned char>(line[begin - 1])) != 0 || line[begin - 1] == '_'))
    --begin;
  return line.substr(begin, parameters - begin);
}

/// The functions in the unnamed namespaces of a source file. Relies on the common formatting of all sources.
std::set<std::string> own_functions(std::istream& source) {
  std::set<std::string> names;
  bool is_inside = false;
  for (std::string line; std::getline(source, line);) {
    if (line == "namespace {") is_inside = true;
    if (line == "}  // namespace") is_inside = false;
    const std::string name = is_inside ? function_in(line) : "";
    if (!name.empty()) names.insert(name);
  }
  return names;
}

/// Functions that two sources of a unit both define in unnamed namespaces, as "name in one source and
/// another".
std::vector<std::string> shared_names(const std::map<std::string, std::set<std::string>>& functions_of) {
  std::vector<std::string> shared;
  std::map<std::string, std::string> first_with;
  for (const auto& [source, names] : functions_of)
    for (const std::string& name : names)
      if (const auto [found, is_new] = first_with.emplace(name, source); !is_new)
        shared.push_back(name + " in " + found->second + " and " + source);
  return shared;
}

std::map<std::string, std::set<std::string>> functions_in_unit(const fs::path& unit) {
  std::map<std::string, std::set<std::string>> functions_of;
  std::ifstream includes{unit};
  for (std::string line; std::getline(includes, line);) {
    const auto begin = line.find('"') + 1;
    const std::string source = line.substr(begin, line.rfind('"') - begin);
    std::ifstream text{fs::path{support::source_folder()} / source};
    EXPECT_TRUE(text) << source;
    functions_of[source] = own_functions(text);
  }
  return functions_of;
}

// If the signatures differ, the compiler gives no error: it takes the function that fits better, which may be
// that of the other source, and the program behaves differently from its sources. Sources of tests have their
// own namespaces.
TEST(JointUnits, HaveNoTwoSourcesWithAFunctionOfOneName) {
  const fs::path units = fs::path{support::program_folder()} / "joint";
  if (!fs::exists(units)) GTEST_SKIP() << "this build compiles every source alone";

  std::vector<std::string> shared;
  std::size_t functions = 0;
  for (const auto& entry : fs::recursive_directory_iterator{units}) {
    const std::string target = entry.path().parent_path().filename();
    if (!entry.is_regular_file() || target.ends_with("_test")) continue;
    const auto functions_of = functions_in_unit(entry.path());
    for (const auto& [source, names] : functions_of) functions += names.size();
    const auto in_unit = shared_names(functions_of);
    shared.insert(shared.end(), in_unit.begin(), in_unit.end());
  }

  EXPECT_THAT(shared, testing::IsEmpty()) << "give one of each two a name of its own";
  EXPECT_GT(functions, 1000U);
}

TEST(JointUnits, AreSearchedForFunctionsOfUnnamedNamespacesAlone) {
  std::istringstream source{
      "namespace {\n\nint one(int a) {\n  two(a);\n}\n\ntemplate <class T>\nstd::vector<T> three(const T&);\n"
      "const std::string four{five(6)};\nstruct Seven {};\n}  // namespace\n\nint eight() { return 8; }\n"};

  EXPECT_THAT(own_functions(source), testing::ElementsAre("one", "three"));
}

}  // namespace
}  // namespace floeplan::support::joint_units_test
