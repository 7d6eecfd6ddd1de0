// Greedy: the first label takes the best place, the next the best of what is left.
#include "labels.hpp"

#include <algorithm>
#include <cmath>

#include "svg.hpp"

namespace foothold::drawing {
namespace {

Box2 box_at(const Vector2d& centre, double width, double height) {
  const Vector2d half(width / 2.0, height / 2.0);
  return {centre - half, centre + half};
}

double common_area(const Box2& a, const Box2& b) {
  const Vector2d size = a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low);
  return std::max(0.0, size.x()) * std::max(0.0, size.y());
}

double outside(const Box2& box, const Rectangle& area) {
  return std::max(0.0, area.left - box.low.x()) + std::max(0.0, box.high.x() - area.right()) +
         std::max(0.0, area.top - box.low.y()) + std::max(0.0, box.high.y() - area.bottom());
}

}  // namespace

LabelSize label_size(std::size_t count) {
  constexpr std::size_t kMany = 30;
  return count > kMany ? LabelSize{9.0, 11.0} : LabelSize{11.0, 14.0};
}

double label_width(const Label& label, LabelSize size) { return std::max(size.height, text_width(label.text, size.font) + 4.0); }

void place_labels(std::vector<Label>& labels, LabelSize size, const Rectangle& area) {
  constexpr int kWays = 16;
  constexpr double kRadii[] = {1.1, 1.7, 2.4, 3.2, 4.2};  // in heights of a label
  std::vector<Box2> taken, points;
  for (const Label& label : labels) points.push_back(box_at(label.point.head<2>(), 6.0, 6.0));
  for (Label& label : labels) {
    const double width = label_width(label, size);
    double least = INFINITY;
    for (const double heights : kRadii)
      for (int way = 0; way < kWays; ++way) {
        // Above and to the right first, then turning away from there.
        const double angle = -M_PI / 4.0 + (way % 2 == 0 ? 1.0 : -1.0) * M_PI * ((way + 1) / 2) / (kWays / 2.0);
        const double radius = heights * size.height;
        const Vector2d at =
            label.point.head<2>() + Vector2d(std::cos(angle) * (radius + (width - size.height) / 2.0), std::sin(angle) * radius);
        const Box2 box = box_at(at, width, size.height);
        double cost = radius * 0.5 + way * 0.2 + outside(box, area) * 50.0;
        for (const Box2& other : taken) cost += common_area(box, other) * 3.0;
        for (const Box2& other : points) cost += common_area(box, other) * 0.5;
        if (cost < least) {
          least = cost;
          label.at = at;
        }
      }
    taken.push_back(box_at(label.at, width, size.height));
  }
}

}  // namespace foothold::drawing
