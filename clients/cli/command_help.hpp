// The commands and options as plain values: what the manual pages and the completions are made from. command_line.cpp, which alone
// knows CLI11, fills them in from the same declarations that parse the arguments.
#pragma once

#include <string>
#include <vector>

namespace foothold::cli {

struct OptionHelp {
  std::vector<std::string> names;  // "-o", "--output"; of a positional: "FILE"
  std::string value;               // what it takes, such as FILE or SECONDS; empty: a flag
  std::string description;
  std::vector<std::string> choices;
  std::string variable;  // of the environment that stands for it
  bool takes_file() const { return value == "FILE" || value == "DIR"; }
};

struct CommandHelp {
  std::vector<std::string> path;  // {"foothold", "scene", "put"}
  std::string description, footer;
  std::vector<OptionHelp> options, positionals;
  std::vector<CommandHelp> commands;
};

// foothold.1 or foothold-scene-put.1, by the path.
std::string man_page(const CommandHelp& command, const CommandHelp& program);

std::string bash_completion(const CommandHelp& program);
std::string zsh_completion(const CommandHelp& program);
std::string fish_completion(const CommandHelp& program);

// Writes every page, or the completion for a shell ("bash", "zsh", "fish"), into a folder that it makes. Throws Complaint.
void write_man_pages(const CommandHelp& program, const std::string& folder);
void write_completion(const CommandHelp& program, const std::string& shell, const std::string& folder);

}  // namespace foothold::cli
