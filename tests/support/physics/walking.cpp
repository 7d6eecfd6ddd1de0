// A walker as a MuJoCo model with position servos, and its way through a motion.
#include "physics/walking.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "physics/mujoco.hpp"

namespace foothold::physics {
namespace {

constexpr double kBall = 0.01;      // m, radius of a link that has no box
constexpr double kControl = 0.008;  // s, between two targets: a servo bus' cycle

std::string attitude(const Isometry3d& at) {
  const Eigen::Quaterniond q(at.linear());
  std::ostringstream out;
  out.precision(17);
  out << "pos='" << words(at.translation()) << "' quat='" << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << "'";
  return out.str();
}

Vector3d inertia_of(const WalkerLink& link) {
  if (link.boxes.empty()) return Vector3d::Constant(0.4 * link.mass * kBall * kBall);
  const Vector3d squares = link.boxes.front().half.cwiseAbs2();
  return link.mass / 3.0 * (Vector3d::Constant(squares.sum()) - squares);
}

void write_link(std::ostream& out, const Walker& walker, int index, const Isometry3d& base) {
  const WalkerLink& link = walker.links[static_cast<std::size_t>(index)];
  const bool root = index == 0;
  out << "<body name='b" << index << "' " << (root ? attitude(base) : "pos='" + words(link.origin) + "'") << ">";
  if (root)
    out << "<freejoint/>";
  else
    out << "<joint name='j" << index << "' type='hinge' axis='" << words(link.axis) << "'/>";
  out << "<inertial pos='" << words(link.centre_of_mass) << "' mass='" << link.mass << "' diaginertia='" << words(inertia_of(link))
      << "'/>";
  for (const WalkerBox& box : link.boxes)
    out << "<geom type='box' pos='" << words(box.centre) << "' size='" << words(box.half) << "'/>";
  for (std::size_t child = 1; child < walker.links.size(); ++child)
    if (walker.links[child].parent == index) write_link(out, walker, static_cast<int>(child), base);
  out << "</body>";
}

std::string model_xml(const Walker& walker, const Isometry3d& base, const WalkOptions& options) {
  std::ostringstream out;
  out.precision(17);
  const Servo& servo = options.servo;
  out << "<mujoco><compiler autolimits='true' angle='radian'/><option timestep='" << options.timestep << "' " << kContactOptions
      << " solver='Newton' iterations='100' tolerance='1e-10'><flag filterparent='disable'/></option><size nconmax='200' "
         "njmax='1000'/>"
      << "<default><geom condim='3' friction='" << options.friction << " 0 0' " << kContactSolver << "/><joint damping='"
      << servo.damping << "' armature='" << servo.armature << "'/><position kp='" << servo.stiffness << "' forcerange='"
      << -servo.torque << ' ' << servo.torque << "'/></default><worldbody><geom name='floor' type='plane' size='10 10 1'/>";
  write_link(out, walker, 0, base);
  out << "</worldbody><contact>";
  for (const auto& [a, b] : walker.excluded) out << "<exclude body1='b" << a << "' body2='b" << b << "'/>";
  out << "</contact><actuator>";
  for (std::size_t k = 1; k < walker.links.size(); ++k) out << "<position joint='j" << k << "'/>";
  out << "</actuator></mujoco>";
  return out.str();
}

// The engine's numbers of our links' bodies and joints: children come after their parents there, but not in our order.
struct Numbers {
  std::vector<int> body, angle;

  Numbers(const Walker& walker, const mjModel& model) {
    for (std::size_t k = 0; k < walker.links.size(); ++k) {
      body.push_back(mj_name2id(&model, mjOBJ_BODY, ("b" + std::to_string(k)).c_str()));
      if (k > 0) angle.push_back(model.jnt_qposadr[mj_name2id(&model, mjOBJ_JOINT, ("j" + std::to_string(k)).c_str())]);
    }
  }
};

Isometry3d place_of(const mjData& data, int body) {
  Isometry3d out = Isometry3d::Identity();
  out.translation() = Eigen::Map<const Vector3d>(data.xpos + 3 * body);
  out.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.xmat + 9 * body);
  return out;
}

class Play {
 public:
  Play(const Walker& walker, const std::vector<int>& feet, const Isometry3d& base, const VectorXd& first,
       const WalkOptions& options)
      : walker_(walker),
        options_(options),
        model_(compiled(model_xml(walker, base, options))),
        data_(state_of(*model_)),
        numbers_(walker, *model_) {
    for (const int foot : feet) feet_.push_back(numbers_.body[static_cast<std::size_t>(foot)]);
    for (std::size_t k = 0; k < numbers_.angle.size(); ++k) data_->qpos[numbers_.angle[k]] = first[static_cast<int>(k)];
    aim(first);
  }

  void aim(const VectorXd& target) {
    for (int k = 0; k < target.size(); ++k) data_->ctrl[k] = target[k];
  }

  void run(double seconds, Walked& out) {
    const double end = data_->time + seconds - 0.5 * options_.timestep;
    while (data_->time < end) {
      mj_step(model_.get(), data_.get());
      look(out);
    }
  }

  // Targets every cycle of the servo bus, between the postures on both sides.
  void follow(const std::vector<TimedPosture>& motion, Walked& out) {
    const double begin = motion.front().time;
    out.time = motion.back().time - begin;
    const int cycles = static_cast<int>(std::ceil(out.time / kControl));
    std::size_t next = 1;
    for (int k = 1; k <= cycles; ++k) {
      const double now = begin + std::min(k * kControl, out.time);
      while (next + 1 < motion.size() && motion[next].time < now) ++next;
      const TimedPosture &from = motion[next - 1], &to = motion[next];
      const double part = to.time > from.time ? std::min(1.0, (now - from.time) / (to.time - from.time)) : 1.0;
      aim(from.joints + part * (to.joints - from.joints));
      run(kControl, out);
    }
  }

  void finish(Walked& out) {
    mj_forward(model_.get(), data_.get());
    for (const int body : numbers_.body) out.links.push_back(place_of(*data_, body));
    out.base = out.links.front();
    out.speed = Eigen::Map<const Vector3d>(data_->qvel).norm();
  }

 private:
  void look(Walked& out) const {
    const double upright = std::clamp(data_->xmat[9 * numbers_.body.front() + 8], -1.0, 1.0);
    out.greatest_tilt = std::max(out.greatest_tilt, std::acos(upright));
    for (int k = 0; k < model_->nu; ++k) out.torque = std::max(out.torque, std::abs(data_->actuator_force[k]));
    for (int k = 0; k < data_->ncon; ++k) {
      const mjContact& contact = data_->contact[k];
      const int a = model_->geom_bodyid[contact.geom1], b = model_->geom_bodyid[contact.geom2];
      if (a != 0 && b != 0) {
        if (out.touching.empty() || -contact.dist > out.touch) {
          out.touch = -contact.dist;
          out.touching = name_of(a) + " and " + name_of(b);
        }
      } else if (std::find(feet_.begin(), feet_.end(), std::max(a, b)) == feet_.end())
        out.floor = true;
    }
  }

  std::string name_of(int body) const {
    const auto found = std::find(numbers_.body.begin(), numbers_.body.end(), body);
    return walker_.links[static_cast<std::size_t>(found - numbers_.body.begin())].name;
  }

  const Walker& walker_;
  const WalkOptions options_;
  OwnedModel model_;
  OwnedData data_;
  Numbers numbers_;
  std::vector<int> feet_;
};

}  // namespace

bool stands_at(const Walked& walked, const Isometry3d& goal, double distance, double angle) {
  const Isometry3d off = goal.inverse() * walked.base;
  return !walked.fell() && off.translation().norm() <= distance && Eigen::AngleAxisd(off.linear()).angle() <= angle;
}

Walked walk(const Walker& walker, const std::vector<int>& feet, const Isometry3d& base, const JointPath& path,
            const WalkOptions& options) {
  std::vector<TimedPosture> motion;
  for (const VectorXd& posture : path) {
    const bool comparable = !motion.empty() && posture.size() == motion.back().joints.size() && posture.size() > 0;
    const double way = comparable ? (posture - motion.back().joints).cwiseAbs().maxCoeff() : 0.0;
    motion.push_back({(motion.empty() ? 0.0 : motion.back().time) + way / options.speed, posture});
  }
  return walk(walker, feet, base, motion, options);
}

Walked walk(const Walker& walker, const std::vector<int>& feet, const Isometry3d& base, const std::vector<TimedPosture>& motion,
            const WalkOptions& options) {
  if (motion.empty()) throw std::runtime_error("a walk needs a posture to begin with");
  for (const TimedPosture& posture : motion)
    if (static_cast<std::size_t>(posture.joints.size()) + 1 != walker.links.size())
      throw std::runtime_error("a posture of " + std::to_string(posture.joints.size()) + " joints for a walker of " +
                               std::to_string(walker.links.size() - 1));
  Walked out;
  Play play(walker, feet, base, motion.front().joints, options);
  play.run(options.settling, out);
  play.follow(motion, out);
  play.run(options.rest, out);
  play.finish(out);
  return out;
}

}  // namespace foothold::physics
