#include "api/service/coverage_checks.hpp"

#include <gmock/gmock.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::service::coverage_checks_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr geo::LonLat in_the_bay{-53.2, 69.2};
constexpr geo::LonLat exchanged{69.2, -53.2};

/// A store that holds currents of Disko Bay.
class CoverageChecks : public testing::Test {
 protected:
  CoverageChecks() {
    add("currents-12345678", repository::DatasetKind::currents, "1234");
  }

  void add(const std::string& id, repository::DatasetKind kind, const std::string& sha256) {
    repository::Dataset dataset;
    dataset.id = {id};
    dataset.kind = kind;
    dataset.name = "bay";
    dataset.bounds = {-55.0, 68.0, -50.0, 70.0};
    dataset.provenance.sha256 = sha256;
    repository::DatasetRepository{db_}.insert(dataset);
  }

  support::TemporaryFolder store_;
  sql::Connection db_{repository::open_store(store_.path())};
  repository::EnvironmentQuery query_;
};

TEST_F(CoverageChecks, NameSwappedPlacesWithTheExchangedCoordinates) {
  const auto found =
      swapped_places(db_, {{"from", exchanged}, {"to", in_the_bay}, {"via/0", exchanged}}, query_);

  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].field, "/from");
  EXPECT_THAT(found[0].rule, HasSubstr("did you mean --from=-53.2,69.2?"));
  EXPECT_EQ(found[1].field, "/via/0");
  EXPECT_THAT(found[1].rule, HasSubstr("did you mean --via=-53.2,69.2?"));
}

TEST_F(CoverageChecks, NameNoPlacesThatNoDataCoverEitherWay) {
  EXPECT_THAT(swapped_places(db_, {{"from", {10.0, 20.0}}}, query_), IsEmpty());
}

TEST_F(CoverageChecks, RefuseAnAreaBeyondAllDepthsUnlessNoneAreStoredOrWanted) {
  query_.area = {10.0, 60.0, 12.0, 61.0};
  EXPECT_THAT(depths_elsewhere(db_, query_), IsEmpty()) << "no bathymetry is stored";

  add("bathymetry-12345678", repository::DatasetKind::bathymetry, "5678");
  const auto refused = depths_elsewhere(db_, query_);
  ASSERT_THAT(refused, SizeIs(1));
  EXPECT_EQ(refused[0].field, "/bathymetry");
  EXPECT_THAT(refused[0].rule, HasSubstr("covers 55° W to 50° W, 68° N to 70° N"));

  query_.bathymetry.how = repository::DatasetChoice::How::none;
  EXPECT_THAT(depths_elsewhere(db_, query_), IsEmpty());
  query_.bathymetry.how = repository::DatasetChoice::How::newest;
  query_.area = {-50.5, 69.0, -45.0, 69.5};
  EXPECT_THAT(depths_elsewhere(db_, query_), IsEmpty()) << "the planner judges the places themselves";
}

TEST_F(CoverageChecks, LookForNoSwappedPlacesWhereNoDataAreWanted) {
  query_.currents.how = repository::DatasetChoice::How::none;
  query_.bathymetry.how = repository::DatasetChoice::How::none;

  EXPECT_THAT(swapped_places(db_, {{"from", exchanged}}, query_), IsEmpty());
}

}  // namespace
}  // namespace floeplan::service::coverage_checks_test
