// foothold-truss: trusses from a seed as scene files.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "truss/generate.hpp"

int main(int argc, char** argv) {
  using namespace foothold::truss;
  CLI::App app{
      "Makes a truss from a seed, as a scene file for climbing robots.\n"
      "Example: foothold-truss tower --seed 3 --beams 40 -o tower.yaml\n"
      "The same family, seed and number give the same bytes on every machine."};
  std::string family, file;
  std::uint64_t seed = 1;
  int beams = 40;
  app.add_option("family", family, "portal (frames with girders and purlins), tower (lattice) or bridge (bays)")
      ->required()
      ->check(CLI::IsMember({"portal", "tower", "bridge"}));
  app.add_option("--seed", seed, "What sizes, profiles and bays are drawn from")->type_name("NUMBER")->capture_default_str();
  app.add_option("--beams", beams, "How many, 2 to 2000")
      ->check(CLI::Range(kFewestBeams, kMostBeams))
      ->type_name("NUMBER")
      ->capture_default_str();
  app.add_option("-o,--output", file, "Where to write; standard output without it")->type_name("FILE");
  CLI11_PARSE(app, argc, argv);

  const std::string text = "# Made by foothold-truss " + family + " --seed " + std::to_string(seed) + " --beams " +
                           std::to_string(beams) + "\n" + to_yaml(generate(*family_named(family), seed, beams));
  if (file.empty()) {
    std::cout << text;
    return std::cout.flush() ? 0 : 1;
  }
  std::ofstream out(file, std::ios::binary);
  if (!(out << text) || !out.flush()) {
    std::cerr << "foothold-truss: " << file << ": cannot be written\n";
    return 1;
  }
  return 0;
}
