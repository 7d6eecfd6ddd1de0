// Axes that meet, legs that are mirrored, servos' signs, neighbours.
#include "bioloid/model/structure.hpp"

#include <cmath>

#include "foothold/errors.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kExact = 1e-6;  // m and 1: to which a file has to keep the structure

// What carries each joint; -1: the torso.
int parent_of(std::size_t joint) {
  if (joint < 2 || joint == leg_joint(Side::kRight, 0) || joint == leg_joint(Side::kLeft, 0)) return -1;
  return static_cast<int>(joint) - 2;
}

std::string millimetres(double length) { return std::to_string(1000.0 * std::abs(length)) + " mm"; }

class Structure {
 public:
  Structure(Model& model, const std::string& entry) : model_(model), entry_(entry) {}

  void complete() {
    for (std::size_t j = 0; j < kJoints; ++j) check_joint(j);
    for (const Side side : {Side::kRight, Side::kLeft}) align(side);
    check_mirrored();
    model_.leg_ = {model_.joints[leg_joint(Side::kRight, 3)].origin, model_.joints[leg_joint(Side::kRight, 4)].origin};
    for (const Side side : {Side::kRight, Side::kLeft}) model_.hips_[index_of(side)] = model_.joints[leg_joint(side, 0)].origin;
    for (std::size_t j = 0; j < kJoints; ++j) find_neighbours(j);
  }

 private:
  [[noreturn]] void fail(std::size_t joint, const std::string& reason) const {
    const std::string name = name_at(kJointNames, joint);
    std::string field = entry_;
    if (const auto star = field.find('*'); star != std::string::npos) field.replace(star, 1, name);
    throw InvalidModel(field, reason);
  }

  void check_joint(std::size_t j) const {
    const JointModel& joint = model_.joints[j];
    const int parent = parent_of(j);
    if (joint.parent != parent)
      fail(j, "must be carried by " + (parent < 0 ? "the torso" : name_at(kJointNames, static_cast<std::size_t>(parent))));
    if (!(std::abs(joint.axis.norm() - 1.0) < kExact)) fail(j, "must have an axis of length 1");
    if (joint.limits.empty()) fail(j, "must have a lower limit that is not above its upper one");
    if (!(joint.speed > 0.0)) fail(j, "must have a speed above 0");
  }

  // Hip yaw about Z, roll about X, pitch about Y; knee about Y; ankle pitch about Y, roll about X.
  void align(Side side) {
    static constexpr std::array<int, kLegJoints> kAxes{2, 0, 1, 1, 1, 0};
    std::array<Vector3d, kLegJoints> at;  // where the axes are in the zero pose, in the torso's frame
    for (std::size_t k = 0; k < kLegJoints; ++k) {
      JointModel& joint = model_.joints[leg_joint(side, k)];
      const double along = joint.axis[kAxes[k]];
      if (!(std::abs(std::abs(along) - 1.0) < kExact))
        fail(leg_joint(side, k), std::string("must turn about ") + "XYZ"[kAxes[k]] + " in the zero pose (X forward, Y left, Z up)");
      model_.signs_[index_of(side)][k] = along > 0.0 ? 1.0 : -1.0;
      joint.axis = model_.signs_[index_of(side)][k] * Vector3d::Unit(kAxes[k]);
      at[k] = k == 0 ? joint.origin : Vector3d(at[k - 1] + joint.origin);
    }
    const auto meets = [&](std::size_t k, double off, const char* with) {
      if (!(std::abs(off) < kExact)) fail(leg_joint(side, k), std::string("its axis passes ") + with + " at " + millimetres(off));
    };
    meets(1, at[1].y() - at[0].y(), "the hip's yaw axis");
    meets(2, at[2].x() - at[0].x(), "the hip's yaw axis");
    meets(2, at[2].z() - at[1].z(), "the hip's roll axis");
    meets(5, at[5].y() - at[0].y(), "the plane of hip and knee");
    meets(5, at[5].z() - at[4].z(), "the ankle's pitch axis");
    const double y = at[0].y();
    const Vector3d hip(at[0].x(), y, at[1].z()), knee(at[3].x(), y, at[3].z()), ankle(at[4].x(), y, at[4].z());
    move(side, at, {hip, hip, hip, knee, ankle, ankle});
  }

  // Moves each joint's frame along its axis from `from` to `to`.
  void move(Side side, const std::array<Vector3d, kLegJoints>& from, const std::array<Vector3d, kLegJoints>& to) {
    for (std::size_t k = 0; k < kLegJoints; ++k) {
      const std::size_t j = leg_joint(side, k);
      const Vector3d shift = to[k] - from[k];
      model_.joints[j].origin = k == 0 ? to[k] : Vector3d(to[k] - to[k - 1]);
      Body& body = model_.bodies[j + 1];
      body.centre_of_mass -= shift;
      for (BodyBox& box : body.boxes) box.centre -= shift;
      if (k + 1 == kLegJoints && side == Side::kRight) model_.ankle_to_sole -= shift;
    }
  }

  void check_mirrored() const {
    for (std::size_t k = 0; k < kLegJoints; ++k) {
      const Vector3d& right = model_.joints[leg_joint(Side::kRight, k)].origin;
      const Vector3d& left = model_.joints[leg_joint(Side::kLeft, k)].origin;
      const double off = (Vector3d(right.x(), -right.y(), right.z()) - left).norm();
      if (!(off < kExact)) fail(leg_joint(Side::kLeft, k), "is not the right side's mirrored: off by " + millimetres(off));
    }
  }

  void find_neighbours(std::size_t j) {
    const auto mark = [&](std::size_t a, std::size_t b) {
      model_.neighbours_[a].set(b);
      model_.neighbours_[b].set(a);
    };
    const JointModel& joint = model_.joints[j];
    mark(0, 0);
    mark(j + 1, j + 1);
    mark(j + 1, static_cast<std::size_t>(joint.parent + 1));
    if (joint.parent < 0) return;
    const JointModel& carrier = model_.joints[static_cast<std::size_t>(joint.parent)];
    const Vector3d across = carrier.axis.cross(joint.axis);
    if (across.norm() > kExact && std::abs(across.normalized().dot(joint.origin)) < kExact)
      mark(j + 1, static_cast<std::size_t>(carrier.parent + 1));
  }

  Model& model_;
  const std::string& entry_;
};

}  // namespace

void complete(Model& model, const std::string& entry) { Structure(model, entry).complete(); }

}  // namespace foothold::bioloid
