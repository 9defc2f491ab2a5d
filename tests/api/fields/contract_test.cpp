#include "tests/api/fields/contract.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/written_out.hpp"

namespace floeplan::fields::contract_test {
namespace {

using nlohmann::ordered_json;

std::string read(const std::string& file) { return support::text_of_tree(file); }

void expect_fresh(const std::string& file, const std::string& made) {
  support::expect_written_out(file, made, "fields_test");
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
