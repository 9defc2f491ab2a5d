#include "storage/sql/copies/rows_digest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "storage/sql/statement.hpp"

namespace floeplan::sql::rows_digest_test {
namespace {

RowsDigest digest_of(const std::string& rows) {
  Connection db = Connection::in_memory();
  execute(db, "CREATE TABLE t (i INTEGER, r REAL, t TEXT, b BLOB) STRICT; INSERT INTO t VALUES " + rows);
  RowsDigest digest;
  Statement query{db, "SELECT * FROM t"};
  while (query.step()) digest.add(query, columns_of(db, "t"));
  return digest;
}

TEST(RowsDigest, DoesNotDependOnTheOrderOfRows) {
  EXPECT_EQ(digest_of("(1, 0.5, 'a', x'00'), (2, 1.5, 'b', NULL)"),
            digest_of("(2, 1.5, 'b', NULL), (1, 0.5, 'a', x'00')"));
}

TEST(RowsDigest, DiffersWithEachValue) {
  const RowsDigest whole = digest_of("(1, 0.5, 'a', x'00')");
  EXPECT_EQ(whole.count(), 1);
  for (const char* other : {"(2, 0.5, 'a', x'00')", "(1, 0.25, 'a', x'00')", "(1, 0.5, 'b', x'00')",
                            "(1, 0.5, 'a', x'01')", "(1, 0.5, 'a', x'0000')", "(1, 0.5, 'a', NULL)",
                            "(NULL, 0.5, 'a', x'00')", "(1, 0.5, '', x'00')",
                            "(1, 0.5, 'a', x'00'), (1, 0.5, 'a', x'00')"})
    EXPECT_NE(digest_of(other), whole) << other;
}

TEST(RowsDigest, TellsEmptyTextsAndNothingApart) {
  EXPECT_NE(digest_of("(1, 0.5, '', NULL)"), digest_of("(1, 0.5, NULL, x'')"));
}

}  // namespace
}  // namespace floeplan::sql::rows_digest_test
