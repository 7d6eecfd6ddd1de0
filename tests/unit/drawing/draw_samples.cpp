// Writes the sample plans as SVG into a folder, to be looked at: draw_samples DIR
#include <fstream>
#include <iostream>

#include "samples.hpp"

int main(int argc, char** argv) {
  using namespace foothold::drawing;
  if (argc != 2) {
    std::cerr << "usage: draw_samples DIR\n";
    return 2;
  }
  const auto write = [&](const std::string& name, const Drawing& drawing, const DrawOptions& options = {}) {
    std::ofstream file(std::string(argv[1]) + "/" + name + ".svg");
    file << draw_svg(drawing, options);
    if (!file.good()) std::cerr << "cannot write " << name << "\n";
  };
  write("planar", samples::planar());
  write("biped", samples::biped(false));
  write("biped-through", samples::biped(true));
  write("tower", samples::tower());
  write("hexapod", samples::hexapod());
  DrawOptions some;
  some.first_step = 3;
  some.last_step = 7;
  some.views = Views::kOblique;
  some.frame = Frame::kPlan;
  write("hexapod-3-7", samples::hexapod(), some);
  return 0;
}
