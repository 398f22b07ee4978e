#include "collision_forge/attack/search/method_registry.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

MethodSetup withoutLearning() {
  const AttackOptions options = shippedOptions();
  const auto futures = std::make_shared<KinematicEgoFutures>(options.ego_futures, nullptr);
  return {options,
          {futures, std::make_shared<KinematicPatternPredictor>(options, futures)},
          std::nullopt,
          ""};
}

std::string complaintOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(MethodRegistry, HasEveryMethodOnceAndWithADescription) {
  const MethodRegistry methods = builtInMethods();
  const auto names = methods.names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const std::string& name : names) {
    EXPECT_TRUE(methods.has(name));
    EXPECT_FALSE(methods.at(name).description.empty()) << name;
  }
}

TEST(MethodRegistry, ListsTheKnownNamesForAnUnknownOne) {
  const std::string complaint = complaintOf([] { builtInMethods().at("serach"); });
  EXPECT_NE(complaint.find("serach"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("network+search"), std::string::npos) << complaint;
}

TEST(MethodRegistry, RejectsASecondMethodOfTheSameName) {
  MethodRegistry methods = builtInMethods();
  EXPECT_THROW(methods.add(methods.at("search")), std::invalid_argument);
  EXPECT_THROW(methods.add({"", "nameless", true, {}}), std::invalid_argument);
}

TEST(MethodRegistry, MethodsWithNetworksNeedThem) {
  const MethodRegistry methods = builtInMethods();
  for (const MethodRegistry::Entry& entry : methods.entries()) {
    const std::string complaint = complaintOf([&] { entry.make(withoutLearning()); });
    const bool needs = entry.name.rfind("network", 0) == 0;
    EXPECT_EQ(complaint.find("names no file for") != std::string::npos, needs) << entry.name;
  }
}

TEST(MethodRegistry, NamesWithAndWithoutNetworksAreInverse) {
  EXPECT_EQ(withNetworks("search"), "network+search");
  EXPECT_EQ(withoutNetworks("network+search"), "search");
  EXPECT_EQ(withoutNetworks("search"), "search");
  EXPECT_EQ(withoutNetworks("network"), "network");
  EXPECT_EQ(defaultMethod(true), "network+search");
  EXPECT_EQ(defaultMethod(false), "search");
}

TEST(MethodRegistry, RejectsLibrariesThatCannotBeLoadedOrHaveNoMethods) {
  EXPECT_NE(complaintOf([] { methodsWith({"/nowhere/lib.so"}); }).find("/nowhere/lib.so"),
            std::string::npos);
  const std::string complaint = complaintOf([] { methodsWith({"libc.so.6"}); });
  EXPECT_NE(complaint.find("addCollisionForgeMethods"), std::string::npos) << complaint;
}

}  // namespace
}  // namespace forge
