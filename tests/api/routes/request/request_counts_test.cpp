#include "api/routes/request/request_counts.hpp"

#include <gmock/gmock.h>

#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::request_counts_test {
namespace {

using std::chrono::duration;
using testing::HasSubstr;

TEST(RequestCounts, AreByOperationAndStatusAndCumulativeInTime) {
  RequestCounts counts;
  counts.add("GET", "/jobs/{job_id}", 200, duration<double>{0.002});
  counts.add("GET", "/jobs/{job_id}", 200, duration<double>{0.2});
  counts.add("GET", "/jobs/{job_id}", 404, duration<double>{20.0});
  counts.add("BREW", "", 404, duration<double>{0.0});

  const std::string text = counts.text();
  EXPECT_THAT(text,
              HasSubstr(R"(floeplan_http_requests_total{method="GET",route="/jobs/{job_id}",status="200"} 2)"
                        "\n"));
  EXPECT_THAT(text, HasSubstr(R"(floeplan_http_requests_total{method="other",route="none",status="404"} 1)"
                              "\n"));
  const std::string bucket = R"(floeplan_http_request_duration_seconds_bucket{route="/jobs/{job_id}",le=")";
  EXPECT_THAT(text, HasSubstr(bucket + "0.001\"} 0\n"));
  EXPECT_THAT(text, HasSubstr(bucket + "0.0025\"} 1\n"));
  EXPECT_THAT(text, HasSubstr(bucket + "10\"} 2\n"));
  EXPECT_THAT(text, HasSubstr(bucket + "+Inf\"} 3\n"));
}

class OperationsTest : public support::ApiTest {};

TEST_F(OperationsTest, TellJobsByState) {
  ask("POST", "/processes/evaluate-route/execution",
      R"({"inputs": {"route": [[-53.0, 69.0], [-52.9, 69.0]], "depart": "2026-11-20T00:00:00Z"}})");
  const auto response = ask("GET", "/metrics");
  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(response.body, HasSubstr("floeplan_jobs{state=\"accepted\"} 1\n"));
  EXPECT_THAT(response.body, HasSubstr("process_resident_memory_bytes "));
}

TEST_F(OperationsTest, AreReadyWhileTheStoreAnswers) { EXPECT_EQ(ask("GET", "/readyz").status, 200); }

}  // namespace
}  // namespace floeplan::routes::request_counts_test
