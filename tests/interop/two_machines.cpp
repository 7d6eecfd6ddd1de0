// Built on unshare(2) and the program `ip`.
#include "two_machines.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace foothold::interop {
namespace {

void run(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

// 1 if a datagram to the port was answered by "port unreachable".
std::uint8_t knock(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  inet_pton(AF_INET, "10.99.0.1", &address.sin_addr);
  bool refused = false;
  if (connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    for (int i = 0; i < 20 && !refused; ++i) {
      refused = send(socket, "knock", 5, 0) < 0 && errno == ECONNREFUSED;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  close(socket);
  return refused ? 1 : 0;
}

[[noreturn]] void be_the_other_machine(int ask, int answer) {
  if (unshare(CLONE_NEWNET) != 0) _exit(1);
  std::uint8_t ready = 1;
  std::uint16_t port = 0;
  if (write(answer, &ready, 1) != 1) _exit(1);
  while (read(ask, &port, sizeof port) == sizeof port) {
    const std::uint8_t refused = knock(port);
    if (write(answer, &refused, 1) != 1) break;
  }
  _exit(0);
}

}  // namespace

bool TwoMachines::allowed() {
  const pid_t child = fork();
  if (child == 0) _exit(unshare(CLONE_NEWNET) == 0 ? 0 : 1);
  int status = 1;
  waitpid(child, &status, 0);
  return status == 0;
}

TwoMachines::TwoMachines() {
  int ask[2];
  int answer[2];
  if (pipe2(ask, O_CLOEXEC) != 0 || pipe2(answer, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  other_ = fork();
  if (other_ == 0) {
    close(ask[1]);
    close(answer[0]);
    be_the_other_machine(ask[0], answer[1]);
  }
  close(ask[0]);
  close(answer[1]);
  ask_ = ask[1];
  answer_ = answer[0];
  std::uint8_t ready = 0;
  if (read(answer_, &ready, 1) != 1) throw std::runtime_error("no other machine");
  if (unshare(CLONE_NEWNET) != 0) throw std::runtime_error("no network namespace");
  const std::string other = std::to_string(other_);
  run("ip link set lo up && ip link add cable type veth peer name cable2 && ip link set cable2 netns " + other);
  // Else the kernel itself sends neighbour solicitations.
  std::ofstream("/proc/sys/net/ipv6/conf/cable/disable_ipv6") << 1;
  run("ip address add 10.99.0.1/24 dev cable && ip link set cable up && ip route add 224.0.0.0/4 dev cable");
  run("nsenter -n -t " + other + " sh -c 'ip address add 10.99.0.2/24 dev cable2 && ip link set cable2 up'");
}

TwoMachines::~TwoMachines() {
  close(ask_);
  close(answer_);
  waitpid(other_, nullptr, 0);
}

std::uint64_t TwoMachines::packets_out() const {
  std::ifstream file("/proc/thread-self/net/dev");
  for (std::string line; std::getline(file, line);) {
    if (line.find("cable:") == std::string::npos) continue;
    std::istringstream columns(line.substr(line.find(':') + 1));
    std::uint64_t value = 0;
    for (int column = 0; column < 10; ++column) columns >> value;  // the tenth: packets transmitted
    return value;
  }
  throw std::runtime_error("no cable");
}

bool TwoMachines::refuses(std::uint16_t port) {
  std::uint8_t refused = 0;
  if (write(ask_, &port, sizeof port) != sizeof port || read(answer_, &refused, 1) != 1)
    throw std::runtime_error("no other machine");
  return refused == 1;
}

std::vector<std::uint16_t> TwoMachines::open_ports() {
  std::vector<std::uint16_t> ports;
  std::ifstream file("/proc/thread-self/net/udp");
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const auto colon = line.find(':', line.find(':') + 1);
    ports.push_back(static_cast<std::uint16_t>(std::stoul(line.substr(colon + 1, 4), nullptr, 16)));
  }
  return ports;
}

}  // namespace foothold::interop
