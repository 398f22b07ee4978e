#include <gtest/gtest.h>
#include <torch/torch.h>

namespace forge {
namespace {

/// More threads than one cost more than they bring on tensors as small as those of the tests, above
/// all on a machine that does something else, too.
class OneThread : public testing::Environment {
 public:
  void SetUp() override { torch::set_num_threads(1); }
};

const testing::Environment* const kOneThread = testing::AddGlobalTestEnvironment(new OneThread);

}  // namespace
}  // namespace forge
