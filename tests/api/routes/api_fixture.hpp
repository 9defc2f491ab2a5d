#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/routes/request/router.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::support {

/// A queue without workers: jobs stay as they were submitted until a test changes them.
class IdleJobs : public routes::JobGateway {
 public:
  tl::expected<repository::JobRecord, routes::SubmissionRefused> submit(sql::Connection& db,
                                                                        const routes::Submission& submission,
                                                                        core::UtcTime now) override {
    last_submission = submission;
    if (refusal) return tl::unexpected(*refusal);
    repository::JobRecord job;
    job.id = {"job" + std::to_string(++last_)};
    job.process = submission.process;
    job.request_json = submission.inputs_json;
    job.digest = submission.digest;
    job.reply_json = submission.reply_json;
    job.created = now;
    job.updated = now;
    repository::JobRepository{db}.submit(job);
    return job;
  }
  bool dismiss(sql::Connection& db, const repository::JobId& id, core::UtcTime now) override {
    return repository::JobRepository{db}.dismiss(id, now);
  }
  std::shared_ptr<void> subscribe(const repository::JobId&, std::function<void()>) override {
    return nullptr;
  }
  std::shared_ptr<void> subscribe_to_all(std::function<void()>) override { return nullptr; }

  std::optional<routes::SubmissionRefused> refusal;
  routes::Submission last_submission;

 private:
  int last_{0};
};

/// The whole API on an empty store in memory, without a socket.
class ApiTest : public testing::Test {
 protected:
  routes::Response ask(const std::string& method, const std::string& target, const std::string& body = "",
                       std::map<std::string, std::string> headers = {}) {
    routes::Request request;
    auto parsed = routes::parse_target(target);
    request.method = method;
    request.path = parsed->path;
    request.query = parsed->query;
    request.body = body;
    request.headers = std::move(headers);
    request.now = core::UtcTime{core::Seconds{1.8e9}};
    request.caller = routes::local_caller;
    last_request_ = request;
    return router_.answer({db_, jobs_, service_}, request);
  }
  routes::Response ask_again(const std::string& token, bool last) {
    last_request_.resumption = routes::Resumption{token, last};
    return router_.answer({db_, jobs_, service_}, last_request_);
  }

  sql::Connection db_{support::empty_store()};
  IdleJobs jobs_;
  routes::ServiceInfo service_{.public_url = "http://127.0.0.1:8080",
                               .web = {},
                               .uploads = {},
                               .current_blocks = std::make_shared<repository::CurrentBlocks>(1 << 20)};
  routes::Router router_{routes::all_routes()};
  routes::Request last_request_;
};

inline nlohmann::json json_of(const routes::Response& response) {
  return nlohmann::json::parse(response.body);
}

inline std::string header_of(const routes::Response& response, const std::string& name) {
  for (const auto& [key, value] : response.headers) {
    if (key == name) return value;
  }
  return {};
}

}  // namespace floeplan::support
