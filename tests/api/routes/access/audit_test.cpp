#include "api/routes/access/audit.hpp"

#include <gtest/gtest.h>

namespace floeplan::routes::audit_test {
namespace {

std::string action_of(const std::string& method, const std::string& path, int status = 200) {
  Request request;
  request.method = method;
  request.path = path;
  Response response;
  response.status = status;
  const auto deed = deed_of(request, response);
  return deed ? deed->action : "";
}

TEST(Deed, IsWhatSomebodyMayHaveToAnswerFor) {
  EXPECT_EQ(action_of("POST", "/processes/plan-route/execution", 201), "plan-route");
  EXPECT_EQ(action_of("POST", "/uploads", 201), "upload");
  EXPECT_EQ(action_of("DELETE", "/collections/plans/items/a", 204), "remove");
  EXPECT_EQ(action_of("GET", "/collections/plans/items/a/mission.zip"), "export");
  EXPECT_EQ(action_of("GET", "/collections/plans/items/a/mission"), "export");
  EXPECT_EQ(action_of("GET", "/simulations/a/tracks.nc"), "export");
  EXPECT_EQ(action_of("DELETE", "/session", 204), "log-out");
}

TEST(Deed, IsNoLookAndNoFailure) {
  EXPECT_EQ(action_of("GET", "/collections/plans/items/a"), "");
  EXPECT_EQ(action_of("POST", "/missions/check"), "");
  EXPECT_EQ(action_of("POST", "/session"), "") << "is counted by the ledger of logins";
  EXPECT_EQ(action_of("POST", "/processes/plan-route/execution", 400), "");
  EXPECT_EQ(action_of("DELETE", "/collections/plans/items/a", 404), "");
}

TEST(Deed, OfAJobIsNotedWhenTheJobIsThereNotWhenItEnds) {
  Request request;
  request.method = "POST";
  request.path = "/processes/plan-route/execution";
  Response waiting;
  waiting.wait = Wait{core::Seconds{1.0}, "7f", {}};
  EXPECT_EQ(deed_of(request, waiting)->target, "/jobs/7f");
  request.resumption = Resumption{"7f", true};
  EXPECT_FALSE(deed_of(request, Response{}));
}

}  // namespace
}  // namespace floeplan::routes::audit_test
