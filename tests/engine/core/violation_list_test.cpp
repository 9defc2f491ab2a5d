#include "engine/core/violation_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floeplan::core::violation_list_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::SizeIs;

Violations of(std::size_t count) {
  Violations list;
  for (std::size_t i = 0; i < count; ++i) note(list, {"/" + std::to_string(i), "is wrong"});
  return list;
}

TEST(ViolationList, HoldsEveryFaultAsFarAsAPersonReads) {
  const Violations list = of(most_violations);

  EXPECT_THAT(list, SizeIs(most_violations));
  EXPECT_EQ(list.back().field, "/99");
  EXPECT_FALSE(is_full(list));
}

TEST(ViolationList, EndsWithOneThatSaysThatThereAreMore) {
  const Violations list = of(100'000);

  EXPECT_THAT(list, SizeIs(most_violations + 1));
  EXPECT_THAT(list.back().rule, HasSubstr("more faults than these 100"));
  EXPECT_TRUE(is_full(list));
}

TEST(ViolationList, SaysOnceThatThereAreMoreWhereListsAreJoined) {
  Violations all = of(5);
  for (const Violation& violation : of(100'000)) note(all, violation);

  EXPECT_THAT(all, SizeIs(most_violations + 1));
  EXPECT_THAT(all[most_violations - 1].rule, "is wrong");
  EXPECT_THAT(all.back().rule, HasSubstr("more faults"));
}

TEST(ViolationList, IsShortenedAsItWouldHaveBeenNoted) {
  const Violations long_list(100'000, {"/a", "is wrong"});

  EXPECT_EQ(shortened(of(3)), of(3));
  EXPECT_EQ(shortened(of(100'000)), of(100'000));
  EXPECT_THAT(shortened(long_list), SizeIs(most_violations + 1));
}

TEST(ViolationList, CutsTextsThatOutsideDataMakeLong) {
  Violations list;
  note(list, {"/" + std::string(1'000'000, 'k'), "is not " + std::string(1'000'000, 'v')});

  EXPECT_THAT(list.front().field, SizeIs(200));
  EXPECT_THAT(list.front().rule, SizeIs(1000));
  EXPECT_THAT(list.front().rule, EndsWith("v..."));
}

TEST(CutShort, KeepsCharactersOfSeveralBytesWhole) {
  EXPECT_EQ(cut_short("Kangerlussuaq", 13), "Kangerlussuaq");
  EXPECT_EQ(cut_short("Kangerlussuaq", 9), "Kanger...");
  EXPECT_EQ(cut_short("\xC3\xA6\xC3\xB8\xC3\xA5\xC3\xA6", 6), "\xC3\xA6...");
  EXPECT_EQ(cut_short("\xF0\x9F\xA7\x8A\xF0\x9F\xA7\x8A", 6), "...");
}

}  // namespace
}  // namespace floeplan::core::violation_list_test
