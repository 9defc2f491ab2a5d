#include <fstream>
#include <utility>

#include "storage/repository/access/owners.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/work/upload_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::routes::uploads_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

const Caller ann{"ann", repository::Role::pilot};
const Caller bob{"bob", repository::Role::pilot};
const Caller admin{"chief", repository::Role::admin};

class UploadsTest : public support::ApiTest {
 protected:
  UploadsTest() { service_.uploads = folder_.path() / "uploads"; }

  Response ask_as(const Caller& caller, const std::string& method, const std::string& target,
                  const std::string& file = "", const std::string& body = "") {
    const auto parsed = parse_target(target);
    Request request;
    request.method = method;
    request.path = parsed->path;
    request.query = parsed->query;
    request.body = body;
    request.headers = {{"content-type", "application/json"}};
    request.now = now_ += core::Seconds{1.0};
    request.caller = caller;
    if (method == "POST" && body.empty()) {
      std::ofstream{folder_.path() / "arriving"} << file;
      request.body_file = BodyFile{folder_.path() / "arriving", std::string(64, '0')};
    }
    return router_.answer({db_, jobs_, service_}, request);
  }
  Response send(const Caller& caller, const std::string& name, const std::string& file = "data") {
    return ask_as(caller, "POST", "/uploads?name=" + name, file);
  }
  std::vector<std::string> names_seen_by(const Caller& caller, std::string target = "/uploads?limit=2") {
    std::vector<std::string> names;
    while (!target.empty()) {
      const json page = support::json_of(ask_as(caller, "GET", target));
      EXPECT_LE(page.at("uploads").size(), 2U);
      for (const json& upload : page.at("uploads")) names.push_back(upload.at("name"));
      target.clear();
      for (const json& link : page.at("links"))
        if (link.at("rel") == "next")
          target = link.at("href").get<std::string>().substr(service_.public_url.size());
    }
    return names;
  }

  support::TemporaryFolder folder_;
  core::UtcTime now_{core::Seconds{1.8e9}};
};

TEST_F(UploadsTest, AreListedToWhoSentThemPageByPageAndAllToAnAdmin) {
  for (const char* name : {"a1", "a2", "a3"}) ASSERT_EQ(send(ann, name).status, 201);
  ASSERT_EQ(send(bob, "b1").status, 201);

  EXPECT_THAT(names_seen_by(ann), ElementsAre("a3", "a2", "a1"));
  EXPECT_THAT(names_seen_by(bob), ElementsAre("b1"));
  EXPECT_THAT(names_seen_by(admin), ElementsAre("b1", "a3", "a2", "a1"));
  const json listed = support::json_of(ask_as(admin, "GET", "/uploads")).at("uploads").at(0);
  EXPECT_EQ(listed.at("owner"), "bob");
  EXPECT_EQ(listed.at("bytes"), 4);
}

TEST_F(UploadsTest, AreNotListedOnceTheyHaveExpired) {
  ASSERT_EQ(send(ann, "a").status, 201);
  now_ += repository::UploadRepository::lifetime;
  EXPECT_THAT(names_seen_by(ann), testing::IsEmpty());
}

/// With the id of an upload of another owner, a user can do no more than with an id that does not exist.
TEST_F(UploadsTest, AreThereForWhoSentThemAndForAnAdminAlone) {
  const std::string id = support::json_of(send(ann, "a1")).at("id");
  const std::string upload = "/uploads/" + id;
  const std::string none = std::string(32, '0');
  const auto answer_of = [&](const Caller& caller, const std::string& method, const std::string& which) {
    Response response = ask_as(caller, method, "/uploads/" + which);
    for (std::size_t at = 0; (at = response.body.find(which, at)) != std::string::npos;)
      response.body.replace(at, which.size(), "ID");
    return std::pair{response.status, response.body};
  };
  const auto execution_with = [](const std::string& which) {
    return R"({"inputs":{"uploads":[")" + which + "\"]}}";
  };

  for (const char* method : {"GET", "DELETE"}) {
    EXPECT_EQ(answer_of(bob, method, id), answer_of(bob, method, none)) << method;
    EXPECT_EQ(answer_of(bob, method, id).first, 404) << method;
  }
  const Response ingested = ask_as(bob, "POST", "/processes/ingest/execution", "", execution_with(id));
  EXPECT_EQ(ingested.status, 400);
  EXPECT_THAT(ingested.body, HasSubstr("no upload has the id " + id));

  EXPECT_EQ(ask_as(ann, "GET", upload).status, 200);
  EXPECT_EQ(ask_as(admin, "GET", upload).status, 200);
  EXPECT_NE(ask_as(ann, "POST", "/processes/ingest/execution", "", execution_with(id)).status, 400);
  EXPECT_EQ(ask_as(admin, "DELETE", upload).status, 204);
  EXPECT_EQ(ask_as(ann, "GET", upload).status, 404);
}

TEST_F(UploadsTest, RefuseAPlaceThatNoLinkNames) {
  for (const char* before : {"", "1", "-", "x-0", "1e3-0"})
    EXPECT_EQ(ask_as(ann, "GET", std::string{"/uploads?before="} + before).status, 400) << before;
  EXPECT_EQ(ask_as(ann, "GET", "/uploads?limit=0").status, 400);
}

TEST_F(UploadsTest, AreAsManyAsTheQuotaOfEachTokenAllows) {
  service_.quotas->set({.uploads = 2});
  ASSERT_EQ(send(ann, "a1").status, 201);
  ASSERT_EQ(send(ann, "a2").status, 201);

  const Response refused = send(ann, "a3");

  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(support::json_of(refused).at("type"), "/problems/quota-uploads");
  EXPECT_THAT(refused.body, HasSubstr("2 uploads waiting"));
  EXPECT_THAT(refused.body, HasSubstr("DELETE /uploads/{id}"));
  EXPECT_THAT(names_seen_by(ann), ElementsAre("a2", "a1"));
  EXPECT_EQ(send(bob, "b1").status, 201) << "who has a quota of his own";
}

TEST_F(UploadsTest, HaveRoomAgainOnceOneIsRemoved) {
  service_.quotas->set({.uploads = 1});
  const std::string id = support::json_of(send(ann, "a1")).at("id");
  ASSERT_EQ(send(ann, "a2").status, 403);

  ASSERT_EQ(ask_as(ann, "DELETE", "/uploads/" + id).status, 204);

  EXPECT_EQ(send(ann, "a2").status, 201);
}

TEST_F(UploadsTest, MayHaveAsManyBytesAsTheQuotaLeavesBesideTheDatasets) {
  service_.quotas->set({.stored_bytes = 3'000'000});
  repository::Dataset dataset;
  dataset.id = {"bed"};
  dataset.provenance.file_size_bytes = 1'000'000;
  repository::DatasetRepository{db_}.insert(dataset);
  repository::Owners{db_}.note_dataset("bed", "ann");
  ASSERT_EQ(send(ann, "a1", std::string(1'000'000, ' ')).status, 201);

  const Response refused = send(ann, "a2", std::string(1'000'001, ' '));

  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(support::json_of(refused).at("type"), "/problems/quota-stored-bytes");
  EXPECT_THAT(refused.body, HasSubstr("stored 2 MB of the 3 MB"));
  EXPECT_THAT(names_seen_by(ann), ElementsAre("a1"));
  EXPECT_EQ(send(ann, "a2", std::string(1'000'000, ' ')).status, 201);
  const json quotas = support::json_of(ask_as(ann, "GET", "/uploads")).at("quotas");
  EXPECT_EQ(quotas.at("stored_bytes"), (json{{"used", 3'000'000}, {"most", 3'000'000}}));
  EXPECT_EQ(quotas.at("uploads").at("used"), 2);
}

TEST_F(UploadsTest, AreIngestedOnlyWhereTheirDatasetsFitTheQuota) {
  service_.quotas->set({.stored_bytes = 10});
  const std::string id = support::json_of(send(ann, "a1", "seven b")).at("id");
  const std::string execution = R"({"inputs":{"uploads":[")" + id + "\"]}}";
  EXPECT_NE(ask_as(ann, "POST", "/processes/ingest/execution", "", execution).status, 403);

  repository::Dataset dataset;
  dataset.id = {"bed"};
  dataset.provenance.file_size_bytes = 4;
  repository::DatasetRepository{db_}.insert(dataset);
  repository::Owners{db_}.note_dataset("bed", "ann");

  const Response refused = ask_as(ann, "POST", "/processes/ingest/execution", "", execution);
  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(support::json_of(refused).at("type"), "/problems/quota-stored-bytes");
}

}  // namespace
}  // namespace floeplan::routes::uploads_test
