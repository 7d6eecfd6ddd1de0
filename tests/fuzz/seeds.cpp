// foothold-fuzz-seeds FOLDER: what each fuzz target begins with, in FOLDER/<target>/: the files of config/, and messages, frames
// and journals with random contents. The same at each call.
#include <worker.h>
#include <zlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>

#include "another_biped.hpp"
#include "certificate.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/client/whole_file.hpp"
#include "foothold/msg/cdr.hpp"
#include "frames/frames.hpp"
#include "journal/entry.hpp"
#include "random_message.hpp"
#include "signing.hpp"

namespace {

using namespace foothold;
namespace fs = std::filesystem;

constexpr int kEach = 12;                   // messages of a kind
constexpr std::size_t kLargest = 8u << 10;  // octets: a larger seed makes each run slow and finds no more
constexpr test::RandomLimits kSmall{3, 8};

class Seeds {
 public:
  explicit Seeds(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& target, const std::string& name, std::string_view octets) {
    if (octets.size() > kLargest) return;
    fs::create_directories(folder_ / target);
    std::ofstream out(folder_ / target / name, std::ios::binary | std::ios::trunc);
    out << octets;
    if (!out.flush()) throw std::runtime_error((folder_ / target / name).string() + " cannot be written");
  }
  void add(const std::string& target, const std::string& name, char first, std::span<const std::byte> octets) {
    add(target, name, std::string(1, first) + std::string(reinterpret_cast<const char*>(octets.data()), octets.size()));
  }
  // Every .yaml file of a folder, without its comments: most of what they are, and nothing that a parser looks into.
  void add_files(const std::string& target, const fs::path& from) {
    static const std::regex kComment(" *#[^\n]*"), kEmpty("\n+");
    for (const auto& entry : fs::directory_iterator(from))
      if (entry.path().extension() == ".yaml")
        add(target, entry.path().filename().string(),
            std::regex_replace(std::regex_replace(client::read_whole_file(entry.path().string()), kComment, ""), kEmpty, "\n"));
  }

 private:
  fs::path folder_;
};

void add_files(Seeds& seeds, const fs::path& config) {
  seeds.add_files("server_config", config);
  seeds.add_files("robot_files", config / "robots");
  for (const char* target : {"plane_scene", "truss", "terrain", "stored_yaml"}) seeds.add_files(target, config / "scenes");
  seeds.add_files("request_file", config / "requests");
  seeds.add("terrain", "step.yaml",
            "kind: terrain\ndescription: \"a step\"\n"
            "vertices: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [1, 0, 0.2], [1, 1, 0.2], [2, 0, 0.2], [2, 1, 0.3]]\n"
            "triangles: [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2], [4, 6, 7], [4, 7, 5]]\n");
  seeds.add("mesh", "cube.obj",
            std::string("\1") +
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\nf 5 6 7 8\n"
                "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  seeds.add("mesh", "ground.ply",
            std::string("\2") +
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0.2\n0 1 0.1\n"
                "3 0 1 2\n3 0 2 3\n");
  seeds.add("mesh", "text.stl",
            std::string("\0", 1) +
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                "endfacet\nendsolid a\n");
  std::string binary(85, '\0');
  binary[81] = 1;  // one triangle, behind the first octet, which chooses the format
  const float triangle[] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  binary.append(reinterpret_cast<const char*>(triangle), sizeof triangle).append(2, '\0');
  seeds.add("mesh", "binary.stl", binary);
  for (const char* text :
       {"250 ms", "7 d", "1.5 GiB", "-3", "0x1p3", "true", "cde", "00112233445566778899aabbccddeeff", "a\nb\n\n\x01"})
    seeds.add("texts", std::to_string(std::hash<std::string>{}(text) % 1000), text);
}

template <class Message>
void add_messages(Seeds& seeds, const std::string& target, char topic, const std::string& name) {
  for (int k = 0; k < kEach; ++k)
    seeds.add(target, name + std::to_string(k), topic,
              msg::encode(test::RandomContents(static_cast<std::uint64_t>(k), kSmall).make<Message>()));
}

// A message of random contents as the frame of its kind, at the end of a stream.
template <class Message>
void add_frame(std::string& stream, frame::WorkerFrame kind, const Message& message) {
  msg::Bytes octets;
  server::encode_frame(kind, 7, message, octets);
  stream.append(reinterpret_cast<const char*>(octets.data()), octets.size());
}

void add_streams(Seeds& seeds) {
  for (int k = 0; k < kEach; ++k) {
    test::RandomContents random(static_cast<std::uint64_t>(k), kSmall);
    frame::Load load;
    load.robot("robot");
    load.plugin_path("/plugins/robot.so");
    load.model().emplace_back();
    load.model().back().path("leg.length");
    load.model().back().values({0.1, 0.2});
    load.model().back().unit("m");
    frame::Plan plan;
    plan.request(random.make<msg::PlanRequest>());
    plan.budget_left(1.5);
    frame::Ready ready;
    ready.info(random.make<msg::RobotInfo>());
    frame::Refused refused;
    refused.reason(random.make<msg::Error>());
    frame::SceneShapes shapes;
    shapes.shapes({random.make<msg::Shape>()});
    frame::Report report;
    report.state(msg::SUCCEEDED);
    report.summary(random.make<msg::Summary>());
    std::string down(1, static_cast<char>(k * 17)), up(1, '\xff');
    add_frame(down, frame::LOAD, load);
    add_frame(down, frame::PLAN, plan);
    add_frame(up, frame::READY, ready);
    add_frame(up, frame::REFUSED, refused);
    add_frame(up, frame::SCENE, shapes);
    add_frame(up, frame::STEP, random.make<msg::Step>());
    add_frame(up, frame::REPORT, report);
    seeds.add("worker_frames", "down" + std::to_string(k), down);
    seeds.add("worker_frames", "up" + std::to_string(k), up);
  }
}

void add_journals(Seeds& seeds) {
  for (int k = 0; k < kEach; ++k) {
    test::RandomContents random(static_cast<std::uint64_t>(k), kSmall);
    const auto request = random.make<msg::PlanRequest>();
    msg::Bytes batch;
    const auto add = [&](server::Entry::Kind kind, const msg::Bytes& body) {
      server::append_entry(batch, {kind, request.id(), k, body});
    };
    add(server::Entry::Kind::kRequest, msg::encode(request));
    add(server::Entry::Kind::kStep, msg::encode(random.make<msg::Step>()));
    add(server::Entry::Kind::kScene, msg::encode(random.make<msg::PlanEvent>()));
    add(server::Entry::Kind::kEnding, msg::encode(random.make<msg::PlanEvent>()));
    const std::string octets(reinterpret_cast<const char*>(batch.data()), batch.size());
    seeds.add("journal_rows", "batch" + std::to_string(k), octets);
    seeds.add("bundle", "batch" + std::to_string(k), octets);
    const std::uint32_t header[] = {
        static_cast<std::uint32_t>(batch.size()),
        static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const unsigned char*>(octets.data()), octets.size()))};
    seeds.add("journal_log", "log" + std::to_string(k), std::string(reinterpret_cast<const char*>(header), sizeof header) + octets);
    client::PlanRecord plan;
    plan.request = request;
    plan.final_event = random.make<msg::PlanEvent>();
    plan.scene = {random.make<msg::Shape>()};
    plan.steps = {random.make<msg::Step>()};
    seeds.add("plan_file", "plan" + std::to_string(k), client::plan_to_json(plan));
  }
}

void add_credentials(Seeds& seeds) {
  security::Key key = security::new_key();
  const auto text = [](char kind, const std::string& pem) { return std::string(1, kind) + pem; };
  seeds.add("credentials", "key.pem", text(1, security::pem(key.get())));
  security::Certificate certificate = security::authority_certificate(key.get(), 86400.0);
  const security::Authority authority{std::move(key), std::move(certificate)};
  seeds.add("credentials", "authority.crt", text(0, security::pem(authority.certificate.get())));
  security::Key identity = security::new_key();
  const auto issued = security::identity_certificate(authority, identity.get(), {"arm", "client", "cyclone"}, 3600.0);
  seeds.add("credentials", "identity.crt", text(0, security::pem(issued.get())));
  const auto revoked = security::with(authority, security::new_revocations(authority).get(), {issued.get()});
  seeds.add("credentials", "revoked.crl", text(2, security::pem(revoked.get())));
  seeds.add("credentials", "document.p7s", text(3, security::sign(authority, "<dds></dds>")));
}

void add_http(Seeds& seeds) {
  seeds.add("http", "metrics", "GET /metrics?name=a HTTP/1.1\r\nHost: 127.0.0.1:9747\r\nAccept: text/plain\r\n\r\n");
  seeds.add("http", "head", "HEAD /healthz HTTP/1.0\r\nConnection: keep-alive\r\n\r\n");
  seeds.add("http", "body", "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\nExpect: 100-continue\r\n\r\n5\r\nhello\r\n0\r\n\r\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "foothold-fuzz-seeds FOLDER\n";
    return 64;
  }
  Seeds seeds(argv[1]);
  add_files(seeds, FOOTHOLD_CONFIG);
  add_messages<msg::PlanRequest>(seeds, "client_messages", 0, "request");
  add_messages<msg::CancelRequest>(seeds, "client_messages", 1, "cancel");
  add_messages<msg::StateQuery>(seeds, "client_messages", 2, "query");
  add_messages<msg::SceneChunk>(seeds, "client_messages", 3, "scene");
  add_messages<msg::PlanEvent>(seeds, "server_messages", 0, "event");
  add_messages<msg::Step>(seeds, "server_messages", 1, "step");
  add_messages<msg::SceneStatus>(seeds, "server_messages", 2, "scene_status");
  add_messages<msg::RobotInfo>(seeds, "server_messages", 3, "robot");
  add_messages<msg::ServerInfo>(seeds, "server_messages", 4, "server");
  add_streams(seeds);
  add_journals(seeds);
  // Limbs without bodies: half as long.
  static const std::regex kBodies("(<link name='[rl]_[a-z_]*')>.*</link>");
  seeds.add("urdf", "by_hand.urdf", std::regex_replace(bioloid::testing::biped_by_hand(), kBodies, "$1/>"));
  add_credentials(seeds);
  add_http(seeds);
  return 0;
}
