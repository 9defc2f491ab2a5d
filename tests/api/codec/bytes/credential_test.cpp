#include "api/codec/bytes/credential.hpp"

#include <gtest/gtest.h>

namespace floeplan::codec::credential_test {
namespace {

TEST(Credential, IsReadAsItIsWritten) {
  const Credential credential = new_credential();
  const std::string text = credential_text(credential);
  EXPECT_EQ(text.size(), 90U);
  EXPECT_EQ(parse_credential(text), credential);
}

TEST(Credential, IsAnotherEachTime) {
  const Credential one = new_credential();
  const Credential other = new_credential();
  EXPECT_NE(one.key, other.key);
  EXPECT_NE(one.secret, other.secret);
}

TEST(Credential, IsNotReadFromAnythingElse) {
  const std::string text = credential_text(new_credential());
  EXPECT_FALSE(parse_credential(""));
  EXPECT_FALSE(parse_credential("floeplan_"));
  EXPECT_FALSE(parse_credential(text + "0"));
  EXPECT_FALSE(parse_credential(text.substr(1)));
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string damaged = text;
    damaged[at] = 'X';
    EXPECT_FALSE(parse_credential(damaged)) << damaged;
  }
}

TEST(Credential, IsProvenByItsOwnDigestAlone) {
  const Credential credential = new_credential();
  EXPECT_TRUE(proves(credential, digest_of(credential)));
  EXPECT_FALSE(proves(credential, digest_of(new_credential())));
  EXPECT_FALSE(proves(credential, ""));
  EXPECT_EQ(digest_of(credential).find(credential.secret), std::string::npos);
}

}  // namespace
}  // namespace floeplan::codec::credential_test
