#include "collision_forge/io/logs/pickle_workers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <thread>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class PickleWorkersTest : public testing::Test {
 protected:
  std::string problemOf(const std::string& path) {
    try {
      workers_.read(path);
      return "";
    } catch (const PickleError& error) {
      return error.what();
    }
  }

  const TemporaryFolder folder_;
  PickleWorkers workers_;
};

TEST_F(PickleWorkersTest, RoundTripsExactly) {
  const double item = 0.1;
  PickleContent content;
  content.json = R"({"metadata": {"id": 9007199254740993, "x": [1, null, "\u00e9"],)"
                 R"( "y": {"ndarray": [1], "dtype": "f8", "at": 0}}, "others": 1})";
  content.items.assign(reinterpret_cast<const char*>(&item), sizeof(item));
  const PickleContent back = workers_.read(folder_.write("a.pkl", workers_.write(content)));
  EXPECT_EQ(back.json, R"({"metadata":{"id":9007199254740993,"x":[1,null,")"
                       "\xc3\xa9"
                       R"("],"y":{"ndarray":[1],"dtype":"f8","at":0}}})");
  EXPECT_EQ(back.items, content.items);
}

TEST_F(PickleWorkersTest, AFileThatCannotBeReadIsNamed) {
  EXPECT_THAT(problemOf("/nowhere/at_all.pkl"), StartsWith("/nowhere/at_all.pkl: cannot be read"));
  const std::string path = folder_.write("hostile.pkl", "cos\nsystem\n(S'true'\ntR.");
  EXPECT_THAT(problemOf(path), AllOf(StartsWith(path), HasSubstr("is no dict")));
}

TEST_F(PickleWorkersTest, ARejectedFileDoesNotAffectOthers) {
  const std::string path = folder_.write("a.pkl", workers_.write({R"({"metadata": {}})", ""}));
  for (int again = 0; again < 3; ++again) {
    EXPECT_THAT(problemOf(folder_.write("b.pkl", "no pickle")), HasSubstr("b.pkl: is no pickle"));
    EXPECT_EQ(workers_.read(path).json, R"({"metadata":{}})");
  }
}

TEST_F(PickleWorkersTest, ManyThreadsReadAtOnce) {
  const std::string path = folder_.write("a.pkl", workers_.write({R"({"metadata": {}})", ""}));
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (int again = 0; again < 10; ++again) {
        EXPECT_EQ(workers_.read(path).json, R"({"metadata":{}})");
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST_F(PickleWorkersTest, ASummaryHasTheMetadataOfEachFileByItsName) {
  const std::string path =
      folder_.write("a.pkl", workers_.write({R"({"metadata": {"id": 1}})", ""}));
  const std::string summary = workers_.summarize({{"metadata", path}});
  EXPECT_EQ(workers_.read(folder_.write("b.pkl", summary)).json, R"({"metadata":{"id":1}})");
  EXPECT_THROW(workers_.summarize({{"c", folder_.path() + "/c.pkl"}}), PickleError);
}

}  // namespace
}  // namespace forge
