#include <gmock/gmock.h>

#include "api/codec/inputs/plan_input_parts.hpp"

namespace floeplan::codec::energy_inputs_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

struct Read {
  planning::EnergyRules rules;
  core::Violations violations;
};

Read read(const json& inputs) {
  InputReader reader{inputs};
  Read result;
  read_energy(reader, result.rules);
  reader.refuse_unknown();
  result.violations = reader.violations();
  return result;
}

TEST(EnergyInputs, MinimiseTheTimeWhenNothingIsSaid) {
  EXPECT_EQ(read(json::object()).rules.objective, planning::time_objective);
  EXPECT_EQ(read({{"objective", "energy"}}).rules.objective, planning::energy_objective);
}

TEST(EnergyInputs, TakeWeightsOfBoth) {
  const Read result = read({{"objective", {{"time", 1.0}, {"energy", 0.5}}}, {"thruster", "off"}});

  EXPECT_THAT(result.violations, IsEmpty());
  EXPECT_EQ(result.rules.objective, (planning::Objective{1.0, 0.5}));
  EXPECT_EQ(result.rules.thruster, planning::ThrusterUse::off);
}

TEST(EnergyInputs, NameEveryFaultAtOnce) {
  const Read result = read({{"objective", {{"time", -1.0}, {"comfort", 2.0}}},
                            {"thruster", "full"},
                            {"require_battery", "please"}});

  EXPECT_THAT(result.violations, UnorderedElementsAre(Field(&core::Violation::field, "/objective/time"),
                                                      Field(&core::Violation::field, "/objective/comfort"),
                                                      Field(&core::Violation::field, "/thruster"),
                                                      Field(&core::Violation::field, "/require_battery")));
}

TEST(EnergyInputs, RefuseWeightsThatAreAllZeroAndOtherWords) {
  EXPECT_THAT(read({{"objective", json::object()}}).violations,
              ElementsAre(Field(&core::Violation::field, "/objective")));
  EXPECT_THAT(read({{"objective", "comfort"}}).violations,
              ElementsAre(Field(&core::Violation::field, "/objective")));
}

TEST(EnergyInputs, AreReadBackAsTheyWereWritten) {
  for (const json& inputs :
       {json::object(), json{{"objective", "energy"}, {"thruster", "on"}},
        json{{"objective", {{"time", 2.0}, {"energy", 0.25}}}, {"require_battery", true}}}) {
    json written;
    write_energy(read(inputs).rules, written);
    json again;
    write_energy(read(written).rules, again);
    EXPECT_EQ(again, written);
  }
}

}  // namespace
}  // namespace floeplan::codec::energy_inputs_test
