#include "collision_forge/export/pickle_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace forge {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace std::string_literals;

// Bytes by hand, after Python's module pickletools. Texts with an 's' may hold zeros.
const std::string kKey = "X\1\0\0\0k"s;

/// The items of a pickle of one key "k".
std::string valueIn(const PickleWriter& writer) {
  const std::string bytes = writer.pickle();
  const std::string begin = "\x80\3}("s + kKey;
  EXPECT_THAT(bytes, StartsWith(begin));
  EXPECT_EQ(bytes.substr(bytes.size() - 2), "u.");
  return bytes.substr(begin.size(), bytes.size() - begin.size() - 2);
}

template <class... Arguments>
std::string written(void (PickleWriter::*write)(const std::string&, Arguments...),
                    std::decay_t<Arguments>... arguments) {
  PickleWriter writer;
  (writer.*write)("k", arguments...);
  return valueIn(writer);
}

TEST(PickleWriter, AnEmptyDictIsAFile) { EXPECT_EQ(PickleWriter().pickle(), "\x80\3}(u."); }

TEST(PickleWriter, TextsHaveTheirLengthInBytes) {
  EXPECT_EQ(written(&PickleWriter::text, "caf\xc3\xa9"), "X\5\0\0\0caf\xc3\xa9"s);
  EXPECT_EQ(written(&PickleWriter::texts, {"a", ""}), "](X\1\0\0\0aX\0\0\0\0e"s);
  EXPECT_EQ(written(&PickleWriter::texts, {}), "](e");
}

TEST(PickleWriter, IntegersAreSignedSoThatLargeOnesNeedANinthByte) {
  EXPECT_EQ(written(&PickleWriter::count, 258), "J\2\1\0\0"s);
  EXPECT_EQ(written(&PickleWriter::count, 0x7fffffff), "J\xff\xff\xff\x7f"s);
  EXPECT_EQ(written(&PickleWriter::count, 0x80000000), "\x8a\11\0\0\0\x80\0\0\0\0\0"s);
  EXPECT_EQ(written(&PickleWriter::count, std::numeric_limits<std::uint64_t>::max()),
            "\x8a\11\xff\xff\xff\xff\xff\xff\xff\xff\0"s);
}

TEST(PickleWriter, NumbersAreBigEndian) {
  EXPECT_EQ(written(&PickleWriter::number, 1.0), "G\x3f\xf0\0\0\0\0\0\0"s);
  EXPECT_EQ(written(&PickleWriter::number, -0.1), "G\xbf\xb9\x99\x99\x99\x99\x99\x9a");
}

TEST(PickleWriter, FlagsAndNone) {
  EXPECT_EQ(written(&PickleWriter::flag, true), "\x88");
  EXPECT_EQ(written(&PickleWriter::flag, false), "\x89");
  EXPECT_EQ(written(&PickleWriter::none), "N");
}

TEST(PickleWriter, AnArrayIsMadeEmptyAndFilled) {
  EXPECT_EQ(written(&PickleWriter::numbers, {1.0, -2.0}, 0),
            "cnumpy.core.multiarray\n_reconstruct\ncnumpy\nndarray\nJ\0\0\0\0\x85"
            "B\1\0\0\0b\x87R"
            "(J\1\0\0\0J\2\0\0\0\x85"
            "cnumpy\ndtype\nX\2\0\0\0f8\x89\x88\x87R"
            "(J\3\0\0\0X\1\0\0\0<NNNJ\xff\xff\xff\xffJ\xff\xff\xff\xffJ\0\0\0\0tb"
            "\x89"
            "B\20\0\0\0\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\xc0tb"s);
}

TEST(PickleWriter, AMatrixHasRowsAndColumns) {
  const std::string bytes = written(&PickleWriter::numbers, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, 2);
  EXPECT_THAT(bytes, HasSubstr("(J\1\0\0\0J\3\0\0\0J\2\0\0\0\x86"s));
  EXPECT_THAT(written(&PickleWriter::numbers, {}, 2), HasSubstr("J\0\0\0\0J\2\0\0\0\x86"s));
}

TEST(PickleWriter, ListsHoldDictsAndMatrices) {
  PickleWriter first;
  first.none("a");
  EXPECT_EQ(written(&PickleWriter::values, {first.dict(), PickleWriter().dict()}),
            "](}(X\1\0\0\0aNu}(ue"s);
  EXPECT_EQ(written(&PickleWriter::values, {}), "](e");
  const std::string one = written(&PickleWriter::numbers, {1.0, 2.0}, 2);
  const std::string two = written(&PickleWriter::numbers, {3.0, 4.0, 5.0, 6.0}, 2);
  EXPECT_EQ(written(&PickleWriter::matrices, {{1.0, 2.0}, {3.0, 4.0, 5.0, 6.0}}, 2),
            "](" + one + two + "e");
}

TEST(PickleWriter, AnArrayOfFlagsHasAByteEach) {
  const std::string bytes = written(&PickleWriter::flags, {true, false, true});
  EXPECT_THAT(bytes, HasSubstr("X\2\0\0\0b1\x89\x88\x87R(J\3\0\0\0X\1\0\0\0|"s));
  EXPECT_THAT(bytes, HasSubstr("B\3\0\0\0\1\0\1tb"s));
}

TEST(PickleWriter, DictsNest) {
  PickleWriter writer;
  writer.beginDict("k");
  writer.beginDict("a");
  writer.endDict();
  writer.none("b");
  writer.endDict();
  EXPECT_EQ(valueIn(writer), "}(X\1\0\0\0a}(uX\1\0\0\0bNu"s);
}

TEST(PickleWriter, AValueHasTheSameBytesWhereverItStands) {
  PickleWriter inner;
  inner.numbers("x", {1.0});
  inner.text("y", "word");
  EXPECT_EQ(written(&PickleWriter::value, inner.dict()), inner.dict());
  PickleWriter nested;
  nested.beginDict("k");
  nested.numbers("x", {1.0});
  nested.text("y", "word");
  nested.endDict();
  EXPECT_EQ(valueIn(nested), inner.dict());
}

TEST(PickleWriter, RefusesNumbersThatAreNotFinite) {
  PickleWriter writer;
  EXPECT_THROW(writer.number("heading", std::nan("")), std::invalid_argument);
  EXPECT_THROW(writer.numbers("position", {0.0, HUGE_VAL}, 2), std::invalid_argument);
  EXPECT_THROW(writer.matrices("interiors", {{0.0, HUGE_VAL}}, 2), std::invalid_argument);
  try {
    writer.number("heading", -HUGE_VAL);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "field heading = -inf is not finite");
  }
}

}  // namespace
}  // namespace forge
