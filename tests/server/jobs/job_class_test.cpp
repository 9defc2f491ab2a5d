#include "server/jobs/job_class.hpp"

#include <gmock/gmock.h>

namespace floeplan::jobs::job_class_test {
namespace {

using repository::JobClass;

std::string plan_inputs(const std::string& more) {
  return R"({"from":[-53,69],"to":[-52.9,69.05],"depart":"2026-11-20T06:00:00Z")" + more + "}";
}

TEST(JobClass, OfOneSearchIsInteractive) {
  EXPECT_EQ(class_of("plan-route", plan_inputs("")), JobClass::interactive);
  EXPECT_EQ(class_of("evaluate-route", "{}"), JobClass::interactive);
  EXPECT_EQ(class_of("plan-route", "no inputs"), JobClass::interactive) << "refused at once";
}

TEST(JobClass, OfManyPartsIsBatch) {
  EXPECT_EQ(class_of("simulate-plan", R"({"plan_id":"p","runs":1})"), JobClass::batch);
  EXPECT_EQ(class_of("fly-scenario", R"({"scenario":"random-icebergs"})"), JobClass::batch);
  EXPECT_EQ(class_of("plan-route", plan_inputs(R"(,"depart_until":"2026-11-21T06:00:00Z")")),
            JobClass::batch);
  EXPECT_EQ(class_of("plan-route", plan_inputs(R"(,"uncertainty":{"objective":"mean"})")), JobClass::batch);
}

TEST(JobClass, OfFilesIsIngest) { EXPECT_EQ(class_of("ingest", R"({"uploads":[]})"), JobClass::ingest); }

TEST(TimeLimits, NameTheirClassAndWhatToDo) {
  for (const JobClass of : {JobClass::interactive, JobClass::batch, JobClass::ingest}) {
    const std::string message = overdue_message(of, core::Seconds{90.0});
    EXPECT_THAT(message, testing::HasSubstr("90 s"));
    EXPECT_THAT(message, testing::HasSubstr("--max-" + repository::class_name(of) + "-s"));
  }
}

}  // namespace
}  // namespace floeplan::jobs::job_class_test
