#include "storage/repository/access/audit_repository.hpp"

#include <gtest/gtest.h>

#include "tests/support/empty_store.hpp"

namespace floeplan::repository::audit_repository_test {
namespace {

TEST(Audit, IsReadFromTheNewestEntryBackwards) {
  sql::Connection db = support::empty_store();
  AuditRepository audit{db};
  for (int i = 1; i <= 3; ++i) {
    audit.add({.at = core::UtcTime{core::Seconds{1.8e9 + i}},
               .caller = "ship",
               .peer = "192.0.2.1",
               .action = "export",
               .target = "/plans/" + std::to_string(i),
               .request_id = "id"});
  }

  const auto newest = audit.list(0, 2);
  ASSERT_EQ(newest.size(), 2U);
  EXPECT_EQ(newest[0].target, "/plans/3");
  EXPECT_EQ(newest[0].caller, "ship");
  EXPECT_EQ(newest[0].at, core::UtcTime{core::Seconds{1.8e9 + 3}});
  const auto rest = audit.list(newest[1].row, 10);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].target, "/plans/1");
}

}  // namespace
}  // namespace floeplan::repository::audit_repository_test
