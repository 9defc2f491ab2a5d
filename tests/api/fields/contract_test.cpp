#include "tests/api/fields/contract.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/support/places.hpp"

namespace floeplan::fields::contract_test {
namespace {

using nlohmann::ordered_json;

/// Lets the tests write the files that they would find out of date.
constexpr const char* let_write = "FLOEPLAN_WRITE_CONTRACT";

std::string path_of(const std::string& file) { return support::source_folder() + "/" + file; }

std::string read(const std::string& file) {
  std::ifstream stream{path_of(file), std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// The first line that the file has otherwise, and how it is made.
std::string first_difference(const std::string& file, const std::string& made) {
  std::istringstream lines_of_file{file};
  std::istringstream lines_made{made};
  std::string there;
  std::string wanted;
  for (int line = 1;; ++line) {
    const bool has_line = static_cast<bool>(std::getline(lines_of_file, there));
    const bool is_line_made = static_cast<bool>(std::getline(lines_made, wanted));
    if (!(has_line && is_line_made) || there != wanted)
      return "line " + std::to_string(line) + " is\n" + there + "\nand is to be\n" + wanted + "\n";
  }
}

/// The file holds what is made from the table; where it may be written it does so from now on.
void expect_fresh(const std::string& file, const std::string& made) {
  if (std::getenv(let_write) != nullptr) std::ofstream{path_of(file), std::ios::binary} << made;
  const std::string there = read(file);
  EXPECT_TRUE(there == made) << file << " is out of date: " << first_difference(there, made) << "Run "
                             << let_write << "=1 build/release/fields_test and commit what it writes.";
}

TEST(Contract, OfOpenApiSaysWhatTheTableOfFieldsSays) {
  const std::string file = "api/openapi/openapi.json";
  const ordered_json document = ordered_json::parse(read(file));

  expect_fresh(file, with_fields(document).dump(1) + "\n");
}

TEST(Contract, OfOpenApiKnowsNoFieldThatTheTableLacks) {
  const ordered_json document = ordered_json::parse(read("api/openapi/openapi.json"));

  EXPECT_THAT(unknown_members(document), testing::IsEmpty());
}

TEST(Contract, OfTheClientSaysWhatTheTableOfFieldsSays) {
  expect_fresh("web/src/contract/request_fields.ts", client_source());
}

TEST(Contract, OfTheFuzzersNamesEveryField) {
  const std::string file = "tests/fuzz/request.dict";

  expect_fresh(file, with_names(read(file)));
}

}  // namespace
}  // namespace floeplan::fields::contract_test
