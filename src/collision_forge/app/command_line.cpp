#include "collision_forge/app/command_line.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <utility>

#include "collision_forge/batch/printable.h"

namespace forge {
namespace {

/// Help in which a command of two words has a line of its own.
class ContentsFormatter : public CLI::Formatter {
 public:
  std::string make_subcommand(const CLI::App* command) const override {
    const std::vector<const CLI::App*> parts = partsOf(*command);
    if (parts.empty()) return CLI::Formatter::make_subcommand(command);
    std::stringstream text;
    for (const CLI::App* part : parts) {
      CLI::detail::format_help(text, command->get_name() + " " + part->get_name(),
                               part->get_description(), get_column_width());
    }
    return text.str();
  }
};

}  // namespace

std::vector<const CLI::App*> partsOf(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* part) { return !part->get_name().empty(); });
}

CommandLine::CommandLine()
    : app_(
          "Turns safe driving logs into collision scenarios.\n"
          "forge COMMAND --help tells the options of a command.",
          "forge") {
  app_.formatter(std::make_shared<ContentsFormatter>());
  app_.require_subcommand(0, 1);  // parse() asks for one, after words that are none
  app_.failure_message([this](const CLI::App*, const CLI::Error& error) {
    return name() + ": " + error.what() + "\ntry: " + name() + " --help\n";
  });
}

CLI::App& CommandLine::add(const std::string& heading, const std::string& name,
                           const std::string& text, Run run) {
  CLI::App* parent = &app_;
  const std::size_t space = name.find(' ');
  if (space != std::string::npos) {
    const std::string first = name.substr(0, space);
    const auto found =
        app_.get_subcommands([&](CLI::App* app) { return app->get_name() == first; });
    parent = found.empty() ? app_.add_subcommand(first)->group(heading) : found.front();
    parent->require_subcommand(0, 1);
  }
  CLI::App* command = parent->add_subcommand(name.substr(space + 1), text);
  if (parent == &app_) command->group(heading);
  runs_[command] = std::move(run);
  return *command;
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  try {
    app_.parse(argc, argv);
    if (runs_.count(chosen()) == 0) throw CLI::RequiredError("a command");
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app_.exit(error) == 0 ? kExitOk : kExitUsage;
  }
}

int CommandLine::run() const {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is told like a full disk
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
