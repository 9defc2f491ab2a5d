#include "storage/ingest/formats/netcdf/variable_meaning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "tests/storage/ingest/support/choice_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::variable_meaning_test {
namespace {

using testing::HasSubstr;

class Meaning : public Choice {};

TEST_F(Meaning, OfIceAndDepthsIsNeverAStatistic) {
  struct Said {
    const char* name_end;
    Texts texts;
    const char* modifier;
  };
  const std::vector<Said> statistics{{"_a", {{"cell_methods", "time: standard_deviation"}}, ""},
                                     {"_b", {{"cell_methods", "area: range"}}, ""},
                                     {"_c", {}, " standard_error"},
                                     {"_d", {}, " number_of_observations"},
                                     {"_std", {}, ""},
                                     {"_e", {{"long_name", "Standard deviation"}}, ""}};
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const bool ice = support::uniform_int(rng, 0, 1) == 1;
    const std::string standard = ice ? "sea_ice_area_fraction" : "sea_floor_depth_below_sea_surface";
    const std::string unit = ice ? "1" : "m";
    std::vector<Field> fields;
    for (const Said& said : statistics) {
      if (support::uniform_int(rng, 0, 1) == 1) continue;
      Texts texts = said.texts;
      texts["standard_name"] = standard + said.modifier;
      texts["units"] = unit;
      fields.push_back({(ice ? "siconc" : "deptho") + std::string{said.name_end}, 0.75, texts});
    }
    const bool has_state = support::uniform_int(rng, 0, 2) > 0;
    if (has_state)
      fields.push_back({ice ? "siconc" : "deptho",
                        0.5,
                        {{"standard_name", standard}, {"units", unit}, {"cell_methods", "time: mean"}}});
    std::ranges::shuffle(fields, rng);

    const auto report = outcome(write(fields, std::nullopt, ice));

    EXPECT_EQ(report.status == IngestStatus::stored, has_state) << words(report);
    if (report.status != IngestStatus::stored) return;
    const repository::FieldRepository stored_fields{db_};
    const auto& id = report.dataset->id;
    EXPECT_FLOAT_EQ(
        ice ? stored_fields.load_ice(id, everywhere, std::nullopt)->samples().concentration.front()
            : stored_fields.load_bathymetry(id, everywhere)->depth_m().front(),
        0.5F);
  });
}

/// The statistics that the words of CF and of producers stand for.
TEST_F(Meaning, KnowsStatisticsByTheirWords) {
  struct Said {
    Texts texts;
    const char* name;
    Statistic is;
  };
  for (const Said& said :
       {Said{{}, "uo", Statistic::none}, Said{{{"cell_methods", "time: mean"}}, "uo", Statistic::none},
        Said{{{"cell_methods",
               "area: mean where sea time: mean (interval: 1 hr comment: maximum of nothing)"}},
             "uo",
             Statistic::none},
        Said{{{"cell_methods", "time: median"}}, "uo", Statistic::none},
        Said{{{"cell_methods", "time: mean area: maximum"}}, "uo", Statistic::maximum},
        Said{{{"cell_methods", "time: minimum within days time: mean over days"}}, "uo", Statistic::minimum},
        Said{{{"cell_methods", "realization: standard_deviation"}}, "uo", Statistic::deviation},
        Said{{{"cell_methods", "time:variance"}}, "uo", Statistic::variance},
        Said{{{"standard_name", "x standard_error"}}, "uo", Statistic::standard_error},
        Said{{{"standard_name", "x status_flag"}}, "uo", Statistic::flag},
        Said{{{"standard_name", "eastward_sea_water_velocity_standard_deviation"}},
             "uo",
             Statistic::deviation},
        Said{{}, "stdu", Statistic::deviation}, Said{{}, "err_ugosa", Statistic::uncertainty},
        Said{{}, "UO_QC", Statistic::flag}, Said{{}, "u_15_min", Statistic::none},
        Said{{}, "bias_corrected_u", Statistic::none},
        Said{{{"long_name", "Maximum eastward velocity"}}, "uo", Statistic::maximum},
        Said{{{"long_name", "Eastward velocity of maximum likelihood"}}, "uo", Statistic::none},
        Said{{{"long_name", "95th percentile of u"}}, "uo", Statistic::percentile}}) {
    const auto file = NetcdfFile::open(write({{said.name, 0.1, said.texts}}));
    ASSERT_TRUE(file) << reason_of(file.error());
    EXPECT_EQ(statistic_of(*file->find(said.name)), said.is)
        << said.name << " " << (said.texts.empty() ? "" : said.texts.begin()->second);
  }
}

}  // namespace
}  // namespace floeplan::ingest::variable_meaning_test
