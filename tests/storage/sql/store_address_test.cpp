#include "storage/sql/store_address.hpp"

#include <gtest/gtest.h>

namespace floeplan::sql::store_address_test {
namespace {

TEST(StoreAddress, IsAFolderOrAServer) {
  EXPECT_EQ(parse_store_address("sqlite:/data/store")->folder, "/data/store");
  EXPECT_FALSE(parse_store_address("sqlite:/data/store")->server);
  for (const char* server :
       {"postgresql://anna@db.example/floeplan?sslmode=verify-full", "postgres:///floeplan"}) {
    EXPECT_EQ(parse_store_address(server)->server, server);
    EXPECT_FALSE(parse_store_address(server)->folder);
  }
}

TEST(StoreAddress, IsRefusedInAnotherForm) {
  for (const char* text : {"", "store", "/data/store", "sqlite:", "mysql://db/floeplan"})
    EXPECT_FALSE(parse_store_address(text)) << text;
}

}  // namespace
}  // namespace floeplan::sql::store_address_test
