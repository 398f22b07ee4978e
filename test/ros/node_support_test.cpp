#include "collision_forge/ros/nodes/node_support.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

struct Response {
  std::uint8_t code = 0;
  std::string message;
};

/// The answer of work that throws.
template <typename Error>
Response answerAfter(const Error& error) {
  Response response;
  answerWith(response, [&]() -> Status { throw error; });
  return response;
}

TEST(AnswerWith, HasTheStatusOfTheWork) {
  Response response;
  answerWith(response, [] { return Status{StatusCode::kNoCandidate, "nobody"}; });
  EXPECT_EQ(response.code, static_cast<int>(StatusCode::kNoCandidate));
  EXPECT_EQ(response.message, "nobody");
}

TEST(AnswerWith, BadInputGivesInvalidInput) {
  for (const Response& response :
       {answerAfter(InputError("size = 0")), answerAfter(MessageError("size = 0"))}) {
    EXPECT_EQ(response.code, static_cast<int>(StatusCode::kInvalidInput));
    EXPECT_EQ(response.message, "size = 0");
  }
}

TEST(AnswerWith, AnyOtherExceptionGivesInternalError) {
  for (const Response& response :
       {answerAfter(std::runtime_error("why")), answerAfter(std::invalid_argument("why")),
        answerAfter(std::out_of_range("why"))}) {
    EXPECT_EQ(response.code, static_cast<int>(StatusCode::kInternalError));
    EXPECT_EQ(response.message, "why");
  }
}

}  // namespace
}  // namespace forge
