// attacker VENDOR DOMAIN CREDENTIALS ACTS ID PARTITION:REQUEST...: does to a server and its clients what it can, until SIGTERM.
// CREDENTIALS: a folder, or - for none; neither ours nor the vendor's own checks of them are made (lies.cpp).
// ACTS, joined by commas: read (everybody's steps, events and requests), request (in a victim's name a plan, under ID, and a cancel
// of each REQUEST), serve (a server called `forged ID`, a step labelled so and an end for each REQUEST in its PARTITION). Prints
// "opened" or why not, then at the end one line: steps, events and requests that it read, messages that it sent.
#include <dlfcn.h>
#include <foothold.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"
#include "foothold/transport/bus.hpp"

namespace {

using namespace foothold;
using transport::Topic;
using transport::Writer;

struct Victim {
  std::string partition;
  msg::Id request;
};

struct Attack {
  std::unique_ptr<transport::Bus> bus;
  std::vector<Victim> victims;
  msg::Id id{};
  std::atomic<unsigned> steps = 0, events = 0, requests = 0;
  unsigned sent = 0, refused = 0;
  std::vector<std::unique_ptr<transport::Reader>> readers;
  std::vector<std::pair<std::unique_ptr<Writer>, std::vector<msg::Bytes>>> writers;
};

// What attackers write is read by all of them, and counts for nothing.
bool genuine(const msg::Step& step) { return !step.label().starts_with("forged"); }
bool genuine(const msg::PlanEvent& event) { return !event.error().message().starts_with("forged"); }
bool genuine(const msg::PlanRequest& request) { return request.unit() != "forged"; }

template <class Message>
void read(Attack& attack, Topic topic, const std::string& partition, std::atomic<unsigned>& count) try {
  const auto on_message = [&count](std::span<const std::byte> octets) {
    const auto message = msg::decode<Message>(octets);
    if (!message || genuine(*message)) ++count;
  };
  attack.readers.push_back(attack.bus->reader(topic, partition, {.on_message = on_message}));
} catch (const transport::BusError&) {
  ++attack.refused;
}

void write(Attack& attack, Topic topic, const std::string& partition, std::vector<msg::Bytes> messages) try {
  attack.writers.emplace_back(attack.bus->writer(topic, partition), std::move(messages));
} catch (const transport::BusError&) {
  ++attack.refused;
}

void begin_reading(Attack& attack) {
  std::vector<std::string> partitions{"*"};
  for (const Victim& victim : attack.victims) partitions.push_back(victim.partition);
  for (const std::string& partition : partitions) {
    read<msg::Step>(attack, Topic::kStep, partition, attack.steps);
    read<msg::PlanEvent>(attack, Topic::kEvent, partition, attack.events);
  }
  read<msg::PlanRequest>(attack, Topic::kRequest, "", attack.requests);
}

void begin_requesting(Attack& attack) {
  msg::PlanRequest request;
  request.id(attack.id);
  // In another's name: the server answers him.
  const auto client = attack.victims.empty() ? attack.id : *msg::id_from_hex(attack.victims.front().partition);
  request.client(client);
  request.robot("good");
  request.unit("forged");
  request.budget(60.0);
  std::vector<msg::Bytes> cancels;
  for (const Victim& victim : attack.victims) {
    msg::CancelRequest cancel;
    cancel.id(victim.request);
    cancel.client(client);
    cancels.push_back(msg::encode(cancel));
  }
  write(attack, Topic::kRequest, "", {msg::encode(request)});
  write(attack, Topic::kCancel, "", std::move(cancels));
}

void begin_serving(Attack& attack) {
  const std::string label = "forged " + msg::to_hex(attack.id);
  msg::ServerInfo server;
  server.key(attack.id);
  server.name(label);
  write(attack, Topic::kServer, "", {msg::encode(server)});
  for (const Victim& victim : attack.victims) {
    msg::Step step;
    step.request(victim.request);
    step.label(label);
    write(attack, Topic::kStep, victim.partition, {msg::encode(step)});
    msg::PlanEvent event;
    event.request(victim.request);
    event.state(msg::FAILED);
    event.error().message(label);
    write(attack, Topic::kEvent, victim.partition, {msg::encode(event)});
  }
}

std::unique_ptr<transport::Bus> open(const std::string& vendor, std::uint32_t domain, const std::string& credentials) {
  void* library = dlopen((std::string(FOOTHOLD_LIBRARIES "/libfoothold_bus_") + vendor + ".so").c_str(), RTLD_NOW);
  if (library == nullptr) throw transport::BusError(dlerror());
  const auto entry = reinterpret_cast<transport::OpenBus>(dlsym(library, "foothold_open_bus_1"));
  return std::unique_ptr<transport::Bus>(
      entry({.vendor = vendor, .domain = domain, .security = credentials == "-" ? std::string() : credentials}));
}

volatile std::sig_atomic_t told_to_end = 0;

void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(100)); }

}  // namespace

int main(int count, char** words) {
  if (count < 6) return 2;
  std::signal(SIGTERM, [](int) { told_to_end = 1; });
  Attack attack;
  const std::string acts = words[4];
  attack.id = *msg::id_from_hex(words[5]);
  for (int i = 6; i < count; ++i) {
    const std::string victim = words[i];
    attack.victims.push_back({victim.substr(0, 32), *msg::id_from_hex(victim.substr(33))});
  }
  try {
    attack.bus = open(words[1], static_cast<std::uint32_t>(std::stoul(words[2])), words[3]);
  } catch (const transport::BusError& error) {
    std::printf("refused at home: %s\n", error.what());
    std::fflush(stdout);
    while (told_to_end == 0) rest();
    std::puts("in all: 0 0 0 0");
    return 0;
  }
  if (acts.find("read") != std::string::npos) begin_reading(attack);
  if (acts.find("request") != std::string::npos) begin_requesting(attack);
  if (acts.find("serve") != std::string::npos) begin_serving(attack);
  std::printf("opened, %u endpoints refused at home\n", attack.refused);
  std::fflush(stdout);
  for (; told_to_end == 0; rest()) {
    for (auto& [writer, messages] : attack.writers)
      for (const msg::Bytes& message : messages)
        if (writer->write(message) == Writer::Result::kSent) ++attack.sent;
    for (auto& [writer, messages] : attack.writers) writer->assert_liveliness();
  }
  std::printf("in all: %u %u %u %u\n", attack.steps.load(), attack.events.load(), attack.requests.load(), attack.sent);
  std::fflush(stdout);
  // The vendors may die at their ends of what they were told: that is nothing to the victims.
  _exit(0);
}
