#include "collision_forge/planner_test/report/shell_commands.h"

#include <charconv>
#include <filesystem>

#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/scenarios/request_file.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Quotes one word of a shell's command line.
std::string shellWord(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./:,=@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char character : text) {
    quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
  }
  return quoted + "'";
}

/// Returns the shortest text that parses to the same number.
std::string exactText(double value) {
  char text[32];
  const auto end = std::to_chars(std::begin(text), std::end(text), value);
  return {std::begin(text), end.ptr};
}

/// " --name value"
std::string option(const std::string& name, const std::string& value) {
  return " --" + name + " " + shellWord(value);
}

std::string optionOf(const std::string& name, const Range& range) {
  return " --" + name + " " + exactText(range.min) + " " + exactText(range.max);
}

std::string sourceOptions(const LogSource& logs) {
  const std::string source = option("source", logs.path.empty() ? "SOURCE" : logs.path);
  return logs.version.empty() ? source : source + option("version", logs.version);
}

/// Returns the options of forge inject that a request sets.
std::string controlOptions(const CollisionRequest& request, const CrashDefinition& defaults) {
  std::string options;
  if (request.attacker) {
    options += option("attacker", *request.attacker);
  } else if (request.choice != AttackerChoice::kAny) {
    options += option("attacker", toString(request.choice));
  }
  const CrashDefinition& crash = request.crash;
  if (crash.believable != defaults.believable) {
    options += option("believable", crash.believable ? "true" : "false");
  }
  if (crash.limits != defaults.limits) options += option("limits", toString(crash.limits));
  if (request.attacker_class)
    options += option("attacker-class", toString(*request.attacker_class));
  if (request.manoeuvre) options += option("manoeuvre", toString(*request.manoeuvre));
  if (request.ego_side) options += option("ego-side", toString(*request.ego_side));
  if (request.impact_speed) options += optionOf("impact-speed", *request.impact_speed);
  if (request.overlap) options += optionOf("overlap", *request.overlap);
  if (request.turning != Turning::kAttacker)
    options += option("turning", toString(request.turning));
  if (request.from_side) options += option("from-side", toString(*request.from_side));
  if (request.hidden_by) options += option("hidden-by", toString(*request.hidden_by));
  if (request.queue) options += option("queue", "true");
  for (const RangeControl& control : kRangeControls) {
    const std::optional<Range>& range = request.*control.asked;
    if (range) options += optionOf(optionName(control.name), *range);
  }
  return options;
}

/// Returns the bag of a scene in a source of bags; empty for other sources.
std::string bagIn(const LogSource& logs, const std::string& scene) {
  const fs::path path(logs.path);
  if (path.extension() == ".bag") return logs.path;
  const fs::path bag = path / (scene + ".bag");
  return fs::exists(bag) ? bag.string() : "";
}

std::string injectLines(const Scenario& scenario, int alternative, double now,
                        const LogSource& logs, const CrashDefinition& defaults) {
  const std::string& scene = scenario.asked.scene;
  const CollisionRequest& request = scenario.asked.request;
  std::string bag = bagIn(logs, scene);
  std::string lines;
  if (bag.empty()) {
    bag = "bags/" + scene + ".bag";
    lines = "forge convert" + sourceOptions(logs) + option("scene", scene) + " --out bags\n";
  }
  lines += "forge inject" + option("bag", bag) + option("type", toString(request.type)) +
           option("now", exactText(now)) + option("tta", exactText(request.tta)) +
           option("mode", toString(request.mode)) + option("seed", std::to_string(request.seed)) +
           controlOptions(request, defaults);
  if (alternative > 1) lines += option("alternative", std::to_string(alternative));
  return lines + " --out attacked.bag --draw attacked";
}

std::string generateLines(const Scenario& scenario, const LogSource& logs,
                          const CrashDefinition& defaults) {
  return "echo " + shellWord(requestLine(scenario.asked, defaults)) + " > request.jsonl\n" +
         "forge generate" + sourceOptions(logs) + " --requests request.jsonl" +
         option("mode", toString(scenario.asked.request.mode)) + " --out answer.jsonl";
}

}  // namespace

std::vector<ShellCommands> commandsOfAttack(const Scenario& scenario, int alternative,
                                            std::optional<double> now_in_recording,
                                            const LogSource& logs,
                                            const CrashDefinition& defaults) {
  std::vector<ShellCommands> commands;
  if (now_in_recording) {
    commands.push_back({"Bag, picture and animation",
                        injectLines(scenario, alternative, *now_in_recording, logs, defaults)});
  }
  commands.push_back({"Line of a scenario file", generateLines(scenario, logs, defaults)});
  return commands;
}

ShellCommands commandsOfTest(const std::string& path, std::size_t line, const RowKey& row,
                             const LogSource& logs) {
  std::string lines = "sed -n " + std::to_string(line) + "p " + shellWord(path) +
                      " > one.jsonl\nforge test" + sourceOptions(logs) + " --scenarios one.jsonl" +
                      option("planners", row.planner) +
                      option("attacker-policy", toString(row.policy));
  if (row.background == Background::kIdm) lines += " --background idm";
  if (row.background == Background::kModel) lines += " --background model:FILE.pt";
  return {"Test, picture and animation", lines + " --out one --report one/page"};
}

std::string commandsRecord(const std::vector<ShellCommands>& commands) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.beginArray("commands");
  for (const ShellCommands& some : commands) {
    writer.beginObject();
    writer.text("title", some.title);
    writer.text("lines", some.lines);
    writer.endObject();
  }
  writer.endArray();
  writer.endObject();
  return writer.line();
}

}  // namespace forge
