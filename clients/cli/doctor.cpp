// foothold doctor: looks at everything that has kept DDS programs from finding each other, and says what to do.
#include <nlohmann/json.hpp>

#include "doctor/check.hpp"
#include "terminal.hpp"
#include "version.hpp"

namespace foothold::cli {
namespace {

const char* name_of(Finding::Level level) {
  return level == Finding::Level::kOk ? "ok" : level == Finding::Level::kWarn ? "warn" : "fail";
}

std::string mark(Finding::Level level) {
  const Colour colour = level == Finding::Level::kOk     ? Colour::kGood
                        : level == Finding::Level::kWarn ? Colour::kWarn
                                                         : Colour::kBad;
  return coloured(colour, name_of(level));
}

class Reporter {
 public:
  explicit Reporter(bool json) : json_(json) {}

  void tell(const Findings& findings) {
    for (const Finding& finding : findings) {
      ++counts_[static_cast<std::size_t>(finding.level)];
      if (json_)
        std::puts(nlohmann::ordered_json{{"finding",
                                          {{"level", name_of(finding.level)},
                                           {"subject", finding.subject},
                                           {"message", finding.message},
                                           {"advice", finding.advice}}}}
                      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
                      .c_str());
      else
        print(finding);
    }
    std::fflush(stdout);
  }

  std::size_t count(Finding::Level level) const { return counts_[static_cast<std::size_t>(level)]; }

 private:
  static void print(const Finding& finding) {
    std::printf("%s%s  %s: %s\n", mark(finding.level).c_str(), finding.level == Finding::Level::kOk ? "  " : "",
                finding.subject.c_str(), printable(finding.message).c_str());
    if (!finding.advice.empty()) std::printf("      %s\n", printable(finding.advice).c_str());
  }

  bool json_;
  std::size_t counts_[3] = {};
};

}  // namespace

Exit run_doctor(const Common& common) {
  const Surroundings around = this_machine();
  Reporter reporter(common.json);
  reporter.tell({{Finding::Level::kOk, "foothold", kVersion, ""}});
  reporter.tell(check_interfaces(around));
  reporter.tell(check_exposure(common));
  reporter.tell(check_security(common));
  reporter.tell(check_environment(around, common));
  reporter.tell(check_participants(around, common));
  reporter.tell(check_socket_buffers(around));
  reporter.tell(check_shared_memory(around));
  reporter.tell(check_servers(common));
  const std::size_t warnings = reporter.count(Finding::Level::kWarn), failures = reporter.count(Finding::Level::kFail);
  if (!common.json)
    std::printf("%zu failure%s, %zu warning%s\n", failures, failures == 1 ? "" : "s", warnings, warnings == 1 ? "" : "s");
  return failures == 0 ? Exit::kSucceeded : Exit::kOther;
}

}  // namespace foothold::cli
