#include "hyrecro_network.hpp"

#include <chrono>
#include <cstdint>

#include "foothold/robot_file.hpp"
#include "hyrecro/reach/labels.hpp"
#include "hyrecro/reach/network.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::bench {
namespace {

using namespace foothold::hyrecro;

constexpr int kTries = 300;    // the paper's
constexpr int kRepeats = 301;  // of a timing, of which the median counts
constexpr std::size_t kPoses = 4096;

// Median over repeats of the mean time of one call, ns. A repeat is shorter than a time slice, so that other programs do not count.
// `sum` of what the calls return keeps them from being left out.
template <typename Call>
double nanoseconds(std::size_t calls, Call call) {
  static volatile std::uint64_t sum;
  std::vector<double> times;
  for (int r = 0; r < kRepeats; ++r) {
    const auto begin = std::chrono::steady_clock::now();
    std::uint64_t local = 0;
    for (std::size_t i = 0; i < calls; ++i) local += call(i) ? 1U : 0U;
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    sum = sum + local;
    times.push_back(took.count() / static_cast<double>(calls));
  }
  return percentile(times, 0.5);
}

// How often a method errs, in percent.
struct Errors {
  double accuracy = 0.0, false_positives = 0.0, false_negatives = 0.0;
};

Errors errors_of(const Accuracy& a) {
  const double reachable = static_cast<double>(a.reachable), poses = static_cast<double>(a.poses);
  return {100.0 * a.share(), 100.0 * static_cast<double>(a.false_positives) / (poses - reachable),
          100.0 * static_cast<double>(a.false_negatives) / reachable};
}

Errors errors_of(Reachability& method, std::span<const Sample> samples) {
  Accuracy out;
  out.poses = samples.size();
  for (const Sample& sample : samples) {
    const bool truly = sample.reachable > 0.5F, said = method.reach(hyrecro::pose_of(sample.inputs), {}).reachable;
    out.reachable += truly;
    out.false_positives += said && !truly;
    out.false_negatives += !said && truly;
  }
  return errors_of(out);
}

}  // namespace

std::vector<Figure> hyrecro_network_figures(bool quick) {
  const Model model = Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"));
  const std::unique_ptr<Reachability> network = make_network(model);
  std::vector<Figure> out;
  for (const PoseKind kind : {PoseKind::kTransition, PoseKind::kFace}) {
    const bool transition = kind == PoseKind::kTransition;
    const std::string name = name_of(kind), tail = transition ? "" : "_face";
    const TrainedPerceptron trained = shipped_perceptron(kind);

    std::mt19937_64 random(1);
    std::vector<Isometry3d> poses(kPoses);
    std::vector<NetworkInputs> inputs(kPoses);
    for (std::size_t i = 0; i < kPoses; ++i) {
      poses[i] = random_pose(kind, trained.radius, random);
      inputs[i] = inputs_of(kind, poses[i]);
    }
    LabelOptions options;
    options.kind = kind;
    options.clearance = trained.clearance;
    options.radius = trained.radius;
    options.count = quick ? 20000 : 200000;
    options.seed = 987654321;
    const std::vector<Sample> samples = labelled(model, options);
    const std::span<const Sample> fewer(samples.data(), quick ? 1000 : 10000);
    std::mt19937_64 tries(2);
    const std::unique_ptr<Reachability> iterative = make_iterative(model, trained.clearance, kTries, tries);
    const auto begin = std::chrono::steady_clock::now();
    const Errors of_iterative = errors_of(*iterative, fewer);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    const double iterative_call = took.count() / static_cast<double>(fewer.size());
    const Errors of_network = errors_of(accuracy(trained.net, samples));

    const std::string paper_tries = "the paper's random search, 300 tries";
    out.push_back({"network_call" + tail, nanoseconds(kPoses, [&](std::size_t i) { return logit(trained.net, inputs[i]) > 0.0F; }),
                   "ns", "less", 60.0, std::nullopt, ""});
    out.push_back({"network_reach" + tail,
                   nanoseconds(kPoses, [&](std::size_t i) { return network->reach(poses[i], {}).reachable; }), "ns", "less",
                   std::nullopt, iterative_call, paper_tries});
    out.push_back({"network_accuracy_" + name, of_network.accuracy, "%", "more", transition ? 97.85 : 98.32, of_iterative.accuracy,
                   paper_tries});
    out.push_back({"network_false_positives_" + name, of_network.false_positives, "% of unreachable", "less", std::nullopt,
                   of_iterative.false_positives, paper_tries});
    out.push_back({"network_false_negatives_" + name, of_network.false_negatives, "% of reachable", "less", std::nullopt,
                   of_iterative.false_negatives, paper_tries});
  }
  return out;
}

}  // namespace foothold::bench
