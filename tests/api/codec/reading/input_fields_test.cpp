#include "api/codec/reading/input_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/fields/request_fields.hpp"
#include "tests/support/property.hpp"

namespace floeplan::codec::input_fields_test {
namespace {

using messages::fault;
using nlohmann::json;
using planning::UnderIceRules;
using support::for_each_seed;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A value that the field may have, as a request writes it.
json drawn(const fields::Field& field, std::mt19937_64& rng) {
  const auto word = [&] { return field.words[rng() % field.words.size()].name; };
  std::uniform_real_distribution<double> within{field.least, field.most};
  switch (field.kind) {
    case fields::Kind::number: return within(rng);
    case fields::Kind::whole_number: return static_cast<int>(within(rng));
    case fields::Kind::boolean: return rng() % 2 == 0;
    case fields::Kind::word: return word();
    case fields::Kind::time: return "2026-11-22T06:00:00Z";
    case fields::Kind::dataset: return word();
    case fields::Kind::datasets: return rng() % 2 == 0 ? json(word()) : json{"first", "second"};
    default: return nullptr;
  }
}

/// Law: every value that is read is written again, and so are the defaults of values that are not given.
template <class Values>
void are_written_as_they_are_read(const fields::Table<Values>& table) {
  for_each_seed(100, [&](std::mt19937_64& rng) {
    json given = json::object();
    for (const auto& row : table)
      if (rng() % 2 == 0) given[std::string{row.field.name}] = drawn(row.field, rng);
    InputReader reader{given};
    Values values{};

    read_fields(reader, table, values);
    reader.refuse_unknown();
    json written;
    write_fields(table, values, written);

    EXPECT_THAT(reader.violations(), IsEmpty());
    EXPECT_EQ(written.size(), table.size());
    for (const auto& [name, value] : given.items()) EXPECT_EQ(written.at(name), value) << name;
  });
}

TEST(InputFields, AreWrittenAsTheyAreRead) {
  are_written_as_they_are_read(fields::margin_fields());
  are_written_as_they_are_read(fields::iceberg_fields());
  are_written_as_they_are_read(fields::passing_under_ice_fields());
  are_written_as_they_are_read(fields::surfacing_fields());
  are_written_as_they_are_read(fields::alternative_fields());
  are_written_as_they_are_read(fields::leg_fields());
  are_written_as_they_are_read(fields::search_fields());
  are_written_as_they_are_read(fields::energy_fields());
  are_written_as_they_are_read(fields::data_fields());
}

TEST(InputFields, AreRefusedWithWhatMayStandThere) {
  const json given{{"margin_below_ice_m", -1}, {"escape_plan", 1}};
  InputReader reader{given, "/under_ice"};
  UnderIceRules rules;

  read_fields(reader, fields::passing_under_ice_fields(), rules);
  read_fields(reader, fields::surfacing_fields(), rules);

  EXPECT_THAT(reader.violations(),
              ElementsAre(fault<"number-out-of-range">("/under_ice/margin_below_ice_m", "0.0", "500.0", "-1"),
                          fault<"wrong-shape-found">("/under_ice/escape_plan", "true or false", "1")));
  EXPECT_EQ(rules.margin_below_ice, UnderIceRules{}.margin_below_ice);
}

TEST(InputFields, NameTheWordsThatAreKnown) {
  const json given{{"tides_mode", "both"}, {"zones", 3}, {"ice", {"a", "b"}}};
  InputReader reader{given};
  repository::EnvironmentQuery data;

  read_fields(reader, fields::data_fields(), data);

  EXPECT_THAT(
      reader.violations(),
      ElementsAre(
          fault<"wrong-shape-found">(
              "/tides_mode", "\"add\" (to currents without tides) or \"only\" (tidal currents only)",
              "\"both\""),
          fault<"wrong-shape-found">("/ice", "\"newest\", \"none\" or an id", "an array"),
          fault<"wrong-shape-found">("/zones", "\"all\", \"none\", an id or an array of ids", "3")));
}

}  // namespace
}  // namespace floeplan::codec::input_fields_test
