#include "hyrecro/reach/accuracy.hpp"

namespace foothold::hyrecro {

Accuracy accuracy(const Perceptron& net, std::span<const Sample> samples) {
  Accuracy out;
  out.poses = samples.size();
  for (const Sample& sample : samples) {
    const bool truly = sample.reachable > 0.5F, said = logit(net, sample.inputs) > 0.0F;
    out.reachable += truly;
    out.false_positives += said && !truly;
    out.false_negatives += !said && truly;
  }
  return out;
}

}  // namespace foothold::hyrecro
