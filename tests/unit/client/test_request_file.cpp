// Request files: what is meant is read, what is malformed is refused with file, line and field.
#include "foothold/client/request_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace foothold::test {
namespace {

using client::read_request;
using client::RequestFile;
using client::RequestFileError;

TEST(RequestFile, ReadsEveryField) {
  const RequestFile file = read_request(R"(
robot: hyrecro
unit: yard-3
scene: {name: beams, revision: 9f86d081}
start:
  base: {position: [0, -1.5e-1, +0.1], heading_deg: 90}
  joints: [0.1, -0.2]
goal:
  contacts:
    - {limb: left, position: [1, 0, 0], rpy_deg: [0, 180, 0], face: top}
    - {limb: right, position: [2, 0, 0], orientation: [0.6, 0, 0, 0.8]}
  base: {position: [1, 2, 3]}
  any_orientation: true
budget: 2.5
priority: -3
seed: 18446744073709551615
parameters: {method: optimal, cycles: 7, early: true}
shapes: true
resume: true
)",
                                        "requests/r.yaml");
  const msg::PlanRequest& request = file.request;
  EXPECT_EQ(request.robot(), "hyrecro");
  EXPECT_EQ(request.unit(), "yard-3");
  EXPECT_EQ(request.scene(), "beams");
  EXPECT_EQ(request.scene_revision(), "9f86d081");
  EXPECT_EQ(file.scene_file, "");
  ASSERT_EQ(request.start().base().size(), 1u);
  EXPECT_EQ(request.start().base()[0].position().y(), -0.15);
  EXPECT_DOUBLE_EQ(request.start().base()[0].orientation().w(), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(request.start().base()[0].orientation().z(), std::sqrt(0.5));
  EXPECT_EQ(request.start().joints(), (std::vector<double>{0.1, -0.2}));
  ASSERT_EQ(request.goal().contacts().size(), 2u);
  EXPECT_EQ(request.goal().contacts()[0].limb(), "left");
  EXPECT_EQ(request.goal().contacts()[0].face(), "top");
  EXPECT_DOUBLE_EQ(request.goal().contacts()[0].frame().orientation().y(), 1.0);
  EXPECT_EQ(request.goal().contacts()[1].frame().orientation().z(), 0.8);
  EXPECT_TRUE(request.goal().any_orientation());
  EXPECT_EQ(request.goal().base()[0].orientation().w(), 1.0);
  EXPECT_EQ(request.budget(), 2.5);
  EXPECT_EQ(request.priority(), -3);
  EXPECT_EQ(request.seed(), 18446744073709551615u);
  ASSERT_EQ(request.parameters().size(), 3u);
  EXPECT_EQ(request.parameters()[1].name(), "cycles");
  EXPECT_EQ(request.parameters()[1].value(), "7");
  EXPECT_EQ(request.parameters()[2].value(), "true");
  EXPECT_TRUE(request.shapes());
  EXPECT_TRUE(request.resume());
}

TEST(RequestFile, SceneFilesAreRelativeToTheRequestAndNamedByTheirStem) {
  const RequestFile file = read_request("robot: a\nscene: {file: ../scenes/beams.yaml}\ngoal: {}\n", "config/requests/r.yaml");
  EXPECT_EQ(file.scene_file, "config/scenes/beams.yaml");
  EXPECT_EQ(file.request.scene(), "beams");
}

TEST(RequestFile, RollPitchYawTurnAboutFixedAxes) {
  const auto request = read_request("robot: a\ngoal: {base: {position: [0, 0, 0], rpy_deg: [90, 0, 90]}}\n", "r.yaml").request;
  const msg::Quaternion& q = request.goal().base()[0].orientation();
  // First z to -y about x, then -y to x about z: the body's z axis ends along world x.
  const double z_axis_x = 2.0 * (q.x() * q.z() + q.w() * q.y());
  EXPECT_NEAR(z_axis_x, 1.0, 1e-15);
}

TEST(RequestFile, WithoutAGoalItIsTheServersToSayWhetherTheRobotNeedsOne) {
  const RequestFile file = read_request("robot: a\nstart: {base: {position: [0, 0, 0], heading_deg: 0}}\n", "r.yaml");
  EXPECT_TRUE(file.request.goal().base().empty());
  EXPECT_TRUE(file.request.goal().contacts().empty());
}

TEST(RequestFile, AContactMayLeaveItsLimbAndFaceToTheServer) {
  const auto request = read_request("robot: a\ngoal: {contacts: [{position: [1, 0, 0], heading_deg: 0}]}\n", "r.yaml").request;
  ASSERT_EQ(request.goal().contacts().size(), 1u);
  EXPECT_EQ(request.goal().contacts()[0].limb(), "");
  EXPECT_EQ(request.goal().contacts()[0].face(), "");
}

struct Malformed {
  const char* text;
  const char* error;
};

class RequestFileRefusal : public testing::TestWithParam<Malformed> {};

TEST_P(RequestFileRefusal, NamesLineFieldAndReason) {
  try {
    read_request(GetParam().text, "r.yaml");
    FAIL() << "accepted: " << GetParam().text;
  } catch (const RequestFileError& error) {
    EXPECT_STREQ(error.what(), GetParam().error);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RequestFileRefusal,
    testing::Values(
        Malformed{"", "r.yaml:1: the file is empty"},
        Malformed{"robot: [a\ngoal: {}\n", "r.yaml:2: not YAML: end of sequence flow not found"},
        Malformed{"- robot\n", "r.yaml:1: expected keys with values"}, Malformed{"goal: {}\n", "r.yaml:1: robot: is missing"},
        Malformed{"robot: a\ngoal: {}\nbugdet: 5\n", "r.yaml:3: bugdet: is not known; did you mean 'budget'?"},
        Malformed{"robot: a\ngoal: {}\nrobot: b\n", "r.yaml:3: 'robot' is given twice"},
        Malformed{"robot: [a]\ngoal: {}\n", "r.yaml:1: robot: expected text"},
        Malformed{"robot: ''\ngoal: {}\n", "r.yaml:1: robot: is empty"},
        Malformed{"robot: a\ngoal: {}\nbudget: soon\n", "r.yaml:3: budget: expected a number, not 'soon'"},
        Malformed{"robot: a\ngoal: {}\nbudget: 0\n", "r.yaml:3: budget: expected seconds above 0"},
        Malformed{"robot: a\ngoal: {}\nbudget: inf\n", "r.yaml:3: budget: expected a finite number, not 'inf'"},
        Malformed{"robot: a\ngoal: {}\nbudget: 5 s\n", "r.yaml:3: budget: expected a number, not '5 s'"},
        Malformed{"robot: a\ngoal: {}\nseed: -1\n", "r.yaml:3: seed: expected an integer of 0 or more, not '-1'"},
        Malformed{"robot: a\ngoal: {}\npriority: 1.5\n", "r.yaml:3: priority: expected an integer, not '1.5'"},
        Malformed{"robot: a\ngoal: {}\npriority: 3000000000\n",
                  "r.yaml:3: priority: 3000000000 is not between -2147483648 and 2147483647"},
        Malformed{"robot: a\ngoal: {}\nshapes: yes\n", "r.yaml:3: shapes: expected true or false, not 'yes'"},
        Malformed{"robot: a\ngoal: {}\nparameters: {cycles: [7]}\n", "r.yaml:3: parameters.cycles: expected one value"},
        Malformed{"robot: a\ngoal: {}\nparameters: {a: 1, a: 2}\n", "r.yaml:3: parameters: 'a' is given twice"},
        Malformed{"robot: a\ngoal: {}\nscene: beams.yaml\n",
                  "r.yaml:3: scene: 'beams.yaml' looks like a file: write scene: {file: beams.yaml}"},
        Malformed{"robot: a\ngoal: {}\nscene: {revision: 12}\n", "r.yaml:3: scene: give a name or a file"},
        Malformed{"robot: a\ngoal: {}\nscene: {file: a.yaml, revision: 12}\n",
                  "r.yaml:3: scene: file and revision exclude each other: a file has the revision that it has"},
        Malformed{"robot: a\ngoal:\n  base: {position: [1, 2]}\n  any_orientation: true\n",
                  "r.yaml:3: goal.base.position: expected [x, y, z], not 2 numbers"},
        Malformed{"robot: a\ngoal:\n  base:\n    position: [1, 2, x]\n    heading_deg: 0\n",
                  "r.yaml:4: goal.base.position[2]: expected a number, not 'x'"},
        Malformed{"robot: a\ngoal:\n  base:\n    position: [1, 2, 3]\n",
                  "r.yaml:4: goal.base: orientation is missing: give orientation [w, x, y, z], rpy_deg [roll, pitch, yaw] or "
                  "heading_deg"},
        Malformed{"robot: a\ngoal:\n  base:\n    position: [1, 2, 3]\n    orientation: [1, 0.1, 0, 0]\n",
                  "r.yaml:5: goal.base.orientation: a quaternion of length 1.004988, not 1: give more digits, or rpy_deg"},
        Malformed{"robot: a\ngoal:\n  base: {position: [1, 2, 3], heading_deg: 0, rpy_deg: [0, 0, 0]}\n",
                  "r.yaml:3: goal.base: orientation, rpy_deg and heading_deg exclude each other"},
        Malformed{"robot: a\ngoal:\n  any_orientation: true\n",
                  "r.yaml:3: goal: any_orientation says something about base, which is missing"},
        Malformed{"robot: a\ngoal:\n  base: {heading_deg: 0}\n", "r.yaml:3: goal.base.position: is missing"},
        Malformed{"robot: a\ngoal: {}\nstart:\n  contacts:\n    - {limb: left, position: [0, 0, 0], orientatoin: [1, 0, 0, 0]}\n",
                  "r.yaml:5: start.contacts[0].orientatoin: is not known; did you mean 'orientation'?"},
        Malformed{"robot: a\ngoal: {}\nstart:\n  contacts: {limb: left}\n", "r.yaml:4: start.contacts: expected a list"},
        Malformed{"robot: a\ngoal:\n  joints: [0.1, true]\n", "r.yaml:3: goal.joints[1]: expected a number, not 'true'"},
        Malformed{"robot: a\ngoal: north\n", "r.yaml:2: goal: expected keys with values"}));

TEST(RequestFile, SaysWhyAFileCannotBeRead) {
  try {
    client::read_request_file("/nowhere/r.yaml");
    FAIL();
  } catch (const RequestFileError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/r.yaml: cannot be read: No such file or directory");
  }
  EXPECT_THROW(client::read_request_file("/"), RequestFileError);
}

}  // namespace
}  // namespace foothold::test
