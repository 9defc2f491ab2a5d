#include "storage/repository/access/token_repository.hpp"

#include <gtest/gtest.h>

#include "tests/support/empty_store.hpp"

namespace floeplan::repository::token_repository_test {
namespace {

constexpr core::UtcTime noon{core::Seconds{1.8e9}};
constexpr core::Seconds hour{3600.0};

class Tokens : public testing::Test {
 protected:
  bool add(const std::string& name, Role role) {
    return tokens_.add(
        {.name = name, .role = role, .key = "key-" + name, .digest = "digest-" + name, .created = noon});
  }
  bool log_in(const std::string& name, const std::string& key, core::UtcTime now) {
    return tokens_.log_in("key-" + name,
                          {.key = key, .digest = "digest-" + key, .created = now, .expires = now + hour});
  }

  sql::Connection db_{support::empty_store()};
  TokenRepository tokens_{db_};
};

TEST_F(Tokens, AreFoundByTheirKeyAndListedByName) {
  EXPECT_FALSE(tokens_.any());
  ASSERT_TRUE(add("ship", Role::pilot));
  ASSERT_TRUE(add("office", Role::admin));

  EXPECT_TRUE(tokens_.any());
  EXPECT_EQ(tokens_.find("key-ship")->name, "ship");
  EXPECT_EQ(tokens_.find("key-ship")->role, Role::pilot);
  EXPECT_FALSE(tokens_.find("key-nobody"));
  ASSERT_EQ(tokens_.list().size(), 2U);
  EXPECT_EQ(tokens_.list().front().name, "office");
}

TEST_F(Tokens, AreRememberedToHaveBeenThereWhenAllAreRevoked) {
  EXPECT_FALSE(tokens_.ever_any());
  ASSERT_TRUE(add("ship", Role::pilot));
  EXPECT_TRUE(tokens_.remove("ship"));
  EXPECT_FALSE(tokens_.any());
  EXPECT_TRUE(tokens_.ever_any());
}

TEST_F(Tokens, BearANameOnce) {
  ASSERT_TRUE(add("ship", Role::pilot));
  EXPECT_FALSE(add("ship", Role::admin));
  EXPECT_EQ(tokens_.find("key-ship")->role, Role::pilot);
}

TEST_F(Tokens, OpenLoginsThatEndInTime) {
  ASSERT_TRUE(add("ship", Role::pilot));
  ASSERT_TRUE(log_in("ship", "browser", noon));
  EXPECT_EQ(tokens_.find_login("browser", noon)->name, "ship");
  EXPECT_EQ(tokens_.find_login("browser", noon)->digest, "digest-browser");
  EXPECT_FALSE(tokens_.find_login("browser", noon + hour));
  EXPECT_FALSE(log_in("nobody", "other", noon));
}

TEST_F(Tokens, TakeTheirLoginsWithThem) {
  ASSERT_TRUE(add("ship", Role::pilot));
  ASSERT_TRUE(log_in("ship", "browser", noon));
  EXPECT_TRUE(tokens_.remove("ship"));
  EXPECT_FALSE(tokens_.find_login("browser", noon));
  EXPECT_FALSE(tokens_.remove("ship"));
}

TEST_F(Tokens, ForgetALoginThatWasEnded) {
  ASSERT_TRUE(add("ship", Role::pilot));
  ASSERT_TRUE(log_in("ship", "browser", noon));
  EXPECT_TRUE(tokens_.log_out("browser"));
  EXPECT_FALSE(tokens_.find_login("browser", noon));
  EXPECT_FALSE(tokens_.log_out("browser"));
}

TEST(Roles, AreReadByTheNamesTheyAreWrittenBy) {
  for (const Role role : {Role::viewer, Role::pilot, Role::admin}) EXPECT_EQ(role_of(role_name(role)), role);
  EXPECT_FALSE(role_of("root"));
}

}  // namespace
}  // namespace floeplan::repository::token_repository_test
