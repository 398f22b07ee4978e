#include "collision_forge/app/command_line.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>
#include <utility>

#include "collision_forge/app/options.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/io/batch/progress_line.h"

namespace forge {
namespace {

constexpr char kExitCodes[] =
    "Exit codes: 0 success, 1 error, 2 invalid command line, 3 no collision as requested, 4 "
    "a planner fails --fail-if.";

/// Lists the subcommands of a command one per line, unless the command has a description itself.
class ContentsFormatter : public CLI::Formatter {
 public:
  std::string make_subcommand(const CLI::App* command) const override {
    const std::vector<const CLI::App*> parts = partsOf(*command);
    const bool is_listed = !command->get_description().empty();
    if (is_listed) return CLI::Formatter::make_subcommand(command);
    std::stringstream text;
    for (const CLI::App* part : parts) {
      CLI::detail::format_help(text, command->get_name() + " " + part->get_name(),
                               part->get_description(), get_column_width());
    }
    return text.str();
  }
};

/// Returns true for a command that has moved to forge study.
bool isFormerStudyCommand(const std::string& word) {
  const std::vector<std::string> words = {"dataset", "evaluate", "measure", "speeds", "train"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns the version, the licences and the weights that the installed configuration uses.
std::string versionText() {
  std::string text = "collision_forge " COLLISION_FORGE_VERSION "\nlicence: BSD-3-Clause";
  const auto installed = installedConfig();
  if (!installed) return text;
  try {
    return text + "\n" + describeWeights(loadConfig(*installed));
  } catch (const ConfigError& error) {
    return text + "\n" + error.what();
  }
}

/// Returns the message for an option or argument that `command` does not know.
std::string unknownWordText(const std::string& word, const CLI::App& command) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> names;
  if (name.front() == '-') {
    for (const CLI::Option* option : optionsOf(command)) {
      for (const std::string& known : option->get_lnames()) names.push_back("--" + known);
    }
    return "unknown option " + name + nearestNameHint(name, names);
  }
  for (const CLI::App* part : partsOf(command)) names.push_back(part->get_name());
  return (names.empty() ? "unexpected argument " : "unknown command ") + word +
         nearestNameHint(word, names);
}

}  // namespace

int exitAfterUnreadable(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) printLine("not read: " + problem);
  return problems.empty() ? kExitOk : kExitError;
}

std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::App* part : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (!part->get_name().empty()) continue;
    for (const CLI::Option* option : part->get_options()) options.push_back(option);
  }
  return options;
}

std::vector<const CLI::App*> partsOf(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* part) { return !part->get_name().empty(); });
}

CommandLine::CommandLine()
    : app_(
          "Turns safe driving logs into collision scenarios.\n"
          "Run forge COMMAND --help for the options of a command.",
          "forge") {
  app_.formatter(std::make_shared<ContentsFormatter>());
  app_.set_version_flag("--version", versionText, "Print version and licences");
  app_.footer(kExitCodes);
  app_.failure_message([this](const CLI::App*, const CLI::Error& error) {
    return name() + ": " + errorText(error) + "\ntry: " + name() + " --help\n";
  });
}

std::string CommandLine::errorText(const CLI::Error& error) const {
  // A mistyped option also causes the error that a required option is missing; report the typo.
  const auto is = [&](CLI::ExitCodes code) {
    return error.get_exit_code() == static_cast<int>(code);
  };
  const bool may_be_mistyped = is(CLI::ExitCodes::ExtrasError) || is(CLI::ExitCodes::RequiredError);
  const std::vector<std::string> unknown = chosen()->remaining();
  if (!may_be_mistyped || unknown.empty()) return error.what();
  return unknownWordText(unknown.front(), *chosen());
}

CLI::App* CommandLine::child(CLI::App& parent, const std::string& name,
                             const std::string& heading) {
  const auto is_named = [&](const CLI::App* app) { return app->get_name() == name; };
  const std::vector<CLI::App*> found = parent.get_subcommands(is_named);
  if (!found.empty()) return found.front();
  parent.require_subcommand(0, 1);  // parse() reports a missing one, after unknown words
  CLI::App* added = parent.add_subcommand(name);
  if (!heading.empty()) added->group(heading);
  return added;
}

void CommandLine::addGroup(const std::string& heading, const std::string& name,
                           const std::string& text) {
  child(app_, name, heading)->description(text);
}

CLI::App& CommandLine::add(const std::string& heading, const std::string& name,
                           const std::string& text, Run run) {
  CLI::App* command = &app_;
  std::istringstream words(name);
  for (std::string word; words >> word;) command = child(*command, word, heading);
  command->description(text);
  runs_[command] = std::move(run);
  return *command;
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  if (argc > 1 && isFormerStudyCommand(argv[1])) {
    std::fprintf(stderr, "forge: %s is now forge study %s\n", argv[1], argv[1]);
    return kExitUsage;
  }
  try {
    app_.parse(argc, argv);
    if (runs_.count(chosen()) == 0) throw CLI::RequiredError("a command");
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app_.exit(error) == 0 ? kExitOk : kExitUsage;
  }
}

int CommandLine::run() const {
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit is reported like a full disk
  const PrintableOutput output;
  try {
    return runs_.at(chosen())();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name().c_str(), printable(error.what()).c_str());
    return kExitError;
  }
}

std::string CommandLine::name() const {
  std::string name = app_.get_name();
  for (const CLI::App* part = &app_; !part->get_subcommands().empty();) {
    part = part->get_subcommands().front();
    name += " " + part->get_name();
  }
  return name;
}

const CLI::App* CommandLine::chosen() const {
  const CLI::App* command = &app_;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return command;
}

}  // namespace forge
