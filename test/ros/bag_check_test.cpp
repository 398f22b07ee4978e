#include "collision_forge/ros/bags/bag_check.h"

#include <collision_forge/AgentArray.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "collision_forge/ros/bags/bag_file.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class BagCheck : public testing::TestWithParam<rosbag::compression::CompressionType> {
 protected:
  void SetUp() override {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    path_ = testing::TempDir() + "bag_check_" + name + ".bag";
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.setCompression(GetParam());
    bag.setChunkThreshold(1000);  // bytes: several chunks
    for (std::uint32_t second = 1; second <= 20; ++second) {
      collision_forge::AgentArray agents;
      agents.header.stamp = ros::Time(second, 0);
      agents.agents.resize(3);
      bag.write("/agents", ros::Time(second, 0), agents);
      bag.write("/others", ros::Time(second, 0), agents);
    }
    bag.close();
    std::ifstream file(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }
  void TearDown() override { std::filesystem::remove(path_); }

  void write(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
  }

  /// The bag with another length in the four bytes at `at`.
  std::string withLength(std::uint32_t length, std::size_t at) const {
    std::string bytes = bytes_;
    std::memcpy(bytes.data() + at, &length, sizeof(length));
    return bytes;
  }

  std::string complaint() const {
    try {
      checkBag(path_);
    } catch (const BagError& error) {
      return error.what();
    }
    return "";
  }

  /// As readers do.
  std::size_t countMessages() const {
    const rosbag::Bag bag(path_, rosbag::bagmode::Read);
    std::size_t count = 0;
    for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
      count += instance.instantiate<collision_forge::AgentArray>() ? 1 : 0;
    }
    return count;
  }

  std::string path_;
  std::string bytes_;
};

INSTANTIATE_TEST_SUITE_P(Compressions, BagCheck,
                         testing::Values(rosbag::compression::Uncompressed,
                                         rosbag::compression::BZ2, rosbag::compression::LZ4));

TEST_P(BagCheck, ValidBagsPass) {
  EXPECT_EQ(complaint(), "");
  EXPECT_EQ(countMessages(), 40u);
}

TEST_P(BagCheck, AFileThatIsNoBagIsCalledSo) {
  write("");
  EXPECT_EQ(complaint(), path_ + ": is not a ROS bag, but empty");
  for (const char* bytes : {"x", "no bag at all, but some bytes"}) {
    write(bytes);
    EXPECT_EQ(complaint(), path_ + ": is not a ROS bag") << bytes;
  }
}

TEST_P(BagCheck, BagsOfOtherVersionsAndNamesAreRejected) {
  for (const char* line : {"#ROSBAG V1.2\n", "#ROSG V2.0\n", "#ROSRECORD V2.0\n"}) {
    write(line + withLength(0x7fffffff, std::strlen("#ROSBAG V2.0\n")));
    EXPECT_EQ(complaint(), path_ + ": is not a bag of version 2.0") << line;
  }
}

TEST_P(BagCheck, OffsetsToMissingRecordsAreRejected) {
  std::string bytes = bytes_;
  bytes[bytes.find("index_pos=") + std::strlen("index_pos=")] ^= 1;
  write(bytes);
  EXPECT_THAT(complaint(), HasSubstr("where the index should begin"));
  bytes = bytes_;
  bytes[bytes.find("chunk_pos=") + std::strlen("chunk_pos=")] ^= 1;
  write(bytes);
  EXPECT_THAT(complaint(), HasSubstr("refers to a chunk that does not exist"));
}

TEST_P(BagCheck, WrongArrayLengthsInAMessageAreRejected) {
  rosbag::Bag bag(path_, rosbag::bagmode::Write);
  bag.setCompression(GetParam());
  collision_forge::AgentArray agents;
  agents.agents.resize(3);
  bag.write("/agents", ros::Time(1, 0), agents);
  topic_tools::ShapeShifter other;  // with the bytes of one, but for the number of agents
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(agents));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, agents);
  const std::uint32_t many = 100000000;
  std::memcpy(bytes.data() + ros::serialization::serializationLength(agents.header), &many,
              sizeof(many));
  namespace traits = ros::message_traits;
  using Agents = collision_forge::AgentArray;
  other.morph(traits::md5sum<Agents>(), traits::datatype<Agents>(), traits::definition<Agents>(),
              "");
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  other.read(in);
  bag.write("/agents", ros::Time(2, 0), other);
  bag.close();
  EXPECT_THAT(complaint(), HasSubstr("collision_forge/AgentArray: the bytes of a message end"));
}

TEST_P(BagCheck, BagsThatPassAreReadWithoutCrash) {
  const unsigned seed = 20261125;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  int passed = 0;
  for (std::size_t mutant = 0; mutant < 200; ++mutant) {
    std::string bytes = bytes_;
    const std::size_t at = random() % bytes.size();
    const auto length = static_cast<std::uint32_t>(random());
    for (std::size_t i = 0; i < 1 + mutant % 4 && at + i < bytes.size(); ++i) {
      bytes[at + i] = static_cast<char>(length >> (8 * i));
    }
    write(bytes);
    if (!complaint().empty()) continue;
    ++passed;
    try {
      countMessages();
    } catch (const std::exception&) {
      continue;  // told, and nothing worse
    }
  }
  EXPECT_GT(passed, 0);
}

}  // namespace
}  // namespace forge
