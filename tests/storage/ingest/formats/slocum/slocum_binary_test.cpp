#include "storage/ingest/formats/slocum/slocum_binary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <iterator>

#include "storage/repository/features/glider_track_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::slocum_binary_test {
namespace {

using testing::HasSubstr;

/// A value of a cycle: nothing, as before, or new.
struct Update {
  int state{};
  double value{};
};

/// Writes small binary logs with a time, a fix and a depth in each cycle, and a byte that nobody wants.
struct LogWriter {
  bool big_endian{true};
  bool factored{false};
  std::string full_filename{"comet-2019-222-2-154"};

  template <class Bits>
  std::string number(Bits bits) const {
    std::string text;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) text += static_cast<char>((bits >> (8 * i)) & 0xff);
    if (big_endian) std::ranges::reverse(text);
    return text;
  }
  std::string real(double value) const { return number(std::bit_cast<std::uint64_t>(value)); }
  std::string single(float value) const { return number(std::bit_cast<std::uint32_t>(value)); }

  static std::string list() {
    return "s: T    0    0 1 x_dr_state enum\ns: F    1   -1 4 m_pitch rad\ns: T    2    1 8 m_present_time "
           "timestamp\ns: T    3    2 8 m_gps_lat lat\ns: T    4    3 8 m_gps_lon lon\ns: T    5    4 4 "
           "m_depth m\n";
  }

  std::string head() const {
    std::string text =
        "dbd_label:    DBD(dinkum_binary_data)file\nencoding_ver:    5\nnum_ascii_tags:    9\n"
        "full_filename:    " +
        full_filename +
        "\nfilename_extension:    dbd\ntotal_num_sensors:    6\nsensors_per_cycle:    5\n"
        "state_bytes_per_cycle:    2\n";
    text += factored ? "sensor_list_factored:    1\n" : "sensor_list_factored:    0\n" + list();
    if (factored)
      text.replace(text.find("num_ascii_tags:    9"), 20,
                   "sensor_list_crc:    0a1B2c3d\nnum_ascii_tags:    10");
    return text + "sa" + number(std::uint16_t{0x1234}) + single(123.456F) + real(123456789.12345);
  }

  std::string cycle(const std::array<Update, 5>& updates) const {
    std::uint16_t states = 0;
    for (std::size_t i = 0; i < 5; ++i)
      states = static_cast<std::uint16_t>(states | (updates[i].state << (14 - 2 * i)));
    std::string text = "d";
    text += static_cast<char>(states >> 8);
    text += static_cast<char>(states & 0xff);
    if (updates[0].state == 2) text += static_cast<char>(updates[0].value);
    for (std::size_t i = 1; i < 4; ++i)
      if (updates[i].state == 2) text += real(updates[i].value);
    if (updates[4].state == 2) text += single(static_cast<float>(updates[4].value));
    return text;
  }

  std::string cycles() const {
    return cycle({{{2, 4}, {2, 1566395000.5}, {2, 5418.9}, {2, 724.6}, {2, 0.5}}}) +
           cycle({{{2, 1}, {2, 1566395060.5}, {}, {}, {2, 20.25}}}) +
           cycle({{{1, 0}, {2, 1566395120.5}, {1, 0}, {2, 724.9}, {}}});
  }
  std::string log() const { return head() + cycles() + "X"; }
};

/// In blocks of this number of bytes, as the gliders of newer firmware send them.
std::string compressed(const std::string& bytes, std::size_t block) {
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += block) {
    const std::string part = bytes.substr(at, block);
    std::string room(static_cast<std::size_t>(LZ4_compressBound(static_cast<int>(part.size()))), '\0');
    const int size = LZ4_compress_default(part.data(), room.data(), static_cast<int>(part.size()),
                                          static_cast<int>(room.size()));
    packed += static_cast<char>(size >> 8);
    packed += static_cast<char>(size & 0xff);
    packed.append(room, 0, static_cast<std::size_t>(size));
  }
  return packed;
}

class SlocumBinary : public StoreFixture {
 protected:
  ocean::GliderTrack stored() {
    const repository::GliderTrackRepository tracks{db_};
    const auto page = tracks.list({}, 0, 2);
    EXPECT_EQ(page.tracks.size(), 1U);
    return page.tracks.empty() ? ocean::GliderTrack{} : tracks.find(page.tracks[0].row)->track;
  }

  ocean::GliderTrack track_of(const std::string& bytes) {
    const auto report = ingest(write_file("log.dbd", bytes));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    return stored();
  }
};

TEST_F(SlocumBinary, GivesWhatTheTextOfTheSameLogGives) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  ASSERT_EQ(ingest(sample_folder() / "glider/slocum_comet-2019-222-02-154_nav.csv").status,
            IngestStatus::stored);
  const auto text = stored();
  const auto report = ingest(sample_folder() / "glider/comet-2019-222-02-154.dbd");
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);

  const repository::GliderTrackRepository tracks{db_};
  const auto page = tracks.list({.glider = "comet"}, 0, 2);
  ASSERT_EQ(page.tracks.size(), 1U);
  const auto binary = tracks.find(page.tracks[0].row)->track;

  ASSERT_EQ(binary.points.size(), text.points.size());
  for (std::size_t i = 0; i < text.points.size(); ++i) {
    EXPECT_NEAR(core::unix_seconds(binary.points[i].time), core::unix_seconds(text.points[i].time), 1e-5);
    EXPECT_NEAR(binary.points[i].place.lon_deg, text.points[i].place.lon_deg, 1e-9);
    EXPECT_NEAR(binary.points[i].place.lat_deg, text.points[i].place.lat_deg, 1e-9);
    ASSERT_EQ(binary.points[i].depth.has_value(), text.points[i].depth.has_value());
    if (text.points[i].depth) {
      EXPECT_NEAR(binary.points[i].depth->value, text.points[i].depth->value, 1e-3);
    }
  }
  ASSERT_EQ(binary.currents.size(), 1U);
  // The text lacks x_utm_to_lmc, so its currents are turned by the variation of that day, 0.2 degrees further.
  EXPECT_NEAR(geo::strength(binary.currents[0].current).value, geo::strength(text.currents[0].current).value,
              1e-6);
  EXPECT_NEAR(binary.currents[0].current.east.value, text.currents[0].current.east.value, 1e-3);
}

TEST_F(SlocumBinary, IsReadInBothOrdersOfBytes) {
  for (const bool big_endian : {true, false}) {
    const auto track = track_of(LogWriter{.big_endian = big_endian}.log());

    EXPECT_EQ(track.glider, "comet");
    ASSERT_EQ(track.points.size(), 3U);
    EXPECT_EQ(core::unix_seconds(track.points[0].time), 1566395000.5);
    EXPECT_NEAR(track.points[0].place.lat_deg, 54.0 + 18.9 / 60.0, 1e-12);
    EXPECT_EQ(track.points[1].depth, core::Metres{20.25});
    EXPECT_FALSE(track.points[1].fixed);
    EXPECT_NEAR(track.points[2].place.lat_deg, 54.0 + 18.9 / 60.0, 1e-12) << "as before";
    EXPECT_NEAR(track.points[2].place.lon_deg, 7.0 + 24.9 / 60.0, 1e-12);
    db_ = repository::open_store_in_memory();
  }
}

TEST_F(SlocumBinary, WithoutTheListOfItsSensorsIsRefusedByTheListsName) {
  expect_refused(write_file("log.dbd", LogWriter{.factored = true}.log()), "0a1b2c3d.cac");
}

TEST_F(SlocumBinary, FindsTheListOfItsSensorsAmongWhatIsGivenAndBesideIt) {
  const auto log = write_file("log.dbd", LogWriter{.factored = true}.log());
  const auto list = write_file("0A1B2C3D.CAC", LogWriter::list());

  const auto together = ingest_together({list, log});
  EXPECT_EQ(together.status, IngestStatus::stored) << words(together);
  EXPECT_EQ(stored().points.size(), 3U);
  EXPECT_EQ(ingest(log).status, IngestStatus::unchanged);
}

TEST_F(SlocumBinary, ThatIsCompressedGivesTheSame) {
  const std::string whole = LogWriter{}.log();
  const auto plain = track_of(whole);
  for (const std::size_t block : {64U, 1000U, 32'768U}) {
    db_ = repository::open_store_in_memory();
    const auto report = ingest(write_file("log.dcd", compressed(whole, block)));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_EQ(stored().points, plain.points) << block;
  }
}

TEST_F(SlocumBinary, ThatIsCompressedFindsItsCompressedList) {
  const auto log = write_file("log.scd", compressed(LogWriter{.factored = true}.log(), 32'768));
  expect_refused(log, "0a1b2c3d.cac");
  const auto list = write_file("0a1b2c3d.ccc", compressed(LogWriter::list(), 32'768));

  const auto report = ingest(log);
  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(stored().points.size(), 3U);
  expect_refused(list, "Give it together with the logs");
}

TEST_F(SlocumBinary, ThatIsCompressedAndDamagedIsRefusedOrLacksOnlyItsEnd) {
  const std::string packed = compressed(LogWriter{}.log(), 200);
  const auto all = track_of(LogWriter{}.log());
  for (std::size_t length = 0; length < packed.size(); length += 3) {
    db_ = repository::open_store_in_memory();
    const auto report = ingest(write_file("log.dcd", packed.substr(0, length)));
    if (report.status == IngestStatus::refused) continue;
    EXPECT_THAT(words(report), HasSubstr("before its end mark")) << length;
    ASSERT_LE(stored().points.size(), all.points.size());
  }
  std::string broken = packed;
  std::fill(broken.end() - 40, broken.end(), '\xff');
  expect_refused(write_file("log.dcd", broken), "cannot be unpacked");
}

TEST_F(SlocumBinary, RefusesTheListOfAnotherLog) {
  const auto log = write_file("log.dbd", LogWriter{.factored = true}.log());
  write_file("0a1b2c3d.cac", "s: T    0    0 1 x_dr_state enum\n");

  expect_refused(log, "another log");
}

TEST_F(SlocumBinary, CutAnywhereIsRefusedOrLacksOnlyItsEnd) {
  const std::string whole = LogWriter{}.log();
  const auto all = track_of(whole);
  db_ = repository::open_store_in_memory();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto report = ingest(write_file("log.dbd", whole.substr(0, length)));
    if (report.status == IngestStatus::refused) continue;
    EXPECT_THAT(words(report), HasSubstr("before its end mark")) << length;
    const auto track = stored();
    ASSERT_LE(track.points.size(), all.points.size());
    EXPECT_EQ(track.points.front(), all.points.front());
    db_ = repository::open_store_in_memory();
  }
}

TEST_F(SlocumBinary, WithBytesChangedIsRefusedOrPlausible) {
  const std::string whole = LogWriter{}.log();
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    std::string bytes = whole;
    for (int flips = support::uniform_int(rng, 1, 6); flips > 0; --flips)
      bytes[std::uniform_int_distribution<std::size_t>{0, bytes.size() - 1}(rng)] =
          static_cast<char>(support::uniform_int(rng, 0, 255));
    const auto report = ingest(write_file("log.dbd", bytes));
    if (report.status == IngestStatus::refused) {
      EXPECT_EQ(stored_datasets(), 0U);
      return;
    }
    for (const auto& point : stored().points) {
      EXPECT_TRUE(geo::is_valid(point.place));
      if (point.depth) {
        EXPECT_LE(point.depth->value, 12'000.0);
      }
    }
    db_ = repository::open_store_in_memory();
  });
}

}  // namespace
}  // namespace floeplan::ingest::slocum_binary_test
