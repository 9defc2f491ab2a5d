#include "api/routes/processes/execution_request.hpp"
#include "storage/repository/access/owners.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::routes::execution_test {
namespace {

using repository::JobRepository;
using support::header_of;
using support::json_of;

constexpr const char* plan_path = "/processes/plan-route/execution";
constexpr const char* valid_body =
    R"({"inputs":{"from":[-53,69],"to":[-52.5,69.3],"depart":"2026-11-20T06:00:00Z"}})";

class ExecutionTest : public support::ApiTest {
 protected:
  void finish(const std::string& id, const std::string& result) {
    JobRepository jobs{db_};
    const core::UtcTime now{core::Seconds{1.8e9}};
    ASSERT_TRUE(jobs.claim("worker", now, core::Seconds{60.0}).has_value());
    ASSERT_TRUE(jobs.succeed({id}, "worker", result, now));
  }
  std::vector<std::string> pointers(const std::string& body) {
    const auto response = ask("POST", plan_path, body);
    EXPECT_EQ(response.status, 400) << response.body;
    std::vector<std::string> found;
    const auto document = json_of(response);
    for (const auto& error : document.value("errors", nlohmann::json::array()))
      found.push_back(error.at("pointer"));
    return found;
  }
};

TEST_F(ExecutionTest, AnswersWithAJobThatIsInTheStore) {
  const auto response = ask("POST", plan_path, valid_body, {{"prefer", "respond-async"}});
  EXPECT_EQ(response.status, 201);
  EXPECT_EQ(header_of(response, "Location"), "http://127.0.0.1:8080/jobs/job1");
  EXPECT_EQ(json_of(response).at("status"), "accepted");
  EXPECT_TRUE(JobRepository{db_}.find({"job1"}).has_value());
}

/// Plans use up a quota as files do. A process that stores nothing is still allowed.
TEST_F(ExecutionTest, BeginsNoPlanForAnOwnerWhoseQuotaIsSpent) {
  service_.quotas->set({.stored_bytes = 1000});
  repository::PlanRecord plan;
  plan.id = {"p"};
  plan.document_json = std::string(1000, ' ');
  repository::PlanRepository{db_}.insert(plan);
  repository::Owners{db_}.note_made(repository::plan_table, "p", plan.created, "");

  const auto refused = ask("POST", plan_path, valid_body, {{"prefer", "respond-async"}});

  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(json_of(refused).at("type"), "/problems/quota-stored-bytes");
  EXPECT_THAT(refused.body, testing::HasSubstr("DELETE /collections/plans/items/{id}"));
  EXPECT_EQ(JobRepository{db_}.count(repository::JobStatus::accepted), 0);
  EXPECT_EQ(
      ask("POST", "/processes/echo/execution", R"({"inputs":{}})", {{"prefer", "respond-async"}}).status,
      201);

  ASSERT_TRUE(repository::PlanRepository{db_}.remove({"p"}));
  EXPECT_EQ(ask("POST", plan_path, valid_body, {{"prefer", "respond-async"}}).status, 201);
}

TEST_F(ExecutionTest, TellsOfTheJobOfAKeyWhateverTheQuota) {
  const std::map<std::string, std::string> headers{{"prefer", "respond-async"}, {"idempotency-key", "k"}};
  ASSERT_EQ(ask("POST", plan_path, valid_body, headers).status, 201);
  service_.quotas->set({.stored_bytes = 0});

  const auto again = ask("POST", plan_path, valid_body, headers);

  EXPECT_EQ(again.status, 201) << again.body;
}

TEST_F(ExecutionTest, NamesEveryFaultAtOnce) {
  EXPECT_THAT(pointers(R"({"inputs":{"from":[-53],"to":[-52.5,99],"sectors":9,"colour":"red"}})"),
              testing::UnorderedElementsAre("/inputs/from", "/inputs/to", "/inputs/depart", "/inputs/sectors",
                                            "/inputs/colour"));
}

TEST_F(ExecutionTest, RefusesEqualEndsAndUnknownDatasets) {
  EXPECT_THAT(pointers(R"({"inputs":{"from":[1,2],"to":[1,2],"depart":"2026-11-20T06:00:00Z"}})"),
              testing::ElementsAre("/inputs/to"));
  EXPECT_THAT(
      pointers(
          R"({"inputs":{"from":[1,2],"to":[1,3],"depart":"2026-11-20T06:00:00Z","bathymetry":"bathymetry-00000000"}})"),
      testing::ElementsAre("/inputs/bathymetry"));
}

TEST_F(ExecutionTest, RefusesWhatIsNotJson) {
  for (const std::string body :
       {"", "{", "NaN", R"({"inputs":{"from":[NaN,1]}})", R"({"inputs":{"speed_m_s":1e999}})"}) {
    EXPECT_EQ(ask("POST", plan_path, body).status, 400) << body;
  }
  EXPECT_EQ(ask("POST", plan_path, valid_body, {{"content-type", "text/plain"}}).status, 415);
}

TEST_F(ExecutionTest, SurvivesTwoMegabytesOfNestedJson) {
  EXPECT_EQ(ask("POST", plan_path, std::string(2'000'000, '[')).status, 400);
  std::string objects;
  for (int i = 0; i < 300'000; ++i) objects += R"({"a":)";
  EXPECT_EQ(ask("POST", plan_path, objects).status, 400);
}

/// Request bodies of a megabyte each.
std::vector<std::string> bodies_with_a_fault_in_every_word() {
  const auto repeated = [](const std::string& word, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + word;
    return text;
  };
  std::string keys;
  for (int i = 0; i < 90'000; ++i) keys += (i == 0 ? "\"k" : ",\"k") + std::to_string(i) + "\":1";
  std::string long_keys;
  for (int i = 0; i < 99; ++i)
    long_keys += (i == 0 ? "\"" : ",\"") + std::to_string(i) + std::string(10'000, 'k') + "\":1";
  const std::string rings = repeated("[[[0,0],[1,1],[2,0],[0,1]]]", 35'000);
  return {
      R"({"inputs":{)" + keys + "}}",
      R"({"inputs":{)" + long_keys + "}}",
      R"({"inputs":{"vehicle":{)" + keys + "}}}",
      R"({"inputs":{"areas":{"type":"FeatureCollection","features":[)" + repeated("1", 1'000) + "]}}}",
      R"({"inputs":{"areas":{"type":"FeatureCollection","features":[)" +
          repeated(R"({"properties":{"kind":7,"until":[1],"top":1}})", 1'000) + "]}}}",
      R"({"inputs":{"areas":{"type":"Feature","properties":{"kind":"no_go"},"geometry":{"type":"MultiPolygon",)"
      R"("coordinates":[)" +
          rings + "]}}}}",
      R"({"inputs":{"currents":[)" + repeated("\"" + std::string(15'000, 'c') + "\"", 64) + "]}}",
      R"({"inputs":{"goals_file":{"name":"a.gpx","text":"<gpx>)" + repeated("<rtept lat='95'/>", 55'000) +
          R"(</gpx>"}}})",
      "{" + keys + "}",
      R"({"outputs":{)" + keys + "}}",
      "{\"" + std::string(500'000, 'k') + "\":1,\"" + std::string(500'000, 'k') + "\":2}"};
}

TEST_F(ExecutionTest, AnswersShortlyHoweverMuchIsWrong) {
  for (const std::string& body : bodies_with_a_fault_in_every_word()) {
    const auto response = ask("POST", plan_path, body);

    EXPECT_EQ(response.status, 400) << body.substr(0, 100);
    EXPECT_LT(response.body.size(), 100'000U) << body.substr(0, 100);
  }
}

TEST_F(ExecutionTest, WaitsForTheResultsUnlessAskedNotTo) {
  const auto first = ask("POST", plan_path, valid_body);
  ASSERT_TRUE(first.wait.has_value());
  EXPECT_TRUE(ask_again(first.wait->token, false).wait.has_value());

  finish("job1", R"({"plan":{"status":"ok"}})");
  const auto answer = ask_again(first.wait->token, false);
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.body, R"({"plan":{"status":"ok"}})");
}

TEST_F(ExecutionTest, HandsOutTheJobWhenTheWaitIsTooLong) {
  const auto first = ask("POST", plan_path, valid_body, {{"prefer", "respond-sync"}});
  ASSERT_TRUE(first.wait.has_value());
  EXPECT_EQ(ask_again(first.wait->token, true).status, 201);
}

TEST_F(ExecutionTest, ResultsAreThereOnlyOnceTheJobHasEnded) {
  ask("POST", plan_path, valid_body);
  const auto early = ask("GET", "/jobs/job1/results");
  EXPECT_EQ(early.status, 404);
  EXPECT_TRUE(json_of(early).at("type").get<std::string>().ends_with("/result-not-ready"));

  finish("job1", R"({"plan":{}})");
  EXPECT_EQ(ask("GET", "/jobs/job1/results").status, 200);
  EXPECT_EQ(json_of(ask("GET", "/jobs/job1")).at("progress"), 100);
}

TEST_F(ExecutionTest, ALongPollAnswersAtTheNextChange) {
  ask("POST", plan_path, valid_body);
  const auto first = ask("GET", "/jobs/job1", "", {{"prefer", "wait=20"}});
  ASSERT_TRUE(first.wait.has_value());
  EXPECT_TRUE(ask_again(first.wait->token, false).wait.has_value());

  finish("job1", "{}");
  EXPECT_EQ(json_of(ask_again(first.wait->token, false)).at("status"), "successful");
}

TEST_F(ExecutionTest, SaysWhyThereIsNoJob) {
  jobs_.refusal = SubmissionRefused::queue_full;
  const auto full = ask("POST", plan_path, valid_body);
  EXPECT_EQ(full.status, 503);
  EXPECT_EQ(header_of(full, "Retry-After"), "30");
  jobs_.refusal = SubmissionRefused::key_reused;
  EXPECT_EQ(ask("POST", plan_path, valid_body).status, 409);
  jobs_.refusal = SubmissionRefused::job_removed;
  EXPECT_EQ(ask("POST", plan_path, valid_body).status, 410);
}

TEST_F(ExecutionTest, TakesWhatTheResultFollowsFromIntoOneDigest) {
  const auto digest_of = [&](const std::string& body) {
    ask("POST", plan_path, body);
    return jobs_.last_submission.digest;
  };
  const auto digest = digest_of(valid_body);
  ASSERT_TRUE(digest.has_value());
  EXPECT_EQ(
      digest_of(R"({"inputs":{"depart":"2026-11-20T06:00:00+00:00","to":[-52.5,69.3],"from":[-53.0,69]}})"),
      digest);
  EXPECT_NE(digest_of(R"({"inputs":{"depart":"2026-11-20T06:00:00Z","to":[-52.5,69.4],"from":[-53,69]}})"),
            digest);
  repository::Dataset more;
  more.id = {"currents-00000000"};
  more.kind = repository::DatasetKind::currents;
  repository::DatasetRepository{db_}.insert(more);
  EXPECT_NE(digest_of(valid_body), digest) << "other data, other results";
}

/// A value as OGC API - Processes 7.11.2.3 allows it: with its media type or schema, or without.
nlohmann::json qualified(std::mt19937_64& rng, const nlohmann::json& value) {
  nlohmann::json input{{"value", value}};
  if (support::uniform_int(rng, 0, 1) == 0) input["mediaType"] = "application/json";
  if (support::uniform_int(rng, 0, 1) == 0) input["schema"] = {{"type", "array"}};
  return input;
}

TEST_F(ExecutionTest, TakesEveryInputOfEveryProcessAsAQualifiedValueToo) {
  using nlohmann::json;
  const std::vector<json> values{3,
                                 "a text",
                                 true,
                                 json::array({-53, 69}),
                                 {{"value", 3}, {"unit", "m"}},
                                 json::array({{-53, 69}, {-52, 69}}),
                                 {{"name", "a.gpx"}, {"text", "<gpx/>"}}};
  support::for_each_seed(100, [&](std::mt19937_64& rng) {
    for (const ProcessEntry& process : all_processes()) {
      json bare;
      json wrapped;
      for (int i = support::uniform_int(rng, 1, 6); i > 0; --i) {
        const std::string name = "input" + std::to_string(i);
        bare[name] = values[static_cast<std::size_t>(support::uniform_int(rng, 0, 6))];
        wrapped[name] = support::uniform_int(rng, 0, 3) == 0 ? bare[name] : qualified(rng, bare[name]);
      }
      bare["several"] = values;
      for (const json& value : values) wrapped["several"].push_back(qualified(rng, value));
      Request request;
      request.body = json{{"inputs", wrapped}}.dump();

      const auto read = read_execution(request, process);

      ASSERT_TRUE(read.has_value()) << read.error().body;
      EXPECT_EQ(read->inputs, bare) << process.id;
    }
  });
}

TEST_F(ExecutionTest, PlansTheSameFromQualifiedValues) {
  ask("POST", plan_path, valid_body);
  const auto digest = jobs_.last_submission.digest;
  ask("POST", plan_path,
      R"({"inputs":{"from":{"value":[-53,69]},"to":{"value":[-52.5,69.3,0],"mediaType":"application/json"},)"
      R"("depart":{"value":"2026-11-20T06:00:00Z"}}})");
  EXPECT_EQ(jobs_.last_submission.digest, digest);
}

TEST_F(ExecutionTest, RefusesInputsThatAreLinksOrEncoded) {
  EXPECT_THAT(
      pointers(
          R"({"inputs":{"from":{"href":"http://127.0.0.1/a.json"},"to":{"value":"AA==","encoding":"base64"},)"
          R"("depart":"2026-11-20T06:00:00Z"}})"),
      testing::UnorderedElementsAre("/inputs/from", "/inputs/to/encoding"));
}

TEST_F(ExecutionTest, DoesAPlanAgainWhoseResultWasRemoved) {
  ask("POST", plan_path, valid_body);
  EXPECT_FALSE(jobs_.last_submission.force);
  finish("job1", R"({"plan":{"status":"ok","plan_id":"p000000000000"}})");

  ask("POST", plan_path, valid_body);

  EXPECT_TRUE(jobs_.last_submission.force) << "no plan p000000000000 is stored";
}

TEST_F(ExecutionTest, GivesTheOutputsThatAreWantedInTheFormThatIsWanted) {
  const std::string echo = "/processes/echo/execution";
  EXPECT_EQ(ask("POST", echo, R"({"inputs":{},"outputs":{"plan":{}}})").status, 400);
  EXPECT_EQ(ask("POST", echo, R"({"inputs":{},"response":"cooked"})").status, 400);
  EXPECT_EQ(ask("POST", echo, R"({"inputs":{"text":{"type":"wrong/type"}}})").status, 400);

  const auto first = ask("POST", echo, R"({"inputs":{},"outputs":{"echo":{}},"response":"raw"})");
  finish("job1", R"({"echo":"teststring","text":"more"})");
  const auto raw = ask_again(first.wait->token, false);
  EXPECT_EQ(raw.body, "teststring");
  EXPECT_TRUE(raw.content_type.starts_with("text/plain"));

  const auto second = ask("POST", echo, R"({"inputs":{},"outputs":{}})");
  finish("job2", R"({"echo":"teststring","text":"more"})");
  EXPECT_EQ(json_of(ask_again(second.wait->token, false)).size(), 2U);
}

TEST_F(ExecutionTest, ListsTheJobsThatFitEveryParameter) {
  ask("POST", plan_path, valid_body);
  ask("POST", "/processes/echo/execution", R"({"inputs":{}})");
  finish("job1", "{}");
  const auto found = [&](const std::string& query) {
    std::vector<std::string> ids;
    const auto page = json_of(ask("GET", "/jobs?" + query));
    for (const auto& job : page.at("jobs")) ids.push_back(job.at("jobID"));
    return ids;
  };
  EXPECT_THAT(found(""), testing::ElementsAre("job2", "job1"));
  EXPECT_THAT(found("status=successful"), testing::ElementsAre("job1"));
  EXPECT_THAT(found("processID=echo&type=process"), testing::ElementsAre("job2"));
  EXPECT_THAT(found("datetime=../2027-01-01T00:00:00Z"), testing::IsEmpty());
  EXPECT_THAT(found("datetime=2027-01-01T00:00:00Z/.."), testing::SizeIs(2));
  EXPECT_THAT(found("minDuration=1"), testing::IsEmpty());
  EXPECT_EQ(ask("GET", "/jobs?status=busy").status, 400);
  EXPECT_EQ(ask("GET", "/jobs?minDuration=soon").status, 400);
}

TEST_F(ExecutionTest, ADismissedJobSaysSo) {
  ask("POST", plan_path, valid_body);
  EXPECT_EQ(json_of(ask("DELETE", "/jobs/job1")).at("status"), "dismissed");
  EXPECT_EQ(ask("GET", "/jobs/job1/results").status, 410);
}

}  // namespace
}  // namespace floeplan::routes::execution_test
