#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <ostream>

#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"

namespace floeplan::ingest::sample_verdicts_test {
namespace {

/// A sample that is no data of the sea's, and a fragment of the reason for its refusal.
struct Refused {
  const char* file;
  const char* reason;
};

void PrintTo(const Refused& sample, std::ostream* out) { *out << sample.file; }

class SampleWithoutData : public StoreFixture, public testing::WithParamInterface<Refused> {};

TEST_P(SampleWithoutData, IsRefusedWithTheReason) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  expect_refused(sample_folder() / GetParam().file, GetParam().reason);
}

INSTANTIATE_TEST_SUITE_P(Gliders, SampleWithoutData,
                         testing::Values(Refused{"glider/1f35be3b.cac", "sensors"},
                                         Refused{"glider/62d8b5da.cac", "sensors"},
                                         Refused{"glider/S102791A002_Barrow_v2_avgd.ad2cp", "not recognised"},
                                         Refused{"glider/seaglider_p5610005.eng", "no positions"}));

INSTANTIATE_TEST_SUITE_P(
    Meshes, SampleWithoutData,
    testing::Values(Refused{"mesh/simplebox_from_direction_clm.nc", "a speed and a direction"},
                    Refused{"mesh/simplebox_to_direction_clm.nc", "a speed and a direction"},
                    Refused{"mesh/dflow_simplebox_hex7_map.nc", "mesh of triangles"}));

INSTANTIATE_TEST_SUITE_P(
    Tides, SampleWithoutData,
    testing::Values(Refused{"tides/tmd25_cats2008_ellipse_raw_mislabelled_a.csv", "does not know"},
                    Refused{"tides/tmd25_cats2008_ellipse_relabelled_a.csv", "does not know"},
                    Refused{"tides/tmd25_cats2008_U_cms_a.csv", "does not know"},
                    Refused{"tides/tmd25_cats2008_V_cms_a.csv", "does not know"},
                    Refused{"tides/aviso_fes2014_v12_fes_slev.txt", "not recognised"},
                    Refused{"tides/utide_HNL2010_prediction_a_2010-03.csv", "not recognised"},
                    Refused{"tides/utide_HNL2010_prediction_a_2016-07.csv", "not recognised"},
                    Refused{"tides/utide_HNL2010_hourly_mm.asc", "not recognised"},
                    Refused{"tides/ttide_constituents_const.nc", "no currents, depths, sea ice or wind"},
                    Refused{"tides/ttide_constituents_sat.nc", "no currents, depths, sea ice or wind"},
                    Refused{"tides/ttide_constituents_shallow.nc", "no currents, depths, sea ice or wind"},
                    Refused{"tides/uhslc_h820_nuuk_hourly.nc", "no currents, depths, sea ice or wind"}));

INSTANTIATE_TEST_SUITE_P(S100, SampleWithoutData,
                         testing::Values(Refused{"s100/101AA005C1MNS.000", "an electronic chart of S-101"}));

/// Every sample is named in a test of these rooms, here or where its values are compared.
TEST(Samples, AreAllJudged) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto text_of = [](const std::filesystem::path& file) {
    std::ifstream in{file};
    return std::string{std::istreambuf_iterator<char>{in}, {}};
  };
  std::string tests;
  for (const auto& file : std::filesystem::recursive_directory_iterator{
           std::filesystem::path{support::source_folder()} / "tests/storage/ingest"})
    if (file.is_regular_file()) tests += text_of(file.path());
  for (const auto& entry : std::filesystem::recursive_directory_iterator{sample_folder()}) {
    const std::string path = entry.path().lexically_relative(sample_folder());
    const bool inside_zarr = path.find(".zarr/") != std::string::npos;
    const bool is_sample = entry.is_regular_file() || path.ends_with(".zarr");
    if (!is_sample || inside_zarr || entry.path().filename() == "PROVENANCE.md") continue;
    EXPECT_NE(tests.find(entry.path().filename()), std::string::npos) << path;
  }
}

}  // namespace
}  // namespace floeplan::ingest::sample_verdicts_test
