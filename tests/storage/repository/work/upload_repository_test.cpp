#include "storage/repository/work/upload_repository.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "tests/support/property.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::upload_repository_test {
namespace {

const core::UtcTime noon{core::Seconds{1.8e9}};

class UploadRepositoryTest : public testing::Test {
 protected:
  Upload send(const std::string& name, const std::string& content = "data", core::UtcTime now = noon) {
    std::ofstream{folder_.path() / "arriving"} << content;
    return uploads_.add(folder_.path() / "arriving", name, "digest", "ann", now);
  }

  support::TemporaryFolder folder_;
  UploadRepository uploads_{folder_.path() / "uploads"};
};

TEST_F(UploadRepositoryTest, GivesBackWhatWasSent) {
  const Upload sent = send("u.nc", "some bytes");

  const auto found = UploadRepository{folder_.path() / "uploads"}.find(sent.id);

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->name, "u.nc");
  EXPECT_EQ(found->bytes, 10U);
  EXPECT_EQ(found->sha256, "digest");
  EXPECT_EQ(found->owner, "ann");
  EXPECT_EQ(found->expires, noon + UploadRepository::lifetime);
  std::ifstream in{uploads_.file_of(*found)};
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>{in}, {}), "some bytes");
}

TEST_F(UploadRepositoryTest, ListsTheNewestFirst) {
  EXPECT_THAT(uploads_.list(), testing::IsEmpty()) << "there is no folder yet";
  send("second", "", noon + core::Seconds{1.0});
  send("third", "", noon + core::Seconds{2.0});
  send("first", "", noon);
  std::filesystem::create_directories(folder_.path() / "uploads" / "half.new");

  EXPECT_THAT(uploads_.list(), testing::ElementsAre(testing::Field(&Upload::name, "third"),
                                                    testing::Field(&Upload::name, "second"),
                                                    testing::Field(&Upload::name, "first")));
}

/// Whatever a disk does to a description: the other uploads are there, and no name becomes a path.
TEST_F(UploadRepositoryTest, WhoseDescriptionIsChangedIsPassedOver) {
  const Upload whole = send("whole");
  const Upload changed = send("changed.nc");
  const auto description = folder_.path() / "uploads" / changed.id / "upload.json";
  std::ifstream in{description};
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    std::string spoilt = text;
    const auto at = static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(text.size()) - 1));
    spoilt[at] = static_cast<char>(spoilt[at] ^ (1 << support::uniform_int(rng, 0, 7)));
    std::ofstream{description} << spoilt;

    EXPECT_THAT(uploads_.list(), testing::Contains(testing::Field(&Upload::id, whole.id)));
    if (const auto found = uploads_.find(changed.id)) {
      EXPECT_EQ(found->name, plain_file_name(found->name));
    }
  });
  std::ofstream{description}
      << R"({"name": "../../x", "bytes": 4, "sha256": "", "created_s": 1, "expires_s": 2})";
  EXPECT_FALSE(uploads_.find(changed.id).has_value());
}

TEST_F(UploadRepositoryTest, TakesNoIdForAPath) {
  std::ofstream{folder_.path() / "upload.json"} << "{}";
  for (const char* id : {"..", "../..", ".", "", "/etc", "0123456789abcdef0123456789abcdeF", "../uploads"}) {
    EXPECT_FALSE(uploads_.find(id).has_value()) << id;
    EXPECT_FALSE(uploads_.remove(id)) << id;
  }
}

TEST_F(UploadRepositoryTest, RemovesWhatIsForgottenAndKeepsTheRest) {
  const Upload old = send("old.nc");
  std::filesystem::create_directories(folder_.path() / "uploads" / "half.new");
  const core::UtcTime next_day = noon + UploadRepository::lifetime;

  uploads_.remove_expired(next_day - core::Seconds{1.0});
  EXPECT_TRUE(uploads_.find(old.id).has_value());
  uploads_.remove_expired(next_day);

  EXPECT_FALSE(uploads_.find(old.id).has_value());
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "uploads" / old.id));
}

TEST_F(UploadRepositoryTest, RemovesOnce) {
  const Upload sent = send("u.nc");
  EXPECT_TRUE(uploads_.remove(sent.id));
  EXPECT_FALSE(uploads_.remove(sent.id));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "uploads"));
}

TEST(PlainFileName, KeepsNothingThatCouldLeaveAFolderOrHide) {
  EXPECT_EQ(plain_file_name("u.nc"), "u.nc");
  EXPECT_EQ(plain_file_name("../../etc/passwd"), "passwd");
  EXPECT_EQ(plain_file_name("C:\\data\\Str\xC3\xB6mung 1.nc"), "Str__mung_1.nc");
  EXPECT_EQ(plain_file_name(".."), "upload");
  EXPECT_EQ(plain_file_name(""), "upload");
  EXPECT_EQ(plain_file_name(".hidden"), "hidden");
  EXPECT_EQ(plain_file_name("a/"), "upload");
  EXPECT_EQ(plain_file_name(std::string("a\0b\n", 4)), "a_b_");
  EXPECT_EQ(plain_file_name(std::string(300, 'a') + ".nc").size(), 100U);
  EXPECT_TRUE(plain_file_name(std::string(300, '.') + std::string(99, 'a')).starts_with('a'));
}

}  // namespace
}  // namespace floeplan::repository::upload_repository_test
