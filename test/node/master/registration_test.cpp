// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The calls to a master, with a fake master and a fake node.
#include "node/master/registration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

constexpr int kSuccess = 1;
constexpr int kError = -1;

XmlRpcValue list(const std::vector<XmlRpcValue>& values) {
  XmlRpcValue result;
  result.setSize(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    result[static_cast<int>(i)] = values[i];
  return result;
}

/// Returns prepared answers by method, and records all calls.
struct Server {
  std::map<std::string, XmlRpcAnswer> answers;
  std::vector<std::string> asked;

  XmlRpcCall call() {
    return [this](const std::string& method, const XmlRpcValue&) -> std::optional<XmlRpcAnswer> {
      asked.push_back(method);
      const auto answer = answers.find(method);
      if (answer == answers.end()) return std::nullopt;
      return answer->second;
    };
  }

  long count(const std::string& method) const {
    return std::count(asked.begin(), asked.end(), method);
  }
};

/// A node with two publications and one subscription.
Server someNode() {
  Server node;
  node.answers["getPublications"] = {
      kSuccess, list({list({"/boxes", "some/Type"}), list({"/rosout", "some/Log"})})};
  node.answers["getSubscriptions"] = {kSuccess, list({list({"/tf", "some/Transforms"})})};
  node.answers["publisherUpdate"] = {kSuccess, 0};
  return node;
}

Server someMaster(const XmlRpcValue& publishers) {
  Server master;
  master.answers["registerPublisher"] = {kSuccess, list({})};
  master.answers["registerSubscriber"] = {kSuccess, publishers};
  return master;
}

TEST(QueryRegistration, AMasterThatIsGoneIsUnreachable) {
  Server master;
  EXPECT_EQ(queryRegistration(master.call()), Registration::kUnreachable);
}

TEST(QueryRegistration, AMasterMayNotKnowUs) {
  Server master;
  master.answers["lookupNode"] = {kError, 0};
  EXPECT_EQ(queryRegistration(master.call()), Registration::kUnknown);
}

/// Without ros::init the URI of this node is empty.
TEST(QueryRegistration, OurOwnUriShowsThatWeAreKnown) {
  Server master;
  master.answers["lookupNode"] = {kSuccess, ""};
  EXPECT_EQ(queryRegistration(master.call()), Registration::kKnown);
}

TEST(QueryRegistration, AnotherUriUnderOurNameIsAnotherNode) {
  Server master;
  master.answers["lookupNode"] = {kSuccess, "http://elsewhere:1/"};
  EXPECT_EQ(queryRegistration(master.call()), Registration::kNameTaken);
}

TEST(RegisterAgain, AllPublicationsAndSubscriptionsAreNamed) {
  Server node = someNode();
  Server master = someMaster(list({"http://publisher:1/"}));
  EXPECT_TRUE(registerAgain(master.call(), node.call()));
  EXPECT_EQ(master.count("registerPublisher"), 2);
  EXPECT_EQ(master.count("registerSubscriber"), 1);
  EXPECT_EQ(node.count("publisherUpdate"), 1);
}

TEST(RegisterAgain, NoPublishersAtTheMasterEndNoConnection) {
  Server node = someNode();
  Server master = someMaster(list({}));
  EXPECT_TRUE(registerAgain(master.call(), node.call()));
  EXPECT_EQ(node.count("publisherUpdate"), 0);
}

TEST(RegisterAgain, AMasterThatGoesAwayMeanwhileIsReported) {
  for (const char* method : {"registerPublisher", "registerSubscriber"}) {
    Server node = someNode();
    Server master = someMaster(list({}));
    master.answers.erase(method);
    EXPECT_FALSE(registerAgain(master.call(), node.call())) << method;
  }
}

TEST(RegisterAgain, ANodeThatDoesNotAnswerIsReported) {
  for (const char* method : {"getPublications", "getSubscriptions", "publisherUpdate"}) {
    Server node = someNode();
    Server master = someMaster(list({"http://publisher:1/"}));
    node.answers.erase(method);
    EXPECT_FALSE(registerAgain(master.call(), node.call())) << method;
  }
}

}  // namespace
}  // namespace link_bounds
