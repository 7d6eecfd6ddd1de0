// Every command and option, declared once with CLI11.
#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "foothold/client/nearest_name.hpp"
#include "foothold/transport/bus.hpp"
#include "past.hpp"
#include "terminal.hpp"
#include "version.hpp"

namespace foothold::cli {
namespace {

struct Everything {
  CLI::App app{"Asks a foothold server for footholds"};
  Common common;
  RobotsOptions robots;
  PlanOptions plan;
  ReplayOptions replay;
  HistoryOptions history;
  TopOptions top;
  CancelOptions cancel;
  StateOptions state;
  ScenePutOptions scene_put;
  PluginInfoOptions plugin_info;
  DrawOptions draw;
  SecurityOptions security;
  std::string generate_folder, generate_shell;
  std::function<Exit()> chosen;
};

const CLI::Validator kSeconds(
    [](std::string& text) {
      double seconds = 0.0;
      return CLI::detail::lexical_cast(text, seconds) && std::isfinite(seconds) && seconds > 0.0
                 ? std::string()
                 : "expected seconds above 0, not '" + text + "'";
    },
    "");

// A command that runs `run` when it is the one that is given.
template <class Run>
CLI::App* command(Everything& all, CLI::App& above, const char* name, const char* description, Run run) {
  CLI::App* sub = above.add_subcommand(name, description);
  sub->callback([&all, run] { all.chosen = run; });
  return sub;
}

// ------------------------------------------------------------------------------------------- declarations

void declare_common(Everything& all) {
  Common& common = all.common;
  all.app
      .add_option("--dds", common.dds, "The DDS library to speak with, cyclone or fastdds; servers of either are found with both")
      ->check(CLI::IsMember({"cyclone", "fastdds"}).description(""))
      ->envname("FOOTHOLD_DDS")
      ->type_name("VENDOR");
  all.app.add_option("--domain", common.domain, "The DDS domain of the server, 0 to 200")
      ->check(CLI::Range(0u, transport::kMaxDomain).description(""))
      ->envname("FOOTHOLD_DOMAIN")
      ->type_name("NUMBER");
  all.app.add_option("--network", common.network, "A configuration file of that DDS library; without it only this host is reached")
      ->envname("FOOTHOLD_NETWORK")
      ->type_name("FILE");
  all.app.add_option("--security", common.security, "A folder of credentials, where the server's DDS Security is on")
      ->envname("FOOTHOLD_SECURITY")
      ->type_name("DIR");
  all.app.add_option("--server", common.server, "Ask only the server of this name or id")->type_name("NAME");
  all.app.add_option("--timeout", common.timeout, "How long to wait for a server or its answer")
      ->check(kSeconds)
      ->type_name("SECONDS")
      ->capture_default_str();
  all.app.add_flag("--json", common.json, "Print one JSON object a line, for scripts");
}

void declare_state_dir(CLI::App& sub, std::string& folder) {
  sub.add_option("--state-dir", folder,
                 "The server's state folder on this host, whose journal is read; " + std::string(kStateFolder) + " unless given")
      ->envname("FOOTHOLD_STATE_DIR")
      ->type_name("DIR");
}

void declare_planning(Everything& all) {
  CLI::App* robots =
      command(all, all.app, "robots", "List what the servers plan for", [&all] { return run_robots(all.common, all.robots); });
  robots->add_option("robot", all.robots.robot, "Only this one, with its parameters")->type_name("NAME");
  robots->add_flag("--parameters", all.robots.parameters, "Also list each planner's parameters");

  CLI::App* plan = command(all, all.app, "plan", "Submit a request, print each step as it arrives, then how good the plan is",
                           [&all] { return run_plan(all.common, all.plan); });
  plan->add_option("request", all.plan.file, "A request as YAML, such as config/requests/*.yaml")->required()->type_name("FILE");
  plan->add_option("--set", all.plan.set, "Set a parameter, whatever the file says; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  plan->add_option("--budget", all.plan.budget, "Time for the plan, waiting included")->check(kSeconds)->type_name("SECONDS");
  plan->add_option("--seed", all.plan.seed, "Seed of the planner's random numbers")->type_name("NUMBER");
  plan->add_option("--priority", all.plan.priority, "Higher goes first")->type_name("NUMBER");
  plan->add_option("--robot", all.plan.robot, "Plan for this robot instead")->type_name("NAME");
  plan->add_option("--scene", all.plan.scene, "Plan in this stored scene instead")->type_name("NAME[@REVISION]");
  plan->add_flag("--shapes", all.plan.shapes, "Ask for the robot's bodies at each step, for drawing");
  plan->add_flag("-v,--verbose", all.plan.verbose, "Print contacts, joints and margins of each step");
  plan->add_option("-o,--output", all.plan.output, "Write the whole plan to a JSON file")->type_name("FILE");
  plan->footer("Ctrl-C cancels the request and waits for its end; a second Ctrl-C leaves at once.");

  CLI::App* replay = command(all, all.app, "replay", "Plan anew what was planned before, and compare octet for octet",
                             [&all] { return run_replay(all.common, all.replay); });
  replay
      ->add_option("plan", all.replay.source,
                   "A plan as 'foothold plan -o' writes it, a bundle of the server's state folder, or a request's id")
      ->required()
      ->type_name("FILE");
  declare_state_dir(*replay, all.replay.state_dir);
  replay->add_option("-o,--output", all.replay.output, "Write the new plan to a JSON file")->type_name("FILE");
}

void declare_asking(Everything& all) {
  CLI::App* cancel = command(all, all.app, "cancel", "Stop a request, and wait until it has ended",
                             [&all] { return run_cancel(all.common, all.cancel); });
  cancel->add_option("id", all.cancel.id, "The request's id, 32 hexadecimal digits")->required()->type_name("ID");
  cancel->add_option("--reason", all.cancel.reason, "Why, for the record")->type_name("TEXT");

  CLI::App* state =
      command(all, all.app, "state", "Show how a request stands", [&all] { return run_state(all.common, all.state); });
  state->add_option("id", all.state.id, "The request's id, 32 hexadecimal digits")->required()->type_name("ID");
  state->add_flag("--steps", all.state.steps, "Also print its steps");
  state->add_flag("-v,--verbose", all.state.verbose, "Print contacts, joints and margins of each step");
  state->add_option("-o,--output", all.state.output, "Write the plan so far to a JSON file")->type_name("FILE");

  CLI::App* scene = all.app.add_subcommand("scene", "Scenes that the server keeps")->require_subcommand(1);
  CLI::App* put = command(all, *scene, "put", "Store a scene file", [&all] { return run_scene_put(all.common, all.scene_put); });
  put->add_option("file", all.scene_put.file, "A file that ends in .yaml, .stl, .obj or .ply")->required()->type_name("FILE");
  put->add_option("--name", all.scene_put.name, "Its name; without it the file's, less the ending")->type_name("NAME");
  command(all, *scene, "list", "List the stored scenes", [&all] { return run_scene_list(all.common); });
}

void declare_past(Everything& all) {
  HistoryOptions& options = all.history;
  CLI::App* history = command(all, all.app, "history", "List what the server's journal on this host holds, whether it runs or not",
                              [&all] { return run_history(all.common, all.history); });
  history->add_option("id", options.id, "Only this request, in full")->type_name("ID");
  declare_state_dir(*history, options.state_dir);
  history->add_option("--robot", options.robot, "Only this robot's")->type_name("NAME");
  history->add_option("--unit", options.unit, "Only this individual's")->type_name("NAME");
  history->add_option("--state", options.state, "Only in this state, such as CRASHED or UNFINISHED")->type_name("STATE");
  history->add_option("--client", options.client, "Only this client's")->type_name("ID");
  history->add_option("--since", options.since, "Only those received in these last seconds")->check(kSeconds)->type_name("SECONDS");
  history->add_option("-n,--most", options.most, "At most so many, the newest")
      ->check(CLI::Range(1u, 1000000000u).description(""))
      ->type_name("NUMBER");
  history->add_option("-o,--output", options.output, "With an id: write the whole plan to a JSON file")->type_name("FILE");
  history->footer(
      "The journal is read as a file, which takes the right to read it (root, or the server's user): a list of everybody's\n"
      "requests over DDS would let every client cancel them. A request whose id you know is shown to you by 'foothold state'.");

  CLI::App* top = command(all, all.app, "top", "Watch servers, robots and running requests, of the whole fleet, live",
                          [&all] { return run_top(all.common, all.top); });
  top->add_option("--interval", all.top.interval, "Time between two pictures")->check(kSeconds)->type_name("SECONDS");
  top->add_option("--count", all.top.count, "End after so many pictures; without it Ctrl-C ends it")->type_name("NUMBER");
}

void declare_looking(Everything& all) {
  CLI::App* plugin = all.app.add_subcommand("plugin", "Planners as shared libraries")->require_subcommand(1);
  CLI::App* info = command(all, *plugin, "info", "Tell what a plugin holds, or why a server would refuse it",
                           [&all] { return run_plugin_info(all.common, all.plugin_info); });
  info->add_option("plugin", all.plugin_info.file, "The plugin, a .so file")->required()->type_name("FILE");
  info->add_option("--robot", all.plugin_info.robot_file, "Also make its planner, with the model of this robot's file")
      ->type_name("FILE");

  CLI::App* draw = command(all, all.app, "draw", "Draw a plan as SVG: the scene, the footholds, the robot at each stance",
                           [&all] { return run_draw(all.common, all.draw); });
  draw->add_option("plan", all.draw.source, "A plan as 'foothold plan -o' writes it, or a request's id")
      ->required()
      ->type_name("FILE");
  draw->add_option("-o,--output", all.draw.output, "Where the picture goes")->required()->type_name("FILE");
  draw->add_option("--view", all.draw.view, "From where: above, oblique or both")
      ->check(CLI::IsMember({"above", "oblique", "both"}).description(""))
      ->type_name("VIEW");
  draw->add_option("--frame", all.draw.frame, "What fills the picture: scene or plan")
      ->check(CLI::IsMember({"scene", "plan"}).description(""))
      ->type_name("WHAT");
  draw->add_option("--steps", all.draw.steps, "Only these, such as 3-7")->type_name("FIRST-LAST");
  draw->add_option("--width", all.draw.width, "Of the picture, in pixels")->type_name("NUMBER");
  draw->add_option("--azimuth", all.draw.azimuth, "Of the oblique view's eye, from +X towards +Y")->type_name("DEGREES");
  draw->add_option("--elevation", all.draw.elevation, "Of that eye above the horizon")->type_name("DEGREES");

  command(all, all.app, "doctor", "Check what keeps DDS programs from finding each other, and say what to do",
          [&all] { return run_doctor(all.common); });
}

void declare_security(Everything& all) {
  SecurityOptions& options = all.security;
  CLI::App* security = all.app.add_subcommand("security", "Credentials for DDS Security")->require_subcommand(1);

  CLI::App* init = command(all, *security, "init", "Make an authority: the key that signs everybody's credentials",
                           [&all] { return run_security_init(all.security); });
  init->add_option("folder", options.folder, "Its folder, new or empty")->required()->type_name("DIR");
  init->add_option("--years", options.years, "How long it is valid")->type_name("NUMBER")->capture_default_str();
  init->footer("Keep the folder on the operators' machine: whoever has it can make himself any credentials.");

  const auto authority = [&options](CLI::App* sub) {
    sub->add_option("--authority", options.authority, "The folder of the authority")->required()->type_name("DIR");
  };
  CLI::App* issue = command(all, *security, "issue", "Make credentials for a server, a client or an observer",
                            [&all] { return run_security_issue(all.security); });
  issue->add_option("name", options.name, "Whose they are")->required()->type_name("NAME");
  issue
      ->add_option("--role", options.role, "What they allow: server, client (own requests and plans) or observer (reads all plans)")
      ->required()
      ->check(CLI::IsMember({"server", "client", "observer"}).description(""))
      ->type_name("ROLE");
  issue->add_option("-o,--output", options.output, "Their folder, new or empty")->required()->type_name("DIR");
  issue->add_option("--days", options.days, "How long they are valid")->type_name("NUMBER")->capture_default_str();
  authority(issue);

  CLI::App* revoke = command(all, *security, "revoke", "Add somebody's credentials to the list of revoked ones",
                             [&all] { return run_security_revoke(all.security); });
  revoke->add_option("name", options.name, "Whose credentials")->required()->type_name("NAME");
  authority(revoke);

  CLI::App* list = command(all, *security, "list", "List everybody who was given credentials",
                           [&all] { return run_security_list(all.common, all.security); });
  authority(list);
}

std::string exit_codes() {
  std::string text = "Exit codes:";
  for (const ExitMeaning& exit : kExitMeanings) text += format("\n  %-4d", static_cast<int>(exit.code)) + std::string(exit.meaning);
  return text;
}

// ------------------------------------------------------------------------------------------- help as values

OptionHelp help_of(const CLI::Option& option) {
  OptionHelp help;
  if (option.get_positional()) {
    help.names = {option.get_type_name()};
  } else {
    for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  }
  help.description = option.get_description();
  help.variable = option.get_envname();
  if (option.get_items_expected_max() == 0) return help;
  help.value = option.get_type_name();
  if (help.value == "VENDOR") help.choices = {"cyclone", "fastdds"};
  if (help.value == "VIEW") help.choices = {"above", "oblique", "both"};
  if (help.value == "ROLE") help.choices = {"server", "client", "observer"};
  if (help.value == "WHAT") help.choices = {"scene", "plan"};
  if (const auto more = help.value.find(':'); more != std::string::npos) help.value.resize(more);
  if (help.names.size() == 1 && option.get_positional()) help.names = {help.value};
  return help;
}

CommandHelp help_of(CLI::App& app, std::vector<std::string> path) {
  CommandHelp help{path, app.get_description(), app.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? help.positionals : help.options).push_back(help_of(*option));
  for (CLI::App* sub : app.get_subcommands([](const CLI::App* s) { return !s->get_group().empty(); })) {
    path.push_back(sub->get_name());
    help.commands.push_back(help_of(*sub, path));
    path.pop_back();
  }
  return help;
}

void declare_generate(Everything& all) {
  CLI::App* generate = all.app.add_subcommand("generate", "Files that are made from this help at build time")->group("");
  generate->require_subcommand(1);
  CLI::App* man = command(all, *generate, "man", "Manual pages", [&all] {
    write_man_pages(help_of(all.app, {"foothold"}), all.generate_folder);
    return Exit::kSucceeded;
  });
  man->add_option("folder", all.generate_folder)->required();
  CLI::App* completion = command(all, *generate, "completion", "Completion for a shell", [&all] {
    write_completion(help_of(all.app, {"foothold"}), all.generate_shell, all.generate_folder);
    return Exit::kSucceeded;
  });
  completion->add_option("shell", all.generate_shell)->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->add_option("folder", all.generate_folder)->required();
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App* s) { return !s->get_group().empty(); }))
    names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// What is wrong, in our own words where CLI11's would not say it.
std::string complaint(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* command = &program;
  std::string path;
  for (; !command->get_subcommands().empty(); command = command->get_subcommands().front())
    path += command->get_subcommands().front()->get_name() + " ";
  if (!path.empty()) path.back() = ':', path += ' ';
  const std::vector<std::string> left = program.remaining(true);
  const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const bool missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if ((!extra && !missing) || (missing && commands_of(*command).empty())) return path + printable(error.what());
  if (left.empty()) return path + "a command is missing" + client::suggestion("", commands_of(*command));
  for (const std::string& word : left) {
    if (!word.starts_with('-')) continue;
    std::vector<std::string> known = options_of(*command);
    if (command != &program) std::ranges::copy(options_of(program), std::back_inserter(known));
    return path + "'" + printable(word) + "' is no option" + client::suggestion(word, known);
  }
  if (commands_of(*command).empty()) return path + "'" + printable(left[0]) + "' is too much";
  return path + "'" + printable(left[0]) + "' is no command" + client::suggestion(left[0], commands_of(*command));
}

}  // namespace

std::function<Exit()> parse(int count, char** words) {
  const auto all = std::make_shared<Everything>();
  all->app.option_defaults()->take_last();  // an alias can set what a user sets again
  all->app.name("foothold");
  all->app.set_version_flag("--version", std::string("foothold ") + kVersion, "Print the version and exit");
  all->app.get_formatter()->column_width(34);
  all->app.fallthrough();
  all->app.require_subcommand(1);
  declare_common(*all);
  declare_planning(*all);
  declare_asking(*all);
  declare_past(*all);
  declare_looking(*all);
  declare_security(*all);
  declare_generate(*all);
  all->app.footer(exit_codes());  // last: commands take over what their parent has when they are made
  try {
    all->app.parse(count, words);
  } catch (const CLI::Success& asked_for_help) {
    all->app.exit(asked_for_help);
    return [] { return Exit::kSucceeded; };
  } catch (const CLI::ParseError& error) {
    print(Complaint(Exit::kUsage, complaint(all->app, error), "see foothold --help"));
    return [] { return Exit::kUsage; };
  }
  return [all] { return all->chosen(); };
}

}  // namespace foothold::cli
