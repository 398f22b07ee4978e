#include <iostream>
#include <sstream>

#include "collision_forge/app/command_line.h"

namespace forge {
namespace {

/// Returns the enumerated values of an option, as "train val test"; "" if it accepts any value.
std::string wordsOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // as "TEXT:{train,val,test}"
  const std::size_t open = type.find('{');
  if (open == std::string::npos) return "";
  std::string words = type.substr(open + 1, type.find('}', open) - open - 1);
  for (char& letter : words) letter = letter == ',' ? ' ' : letter;
  return words;
}

/// Writes the branches of two bash `case` statements: the words that may follow a command (`next`)
/// and the values that may follow its options (`values`); recurses into subcommands.
void describe(const CLI::App& command, const std::string& name, std::ostream& next,
              std::ostream& values) {
  next << "    '" << name << "') words='";
  for (const CLI::App* part : partsOf(command)) next << part->get_name() << " ";
  for (const CLI::Option* option : optionsOf(command)) {
    for (const std::string& word : option->get_lnames()) {  // positional arguments have none
      next << "--" << word << " ";
      if (option->get_items_expected_max() == 0) continue;  // a flag
      values << "    '" << name << " --" << word << "') words='" << wordsOf(*option) << "' ;;\n";
    }
  }
  next << "' ;;\n";
  for (const CLI::App* part : partsOf(command)) {
    describe(*part, name + " " + part->get_name(), next, values);
  }
}

}  // namespace

std::string bashCompletion(const CLI::App& app) {
  std::ostringstream next;
  std::ostringstream values;
  describe(app, app.get_name(), next, values);
  return "_forge_complete() {\n"
         "  local word words='' name=forge current=${COMP_WORDS[COMP_CWORD]}\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    [[ $word == -* ]] && break\n"
         "    name+=\" $word\"\n"
         "  done\n"
         "  case $name in\n" +
         next.str() +
         "  esac\n"
         "  case \"$name ${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
         values.str() +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o default -F _forge_complete forge\n";
}

void addCompletion(CommandLine& line) {
  const CLI::App& app = line.app();
  line.add(kOther, "completion bash",
           "Prints a script for the completion of forge commands in bash.", [&app] {
             std::cout << bashCompletion(app);
             return kExitOk;
           });
}

}  // namespace forge
