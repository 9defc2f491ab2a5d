#include "storage/repository/work/upload_folder.hpp"
#include "storage/repository/work/uploads_of.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::upload_repository_test {
namespace {

const core::UtcTime noon{core::Seconds{1.8e9}};

/// The uploads of a store: in a folder, or at a database server.
class UploadRepositoryTest : public testing::Test {
 protected:
  Upload send(const std::string& name, const std::string& content = "data", core::UtcTime now = noon) {
    std::ofstream{folder_.path() / "arriving"} << content;
    return uploads_->add(folder_.path() / "arriving", name, "digest", "ann", now);
  }

  support::TemporaryFolder folder_;
  sql::Connection db_{support::empty_store()};
  std::unique_ptr<UploadRepository> uploads_{uploads_of(db_, folder_.path() / "uploads")};
};

class UploadFolderTest : public testing::Test {
 protected:
  Upload send(const std::string& name) {
    std::ofstream{folder_.path() / "arriving"} << "data";
    return uploads_.add(folder_.path() / "arriving", name, "digest", "ann", noon);
  }

  support::TemporaryFolder folder_;
  UploadFolder uploads_{folder_.path() / "uploads"};
};

TEST_F(UploadRepositoryTest, GivesBackWhatWasSent) {
  const Upload sent = send("u.nc", "some bytes");

  const auto found = uploads_of(db_, folder_.path() / "uploads")->find(sent.id);

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->name, "u.nc");
  EXPECT_EQ(found->bytes, 10U);
  EXPECT_EQ(found->sha256, "digest");
  EXPECT_EQ(found->owner, "ann");
  EXPECT_EQ(found->expires, noon + UploadRepository::lifetime);
  EXPECT_FALSE(uploads_->lay_out(*found, folder_.path() / "laid out"));
  std::ifstream in{folder_.path() / "laid out"};
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>{in}, {}), "some bytes");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "arriving")) << "it was taken away";
}

TEST_F(UploadRepositoryTest, GivesBackALargeFileByteByByte) {
  std::mt19937_64 rng{7};
  std::string content(3'500'000, ' ');  // more than one block
  for (char& c : content) c = static_cast<char>(support::uniform_int(rng, -128, 127));
  const Upload sent = send("large.nc", content);

  ASSERT_FALSE(uploads_->lay_out(sent, folder_.path() / "laid out"));

  std::ifstream in{folder_.path() / "laid out", std::ios::binary};
  EXPECT_TRUE(std::string(std::istreambuf_iterator<char>{in}, {}) == content);
}

TEST_F(UploadRepositoryTest, SaysThatARemovedUploadCannotBeLaidOut) {
  const Upload sent = send("u.nc");
  ASSERT_TRUE(uploads_->remove(sent.id));
  EXPECT_TRUE(uploads_->lay_out(sent, folder_.path() / "laid out"));
}

TEST_F(UploadRepositoryTest, ListsTheNewestFirst) {
  EXPECT_THAT(uploads_->list(), testing::IsEmpty()) << "there is no folder yet";
  send("second", "", noon + core::Seconds{1.0});
  send("third", "", noon + core::Seconds{2.0});
  send("first", "", noon);

  EXPECT_THAT(uploads_->list(), testing::ElementsAre(testing::Field(&Upload::name, "third"),
                                                    testing::Field(&Upload::name, "second"),
                                                    testing::Field(&Upload::name, "first")));
}

/// Whatever a disk does to a description: the other uploads are there, and no name becomes a path.
TEST_F(UploadFolderTest, WhoseDescriptionIsChangedIsPassedOver) {
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
    EXPECT_FALSE(uploads_->find(id).has_value()) << id;
    EXPECT_FALSE(uploads_->remove(id)) << id;
  }
}

TEST_F(UploadRepositoryTest, RemovesWhatIsForgottenAndKeepsTheRest) {
  const Upload old = send("old.nc");
  const core::UtcTime next_day = noon + UploadRepository::lifetime;
  const Upload young = send("young.nc", "data", noon + core::Seconds{1.0});

  uploads_->remove_expired(next_day - core::Seconds{1.0});
  EXPECT_TRUE(uploads_->find(old.id).has_value());
  uploads_->remove_expired(next_day);

  EXPECT_FALSE(uploads_->find(old.id).has_value());
  EXPECT_TRUE(uploads_->find(young.id).has_value());
}

TEST_F(UploadRepositoryTest, RemovesOnce) {
  const Upload sent = send("u.nc");
  EXPECT_TRUE(uploads_->remove(sent.id));
  EXPECT_FALSE(uploads_->remove(sent.id));
}

TEST_F(UploadFolderTest, HoldsNoFileOfARemovedUpload) {
  const Upload sent = send("u.nc");
  EXPECT_TRUE(uploads_.remove(sent.id));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "uploads"));
}

/// The unfinished file of a killed process is not an upload, and is removed after a day.
TEST_F(UploadFolderTest, TakesAnUnfinishedUploadForNone) {
  std::filesystem::create_directories(folder_.path() / "uploads" / "half.new");
  EXPECT_THAT(uploads_.list(), testing::IsEmpty());
  uploads_.remove_expired(std::chrono::system_clock::now());
  EXPECT_FALSE(std::filesystem::is_empty(folder_.path() / "uploads"));
  uploads_.remove_expired(std::chrono::system_clock::now() + UploadRepository::lifetime + core::Seconds{5.0});
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
