#include "engine/ocean/zone_words.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::ocean::zone_words_test {
namespace {

using enum AttributeMeaning;

void expect_meaning(AttributeMeaning meaning, std::initializer_list<const char*> names) {
  for (const char* const name : names) EXPECT_EQ(meaning_of_attribute(name), meaning) << name;
}

TEST(ZoneWords, TellARule) {
  expect_meaning(kind, {"kind", "Rule", "zone_kind", "ZoneKind", "ZONEKIND", "area rule"});
  expect_meaning(perhaps_kind,
                 {"type", "zone_type", "ZoneType", "AREATYPE", "Class", "RESTRN", "rule_type", "restrictio"});
}

TEST(ZoneWords, TellAPeriod) {
  expect_meaning(from, {"from",
                        "valid_from",
                        "start",
                        "begin",
                        "starttime",
                        "start_date",
                        "StartDate",
                        "STARTDATE",
                        "DateStart",
                        "effective_from",
                        "effective_date",
                        "Effective",
                        "EFF_DATE",
                        "beginning",
                        "closure_start",
                        "fishing_start_date",
                        "DATSTA",
                        "PERSTA",
                        "since",
                        "time_min",
                        "date_debut_from",
                        "first_day",
                        "effectiveFrom",
                        "valid-from",
                        "startDateTime"});
  expect_meaning(until,
                 {"until",      "valid_until",  "valid_unti",  "validUntil", "valid_to", "Valid To",
                  "to",         "end",          "stop",        "end_time",   "expires",  "expiry_date",
                  "EXPIRYDATE", "EXPDATE",      "expiry_dat",  "Expiration", "DateEnd",  "effective_to",
                  "DATEND",     "validity_end", "closure_end", "valid_thro", "time_max", "last_day",
                  "end_mo",     "to_date"});
  expect_meaning(period, {"period", "validity", "valid", "effective_period", "start_to_end", "from_to",
                          "dates_from_to", "in_force", "active", "closure_period", "months"});
  expect_meaning(unclear_period, {"effective_", "effectiv_1", "effectivef", "project_end", "start_lat",
                                  "opening_date", "from_port", "validity_s"});
}

TEST(ZoneWords, TellDepths) {
  expect_meaning(top, {"top_m", "topm", "TOP", "min_depth", "MinDepth", "depthminm", "depth_from", "upper",
                       "upper_depth", "UPPERDEPTH", "depth_uppe", "top_ft", "minimum_depth_m", "minimumdep",
                       "depthFrom"});
  expect_meaning(bottom, {"bottom_m", "bottom", "max_depth", "maxdepthm", "DEPTH_MAX", "depth_to", "lower",
                          "LowerLimit", "maximumdep", "depthTo", "deepest_depth"});
  expect_meaning(depths, {"depth", "depth_range", "DEPTHS", "depth_m", "min_max_depth"});
  expect_meaning(unclear_depth,
                 {"mean_depth", "max_water_depth", "bottom_depth_min", "top_elevation", "height_max"});
}

TEST(ZoneWords, TellTheNameOfTheZone) { expect_meaning(zone_name, {"name", "Title", "LABEL"}); }

/// Attributes as ArcGIS, QGIS, Google Earth, S-57, the World Database on Protected Areas, INSPIRE and national
/// services write them.
TEST(ZoneWords, LeaveTheRecordAndOrdinaryAttributesAlone) {
  expect_meaning(record,
                 {"created_date", "last_edited_date", "last_edite", "edit_date", "EditDate", "date_added",
                  "CreationDate", "creationda", "last_update", "DESIG_DATE", "publication_date", "issue_date",
                  "SORDAT", "DATE_ENTERED", "created_user", "version", "update_time"});
  expect_meaning(some_date, {"date", "Date", "timestamp", "YEAR", "beginLifespanVersion", "survey_start",
                             "closure_date"});
  expect_meaning(nothing,
                 {"OBJECTID", "Shape_Area", "Shape_Leng", "SHAPE__Length",    "GlobalID",    "fid",
                  "id",       "FID_1",      "Descriptio", "description",      "area_name",   "AreaName",
                  "NAME_E",   "WDPAID",     "NO_TAKE",    "NO_TK_AREA",       "REP_M_AREA",  "GIS_AREA",
                  "STATUS",   "STATUS_YR",  "OWN_TYPE",   "vessel_type",      "bottom_type", "top_speed",
                  "COUNTRY",  "tessellate", "extrude",    "altitudeMode",     "drawOrder",   "icon",
                  "OBJNAM",   "INFORM",     "CATREA",     "SCAMIN",           "DRVAL1",      "DRVAL2",
                  "POWER_MW", "DIST_COAST", "N_TURBINES", "observation_date", "minimum",     "max_speed",
                  "total",    "storage",    "weekend",    "endemic",          "mandate",     "",
                  "_",        "42"});
}

/// Whatever way words are put together to a name.
TEST(ZoneWords, AreUnderstoodHoweverTheyAreJoined) {
  struct Known {
    std::vector<std::string> words;
    AttributeMeaning meaning;
  };
  const std::vector<Known> names{{{"start", "date"}, from},        {{"date", "begin"}, from},
                                 {{"valid", "from"}, from},        {{"effective", "from", "date"}, from},
                                 {{"end", "date"}, until},         {{"valid", "until"}, until},
                                 {{"expiry", "datetime"}, until},  {{"zone", "valid", "through"}, until},
                                 {{"depth", "min"}, top},          {{"upper", "depth", "limit"}, top},
                                 {{"depth", "max"}, bottom},       {{"lower", "limit"}, bottom},
                                 {{"zone", "kind"}, kind},         {{"area", "type"}, perhaps_kind},
                                 {{"validity", "period"}, period}, {{"last", "edited", "date"}, record}};
  support::for_each_seed(400, [&](std::mt19937_64& rng) {
    const Known& known =
        names[static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(names.size()) - 1))];
    const int style = support::uniform_int(rng, 0, 5);
    std::string name;
    for (std::string word : known.words) {
      const bool is_first = name.empty();
      if (style >= 4)
        for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      if (style == 2 || (style == 3 && !is_first))
        word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
      if (!is_first && (style == 0 || style == 4)) name += "_";
      if (!is_first && style == 1) name += support::uniform_int(rng, 0, 1) == 0 ? " " : "-";
      name += word;
    }
    if (name.size() == 10) name += " ";  // at ten letters the last word may be the beginning of another
    EXPECT_EQ(meaning_of_attribute(name), known.meaning) << name;
  });
}

TEST(ZoneWords, HoldTheUnitOfADepth) {
  EXPECT_EQ(unit_in_attribute("top_ft"), "ft");
  EXPECT_EQ(unit_in_attribute("DEPTH_MAX_FEET"), "feet");
  EXPECT_EQ(unit_in_attribute("bottom_m"), "m");
  EXPECT_EQ(unit_in_attribute("max_depth"), "");
}

}  // namespace
}  // namespace floeplan::ocean::zone_words_test
