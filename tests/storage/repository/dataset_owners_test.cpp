#include "storage/repository/dataset_owners.hpp"

#include <gtest/gtest.h>

#include "storage/repository/dataset_repository.hpp"
#include "storage/repository/migrations.hpp"

namespace floeplan::repository::dataset_owners_test {
namespace {

class DatasetOwnersTest : public testing::Test {
 protected:
  DatasetId add(const std::string& id, std::int64_t bytes) {
    Dataset dataset;
    dataset.id = {id};
    dataset.kind = DatasetKind::bathymetry;
    dataset.provenance.file_size_bytes = bytes;
    datasets_.insert(dataset);
    return dataset.id;
  }

  sqlite::Connection db_ = open_store_in_memory();
  DatasetRepository datasets_{db_};
  DatasetOwners owners_{db_};
};

TEST_F(DatasetOwnersTest, AddUpTheBytesOfEachAlone) {
  owners_.note(add("a", 10), "ann");
  owners_.note(add("b", 200), "ann");
  owners_.note(add("c", 3000), "");
  add("d", 40'000);  // of the operator

  EXPECT_EQ(owners_.bytes_of("ann"), 210U);
  EXPECT_EQ(owners_.bytes_of(""), 3000U);
  EXPECT_EQ(owners_.bytes_of("bob"), 0U);
}

TEST_F(DatasetOwnersTest, StayWhoTheyAre) {
  const DatasetId id = add("a", 10);
  owners_.note(id, "ann");

  owners_.note(id, "bob");

  EXPECT_EQ(owners_.bytes_of("ann"), 10U);
  EXPECT_EQ(owners_.bytes_of("bob"), 0U);
}

TEST_F(DatasetOwnersTest, FreeTheirBytesWithTheDataset) {
  const DatasetId id = add("a", 10);
  owners_.note(id, "ann");

  ASSERT_TRUE(datasets_.remove(id));

  EXPECT_EQ(owners_.bytes_of("ann"), 0U);
}

}  // namespace
}  // namespace floeplan::repository::dataset_owners_test
