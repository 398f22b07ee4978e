#include <iostream>
#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/search/request_phrase.h"
#include "collision_forge/io/scenarios/request_file.h"

namespace forge {
namespace {

struct Arguments {
  std::string text;
  SceneRequest asked;
  ConfigFolder config;
};

/// Prints the request as a line of a list; what was understood and what was not goes to stderr.
int ask(const Arguments& arguments) {
  SceneRequest asked = arguments.asked;
  const PhraseReading reading =
      readPhrase(arguments.text, readVocabulary(arguments.config), asked.request);
  asked.request = reading.request;
  asked.name = reading.name;
  std::cerr << echoOf(reading);
  std::cout << requestLine(asked) << "\n";
  return kExitOk;
}

}  // namespace

void addAsk(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kMakingCollisions, "ask", "Turns a request in words into a line of a list.",
               [arguments] { return ask(*arguments); });
  app.add_option("text", arguments->text,
                 "the request in English, e.g. \"truck cuts in from the left in 3 s\"")
      ->required();
  CLI::Option* scene =
      app.add_option("--scene", arguments->asked.scene, "name of the scene, a field of the line");
  scene->needs(app.add_option("--now", arguments->asked.now,
                              "time of the request t0, s on the clock of the scene")
                   ->needs(scene));
  addSeed(app, arguments->asked.request.seed, "random seed of the request");
  addConfig(app, arguments->config);
}

}  // namespace forge
