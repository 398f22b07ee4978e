#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace forge {

/// Exit codes of every command. kExitNoAttack: no crash as it was asked for; forge inject writes
/// the bag all the same where there is an attack that does not crash into the recorded ego as
/// asked.
enum ExitCode { kExitOk = 0, kExitError = 1, kExitUsage = 2, kExitNoAttack = 3 };

/// The command line of forge: its commands, and the one that a line asks for.
class CommandLine {
 public:
  /// Does a command's work and returns an exit code, or throws.
  using Run = std::function<int()>;

  CommandLine();

  /// A command with its line in the table of contents, under `heading`. `name` is one or more
  /// words, as "completion bash"; the last one is the command's own. The options that are added to
  /// what is returned are read before `run` is called.
  CLI::App& add(const std::string& heading, const std::string& name, const std::string& text,
                Run run);

  /// A command that only holds others, which add() adds as "NAME ...".
  void addGroup(const std::string& heading, const std::string& name, const std::string& text);

  /// Reads a line. Empty when a command is to be run, which run() then does; else what is asked for
  /// has been printed, or what is wrong, and this is the exit code.
  std::optional<int> parse(int argc, const char* const* argv);
  /// Runs the command that was read. An exception becomes a message and kExitError.
  int run() const;

  /// The name of the command that was read, as "forge study measure coverage".
  std::string name() const;
  const CLI::App& app() const { return app_; }

 private:
  /// The command `name` of `parent`, which is added under `heading` where it is not there.
  static CLI::App* child(CLI::App& parent, const std::string& name, const std::string& heading);
  /// The innermost command that was read.
  const CLI::App* chosen() const;
  /// What is wrong with a line that was refused.
  std::string complaintOf(const CLI::Error& error) const;

  CLI::App app_;
  std::map<const CLI::App*, Run> runs_;
};

/// The commands of the product.
void addCommands(CommandLine& line);

/// The commands of a command: "coverage" of "measure". CLI11 has groups of options among them.
std::vector<const CLI::App*> partsOf(const CLI::App& command);

/// The options of a command, those of its groups included.
std::vector<const CLI::Option*> optionsOf(const CLI::App& command);

/// A script for bash that completes the words of the command line.
std::string bashCompletion(const CLI::App& app);

// Each adds a command.
void addConvert(CommandLine& line);
void addInject(CommandLine& line);
void addPossible(CommandLine& line);
void addRequests(CommandLine& line);
void addGenerate(CommandLine& line);
void addExport(CommandLine& line);
void addReport(CommandLine& line);
void addTest(CommandLine& line);
void addTune(CommandLine& line);
void addCompletion(CommandLine& line);

/// The commands of the study, `forge study ...`; in a build without the study, a command `study`
/// that says so.
void addStudyCommands(CommandLine& line);

// The headings of the table of contents.
inline const std::string kMakingCollisions = "Make collisions";
inline const std::string kPlanners = "Test planners";
inline const std::string kOther = "Other";

}  // namespace forge
