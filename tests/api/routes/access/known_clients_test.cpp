#include "api/routes/access/known_clients.hpp"

#include <gtest/gtest.h>

namespace floeplan::routes::known_clients_test {
namespace {

Request request_from(const std::string& peer, const std::string& token = "") {
  Request request;
  request.method = "GET";
  request.path = "/jobs";
  request.peer = peer;
  if (!token.empty()) request.headers["authorization"] = "Bearer " + token;
  return request;
}

TEST(KnownClients, AreAddressesUntilTheirTokensWereLetIn) {
  KnownClients clients{false};
  EXPECT_EQ(clients.client_of(request_from("10.0.0.1", "t")), clients.client_of(request_from("10.0.0.1")));
  EXPECT_NE(clients.client_of(request_from("10.0.0.1")), clients.client_of(request_from("10.0.0.2")));

  clients.learn(request_from("10.0.0.1", "t"), "ann");

  EXPECT_NE(clients.client_of(request_from("10.0.0.1", "t")), clients.client_of(request_from("10.0.0.1")));
  EXPECT_EQ(clients.client_of(request_from("10.0.0.1", "t")),
            clients.client_of(request_from("10.0.0.2", "t")));
}

TEST(KnownClients, AreOneHoweverOftenTheyLogIn) {
  KnownClients clients{false};
  Request by_cookie = request_from("10.0.0.2");
  by_cookie.headers["cookie"] = "floeplan_session=s";
  clients.learn(request_from("10.0.0.1", "t"), "ann");
  clients.learn(by_cookie, "ann");

  EXPECT_EQ(clients.client_of(by_cookie), clients.client_of(request_from("10.0.0.1", "t")));
}

TEST(KnownClients, MakeUpNoClientsWithCredentialsThatNobodyKnows) {
  KnownClients clients{false};
  for (const char* token : {"x1", "x2", "x3"}) {
    clients.learn(request_from("10.0.0.1", token), "");
    EXPECT_EQ(clients.client_of(request_from("10.0.0.1", token)),
              clients.client_of(request_from("10.0.0.1")));
  }
}

TEST(KnownClients, AreToldApartBehindAProxyByWhatItAdds) {
  const KnownClients clients{true};
  const auto through_proxy = [&](const std::string& hops) {
    Request request = request_from("127.0.0.1");
    request.headers["x-forwarded-for"] = hops;
    return clients.client_of(request);
  };
  EXPECT_NE(through_proxy("10.0.0.1"), through_proxy("10.0.0.2"));
  EXPECT_EQ(through_proxy("made up, 10.0.0.1"), through_proxy("10.0.0.1"));
}

TEST(KnownClients, ForgetRatherThanGrow) {
  KnownClients clients{false};
  for (std::size_t i = 0; i <= KnownClients::most_credentials; ++i)
    clients.learn(request_from("10.0.0.1", "t" + std::to_string(i)), "ann");

  EXPECT_EQ(clients.client_of(request_from("10.0.0.1", "t0")), clients.client_of(request_from("10.0.0.1")));
}

}  // namespace
}  // namespace floeplan::routes::known_clients_test
