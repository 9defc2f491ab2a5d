#include "tests/storage/ingest/hostile/gallery.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/sql/statement.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/loopback_listener.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::hostile_gallery_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* secret_word = "xylophone";
/// The longest time for a file of the gallery, with the start of its reader on a busy machine.
constexpr std::chrono::seconds longest{60};

std::string content_of(const fs::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// Everything in a folder, by path, with what it holds.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator{folder})
    contents[entry.path().string()] = entry.is_regular_file() ? content_of(entry.path()) : "";
  return contents;
}

/// The paths that only one of the two has, or whose contents differ.
std::set<std::string> differences(const std::map<std::string, std::string>& one,
                                  const std::map<std::string, std::string>& other) {
  std::set<std::string> paths;
  for (const auto& [path, content] : one)
    if (const auto found = other.find(path); found == other.end() || found->second != content)
      paths.insert(path);
  for (const auto& [path, content] : other)
    if (!one.contains(path)) paths.insert(path);
  return paths;
}

/// The targets of the files: a store in use, a secret, and a listener.
class Gallery : public StoreFixture, public testing::WithParamInterface<std::string_view> {
 protected:
  Gallery() {
    fs::create_directories(aims_.store);
    fs::create_directories(path("given"));
    fs::create_directories(guard_.staging);
    for (const char* const name : {"floeplan.sqlite", "floeplan.sqlite-wal", "floeplan.sqlite-shm"})
      std::ofstream{aims_.store / name} << name;
    std::ofstream{aims_.secret} << secret_word << "\n2026-11-20T06:00:00Z,60,-50," << secret_word << '\n';
  }

  /// How many texts of the store hold one of these.
  std::int64_t rows_with(const std::vector<std::string>& words_of_others) {
    std::vector<std::pair<std::string, std::string>> columns;
    {
      sql::Statement query{
          db_,
          "SELECT t.name, c.name FROM sqlite_schema AS t JOIN pragma_table_info(t.name) AS c "
          "WHERE t.type = 'table' AND c.type = 'TEXT' AND t.name NOT LIKE 'sqlite_%'"};
      while (query.step()) columns.emplace_back(query.text(0), query.text(1));
    }
    std::int64_t rows = 0;
    for (const auto& [table, column] : columns)
      for (const std::string& word : words_of_others) {
        sql::Statement query{db_, "SELECT count(*) FROM " + table + " WHERE instr(" + column + ", ?1)"};
        query.bind(1, word);
        if (query.step()) rows += query.integer(0);
      }
    return rows;
  }

  /// Reads the file, and expects no effect on anything else, whether the file is refused or not.
  void read(const HostileFile& hostile) {
    const testing::ScopedTrace trace{
        __FILE__, __LINE__, hostile.format + " that wants " + hostile.wants + " " + hostile.crs.value_or("")};
    fs::remove_all(path("given"));
    fs::create_directories(path("given"));
    const auto files = hostile.write(path("given"));
    const auto before = contents_of(path(""));
    const auto began = std::chrono::steady_clock::now();

    const auto reports = guarded_ingest(db_, guard_, files, {.crs = hostile.crs, .positive = "up"},
                                        core::from_unix_seconds(1.8e9), {}, {}, {});

    EXPECT_LT(std::chrono::steady_clock::now() - began, longest);
    EXPECT_FALSE(reports.empty());
    EXPECT_EQ(rows_with({secret_word, "root:x:0:0"}), 0);
    for (const IngestReport& report : reports) {
      EXPECT_THAT(words(report), Not(HasSubstr(secret_word)));
      EXPECT_THAT(words(report), Not(HasSubstr("root:x:0:0")));
      EXPECT_EQ(report.dataset.has_value(), report.status != IngestStatus::refused);
      EXPECT_NE(report.dataset.has_value(), !report.errors.empty());
      if (report.dataset) repository::DatasetRepository{db_}.remove(report.dataset->id);
    }
    EXPECT_EQ(stored_datasets(), 0U);
    EXPECT_FALSE(listener_.somebody_came());
    EXPECT_THAT(differences(before, contents_of(path(""))), testing::IsEmpty())
        << "something was written, changed or left";
    EXPECT_FALSE(fs::exists("/tmp/floeplan-escaped.geojson"));
  }

  const support::LoopbackListener listener_;
  const HostileAims aims_{.secret = path("secret.csv"), .store = path("store"), .port = listener_.port()};
  const Guard guard_{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
};

TEST_P(Gallery, GetsNothing) {
  support::for_each_seed(damaged_variants(1), [&](std::mt19937_64& rng) {
    for (const HostileFile& hostile : hostile_files(aims_, rng))
      if (hostile.format == GetParam()) read(hostile);
  });
}

INSTANTIATE_TEST_SUITE_P(Of, Gallery, testing::ValuesIn(hostile_formats),
                         [](const testing::TestParamInfo<std::string_view>& format) {
                           std::string name{format.param};
                           for (char& c : name)
                             if (c == ' ' || c == '-') c = '_';
                           return name;
                         });

/// Eighty files, and more than one of nearly every format.
TEST(HostileGallery, IsAfterEveryFormatThatIsRead) {
  std::mt19937_64 rng{1};
  std::map<std::string, int> files;
  for (const HostileFile& hostile : hostile_files({"/secret", "/store", 1}, rng)) ++files[hostile.format];
  int all = 0;
  for (const auto& [format, count] : files) all += count;

  EXPECT_GE(all, 80);
  EXPECT_EQ(files.size(), std::size(hostile_formats));
  for (const std::string_view format : hostile_formats) EXPECT_GE(files[std::string{format}], 1) << format;
}

}  // namespace
}  // namespace floeplan::ingest::hostile_gallery_test
