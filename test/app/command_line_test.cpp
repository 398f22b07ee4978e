#include "collision_forge/app/command_line.h"

#include <gmock/gmock.h>

#include <regex>
#include <stdexcept>

#include "collision_forge/app/options.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kDataroot = std::string(COLLISION_FORGE_SOURCE_DIR) + "/data/embedded";
const std::string kConfig = std::string(COLLISION_FORGE_SOURCE_DIR) + "/config";
const std::string kFile = std::string(COLLISION_FORGE_SOURCE_DIR) + "/package.xml";
const std::string kLogs =
    " --dataroot " + kDataroot + " --version v1.0-embedded --config " + kConfig;

/// The result of parsing a command line: the exit code if no command is run, and the output.
struct Reading {
  std::optional<int> exit_code;
  std::string name;
  std::string out;
  std::string err;
};

/// A command line with all commands; read() parses a line.
class Forge {
 public:
  Forge() {
    addCommands(line_);
    addStudyCommands(line_);
  }

  Reading read(const std::string& words) {
    std::istringstream stream(words);
    std::vector<std::string> split = {"forge"};
    for (std::string word; stream >> word;) split.push_back(word);
    std::vector<const char*> arguments;
    for (const std::string& word : split) arguments.push_back(word.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Reading reading;
    reading.exit_code = line_.parse(static_cast<int>(arguments.size()), arguments.data());
    reading.name = line_.name();
    reading.out = testing::internal::GetCapturedStdout();
    reading.err = testing::internal::GetCapturedStderr();
    return reading;
  }

  const CLI::App& app() const { return line_.app(); }

 private:
  CommandLine line_;
};

Reading read(const std::string& words) { return Forge().read(words); }

/// Valid options for each command.
const std::map<std::string, std::string> kComplete = {
    {"convert", kLogs + " --out bags"},
    {"possible", " --bag a.bag --now 4 --config " + kConfig},
    {"inject", " --bag a.bag --type ltap --tta 4 --now 4 --out b.bag --config " + kConfig},
    {"requests", kLogs + " --out requests.jsonl"},
    {"ask", " cut-in"},
    {"generate", kLogs + " --requests requests.jsonl --out scenarios.jsonl"},
    {"export", kLogs + " --to openscenario --scenarios " + kFile + " --out out"},
    {"study evaluate", kLogs + " --requests " + kFile + " --out out"},
    {"report", " " + kFile + " --out page --config " + kConfig},
    {"test", kLogs + " --scenarios scenarios.jsonl --out out"},
    {"sweep",
     " --bag a.bag --now 4 --type ltap --tta 4 --vary overlap=0.2,0.6 --out out --config " +
         kConfig},
    {"tune", kLogs + " --train a.jsonl --test b.jsonl --out out"},
    {"study dataset", kLogs + " --out out"},
    {"study train", kLogs + " --out out"},
    {"study speeds fit", kLogs + " --out model.jsonl"},
    {"study measure latency", ""},
    {"study measure lidar", " --bag " + kFile},
    {"study measure patterns",
     " --collide " + kDataroot + " --dataroot " + kDataroot + " --config " + kConfig},
    {"study test",
     " --collide " + kDataroot + " --dataroot " + kDataroot + " --out out --config " + kConfig},
    {"study tune",
     " --collide " + kDataroot + " --dataroot " + kDataroot + " --out out --config " + kConfig},
    {"completion bash", ""},
};

/// Returns the commands that a help text lists below its headings.
std::vector<std::string> listedIn(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find("\n\n", help.find("--help,")) + 1));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("  ", 0) != 0 || line[2] == ' ') continue;
    if (line[2] != '-') names.push_back(line.substr(2, line.find("  ", 2) - 2));
  }
  return names;
}

TEST(CommandLine, HelpListsEveryCommandAndNoOther) {
  std::vector<std::string> product = listedIn(read("--help").out);
  std::vector<std::string> listed;
  for (const std::string& name : product) {
    if (name != "study") listed.push_back(name);
  }
  EXPECT_LT(listed.size(), product.size());
  for (const std::string& name : listedIn(read("study --help").out))
    listed.push_back("study " + name);
  std::vector<std::string> all;
  for (const auto& [name, options] : kComplete) all.push_back(name);
  EXPECT_THAT(listed, testing::UnorderedElementsAreArray(all));
}

TEST(CommandLine, FormerStudyCommandsNameTheirReplacement) {
  const Reading reading = read("measure latency" + kComplete.at("study measure latency"));
  EXPECT_EQ(reading.exit_code, kExitUsage);
  EXPECT_THAT(reading.err, HasSubstr("forge: measure is now forge study measure\n"));
}

TEST(CommandLine, EveryCommandHasHelpOfItsOwn) {
  for (const auto& [name, options] : kComplete) {
    const Reading help = read(name + " --help");
    EXPECT_EQ(help.exit_code, kExitOk) << name;
    EXPECT_THAT(help.out, HasSubstr("Usage: forge " + name)) << name;
  }
}

TEST(CommandLine, MissingRequiredOptionsAreReported) {
  for (const auto& [name, options] : kComplete) {
    const std::size_t out = options.find(" --out ");
    if (out == std::string::npos) continue;
    const std::size_t after = std::min(options.find(' ', out + 7), options.size());
    const Reading reading = read(name + options.substr(0, out) + options.substr(after));
    EXPECT_EQ(reading.exit_code, kExitUsage) << name;
    EXPECT_THAT(reading.err, HasSubstr("forge " + name + ": --out is required")) << name;
  }
}

TEST(CommandLine, InvalidValuesAreReportedWithTheirOption) {
  for (const auto& [line, named] : std::map<std::string, std::string>{
           {"generate" + kComplete.at("generate") + " --mode live", "--mode"},
           {"generate" + kComplete.at("generate") + " --jobs 0", "--jobs"},
           {"generate" + kComplete.at("generate") + " --jobs 257", "--jobs"},
           {"generate" + kComplete.at("generate") + " --format csv", "csv-collide"},
           {"requests" + kComplete.at("requests") + " --attackers all", "--attackers"},
           {"requests" + kComplete.at("requests") + " --tta nan", "--tta"},
           {"requests" + kComplete.at("requests") + " --types drift", "--types"},
           {"test" + kComplete.at("test") + " --background still", "--background"},
           {"test" + kComplete.at("test") + " --background idm,model:", "--background"},
           {"test" + kComplete.at("test") + " --background idm,idm", "given twice"},
           {"tune" + kComplete.at("tune") + " --background idm,replay", "--background"},
           {"test" + kComplete.at("test") + " --planners idm,none", "--planners"},
           {"sweep" + kComplete.at("sweep") + " --vary speed=1:2:1", "--vary: speed=1:2:1"},
           {"sweep" + kComplete.at("sweep") + " --vary tta=3:6:1", "--tta"},
           {"sweep" + kComplete.at("sweep") + " --vary overlap=0.1,0.2", "varied twice"},
           {"sweep" + kComplete.at("sweep") + " --map overlap,class", "--map"},
           {"sweep --bag a.bag --now 4 --type ltap --vary overlap=0.2 --out o --config " + kConfig,
            "--tta"},
           {"study evaluate" + kComplete.at("study evaluate") + " --seeds 0", "--seeds"},
           {"study train" + kComplete.at("study train") + " --fold 6", "--fold"},
           {"study train" + kComplete.at("study train") + " --collide " + kConfig +
                " --generator none",
            "--generator"},
           {"study train" + kComplete.at("study train") + " --generator c_sgan", "--collide"},
           {"convert --dataroot /nowhere --version v --out bags", "/nowhere"},
           {"inject" + kComplete.at("inject") + " --nonsense", "--nonsense"}}) {
    const Reading reading = read(line);
    EXPECT_EQ(reading.exit_code, kExitUsage) << line;
    EXPECT_THAT(reading.err, HasSubstr(named)) << line;
  }
}

TEST(CommandLine, ClipOptionsAndLogOptionsAreMutuallyExclusive) {
  const std::string clips = "study evaluate --dataroot " + kDataroot + " --config " + kConfig +
                            " --out out --collide " + kDataroot;
  EXPECT_EQ(read(clips).exit_code, std::nullopt);
  EXPECT_EQ(read(clips + " --requests " + kFile + " --version v").exit_code, kExitUsage);
  EXPECT_EQ(read(clips + " --scene scene-0001").exit_code, kExitUsage);
  EXPECT_EQ(read("study evaluate" + kComplete.at("study evaluate") + " --by-scene").exit_code,
            kExitUsage);
  EXPECT_EQ(read("study evaluate" + kComplete.at("study evaluate") + " --split val").exit_code,
            kExitUsage);
  EXPECT_EQ(read("test" + kLogs + " --out out").exit_code, kExitUsage);
}

TEST(CommandLine, AnUnknownMethodIsRejectedAndTheKnownOnesAreListed) {
  for (const std::string command : {"generate", "inject", "possible", "study evaluate"}) {
    const std::string line = command + kComplete.at(command) + " --method ";
    EXPECT_EQ(read(line + "nominal").exit_code, std::nullopt) << command;
    const Reading reading = read(line + "magic");
    EXPECT_EQ(reading.exit_code, kExitUsage) << command;
    EXPECT_THAT(reading.err, HasSubstr("--method: method \"magic\" is none of search,")) << command;
  }
  const std::string draw = "test" + kLogs + " --out out --until-hit --method ";
  EXPECT_EQ(read(draw + "search").exit_code, std::nullopt);
  EXPECT_EQ(read(draw + "magic").exit_code, kExitUsage);
  const std::string line = "study evaluate --collide " + kDataroot + " --dataroot " + kDataroot +
                           " --out out --config " + kConfig + " --method ";
  EXPECT_EQ(read(line + "nominal").exit_code, std::nullopt);
  const Reading clips = read(line + "magic");
  EXPECT_EQ(clips.exit_code, kExitUsage);
  EXPECT_THAT(clips.err, HasSubstr("--method: method \"magic\" is none of recorded,"));
}

/// Returns the help of a command with defaults as CLI11 before 2.4 shows them: "=replay", not
/// " [replay]".
std::string helpOf(const std::string& command) {
  static const std::regex newer_default(R"((\S) \[([^\[\]\s]+)\](?=\s))");
  return std::regex_replace(read(command + " --help").out, newer_default, "$1=$2");
}

TEST(CommandLine, HelpShowsDefaults) {
  EXPECT_THAT(helpOf("generate"), AllOf(HasSubstr("{history,replay,adaptive}=replay"),
                                        HasSubstr("{jsonl,csv-collide}=jsonl")));
  EXPECT_THAT(helpOf("test"), HasSubstr("{replay,idm,model:FILE.pt}=replay"));
  EXPECT_THAT(helpOf("study test"),
              AllOf(HasSubstr("{recorded,history,replay}=recorded"), HasSubstr("=val")));
  EXPECT_THAT(helpOf("requests"), HasSubstr("{any,existing,new,each}=any"));
}

TEST(CommandLine, DefaultModeIsReplayForMakingAndHistoryForMeasuring) {
  for (const std::string command : {"inject", "possible", "generate"}) {
    EXPECT_THAT(helpOf(command), HasSubstr("}=replay")) << command;
  }
  for (const std::string command : {"study evaluate", "study measure latency"}) {
    EXPECT_THAT(helpOf(command), HasSubstr("}=history")) << command;
  }
}

TEST(CommandLine, VersionShowsTheLicences) {
  const Reading version = read("--version");
  EXPECT_EQ(version.exit_code, kExitOk);
  EXPECT_THAT(version.out,
              testing::MatchesRegex("collision_forge [0-9]+\\.[0-9]+\\.[0-9]+\n"
                                    "licence: BSD-3-Clause\n(weights .*CC BY-NC-SA.*\n)?"));
}

TEST(CommandLine, HelpOfEveryCommandEndsWithTheExitCodes) {
  for (const auto& [name, options] : kComplete) {
    EXPECT_THAT(read(name + " --help").out,
                HasSubstr("\nExit codes: 0 success, 1 error, 2 invalid"))
        << name;
  }
  EXPECT_THAT(read("inject --help").out, HasSubstr("the bag is written but its attack"));
}

TEST(CommandLine, MistypedWordsGetASuggestion) {
  for (const auto& [line, named] : std::map<std::string, std::string>{
           {"genrate --jobs 2", "forge: unknown command genrate; did you mean generate?"},
           {"study measure latncy",
            "forge study measure: unknown command latncy; did you mean latency?"},
           {"inject --bagg a.bag", "forge inject: unknown option --bagg; did you mean --bag?"},
           {"inject --output=b.bag", "forge inject: unknown option --output; did you mean --out?"},
           {"inject" + kComplete.at("inject") + " --mode repaly", "did you mean replay?"},
           {"possible" + kComplete.at("possible") + " --type rear_ned", "did you mean rear_end?"},
           {"test" + kComplete.at("test") + " --planners idm,pmd", "did you mean pdm?"}}) {
    const Reading reading = read(line);
    EXPECT_EQ(reading.exit_code, kExitUsage) << line;
    EXPECT_THAT(reading.err, HasSubstr(named)) << line;
  }
}

TEST(CommandLine, ACatalogueExcludesTypes) {
  for (const std::string& line : {"requests" + kComplete.at("requests") + " --types rear_end",
                                  "possible" + kComplete.at("possible") + " --type rear_end"}) {
    EXPECT_EQ(read(line).exit_code, std::nullopt) << line;
    const Reading reading = read(line + " --catalogue nhtsa");
    EXPECT_EQ(reading.exit_code, kExitUsage) << line;
    EXPECT_THAT(reading.err, HasSubstr("--catalogue")) << line;
  }
}

TEST(CommandLine, ControlOptionsAreTheSameInAllCommands) {
  for (const std::string command : {"inject", "generate", "requests"}) {
    const std::string line = command + kComplete.at(command);
    for (const char* good : {" --believable false", " --limits strict", " --attacker-class bus",
                             " --manoeuvre lead_brakes", " --ego-side rear",
                             " --impact-speed 2 9.5", " --overlap 0.25 0.5"}) {
      EXPECT_EQ(read(line + good).exit_code, std::nullopt) << command << good;
    }
    for (const char* bad : {" --believable maybe", " --limits none", " --attacker-class animal",
                            " --manoeuvre swerve", " --ego-side top"}) {
      const std::string word = std::string(bad).substr(std::string(bad).rfind(' ') + 1);
      EXPECT_THAT(read(line + bad).err, HasSubstr(word)) << command;
      EXPECT_EQ(read(line + bad).exit_code, kExitUsage) << command << bad;
    }
    EXPECT_EQ(read(line + " --impact-speed 2").exit_code, kExitUsage) << command;
    EXPECT_EQ(read(line + " --overlap 0.5").exit_code, kExitUsage) << command;
    EXPECT_THAT(
        read(command + " --help").out,
        AllOf(HasSubstr("lane_change: cut_in, drift, merge, pull_out"), HasSubstr("MIN MAX")));
  }
}

TEST(CommandLine, BulkCommandsAcceptReport) {
  for (const std::string command : {"generate", "test", "tune", "sweep", "study dataset"}) {
    const std::string line = command + kComplete.at(command);
    EXPECT_EQ(read(line + " --report page").exit_code, std::nullopt) << command;
  }
  EXPECT_EQ(read("test" + kLogs + " --out out --until-hit --report page").exit_code, std::nullopt);
  const std::string clips = " --dataroot " + kDataroot + " --collide " + kDataroot +
                            " --out out --report page --config " + kConfig;
  EXPECT_EQ(read("study test" + clips).exit_code, std::nullopt);
}

TEST(RequestControls, OverrideOnlyTheGivenFields) {
  CollisionRequest request;
  request.attacker = "a";
  request.crash.believable = false;
  RequestControls controls;
  controls.applyTo(request);
  EXPECT_EQ(request.attacker, "a");
  EXPECT_FALSE(request.crash.believable);
  controls.attacker = "b";
  controls.believable = true;
  controls.ego_side = Side::kLeft;
  controls.applyTo(request);
  EXPECT_EQ(request.attacker, "b");
  EXPECT_EQ(request.choice, AttackerChoice::kAny);
  EXPECT_TRUE(request.crash.believable);
  EXPECT_EQ(request.ego_side, Side::kLeft);
  EXPECT_FALSE(request.manoeuvre);
  controls.attacker = "new";
  controls.applyTo(request);
  EXPECT_FALSE(request.attacker);
  EXPECT_EQ(request.choice, AttackerChoice::kNew);
}

TEST(CommandLine, ErrorsBeginWithTheNameOfTheCommand) {
  CommandLine line;
  line.add("Heading", "group fails", "Fails.",
           []() -> int { throw std::runtime_error("no luck"); });
  const char* const words[] = {"forge", "group", "fails"};
  ASSERT_EQ(line.parse(3, words), std::nullopt);
  testing::internal::CaptureStderr();
  EXPECT_EQ(line.run(), kExitError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "forge group fails: no luck\n");
}

TEST(CommandLine, TheExitCodeOfACommandIsReturned) {
  CommandLine line;
  line.add("Heading", "refuses", "Refuses.", [] { return kExitNoAttack; });
  line.add("Heading", "works", "Works.", [] { return kExitOk; });
  const char* const words[] = {"forge", "refuses"};
  ASSERT_EQ(line.parse(2, words), std::nullopt);
  EXPECT_EQ(line.run(), kExitNoAttack);
}

TEST(BashCompletion, CompletesCommandsOptionsAndValues) {
  const Forge forge;
  const std::string script = bashCompletion(forge.app());
  EXPECT_THAT(script, HasSubstr("complete -o default -F _forge_complete forge\n"));
  EXPECT_THAT(script, HasSubstr("'forge generate --mode') words='history replay adaptive'"));
  EXPECT_THAT(script, HasSubstr("'forge generate --requests') words=''"));
  EXPECT_THAT(script, HasSubstr("'forge study measure') words='latency lidar patterns "));
  EXPECT_THAT(script, HasSubstr("--scenarios"));
  EXPECT_THAT(script, Not(HasSubstr("'forge convert --force')")));
  EXPECT_THAT(script, HasSubstr("'forge report --dataroot') words=''"));
}

TEST(Commands, EnumeratedValuesAreCaseInsensitive) {
  Forge forge;
  const std::string line =
      "inject --bag a.bag --type Ltap --tta 4 --now 4 --out b.bag --mode Replay "
      "--believable TRUE --limits Strict --ego-side Front --config " +
      kConfig;
  EXPECT_EQ(forge.read(line).exit_code, std::nullopt);
  EXPECT_EQ(forge.read(line + "s").exit_code, kExitUsage);
  for (const std::string& words : std::vector<std::string>{
           "test" + kComplete.at("test") + " --planners IDM,Pdm --attacker-policy Fixed,ADAPTIVE",
           "tune" + kComplete.at("tune") + " --planner PDM",
           "requests" + kComplete.at("requests") + " --attackers New"}) {
    const Reading reading = read(words);
    EXPECT_EQ(reading.exit_code, std::nullopt) << reading.err;
  }
}

}  // namespace
}  // namespace forge
