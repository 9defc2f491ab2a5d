#include "api/fields/request_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "api/fields/process_fields.hpp"

namespace floeplan::fields::request_fields_test {
namespace {

using testing::Contains;
using testing::Each;
using testing::IsEmpty;
using testing::Not;

const std::map<std::string, std::vector<Field>>& lists() {
  static const std::map<std::string, std::vector<Field>> all{
      {"plan-route", fields_of(Process::plan_route)},
      {"evaluate-route", fields_of(Process::evaluate_route)},
      {"reach", fields_of(Process::reach)},
      {"vehicle", fields_of_vehicle()}};
  return all;
}

void for_each_field(const auto& law) {
  for (const auto& [list, fields] : lists()) {
    for (const Field& field : fields) {
      SCOPED_TRACE(list + pointer_of(field));
      law(field);
    }
  }
}

bool is_number(const Field& field) { return field.kind == Kind::number || field.kind == Kind::whole_number; }

TEST(RequestFields, HaveNamesAndFlagsOfTheirOwn) {
  for (const auto& [list, fields] : lists()) {
    std::set<std::string> pointers;
    std::set<std::string_view> flags;
    for (const Field& field : fields) {
      EXPECT_TRUE(pointers.insert(pointer_of(field)).second) << list << pointer_of(field);
      EXPECT_TRUE(field.flag.empty() || flags.insert(field.flag).second) << list << " --" << field.flag;
    }
  }
}

TEST(RequestFields, SayTheUnitOfANumberInItsName) {
  const std::map<std::string_view, std::string> endings{
      {"m", "_m"}, {"m2", "_m2"},   {"s", "_s"},         {"m/s", "_m_s"},   {"deg", "_deg"}, {"J", "_j"},
      {"W", "_w"}, {"cm3", "_cm3"}, {"J/cm3", "_j_cm3"}, {"days", "_days"}, {"share", ""}};
  for_each_field([&](const Field& field) {
    if (field.unit.empty() || field.name == "refine_seconds") return;
    ASSERT_TRUE(endings.contains(field.unit)) << field.unit;
    EXPECT_TRUE(field.name.ends_with(endings.at(field.unit))) << field.unit;
  });
}

TEST(RequestFields, AreUsuallyWithinTheirRange) {
  for_each_field([](const Field& field) {
    if (!is_number(field)) return;
    EXPECT_LT(field.least, field.most);
    if (!field.usual) return;
    const double usual =
        field.kind == Kind::number ? std::get<double>(*field.usual) : std::get<int>(*field.usual);
    EXPECT_GE(usual, field.least);
    EXPECT_LE(usual, field.most);
  });
}

TEST(RequestFields, TellWhatAFlagOfASwitchTurns) {
  for_each_field([](const Field& field) {
    if (field.kind != Kind::boolean || field.flag.empty()) return;
    ASSERT_TRUE(field.usual);
    EXPECT_EQ(field.flag.starts_with("no-"), std::get<bool>(*field.usual));
  });
}

TEST(RequestFields, AreExplainedInOneSentenceWhereAFlagAsksForThem) {
  for_each_field([](const Field& field) {
    EXPECT_TRUE(field.flag.empty() || !field.help.empty());
    for (const std::string_view text : {field.help, field.details}) EXPECT_FALSE(text.ends_with('.'));
  });
}

TEST(RequestFields, NameMethodsAsPlansDo) {
  for (const auto& row : search_fields()) {
    if (row.field.name != "method") continue;
    for (const Word& word : row.field.words) EXPECT_TRUE(planning::parse_method(word.name)) << word.name;
    EXPECT_EQ(row.field.words.size(), 5U);
  }
}

/// Law: a member that was set through its row has this value.
template <class Values>
void keeps_what_is_set(const Table<Values>& table) {
  for (const Bound<Values>& row : table) {
    SCOPED_TRACE(pointer_of(row.field));
    Values values{};
    std::vector<Value> given;
    if (row.field.kind == Kind::number) given = {row.field.least, row.field.most};
    if (row.field.kind == Kind::whole_number)
      given = {static_cast<int>(row.field.least), static_cast<int>(row.field.most)};
    if (row.field.kind == Kind::boolean) given = {true, false};
    for (const Word& word : row.field.words)
      if (row.field.kind == Kind::word) given.emplace_back(std::string{word.name});
    for (const Value& value : given) {
      row.set(values, value);

      const std::optional<Value> kept = row.get(values);
      ASSERT_TRUE(kept);
      EXPECT_EQ(kept->index(), value.index());
      if (row.field.kind == Kind::number) {
        const double number = std::get<double>(value);
        EXPECT_NEAR(std::get<double>(*kept), number, 1e-12 * std::abs(number));
      } else if (const auto* word = std::get_if<std::string>(&value)) {
        EXPECT_EQ(std::get<std::string>(*kept), *word);
      } else if (const auto* number = std::get_if<int>(&value)) {
        EXPECT_EQ(std::get<int>(*kept), *number);
      } else {
        EXPECT_EQ(std::get<bool>(*kept), std::get<bool>(value));
      }
    }
  }
}

TEST(RequestFields, KeepWhatIsSet) {
  keeps_what_is_set(margin_fields());
  keeps_what_is_set(iceberg_fields());
  keeps_what_is_set(encounter_fields());
  keeps_what_is_set(sighting_fields());
  keeps_what_is_set(passing_under_ice_fields());
  keeps_what_is_set(surfacing_fields());
  keeps_what_is_set(order_fields());
  keeps_what_is_set(alternative_fields());
  keeps_what_is_set(leg_fields());
  keeps_what_is_set(search_fields());
  keeps_what_is_set(hold_fields());
  keeps_what_is_set(energy_fields());
  keeps_what_is_set(weight_fields());
  keeps_what_is_set(error_model_fields());
  keeps_what_is_set(robustness_fields());
  keeps_what_is_set(isochrone_grid_fields());
  keeps_what_is_set(flight_fields());
  keeps_what_is_set(build_fields());
  keeps_what_is_set(thruster_fields());
}

/// The fields whose values the engine itself refuses.
std::vector<std::string> faults_of(const auto& values) {
  std::vector<std::string> fields;
  for (const core::Violation& violation : values.violations()) fields.push_back(violation.field);
  return fields;
}

/// Law: the engine accepts exactly the values that a request may have.
template <class Values>
void engine_agrees(const Table<Values>& table) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const Bound<Values>& row : table) {
    if (row.field.kind != Kind::number) continue;
    const std::string pointer = pointer_of(row.field);
    Values values{};
    for (const double allowed : {row.field.least, row.field.most}) {
      row.set(values, allowed);
      EXPECT_THAT(faults_of(values), Not(Contains(pointer))) << allowed;
    }
    for (const double refused :
         {std::nextafter(row.field.least, -infinite), std::nextafter(row.field.most, infinite)}) {
      row.set(values, refused);
      EXPECT_THAT(faults_of(values), Contains(pointer)) << refused;
    }
  }
}

TEST(RequestFields, HaveTheRangesOfTheEngine) {
  engine_agrees(margin_fields());
  engine_agrees(iceberg_fields());
  engine_agrees(encounter_fields());
  engine_agrees(passing_under_ice_fields());
  engine_agrees(surfacing_fields());
  engine_agrees(leg_fields());
  engine_agrees(search_fields());
  engine_agrees(hold_fields());
}

}  // namespace
}  // namespace floeplan::fields::request_fields_test
