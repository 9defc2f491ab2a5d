#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::job_events_test {
namespace {

using repository::JobRepository;
using testing::HasSubstr;
using testing::Not;

constexpr core::UtcTime now{core::Seconds{1.8e9}};

class JobEventsTest : public support::ApiTest {
 protected:
  void submit(const std::string& id) {
    repository::JobRecord job;
    job.id = {id};
    job.process = "echo";
    job.created = now;
    JobRepository{db_}.submit(job);
  }
  void finish(const std::string& id) {
    JobRepository jobs{db_};
    ASSERT_TRUE(jobs.claim("worker", now, core::Seconds{60.0}).has_value());
    ASSERT_TRUE(jobs.succeed({id}, "worker", "{}", now));
  }
};

TEST_F(JobEventsTest, TellOfOneJobUntilItHasEnded) {
  submit("a");
  const auto first = ask("GET", "/jobs/a/events");
  EXPECT_EQ(first.content_type, "text/event-stream");
  EXPECT_THAT(first.body, HasSubstr("\"status\":\"accepted\""));
  ASSERT_TRUE(first.streams && first.wait);

  const auto nothing = ask_again(first.wait->token, false);
  EXPECT_EQ(nothing.body, "");
  EXPECT_TRUE(nothing.wait);
  EXPECT_TRUE(ask_again(first.wait->token, true).body.starts_with(":")) << "the line is kept open";

  finish("a");
  const auto last = ask_again(first.wait->token, false);
  EXPECT_THAT(last.body, HasSubstr("\"status\":\"successful\""));
  EXPECT_TRUE(last.streams && !last.wait);
}

TEST_F(JobEventsTest, ResumeAfterTheLastEventThatWasSeen) {
  submit("a");
  submit("b");
  finish("a");

  const auto first = ask("GET", "/events", "", {{"last-event-id", "1"}});
  EXPECT_THAT(first.body, HasSubstr("\"jobID\":\"b\""));
  EXPECT_THAT(first.body, HasSubstr("\"status\":\"successful\""));
  EXPECT_THAT(first.body, Not(HasSubstr("\"running\""))) << "each job as it stands";

  const std::string seen = first.wait->token;
  EXPECT_EQ(ask("GET", "/events", "", {{"last-event-id", seen}}).body, "retry: 2000\n\n");
  EXPECT_EQ(ask("GET", "/jobs/a/events", "", {{"last-event-id", seen}}).status, 204);
}

TEST_F(JobEventsTest, BeginWithWhatChangesFromNowOn) {
  submit("a");
  const auto first = ask("GET", "/events");
  EXPECT_THAT(first.body, Not(HasSubstr("jobID")));

  submit("b");
  EXPECT_THAT(ask_again(first.wait->token, false).body, HasSubstr("\"jobID\":\"b\""));
}

TEST_F(JobEventsTest, RefuseWhatIsNoEventOrNoJob) {
  EXPECT_EQ(ask("GET", "/events", "", {{"last-event-id", "yesterday"}}).status, 400);
  EXPECT_EQ(ask("GET", "/jobs/none/events").status, 404);
}

}  // namespace
}  // namespace floeplan::routes::job_events_test
