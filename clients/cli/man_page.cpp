// Manual pages from the help, in man(7)'s macros.
#include <filesystem>
#include <fstream>

#include "command_help.hpp"
#include "terminal.hpp"
#include "version.hpp"

namespace foothold::cli {
namespace {

// Text that man(7) takes literally.
std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_line = i == 0 || text[i - 1] == '\n';
    if (begins_line && (text[i] == '.' || text[i] == '\'')) out += "\\&";
    if (text[i] == '\\')
      out += "\\e";
    else if (text[i] == '-')
      out += "\\-";
    else
      out += text[i];
  }
  return out;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string options(const std::vector<OptionHelp>& list) {
  std::string text;
  for (const OptionHelp& option : list) {
    text += ".TP\n\\fB" + roff(joined(option.names, ", ")) + "\\fR";
    if (!option.value.empty() && option.names[0].starts_with('-')) text += " \\fI" + roff(option.value) + "\\fR";
    text += "\n" + roff(option.description);
    if (!option.variable.empty()) text += ". The variable \\fB" + roff(option.variable) + "\\fR stands for it";
    text += ".\n";
  }
  return text;
}

std::string synopsis(const CommandHelp& command) {
  std::string text = "\\fB" + roff(joined(command.path, " ")) + "\\fR";
  if (!command.options.empty()) text += " [\\fIoptions\\fR]";
  for (const OptionHelp& positional : command.positionals) text += " \\fI" + roff(positional.names[0]) + "\\fR";
  if (!command.commands.empty()) text += " \\fIcommand\\fR";
  return text;
}

std::string page_name(const CommandHelp& command) { return joined(command.path, "-"); }

std::string list_of_commands(const CommandHelp& command) {
  std::string text;
  for (const CommandHelp& sub : command.commands) {
    if (sub.commands.empty())
      text += ".TP\n\\fB" + roff(joined({sub.path.begin() + 1, sub.path.end()}, " ")) + "\\fR\n" + roff(sub.description) +
              ". See \\fB" + roff(page_name(sub)) + "\\fR(1).\n";
    else
      text += list_of_commands(sub);
  }
  return text;
}

// "Exit codes:" and then a line each: a heading and tagged paragraphs.
std::string exit_status(const std::string& footer) {
  std::string text = ".SH EXIT STATUS\n";
  for (std::size_t begin = footer.find('\n'); begin != std::string::npos;) {
    const std::size_t end = footer.find('\n', begin + 1);
    const std::string line = footer.substr(begin + 1, end == std::string::npos ? end : end - begin - 1);
    const std::size_t code = line.find_first_not_of(' '), meaning = line.find_first_not_of(' ', line.find(' ', code));
    text += ".TP\n" + line.substr(code, line.find(' ', code) - code) + "\n" + roff(line.substr(meaning)) + "\n";
    begin = end;
  }
  return text;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::error_code fault;
  std::filesystem::create_directories(path.parent_path(), fault);
  std::ofstream file(path, std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw Complaint(Exit::kOther, path.string() + ": cannot be written");
}

void write_pages(const CommandHelp& command, const CommandHelp& program, const std::filesystem::path& folder) {
  if (command.commands.empty() || &command == &program) write(folder / (page_name(command) + ".1"), man_page(command, program));
  for (const CommandHelp& sub : command.commands) write_pages(sub, program, folder);
}

}  // namespace

std::string man_page(const CommandHelp& command, const CommandHelp& program) {
  const bool whole = command.path.size() == 1;
  const std::string name = page_name(command);
  std::string upper = name;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string text =
      ".\\\" Made from the help of foothold.\n.TH " + roff(upper) + " 1 \"\" \"foothold " + kVersion + "\" \"User Commands\"\n";
  text += ".SH NAME\n" + roff(name) + " \\- " + roff(command.description) + "\n";
  text += ".SH SYNOPSIS\n" + synopsis(command) + "\n";
  if (whole)
    text +=
        ".SH DESCRIPTION\nPlans footholds for walking and climbing robots with a server, \\fBfootholdd\\fR(8), over DDS.\n"
        "Unless \\fB\\-\\-network\\fR names a configuration, nothing leaves this host.\n.SH COMMANDS\n" +
        list_of_commands(command);
  else if (!command.footer.empty())
    text += ".SH DESCRIPTION\n" + roff(command.description) + ".\n" + roff(command.footer) + "\n";
  if (!command.positionals.empty()) text += ".SH ARGUMENTS\n" + options(command.positionals);
  if (!command.options.empty()) text += ".SH OPTIONS\n" + options(command.options);
  if (!whole) text += ".PP\nThe options of \\fBfoothold\\fR(1) are taken as well.\n";
  text += exit_status(program.footer);
  text += ".SH SEE ALSO\n" + std::string(whole ? "\\fBfootholdd\\fR(8)\n" : "\\fBfoothold\\fR(1)\n");
  return text;
}

void write_man_pages(const CommandHelp& program, const std::string& folder) { write_pages(program, program, folder); }

void write_completion(const CommandHelp& program, const std::string& shell, const std::string& folder) {
  const std::filesystem::path path(folder);
  if (shell == "bash") write(path / "foothold", bash_completion(program));
  if (shell == "zsh") write(path / "_foothold", zsh_completion(program));
  if (shell == "fish") write(path / "foothold.fish", fish_completion(program));
}

}  // namespace foothold::cli
