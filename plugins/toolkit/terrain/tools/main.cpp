// foothold-terrain: rough terrain from a seed as scene files.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "geometry/scene_text.hpp"
#include "terrain/generate.hpp"

int main(int argc, char** argv) {
  using namespace foothold;
  CLI::App app{
      "Makes rough terrain from a seed, as a scene file for walking robots.\n"
      "Example: foothold-terrain boulders --seed 3 --size 4 -o boulders.yaml\n"
      "The same family, seed, size and grid give the same bytes on every machine."};
  std::string family, file;
  terrain::Options options;
  app.add_option("family", family, "ramps (2 x 2 m, no seed), boulders, stairs or ditch")
      ->required()
      ->check(CLI::IsMember({"ramps", "boulders", "stairs", "ditch"}));
  app.add_option("--seed", options.seed, "What rocks, steps and banks are drawn from")->type_name("NUMBER")->capture_default_str();
  app.add_option("--size", options.size, "Edge of the square, m, 1 to 100")
      ->check(CLI::Range(1.0, 100.0))
      ->type_name("METRES")
      ->capture_default_str();
  app.add_option("--grid", options.grid, "Distance of vertices, m, 0.01 to 1; not of stairs")
      ->check(CLI::Range(0.01, 1.0))
      ->type_name("METRES")
      ->capture_default_str();
  app.add_option("-o,--output", file, "Where to write; standard output without it")->type_name("FILE");
  CLI11_PARSE(app, argc, argv);

  std::string text = "# Made by foothold-terrain " + family;
  if (family != "ramps")
    text += " --seed " + std::to_string(options.seed) + " --size " + geometry::number_text(options.size) + " --grid " +
            geometry::number_text(options.grid);
  try {
    text += "\n" + terrain::to_yaml(terrain::generate(*terrain::family_named(family), options));
  } catch (const std::invalid_argument& fault) {
    std::cerr << "foothold-terrain: " << fault.what() << "\n";
    return 1;
  }
  if (file.empty()) {
    std::cout << text;
    return std::cout.flush() ? 0 : 1;
  }
  std::ofstream out(file, std::ios::binary);
  if (!(out << text) || !out.flush()) {
    std::cerr << "foothold-terrain: " << file << ": cannot be written\n";
    return 1;
  }
  return 0;
}
