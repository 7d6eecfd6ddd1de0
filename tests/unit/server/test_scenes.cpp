// Scenes on their way in: chunks in any order, every refusal with its field, files kept by hash and known by name.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "fakes.hpp"
#include "scenes/keeping.hpp"
#include "scenes/scenes.hpp"
#include "temporary_folder.hpp"

namespace foothold::server::testing {
namespace {

using test::TemporaryFolder;

const std::string kYaml = "ground:\n  polygon: [[0, 0], [1, 0], [1, 1]]\n";

class ScenesTest : public ::testing::Test {
 protected:
  ScenesTest() { open(); }

  void open() {
    scenes_.emplace(ScenesOptions{.server = kServer, .folder = folder_ / "scenes", .max_bytes = 1 << 20}, clock_);
    scenes_->open({.tell = [this](msg::SceneStatus status) { told_.push_back(std::move(status)); },
                   .background =
                       [](const std::function<void()>& work, const std::function<void()>& then) {
                         work();
                         then();
                       }});
  }

  static msg::SceneChunk chunk(const std::string& file, std::size_t offset, std::size_t size, const std::string& upload = "upload",
                               const std::string& name = "yard") {
    msg::SceneChunk c;
    c.upload(msg::id_of(upload));
    c.client(World::kClient);
    c.name(name);
    c.format("yaml");
    c.revision(msg::sha256_hex(file));
    c.size(file.size());
    c.offset(offset);
    const std::string data = file.substr(offset, size);
    c.data().assign(data.begin(), data.end());
    return c;
  }
  void put(const std::string& file, const std::string& upload, const std::string& name = "yard") {
    scenes_->take(chunk(file, 0, file.size(), upload, name));
  }
  std::string stored(const std::string& name, const std::string& revision = {}) const {
    const auto scene = scenes_->find(name, revision);
    if (!scene) return "";
    std::ifstream in(scene->path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  static inline const Id kServer = msg::id_of("server");
  TemporaryFolder folder_;
  FakeClock clock_;
  std::vector<msg::SceneStatus> told_;
  std::optional<Scenes> scenes_;
};

TEST_F(ScenesTest, P26ChunksMayComeInAnyOrderAndTwice) {
  std::mt19937 random(3);
  std::string file = "words:\n";
  while (file.size() < 50'000) file += "- " + std::to_string(random()) + "\n";
  std::vector<msg::SceneChunk> chunks;
  for (std::size_t at = 0; at < file.size(); at += 777) chunks.push_back(chunk(file, at, 777));
  const auto once = chunks;
  for (std::size_t i = 0; i < once.size(); i += 3) chunks.push_back(once[i]);
  std::shuffle(chunks.begin(), chunks.end(), random);
  for (const auto& c : chunks) scenes_->take(c);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].state(), msg::STORED) << told_[0].error().message();
  EXPECT_EQ(told_[0].upload(), msg::id_of("upload"));
  EXPECT_EQ(told_[0].revision(), msg::sha256_hex(file));
  EXPECT_EQ(stored("yard"), file);
}

TEST_F(ScenesTest, P26OverlappingChunksMakeTheFileToo) {
  for (const auto& [offset, size] : {std::pair<std::size_t, std::size_t>{20, 10}, {0, 5}, {3, 20}, {25, 100}})
    scenes_->take(chunk(kYaml, offset, size));
  EXPECT_EQ(stored("yard"), kYaml);
}

TEST_F(ScenesTest, P26TheNewestRevisionIsTheOneStoredLast) {
  const std::string other = kYaml + "# newer\n";
  put(kYaml, "1");
  clock_.advance(1);
  put(other, "2");
  EXPECT_EQ(stored("yard"), other);
  EXPECT_EQ(stored("yard", msg::sha256_hex(kYaml)), kYaml);
  clock_.advance(1);
  put(kYaml, "3");
  EXPECT_EQ(stored("yard"), kYaml) << "the old one again";
  open();
  EXPECT_EQ(stored("yard"), kYaml) << "after a restart, too";
}

TEST_F(ScenesTest, P26TheSameFileUnderTwoNamesIsStoredOnce) {
  put(kYaml, "1", "yard");
  put(kYaml, "2", "court");
  EXPECT_EQ(scenes_->find("yard", "")->path, scenes_->find("court", "")->path);
  EXPECT_NE(told_[0].key(), told_[1].key());
}

TEST_F(ScenesTest, StoredScenesAreToldAgainAtTheNextStart) {
  put(kYaml, "1");
  const auto before = told_[0];
  told_.clear();
  open();
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].key(), before.key());
  EXPECT_EQ(told_[0].revision(), before.revision());
  EXPECT_EQ(told_[0].upload(), msg::kNoId);
}

TEST_F(ScenesTest, AFileThatIsGoneIsNotAStoredScene) {
  put(kYaml, "1");
  std::filesystem::remove(scenes_->find("yard", "")->path);
  open();
  EXPECT_FALSE(scenes_->knows("yard"));
}

TEST_F(ScenesTest, P27ChunksThatStopComingAreSceneIncomplete) {
  scenes_->take(chunk(kYaml, 0, 10));
  EXPECT_EQ(*scenes_->next_deadline(), clock_.now() + Scenes::kPatience);
  clock_.advance(9.0);
  scenes_->take(chunk(kYaml, 20, 5));
  clock_.advance(9.9);
  scenes_->tick();
  EXPECT_TRUE(told_.empty());
  clock_.advance(0.2);
  scenes_->tick();
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].error().code(), msg::SCENE_INCOMPLETE);
  EXPECT_NE(told_[0].error().message().find("has only 15 of"), std::string::npos) << told_[0].error().message();
  EXPECT_NE(told_[0].error().message().find("first missing at offset 10"), std::string::npos);
  EXPECT_FALSE(scenes_->next_deadline());
}

TEST_F(ScenesTest, AnotherServersUploadIsLeftAlone) {
  auto c = chunk(kYaml, 0, kYaml.size());
  c.server(msg::id_of("another"));
  scenes_->take(c);
  EXPECT_TRUE(told_.empty());
  c.server(kServer);
  scenes_->take(c);
  EXPECT_EQ(told_.size(), 1U);
}

TEST_F(ScenesTest, KeysOfRefusalsGoRound) {
  std::set<Id> keys;
  for (int i = 0; i < 500; ++i) {
    auto c = chunk(kYaml, 0, 1, std::to_string(i));
    c.format("dwg");
    scenes_->take(c);
  }
  for (const auto& status : told_) keys.insert(status.key());
  EXPECT_EQ(told_.size(), 500U);
  EXPECT_EQ(keys.size(), Scenes::kRefusedKeys);
}

TEST_F(ScenesTest, ARefusedUploadIsRefusedOnceWhateverElseComesOfIt) {
  auto c = chunk(kYaml, 0, 5);
  c.format("dwg");
  for (int i = 0; i < 5; ++i) scenes_->take(c);
  scenes_->take(chunk(kYaml, 0, kYaml.size()));
  EXPECT_EQ(told_.size(), 1U);
  EXPECT_FALSE(scenes_->knows("yard"));
}

TEST_F(ScenesTest, SoManyUploadsAtATimeAndNoMore) {
  for (std::size_t i = 0; i <= Scenes::kMostUploads; ++i) scenes_->take(chunk(kYaml, 0, 5, std::to_string(i)));
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].error().code(), msg::QUEUE_FULL);
  EXPECT_GT(told_[0].error().retry_after(), 0.0);
}

struct Spoilt {
  const char* name;
  std::function<void(msg::SceneChunk&)> spoil;
  std::uint16_t code;
  const char* field;
};

class RefusedScenes : public ScenesTest, public ::testing::WithParamInterface<Spoilt> {};

TEST_P(RefusedScenes, NameTheField) {
  auto c = chunk(kYaml, 0, kYaml.size());
  GetParam().spoil(c);
  scenes_->take(c);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].state(), msg::REFUSED);
  EXPECT_EQ(told_[0].error().name(), msg::make_error(GetParam().code, "").name());
  EXPECT_EQ(told_[0].error().field(), GetParam().field);
  EXPECT_NE(told_[0].error().message().find(GetParam().field), std::string::npos) << told_[0].error().message();
  EXPECT_FALSE(scenes_->knows("yard"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "scenes/incoming")) << "nothing is left behind";
}

// Another whole file under the same label, with its true hash.
std::function<void(msg::SceneChunk&)> file(const std::string& text) {
  return [=](msg::SceneChunk& c) {
    c.data().assign(text.begin(), text.end());
    c.size(text.size());
    c.revision(msg::sha256_hex(text));
  };
}

INSTANTIATE_TEST_SUITE_P(
    P27, RefusedScenes,
    ::testing::Values(Spoilt{"NoUpload", [](auto& c) { c.upload(msg::kNoId); }, msg::MALFORMED, "upload"},
                      Spoilt{"NoClient", [](auto& c) { c.client(msg::kNoId); }, msg::MALFORMED, "client"},
                      Spoilt{"NoName", [](auto& c) { c.name(""); }, msg::MALFORMED, "name"},
                      Spoilt{"NameTooLong", [](auto& c) { c.name(std::string(65, 'n')); }, msg::MALFORMED, "name"},
                      Spoilt{"NameNotText", [](auto& c) { c.name("ya\nrd"); }, msg::MALFORMED, "name"},
                      Spoilt{"Format", [](auto& c) { c.format("dwg"); }, msg::SCENE_FORMAT, "format"},
                      Spoilt{"Revision", [](auto& c) { c.revision("abc"); }, msg::MALFORMED, "revision"},
                      Spoilt{"SizeZero", [](auto& c) { c.size(0); }, msg::MALFORMED, "size"},
                      Spoilt{"SizeTooLarge", [](auto& c) { c.size((1 << 20) + 1); }, msg::SCENE_TOO_LARGE, "size"},
                      Spoilt{"NoData", [](auto& c) { c.data().clear(); }, msg::MALFORMED, "data"},
                      Spoilt{"DataTooLarge", [](auto& c) { c.data().resize(65537), c.size(100000); }, msg::MALFORMED, "data"},
                      Spoilt{"OffsetBeyondTheEnd", [](auto& c) { c.offset(1); }, msg::MALFORMED, "offset"},
                      Spoilt{"OffsetThatOverflows", [](auto& c) { c.offset(~0ULL - 3); }, msg::MALFORMED, "offset"},
                      Spoilt{"Hash", [](auto& c) { c.revision(std::string(64, 'a')); }, msg::SCENE_HASH_MISMATCH, "revision"},
                      Spoilt{"NotYaml", file("a: 1\nb: [1, 2\nc: 3\n"), msg::INVALID_SCENE, "line 3"},
                      Spoilt{"YamlTabs", file("a:\n\t- 1\n"), msg::INVALID_SCENE, "line 2"},
                      Spoilt{"YamlEmpty", file("# nothing\n"), msg::INVALID_SCENE, "line 1"}),
    [](const auto& tested) { return tested.param.name; });

TEST_F(ScenesTest, P27WhatDiffersFromTheFirstChunkIsNamed) {
  const std::vector<std::pair<const char*, std::function<void(msg::SceneChunk&)>>> differences = {
      {"name", [](auto& c) { c.name("court"); }},
      {"format", [](auto& c) { c.format("stl"); }},
      {"revision", [](auto& c) { c.revision(std::string(64, 'a')); }},
      {"size", [](auto& c) { c.size(1000); }}};
  for (const auto& [field, spoil] : differences) {
    told_.clear();
    scenes_->take(chunk(kYaml, 0, 5, field));
    auto c = chunk(kYaml, 5, 5, field);
    spoil(c);
    scenes_->take(c);
    ASSERT_EQ(told_.size(), 1U) << field;
    EXPECT_EQ(told_[0].error().field(), field);
    EXPECT_EQ(told_[0].name(), "yard") << "what the first chunk said";
  }
}

TEST_F(ScenesTest, AFolderIsPreloadedByStemAndFaultsAreToldWithTheFile) {
  const TemporaryFolder shipped;
  std::ofstream(shipped / "yard.yaml") << kYaml;
  std::ofstream(shipped / "rock.stl") << "solid rock\nendsolid rock\n";
  std::ofstream(shipped / "broken.yaml") << "a: [\n";
  std::ofstream(shipped / "README.txt") << "not a scene";
  const auto complaints = scenes_->preload(shipped.path().string());
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_NE(complaints[0].find("broken.yaml: line 2"), std::string::npos) << complaints[0];
  EXPECT_EQ(stored("yard"), kYaml);
  EXPECT_EQ(scenes_->find("rock", "")->format, "stl");
  EXPECT_FALSE(scenes_->knows("README"));
  const Stamp first = scenes_->find("yard", "")->stamp;
  clock_.advance(5);
  scenes_->preload(shipped.path().string());
  EXPECT_EQ(scenes_->find("yard", "")->stamp, first) << "what is stored already stays";
  EXPECT_EQ(scenes_->preload(shipped / "none").size(), 1U);
}

TEST_F(ScenesTest, WhatChangedInAPreloadedFolderIsStoredAndToldWhileServing) {
  TemporaryFolder shipped;
  std::ofstream(shipped / "same.yaml") << kYaml;
  std::ofstream(shipped / "other.yaml") << kYaml;
  scenes_->preload(shipped.path().string());
  std::ofstream(shipped / "other.yaml") << kYaml << "newer: true\n";
  std::ofstream(shipped / "new.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(shipped / "faulty.yaml") << "a: [";
  std::ofstream(shipped / "large.yaml") << std::string(2 << 20, '#');
  std::vector<std::string> complaints;
  scenes_->preload_again(shipped.path().string(), [&](const std::string& text) { complaints.push_back(text); });
  EXPECT_EQ(stored("other"), kYaml + "newer: true\n");
  EXPECT_TRUE(scenes_->knows("new"));
  ASSERT_EQ(told_.size(), 2U) << "what is the same is not told again";
  EXPECT_EQ(told_[0].state(), msg::STORED);
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_NE(complaints[0].find("large.yaml: must have 1 to 1048576 octets"), std::string::npos) << complaints[0];
  EXPECT_NE(complaints[1].find("faulty.yaml: "), std::string::npos) << complaints[1];
}

}  // namespace
}  // namespace foothold::server::testing
