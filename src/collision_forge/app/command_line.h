#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace forge {

/// Exit codes of every command. kExitOk: success; kExitError: a failure without a code of its own,
/// as an exception; kExitUsage: invalid command line; kExitNoAttack: no collision as requested
/// (forge inject still writes the bag if an attack exists that misses the recorded ego or hits it
/// differently); kExitFailed: a planner fails a criterion of the user (--fail-if).
enum ExitCode { kExitOk = 0, kExitError = 1, kExitUsage = 2, kExitNoAttack = 3, kExitFailed = 4 };

/// Prints "not read: PROBLEM" on stderr for each scene that could not be read. `problems`:
/// "SCENE: REASON" each, as SceneSource::forEach() returns. Returns kExitOk if there is none, else
/// kExitError.
int exitAfterUnreadable(const std::vector<std::string>& problems);

/// The command line of forge: holds the commands, parses the arguments, runs the selected command.
class CommandLine {
 public:
  /// Runs a command and returns an ExitCode. An exception becomes a message and kExitError.
  using Run = std::function<int()>;

  /// Creates the program "forge" without commands, with --help and --version.
  CommandLine();

  /// Adds a command, or replaces `text` and `run` of the command with this name, and returns its
  /// CLI11 app, to which the caller adds options; these are parsed before `run` is called. `name`:
  /// one or more words, as "completion bash"; missing parent commands are created. `heading` and
  /// `text` are its section and its line in forge --help. The returned reference is valid as long
  /// as this object.
  CLI::App& add(const std::string& heading, const std::string& name, const std::string& text,
                Run run);

  /// Adds a command that does nothing itself; add() adds its subcommands as "NAME ...". `heading`
  /// and `text` as in add().
  void addGroup(const std::string& heading, const std::string& name, const std::string& text);

  /// Parses the arguments of main(), the program's name first. Returns nullopt if a command was
  /// selected and run() is to be called. Otherwise prints the help, the version or the error and
  /// returns the exit code: kExitOk for help and version, kExitUsage for an error.
  std::optional<int> parse(int argc, const char* const* argv);
  /// Runs the selected command and returns its ExitCode. If it throws, prints the exception on
  /// stderr and returns kExitError. parse() must have returned nullopt.
  int run() const;

  /// Returns the full name of the command that the last parse() selected, as "forge study measure
  /// latency"; "forge" if none is selected.
  std::string name() const;
  /// Returns the CLI11 app of the program, whose subcommands are the commands.
  const CLI::App& app() const { return app_; }

 private:
  /// Returns the subcommand `name` of `parent`; adds it under `heading` if it does not exist.
  static CLI::App* child(CLI::App& parent, const std::string& name, const std::string& heading);
  /// Returns the innermost selected command; `app_` if none is selected.
  const CLI::App* chosen() const;
  /// Returns the message for arguments that were rejected with `error`.
  std::string errorText(const CLI::Error& error) const;

  CLI::App app_;
  std::map<const CLI::App*, Run> runs_;  // by the command's app, a descendant of `app_`
};

/// Adds all commands except the study commands: calls each add...() from addConvert() to
/// addCompletion() below.
void addCommands(CommandLine& line);

/// Returns the direct subcommands of `command`, as "coverage" of "measure", without option groups,
/// which CLI11 also stores as subcommands, in the order in which they were added.
std::vector<const CLI::App*> partsOf(const CLI::App& command);

/// Returns all options of `command` (--help too): its own in the order in which they were added,
/// then the options of its option groups; without the options of its subcommands.
std::vector<const CLI::Option*> optionsOf(const CLI::App& command);

/// Returns a bash script that completes commands, options and their enumerated values for the
/// program `app` with all its subcommands.
std::string bashCompletion(const CLI::App& app);

// Each function adds the command `forge NAME` with its options ("add" NAME: addConvert() adds
// forge convert); app/NAME.cpp implements it.
void addConvert(CommandLine& line);
void addInject(CommandLine& line);
void addPossible(CommandLine& line);
void addRequests(CommandLine& line);
void addAsk(CommandLine& line);
void addGenerate(CommandLine& line);
void addExport(CommandLine& line);
void addReport(CommandLine& line);
void addTest(CommandLine& line);
void addSweep(CommandLine& line);
void addTune(CommandLine& line);
void addCompletion(CommandLine& line);

/// Adds the commands `forge study ...`. A build without the study adds a command `study` that
/// throws std::runtime_error, whose message says how to configure the build.
void addStudyCommands(CommandLine& line);

// The section headings of forge --help, for CommandLine::add().
inline const std::string kMakingCollisions = "Make collisions";
inline const std::string kPlanners = "Test planners";
inline const std::string kOther = "Other";

}  // namespace forge
