#include "api/codec/inputs/ingest_inputs.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace floeplan::codec::ingest_inputs_test {
namespace {

using nlohmann::json;

TEST(IngestInputs, ComeBackAsTheyWereWritten) {
  const json document{{"uploads", {"a", "b"}}, {"name", "Bay"},
                      {"kind", "tides"},       {"crs", "EPSG:3413"},
                      {"positive", "up"},      {"variable", "sic"},
                      {"at", {-53.2, 69.2}},   {"unit", "ft"},
                      {"zone_kind", "no_go"},  {"time", "2026-11-20T18:00:00Z"},
                      {"missing", -99.99}};
  const auto inputs = parse_ingest_inputs(document);
  ASSERT_TRUE(inputs.has_value());
  EXPECT_EQ(inputs->kind, repository::DatasetKind::tides);
  EXPECT_EQ(inputs->at, (geo::LonLat{-53.2, 69.2}));
  EXPECT_EQ(to_json(*inputs), document);
}

TEST(IngestInputs, TakeTheKindAutoForNone) {
  const auto inputs = parse_ingest_inputs({{"uploads", {"a"}}, {"kind", "auto"}});
  ASSERT_TRUE(inputs.has_value());
  EXPECT_FALSE(inputs->kind.has_value());
}

TEST(IngestInputs, NameEveryFaultAtOnce) {
  const auto inputs = parse_ingest_inputs({{"uploads", {"a", 7, "a"}},
                                           {"kind", "weather"},
                                           {"positive", "sideways"},
                                           {"at", {-53.2, 169.2}},
                                           {"unit", "fathom"},
                                           {"zone_kind", "maybe"},
                                           {"colour", "blue"}});
  ASSERT_FALSE(inputs.has_value());
  std::set<std::string> fields;
  for (const auto& violation : inputs.error()) fields.insert(violation.field);
  EXPECT_EQ(fields, (std::set<std::string>{"/uploads/1", "/uploads/2", "/kind", "/positive", "/at", "/unit",
                                           "/zone_kind", "/colour"}));
}

TEST(IngestInputs, NeedAnUploadAtLeast) {
  for (const json& document : {json::object(), json{{"uploads", json::array()}}, json{{"uploads", "a"}}})
    EXPECT_FALSE(parse_ingest_inputs(document).has_value()) << document;
}

}  // namespace
}  // namespace floeplan::codec::ingest_inputs_test
