// Completion for bash, zsh and fish from the help. Every shell offers commands, options, the words that an option takes, and files
// where a file is meant.
#include <set>

#include "command_help.hpp"

namespace foothold::cli {
namespace {

// The path without the program: "scene put".
std::string words_of(const CommandHelp& command) {
  std::string text;
  for (std::size_t i = 1; i < command.path.size(); ++i) text += (i > 1 ? " " : "") + command.path[i];
  return text;
}

template <class Visit>
void each(const CommandHelp& command, const Visit& visit) {
  visit(command);
  for (const CommandHelp& sub : command.commands) each(sub, visit);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// For single quotes of a shell.
std::string single(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out;
}

bool wants_file(const CommandHelp& command) { return !command.positionals.empty() && command.positionals[0].takes_file(); }

// ------------------------------------------------------------------------------------------- bash

// Of one option that takes a value: which words follow it, wherever it is given.
std::string bash_value(const CommandHelp& command, const OptionHelp& option) {
  std::string pattern;
  const std::string where = command.path.size() == 1 ? "*" : "\"" + words_of(command) + "\"";
  for (const std::string& name : option.names) pattern += (pattern.empty() ? "" : "|") + where + ":" + name;
  std::string action = "COMPREPLY=()";
  if (!option.choices.empty()) action = "COMPREPLY=($(compgen -W \"" + joined(option.choices) + "\" -- \"$current\"))";
  if (option.takes_file()) action = "COMPREPLY=($(compgen -f -- \"$current\"))";
  return "    " + pattern + ") " + action + "; return ;;\n";
}

// ------------------------------------------------------------------------------------------- zsh

std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return single(out);
}

std::string zsh_value(const OptionHelp& option) {
  if (option.value.empty()) return "";
  std::string action = " ";
  if (!option.choices.empty()) action = "(" + joined(option.choices) + ")";
  if (option.takes_file()) action = "_files";
  return ":" + zsh_text(option.value) + ":" + action;
}

std::string zsh_options(const CommandHelp& command) {
  std::string text;
  for (const OptionHelp& option : command.options)
    for (const std::string& name : option.names)
      text += " \\\n    '*" + name + "[" + zsh_text(option.description) + "]" + zsh_value(option) + "'";
  return text;
}

std::string zsh_function(const CommandHelp& command) {
  std::string name;
  for (const std::string& word : command.path) name += "_" + word;
  std::string text = name + "() {\n";
  if (command.commands.empty()) {
    text += "  _arguments -s" + zsh_options(command);
    for (const OptionHelp& positional : command.positionals)
      text += std::string(" \\\n    ':") + zsh_text(positional.value) + ":" + (positional.takes_file() ? "_files" : " ") + "'";
    return text + "\n}\n\n";
  }
  text += "  local context state line\n  typeset -A opt_args\n  _arguments -C" + zsh_options(command) +
          " \\\n    '1: :->command' '*:: :->rest'\n  case $state in\n    command)\n      local -a commands=(\n";
  for (const CommandHelp& sub : command.commands) text += "        '" + sub.path.back() + ":" + zsh_text(sub.description) + "'\n";
  text += "      )\n      _describe command commands ;;\n    rest)\n      case $line[1] in\n";
  for (const CommandHelp& sub : command.commands)
    text += "        " + sub.path.back() + ") " + name + "_" + sub.path.back() + " ;;\n";
  return text + "      esac ;;\n  esac\n}\n\n";
}

// ------------------------------------------------------------------------------------------- fish

// True in fish when the words so far are those of this command and of none below it.
std::string fish_condition(const CommandHelp& command) {
  if (command.path.size() == 1) return "__fish_use_subcommand";
  std::string text;
  for (std::size_t i = 1; i < command.path.size(); ++i)
    text += (text.empty() ? "" : "; and ") + std::string("__fish_seen_subcommand_from ") + command.path[i];
  if (!command.commands.empty()) {
    text += "; and not __fish_seen_subcommand_from";
    for (const CommandHelp& sub : command.commands) text += " " + sub.path.back();
  }
  return text;
}

std::string fish_option(const std::string& condition, const OptionHelp& option) {
  std::string text = "complete -c foothold" + condition;
  for (const std::string& name : option.names) text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) text += option.takes_file() ? " -r -F" : " -x";
  if (!option.choices.empty()) text += " -a '" + joined(option.choices) + "'";
  return text + " -d '" + single(option.description) + "'\n";
}

}  // namespace

std::string bash_completion(const CommandHelp& program) {
  std::string paths, values, cases;
  each(program, [&](const CommandHelp& command) {
    std::vector<std::string> offered;
    for (const CommandHelp& sub : command.commands) {
      const std::string above = words_of(command);
      paths += (paths.empty() ? "" : "|") + std::string("\"") + above + " " + sub.path.back() + "\"";
      offered.push_back(sub.path.back());
    }
    for (const OptionHelp& option : command.options) {
      offered.insert(offered.end(), option.names.begin(), option.names.end());
      if (!option.value.empty()) values += bash_value(command, option);
    }
    cases += "    \"" + words_of(command) + "\") offered=\"" + joined(offered) + "\"" + (wants_file(command) ? " files=1" : "") +
             " ;;\n";
  });
  return "# bash completion for foothold; made from its help\n_foothold() {\n"
         "  local current=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\" command=\"\" offered=\"\" "
         "files=\"\" i\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n    case \"$command ${COMP_WORDS[i]}\" in\n      " +
         paths + ") command=\"${command:+$command }${COMP_WORDS[i]}\" ;;\n    esac\n  done\n  case \"$command:$previous\" in\n" +
         values + "  esac\n  case \"$command\" in\n" + cases +
         "  esac\n  COMPREPLY=($(compgen -W \"$offered\" -- \"$current\"))\n"
         "  if [[ -n $files && $current != -* ]]; then COMPREPLY+=($(compgen -f -- \"$current\")); fi\n}\n"
         "complete -o filenames -F _foothold foothold\n";
}

std::string zsh_completion(const CommandHelp& program) {
  std::string text = "#compdef foothold\n# zsh completion for foothold; made from its help\n\n";
  each(program, [&](const CommandHelp& command) { text += zsh_function(command); });
  return text + "_foothold \"$@\"\n";
}

std::string fish_completion(const CommandHelp& program) {
  std::string text = "# fish completion for foothold; made from its help\ncomplete -c foothold -f\n";
  each(program, [&](const CommandHelp& command) {
    const std::string condition = " -n '" + fish_condition(command) + "'";
    for (const CommandHelp& sub : command.commands)
      text += "complete -c foothold" + condition + " -a " + sub.path.back() + " -d '" + single(sub.description) + "'\n";
    // The program's own options are taken behind every command.
    for (const OptionHelp& option : command.options) text += fish_option(command.path.size() == 1 ? "" : condition, option);
    if (wants_file(command)) text += "complete -c foothold" + condition + " -F\n";
  });
  return text;
}

}  // namespace foothold::cli
