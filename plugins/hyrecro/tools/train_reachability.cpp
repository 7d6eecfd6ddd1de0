// foothold-hyrecro-train: makes a weights file of the reachability networks. Labels random poses by exact reachability, trains a
// perceptron on them, measures it on fresh ones.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "foothold/robot_file.hpp"
#include "hyrecro/reach/labels.hpp"
#include "hyrecro/tools/trainer.hpp"

namespace {

using namespace foothold;
using namespace foothold::hyrecro;

struct Line {
  std::string net, robot = "config/robots/hyrecro.yaml", out;
  std::size_t poses = 4000000, fresh = 1000000;
  double clearance = 0.005;
  unsigned threads = 1;
  TrainingOptions training;
};

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

std::vector<Sample> label(const char* what, const Model& model, const LabelOptions& options) {
  const Clock clock;
  double told = 0.0;
  auto out = labelled(model, options, [&](std::size_t done) {
    if (clock.seconds() < told + 5.0) return;
    told = clock.seconds();
    std::printf("  %s: %zu of %zu poses labelled, %.0f s\n", what, done, options.count, told);
    std::fflush(stdout);
  });
  std::printf("  %s: %zu poses labelled in %.1f s\n", what, out.size(), clock.seconds());
  return out;
}

std::string percent(double part) {
  char word[32];
  std::snprintf(word, sizeof word, "%.3f %%", 100.0 * part);
  return word;
}

std::string comment(const Line& line, const Accuracy& a) {
  const double poses = static_cast<double>(a.poses), reachable = static_cast<double>(a.reachable);
  const std::string space = line.net == "face" ? "uniform in a disc round the sole that holds, headings uniform"
                                               : "singular postures, uniform in a ball round the sole that holds, any bend";
  std::ostringstream out;
  out << "HyReCRo's reachability network for " << line.net << " poses: a 6-32-64-1 perceptron, made by foothold-hyrecro-train.\n"
      << "Accuracy on " << a.poses << " fresh poses (" << space << "): " << percent(a.share())
      << ". Reachable: " << percent(reachable / poses)
      << ".\nFalse positives: " << percent(static_cast<double>(a.false_positives) / (poses - reachable))
      << " of the unreachable; false negatives: " << percent(static_cast<double>(a.false_negatives) / reachable)
      << " of the reachable.\nTrained on " << line.poses << " poses with seed " << line.training.seed
      << ". Again:\n  foothold-hyrecro-train --net " << line.net << " --poses " << line.poses << " --epochs "
      << line.training.epochs << " --batch " << line.training.batch << " --rate " << line.training.rate << " --seed "
      << line.training.seed << " --fresh " << line.fresh << " --clearance " << line.clearance << "\n";
  return out.str();
}

void run(const Line& line) {
  const Model model = Model::from_model(load_robot_model(line.robot));
  LabelOptions options;
  options.kind = line.net == "face" ? PoseKind::kFace : PoseKind::kTransition;
  options.clearance = line.clearance;
  options.radius = farthest(options.kind, model);
  options.count = line.poses;
  options.seed = line.training.seed;
  options.threads = line.threads;
  std::printf("%s poses within %.3f m, clearance %.3f m\n", line.net.c_str(), options.radius, options.clearance);
  const std::vector<Sample> samples = label("training", model, options);

  const Clock clock;
  const Perceptron net = train(samples, line.training, [&](int epoch, double loss) {
    std::printf("  epoch %d of %d: loss %.5f, %.0f s\n", epoch, line.training.epochs, loss, clock.seconds());
    std::fflush(stdout);
  });

  options.count = line.fresh;
  options.seed = line.training.seed + 1;
  const Accuracy measured = accuracy(net, label("measuring", model, options));
  TrainedPerceptron out;
  out.comment = comment(line, measured);
  out.kind = line.net;
  out.robot = robot_numbers(model);
  out.clearance = options.clearance;
  out.radius = options.radius;
  out.fresh = measured.poses;
  out.seed = options.seed;
  out.reachable = measured.reachable;
  out.false_positives = measured.false_positives;
  out.false_negatives = measured.false_negatives;
  out.net = net;
  std::ofstream file(line.out);
  if (!(file << to_text(out) << std::flush)) throw std::runtime_error("cannot write " + line.out);
  std::printf("%s%s written. To use it, build the planner again: the weights are compiled in.\n", out.comment.c_str(),
              line.out.c_str());
}

}  // namespace

int main(int count, char** words) {
  CLI::App app{
      "Makes a weights file of HyReCRo's reachability networks (method `network`). To be run at the root of the repository, once "
      "for "
      "each net, whenever the robot's numbers change. The same build gives the same file for the same command on the same "
      "machine."};
  Line line;
  app.add_option("--net", line.net, "Which network: face or transition")->required()->check(CLI::IsMember({"face", "transition"}));
  app.add_option("--robot", line.robot, "The robot's numbers")->capture_default_str();
  app.add_option("--out", line.out, "File to write; plugins/hyrecro/reach/weights/<net>.txt unless given");
  app.add_option("--poses", line.poses, "Poses to learn from")->capture_default_str()->check(CLI::Range(1000UL, 1000000000UL));
  app.add_option("--fresh", line.fresh, "Poses to measure the accuracy on")
      ->capture_default_str()
      ->check(CLI::Range(1UL, 1000000000UL));
  app.add_option("--clearance", line.clearance, "Least distance between the robot's bodies, m")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  app.add_option("--epochs", line.training.epochs, "Passes over the poses")->capture_default_str()->check(CLI::Range(1, 10000));
  app.add_option("--batch", line.training.batch, "Poses for each step of the weights")
      ->capture_default_str()
      ->check(CLI::Range(1UL, 1000000UL));
  app.add_option("--rate", line.training.rate, "Learning rate at the start")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--seed", line.training.seed, "Of poses and first weights; the fresh poses have the next one")
      ->capture_default_str();
  app.add_option("--threads", line.threads, "For labelling; changes no result")->capture_default_str()->check(CLI::Range(1U, 256U));
  CLI11_PARSE(app, count, words);
  if (line.out.empty()) line.out = "plugins/hyrecro/reach/weights/" + line.net + ".txt";
  try {
    run(line);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "foothold-hyrecro-train: %s\n", error.what());
    return 1;
  }
}
