#include <gtest/gtest.h>
#include <torch/torch.h>

namespace forge {
namespace {

/// Several threads are slower than one on the small tensors of the tests, especially on a busy
/// machine.
class OneThread : public testing::Environment {
 public:
  void SetUp() override { torch::set_num_threads(1); }
};

const testing::Environment* const kOneThread = testing::AddGlobalTestEnvironment(new OneThread);

}  // namespace
}  // namespace forge
