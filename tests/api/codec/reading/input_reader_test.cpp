#include "api/codec/reading/input_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/bytes/document_values.hpp"

namespace floeplan::codec::input_reader_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

json with_unknown_keys(int count) {
  json object = json::object();
  for (int i = 0; i < count; ++i) object["k" + std::to_string(i)] = 1;
  return object;
}

std::size_t bytes_of(const core::Violations& violations) {
  std::size_t bytes = 0;
  for (const core::Violation& violation : violations) bytes += violation.field.size() + violation.rule.size();
  return bytes;
}

TEST(InputReader, NamesTheKnownKeysOnceAndEveryUnknownOne) {
  const json object{{"speed", 1}, {"colour", 2}, {"shape", 3}};
  InputReader reader{object};
  (void)reader.member("speed");
  (void)reader.member("depth");

  reader.refuse_unknown();

  EXPECT_EQ(
      errors_json(reader.violations()),
      json::parse(R"([{"pointer": "/colour", "detail": "is not a known key. The known keys are depth, speed",
                             "code": "unknown-member", "values": {"known": "depth, speed"}},
                            {"pointer": "/shape", "detail": "is not a known key either; check its name",
                             "code": "another-unknown-member", "values": {}}])"));
}

TEST(InputReader, NotesAHundredOfVeryManyUnknownKeysAndThatThereAreMore) {
  const json object = with_unknown_keys(95'000);
  InputReader reader{object};

  reader.refuse_unknown();

  EXPECT_THAT(reader.violations(), SizeIs(core::most_violations + 1));
  EXPECT_THAT(reader.violations().back().rule, HasSubstr("more faults"));
  EXPECT_LT(bytes_of(reader.violations()), 10'000U);
}

TEST(InputReader, NotesAHundredFaultsInAllOfReadersInsideEachOther) {
  const json object = with_unknown_keys(80);
  InputReader reader{object};
  for (const char* place : {"/a", "/b", "/c"}) {
    InputReader members{object};
    members.refuse_unknown();
    reader.refuse_all(place, members.violations());
  }

  EXPECT_THAT(reader.violations(), SizeIs(core::most_violations + 1));
  EXPECT_THAT(reader.violations()[core::most_violations - 1].field, StartsWith("/b/"));
  EXPECT_TRUE(reader.is_full());
}

TEST(InputReader, LeavesTheRestOfAnArrayThatIsWrongThroughout) {
  const json object{{"places", json::array()}};
  json array = json::array();
  for (int i = 0; i < 100'000; ++i) array.push_back("here");
  InputReader reader{object};

  EXPECT_FALSE(reader.places(array, "/places", 0, array.size()).has_value());

  EXPECT_THAT(reader.violations(), SizeIs(core::most_violations + 1));
}

TEST(InputReader, CutsTheNamesOfKeysThatNobodyCanRead) {
  json object = json::object();
  for (int i = 0; i < 100; ++i) object[std::to_string(i) + std::string(10'000, 'k')] = 1;
  InputReader reader{object};

  reader.refuse_unknown();

  EXPECT_THAT(reader.violations(), SizeIs(100));
  EXPECT_LT(bytes_of(reader.violations()), 30'000U);
}

}  // namespace
}  // namespace floeplan::codec::input_reader_test
