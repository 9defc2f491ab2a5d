#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/adcirc_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::adcirc_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Adcirc : public StoreFixture {
 protected:
  void SetUp() override {
    StoreFixture::SetUp();
    write_file("fort.14", AdcircBay::mesh());
    write_file("fort.63", AdcircBay::elevations());
    write_file("fort.64", AdcircBay::currents(false));
  }

  IngestReport run(const std::vector<std::string>& names, bool with_start = true) {
    IngestOptions options;
    if (with_start) options.time = core::parse_iso8601("2026-03-01T00:00:00Z");
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names) files.push_back(path(name));
    return ingest_together(files, options);
  }

  std::optional<geo::VelocityEn> at(const IngestReport& report, int node, const std::string& time) {
    const geo::BoundingBox area{AdcircBay::lon_of(node), AdcircBay::lat_of(node), AdcircBay::lon_of(node),
                                AdcircBay::lat_of(node)};
    const auto found = repository::FieldRepository{db_}.load_currents(report.dataset.value().id, area,
                                                                      std::nullopt, std::nullopt);
    if (!found) return std::nullopt;
    return found->at({AdcircBay::lon_of(node), AdcircBay::lat_of(node)}, {5.0},
                     core::parse_iso8601(time).value());
  }
};

TEST_F(Adcirc, ANodeHasTheModelsOwnCurrent) {
  for (const bool compact : {false, true}) {
    write_file("fort.64", AdcircBay::currents(compact));
    const auto report = run({"fort.14", "fort.64"});
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);

    for (int node = 1; node <= AdcircBay::nodes; ++node) {
      const auto first = at(report, node, "2026-03-01T01:00:00Z");
      ASSERT_EQ(first.has_value(), node != AdcircBay::dry_node) << node;
      if (!first) continue;
      EXPECT_NEAR(first->east.value, AdcircBay::east_of(node, 1), 1e-6);
      EXPECT_NEAR(first->north.value, AdcircBay::north_of(node, 1), 1e-6);
      EXPECT_NEAR(at(report, node, "2026-03-01T02:00:00Z")->east.value, AdcircBay::east_of(node, 2), 1e-6);
    }
    EXPECT_THAT(words(report), HasSubstr("counts as dry at each time"));
  }
}

TEST_F(Adcirc, TheElevationsSayWhichNodesAreDry) {
  const auto report = run({"fort.63", "fort.64", "fort.14"});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_FALSE(at(report, AdcircBay::dry_node + 1, "2026-03-01T01:00:00Z").has_value());
  EXPECT_EQ(at(report, AdcircBay::dry_node, "2026-03-01T01:00:00Z").value().east.value, 0.0);  // at rest
  EXPECT_THAT(words(report), Not(HasSubstr("counts as dry")));
}

TEST_F(Adcirc, AFileThatLacksTheOthersSaysWhichToGive) {
  EXPECT_THAT(words(run({"fort.14"})), HasSubstr("Give fort.64 and its mesh"));
  EXPECT_THAT(words(run({"fort.63"})), HasSubstr("elevations of the surface"));
  EXPECT_THAT(words(run({"fort.64"})), HasSubstr("Give the mesh of the run, fort.14"));
  EXPECT_THAT(words(run({"fort.14", "fort.64"}, false)), HasSubstr("--time"));
}

TEST_F(Adcirc, DamagedFilesAreRefusedWithTheirLine) {
  const auto refusal_of = [&](const std::string& name, std::string text) {
    write_file(name, text);
    const auto report = run({"fort.14", "fort.64"});
    write_file("fort.14", AdcircBay::mesh());
    write_file("fort.64", AdcircBay::currents(false));
    EXPECT_EQ(report.status, IngestStatus::refused) << name;
    return words(report);
  };
  const auto with = [](std::string text, const std::string& part, const std::string& by) {
    return text.replace(text.find(part), part.size(), by);
  };
  const std::string currents = AdcircBay::currents(false);
  const std::string mesh = AdcircBay::mesh();

  EXPECT_THAT(refusal_of("fort.64", currents.substr(0, currents.size() / 2)), HasSubstr("line"));
  EXPECT_THAT(refusal_of("fort.64", with(currents, "\n7 ", "\n8 ")), HasSubstr("instead of node 7"));
  EXPECT_THAT(refusal_of("fort.64", with(currents, "\n7 0.", "\n7 x")), HasSubstr("line 10"));
  EXPECT_THAT(refusal_of("fort.64", with(currents, "7200 1440", "1200 1440")),
              HasSubstr("later than the one"));
  EXPECT_THAT(refusal_of("fort.14", with(mesh, "\n1 3 1 2 10\n", "\n1 3 1 2 99\n")),
              HasSubstr("an element: its number"));
  EXPECT_THAT(refusal_of("fort.14", with(mesh, "-9 54 21", "512000 5900000 21")), HasSubstr("ICS = 2"));
  EXPECT_THAT(refusal_of("fort.14", mesh.substr(0, mesh.size() / 2)), HasSubstr("line"));
}

TEST_F(Adcirc, ElevationsOfOtherTimesAreRefused) {
  std::string text = AdcircBay::elevations();
  write_file("fort.63", text.replace(text.find("7200 1440"), 9, "9000 1440"));
  EXPECT_THAT(words(run({"fort.63", "fort.64", "fort.14"})), HasSubstr("other times or another mesh"));
}

}  // namespace
}  // namespace floeplan::ingest::adcirc_test
