// The way from the daemon's loop into a worker process and back, with a planner that returns at once: start to first step, start to
// report, plans and steps per second; beside them the bare round trip over a socket pair between two processes, measured in turn.
// bench_workers [--quick]
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "figures.hpp"
#include "workers/workers.hpp"

namespace {

using namespace foothold;
using namespace foothold::server;
using SteadyClock = std::chrono::steady_clock;

double microseconds(SteadyClock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); }

// A process that sends back what it is sent.
class Echo {
 public:
  Echo() {
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, sockets_) != 0) std::abort();
    child_ = fork();
    if (child_ != 0) return;
    for (char octets[256];;)
      if (const ssize_t count = recv(sockets_[1], octets, sizeof(octets), 0);
          count <= 0 || send(sockets_[1], octets, static_cast<std::size_t>(count), 0) < 0)
        std::_Exit(0);
  }
  ~Echo() {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  double round_trip() {
    char octets[256] = {};
    const auto begin = SteadyClock::now();
    if (send(sockets_[0], octets, sizeof(octets), 0) < 0 || recv(sockets_[0], octets, sizeof(octets), MSG_WAITALL) < 0)
      std::abort();
    return microseconds(SteadyClock::now() - begin);
  }

 private:
  int sockets_[2] = {-1, -1};
  pid_t child_ = -1;
};

// One robot with one slot, and a stop watch in the place of Jobs.
class Course : private RunEvents {
 public:
  Course() {
    RobotConfig robot;
    robot.name = "many";
    robot.plugin = std::string(FOOTHOLD_TEST_PLUGINS) + "/many.so";
    workers_ = std::make_unique<Workers>(loop_, WorkersOptions{FOOTHOLD_WORKER, {}}, std::vector{robot});
    bool settled = false;
    workers_->open(*this, [&] { settled = true; });
    while (!settled) loop_.run_one();
    if (!workers_->has_idle("many")) throw std::runtime_error(workers_->status("many").info->reason());
  }

  struct Times {
    double first_step, report;
    std::size_t steps;
  };
  Times run(const std::string& steps) {
    msg::PlanRequest request;
    request.id().fill(1);
    request.robot("many");
    request.parameters().resize(1);
    request.parameters()[0].name("steps");
    request.parameters()[0].value(steps);
    steps_ = 0;
    ended_ = false;
    const auto begin = SteadyClock::now();
    workers_->start(request, 10.0, std::nullopt);
    while (!ended_) loop_.run_one();
    return {microseconds(first_ - begin), microseconds(end_ - begin), steps_};
  }

 private:
  void on_run_scene(Run, std::vector<msg::Shape>) override {}
  void on_run_step(Run, std::uint32_t index, Bytes) override {
    if (index == 0) first_ = SteadyClock::now();
    ++steps_;
  }
  void on_run_end(Run, RunEnd end) override {
    end_ = SteadyClock::now();
    ended_ = true;
    if (end.state != msg::SUCCEEDED) throw std::runtime_error(end.error.message());
  }
  void on_slots_changed(const std::string&) override {}

  boost::asio::io_context loop_{1};
  std::unique_ptr<Workers> workers_;
  SteadyClock::time_point first_{}, end_{};
  std::size_t steps_ = 0;
  bool ended_ = false;
};

}  // namespace

int main(int count, char** words) {
  const bool is_quick = bench::quick(count, words);
  const int plans = is_quick ? 3000 : 20000, long_plans = is_quick ? 3 : 20;
  Echo echo;
  Course course;
  for (int i = 0; i < 300; ++i) course.run("1"), echo.round_trip();

  std::vector<double> echoes, firsts, reports;
  for (int i = 0; i < plans; ++i) {
    echoes.push_back(echo.round_trip());
    const auto times = course.run("1");
    firsts.push_back(times.first_step);
    reports.push_back(times.report);
  }
  const auto begin = SteadyClock::now();
  for (int i = 0; i < plans; ++i) course.run("1");
  const double plans_per_s = 1e6 * plans / microseconds(SteadyClock::now() - begin);
  double steps = 0.0, time = 0.0;
  for (int i = 0; i < long_plans; ++i) {
    const auto times = course.run("20000");
    steps += static_cast<double>(times.steps);
    time += times.report;
  }

  const double echo_p50 = bench::percentile(echoes, 0.5);
  const char* raw = "round trip over a socket pair";
  const std::vector<bench::Figure> figures = {
      {"first_step_p50", bench::percentile(firsts, 0.5), "us", "less", 40.0, echo_p50, raw},
      {"first_step_p99", bench::percentile(firsts, 0.99), "us", "less", {}, bench::percentile(echoes, 0.99), raw},
      {"report_p50", bench::percentile(reports, 0.5), "us", "less", {}, echo_p50, raw},
      {"report_p99", bench::percentile(reports, 0.99), "us", "less", {}, bench::percentile(echoes, 0.99), raw},
      {"plans_per_s", plans_per_s, "1/s", "more", 2000.0, {}, ""},
      {"steps_per_s", 1e6 * steps / time, "1/s", "more", 20000.0, {}, ""}};
  bench::report("workers", figures);
}
