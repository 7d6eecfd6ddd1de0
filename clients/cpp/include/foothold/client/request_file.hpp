// A plan request as a YAML file, for people:
//
//   robot: xrobin                       # which model; `foothold robots` lists them
//   unit: yard-3                        # which individual; passed through to logs
//   scene: beams                        # a stored scene's newest revision, or
//   scene: {name: beams, revision: 9f86...}
//   scene: {file: ../scenes/beams.yaml, name: beams}   # sent to the server first; relative to this file; name: the stem if left
//   out start:                              # what is left out is not given: see `foothold robots` for what a robot needs
//     base: {position: [0, 0, 0.1], heading_deg: 90}
//     joints: [0.1, -0.2]               # rad or m, in the order that the robot announces
//   goal:                             # left out where a robot adapts on the spot
//     base:
//       position: [0.4, 0.4, 0]         # m
//       orientation: [1, 0, 0, 0]       # w, x, y, z; or rpy_deg: [roll, pitch, yaw], about the fixed x, then y, then z axis;
//                                       # or heading_deg: 90, about z
//     any_orientation: true             # only the position counts; the orientation may then be left out
//     contacts:
//       - {limb: left, position: [1, 0, 0], heading_deg: 0, face: top}   # limb, face: may be left out where a robot allows it
//   budget: 5                           # s from receipt
//   priority: 0
//   seed: 1
//   parameters: {method: optimal, cycles: 7}
//   shapes: true                        # steps carry the robot's bodies, for drawing
//   resume: true                        # plan again if the server is restarted in mid-plan
#pragma once

#include <foothold.h>

#include <stdexcept>
#include <string>

namespace foothold::client {

// what() is "file:line: field: reason"; the line is left out where the file itself cannot be read.
class RequestFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RequestFile {
  msg::PlanRequest request;  // id, client and server zero; budget 0 if the file gives none
  std::string scene_file;    // to be sent under the name request.scene(); empty: none
};

// Refuses unknown keys with the nearest known name, keys given twice, and values of the wrong kind. What only a server can know
// (robots, parameters, limits) it leaves to the server. Throws RequestFileError. Any thread.
RequestFile read_request_file(const std::string& path);
// `path` names the text in errors and is what scene files are relative to.
RequestFile read_request(const std::string& text, const std::string& path);

}  // namespace foothold::client
