#include "collision_forge/attack/search/request_phrase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "collision_forge/io/scenarios/request_file.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const RequestVocabulary& vocabulary() {
  static const RequestVocabulary read =
      readVocabulary(std::string(COLLISION_FORGE_SOURCE_DIR "/config"));
  return read;
}

PhraseReading readingOf(const std::string& text) { return readPhrase(text, vocabulary()); }

/// Returns the message of the refusal.
std::string refusalOf(const std::string& text) {
  try {
    readingOf(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no refusal";
}

/// Each line of the table: a phrase, its request as in a list, and the words that are unknown.
TEST(RequestPhrase, ReadsThePhrasesOfTheTable) {
  std::ifstream table(COLLISION_FORGE_SOURCE_DIR "/test/attack/search/phrases.tsv");
  std::size_t count = 0;
  for (std::string line; std::getline(table, line); ++count) {
    std::istringstream columns(line);
    std::string phrase;
    std::string request;
    std::string unknown;
    std::getline(columns, phrase, '\t');
    std::getline(columns, request, '\t');
    std::getline(columns, unknown, '\t');
    const PhraseReading reading = readingOf(phrase);
    SceneRequest read;
    read.request = reading.request;
    read.name = reading.name;
    EXPECT_EQ(requestLine(read), request) << phrase;
    std::string words;
    for (const std::string& word : reading.unknown) words += (words.empty() ? "" : " ") + word;
    EXPECT_EQ(words, unknown) << phrase;
  }
  EXPECT_GE(count, 200U);
}

TEST(RequestPhrase, ReadsTheTextsOfTheCatalogueOrNamesWhatIsUnknown) {
  std::size_t same_type = 0;
  std::size_t all = 0;
  for (const CatalogueEntry& entry : vocabulary().catalogue) {
    if (!entry.missing.empty()) continue;
    const PhraseReading reading = readingOf(entry.text);
    ++all;
    same_type += reading.request.type == entry.request.type;
    if (reading.request.attacker_class) {
      EXPECT_EQ(reading.request.attacker_class, entry.request.attacker_class) << entry.text;
    }
  }
  EXPECT_GE(same_type, all * 9 / 10);
}

TEST(RequestPhrase, EchoesEachWordWithItsMeaning) {
  const PhraseReading reading = readingOf("a purple truck cuts in from the left in 3 s");
  EXPECT_THAT(
      reading.understood,
      ElementsAre("\"cuts in\": manoeuvre = cut_in", "\"in 3 s\": tta = 3 s",
                  "\"from the left\": from_side = left", "\"truck\": attacker_class = truck",
                  "type = lane_change, manoeuvre = cut_in, tta = 3 s"));
  EXPECT_THAT(reading.unknown, ElementsAre("purple"));
  EXPECT_THAT(echoOf(reading), HasSubstr("not understood: purple\n"));
}

TEST(RequestPhrase, ANegatedPhraseIsNotAppliedAndIsNamed) {
  const PhraseReading reading = readingOf("car crosses, not from the left");
  EXPECT_FALSE(reading.request.from_side);
  EXPECT_THAT(reading.unknown, ElementsAre("not from the left"));
}

TEST(RequestPhrase, ContradictionsAreRefusedWithBothPhrases) {
  EXPECT_THAT(refusalOf("truck and bus cut in"), HasSubstr("contradicts"));
  EXPECT_THAT(refusalOf("rear end with the car from the left"),
              HasSubstr("from_side = left contradicts type = rear_end"));
  EXPECT_THAT(refusalOf("head-on in 3 s, tta 5 s"),
              HasSubstr("\"in 3 s\" (tta = 3 s) contradicts \"tta 5 s\" (tta = 5 s)"));
}

TEST(RequestPhrase, TextsWithoutAMeaningAreRefused) {
  EXPECT_THAT(refusalOf("purple haze"), HasSubstr("no word of the request is understood"));
  EXPECT_THAT(refusalOf(""), HasSubstr("no word of the request is understood"));
  EXPECT_THAT(refusalOf(std::string(kMostPhrase + 1, 'a')), HasSubstr("at most 500"));
}

TEST(RequestPhrase, AScenarioThatCannotBeRequestedIsRefusedWithTheReason) {
  EXPECT_THAT(refusalOf("CBDA in 3 s"), HasSubstr("euro_ncap_2026/CBDA cannot be requested: "));
}

TEST(RequestPhrase, KeepsTheFieldsThatThePhraseDoesNotGive) {
  CollisionRequest asked;
  asked.tta = 2.5;
  asked.seed = 9;
  asked.crash.believable = false;
  const PhraseReading reading = readPhrase("CCRb", vocabulary(), asked);
  EXPECT_EQ(reading.request.tta, 2.5);
  EXPECT_EQ(reading.request.seed, 9U);
  EXPECT_FALSE(reading.request.crash.believable);
  EXPECT_EQ(reading.request.manoeuvre, Manoeuvre::kLeadBrakes);
}

TEST(RequestPhrase, BracesOfTheTextAreNoQuantities) {
  EXPECT_THAT(readingOf("cut in {u99} at {v0}").unknown, ElementsAre("u99", "v0"));
}

TEST(RequestPhrase, NumbersThatAreNoneAreRefusedOrUnknown) {
  EXPECT_THAT(readingOf("cut in, 1e999 km/h").request.attacker_speed, testing::Eq(std::nullopt));
  EXPECT_THAT(refusalOf("cut in with 999999999999 alternatives"), HasSubstr("alternatives"));
  EXPECT_THAT(refusalOf("cut in, seed 99999999999999999999999"), HasSubstr("seed"));
  EXPECT_THAT(refusalOf("cut in, 1/0 overlap"), HasSubstr("\"1/0\" is not a finite number"));
}

}  // namespace
}  // namespace forge
