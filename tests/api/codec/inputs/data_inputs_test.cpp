#include "api/codec/inputs/data_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace floeplan::codec::data_inputs_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using How = repository::DatasetChoice::How;

repository::EnvironmentQuery read(const json& inputs, std::vector<std::string>& faults) {
  InputReader reader{inputs};
  repository::EnvironmentQuery data;
  read_data(reader, data);
  reader.refuse_unknown();
  for (const core::Violation& violation : reader.violations()) faults.push_back(violation.field);
  return data;
}

TEST(DataInputs, TakeSeveralDatasetsOfIcebergsAndWriteThemAsTheyWereGiven) {
  const json inputs{{"icebergs", {"icebergs-1", "icebergs-by-hand"}}};
  std::vector<std::string> faults;

  const auto data = read(inputs, faults);
  json written = json::object();
  write_data(data, written);

  EXPECT_THAT(faults, ElementsAre());
  EXPECT_EQ(data.icebergs.how, How::named);
  EXPECT_THAT(data.icebergs.ids,
              ElementsAre(repository::DatasetId{"icebergs-1"}, repository::DatasetId{"icebergs-by-hand"}));
  EXPECT_EQ(written.at("icebergs"), inputs.at("icebergs"));
}

TEST(DataInputs, RefuseAnArrayWhereOneDatasetIsUsed) {
  std::vector<std::string> faults;

  (void)read({{"ice", {"ice-1", "ice-2"}}, {"icebergs", json::array()}, {"coastline", 3}}, faults);

  EXPECT_THAT(faults, testing::UnorderedElementsAre("/ice", "/icebergs", "/coastline"));
}

}  // namespace
}  // namespace floeplan::codec::data_inputs_test
