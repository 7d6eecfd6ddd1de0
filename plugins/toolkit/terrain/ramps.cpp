// The terrain of Molla-Santamaria et al. 2023, after its description and its three points.
#include "terrain/generate.hpp"

namespace foothold::terrain {
namespace {

constexpr double kFloor = -0.5, kTop = 0.4;  // m
// Of the landings between the ramps, m: so that P_A is half way up the second ramp, and P_B on the third, which ends at the top.
constexpr double kFirst = -4.0 / 15.0, kSecond = -2.0 / 15.0;

enum Vertex : int {
  kFloorCorner,
  kFoot0,
  kFoot1,
  kFoot2,  // the first ramp's foot, from the wall x = 1 inwards
  kHead0,
  kHead1,
  kHead2,  // its head: the first landing's edge
  kCorner1,
  kEdge1a,
  kEdge1b,
  kEdge1c,  // the first landing's corner and edge to the second ramp
  kCorner2,
  kEdge2a,
  kEdge2b,
  kEdge2c,  // the second landing's
  kThird0,
  kThird1,
  kThird2,  // the third ramp's foot, from the wall x = -1 inwards
  kTop0,
  kTop1,
  kTop2,  // its head
  kBend1,
  kBend2,
  kBend3,
  kBend4,
  kBend5,
  kBend6,
  kBend7,  // where the floor ends below the steep slopes
};

const std::vector<Vector3d>& vertices() {
  static const std::vector<Vector3d> kVertices{
      {1.0, -1.0, kFloor},    {1.0, -0.3, kFloor},   {0.8, -0.3, kFloor},   {0.6, -0.3, kFloor},  {1.0, 0.6, kFirst},
      {0.8, 0.6, kFirst},     {0.6, 0.6, kFirst},    {1.0, 1.0, kFirst},    {0.6, 1.0, kFirst},   {0.6, 0.9, kFirst},
      {0.6, 0.7, kFirst},     {-1.0, 1.0, kSecond},  {-0.6, 1.0, kSecond},  {-0.6, 0.9, kSecond}, {-0.6, 0.7, kSecond},
      {-1.0, 0.6, kSecond},   {-0.8, 0.6, kSecond},  {-0.6, 0.6, kSecond},  {-1.0, -1.0, kTop},   {-0.8, -1.0, kTop},
      {-0.6, -1.0, kTop},     {0.5, 0.4, kFloor},    {-0.25, 0.15, kFloor}, {-0.25, 0.0, kFloor}, {-0.2, -0.25, kFloor},
      {-0.15, -0.45, kFloor}, {-0.05, -0.7, kFloor}, {0.3, -1.0, kFloor}};
  return kVertices;
}

// Counter-clockwise seen from above.
const std::vector<std::array<int, 3>>& triangles() {
  static const std::vector<std::array<int, 3>> kTriangles{
      // first ramp
      {kFoot2, kFoot1, kHead1},
      {kFoot2, kHead1, kHead2},
      {kFoot1, kFoot0, kHead0},
      {kFoot1, kHead0, kHead1},
      // first landing
      {kCorner1, kEdge1a, kEdge1b},
      {kCorner1, kEdge1b, kEdge1c},
      {kCorner1, kEdge1c, kHead2},
      {kCorner1, kHead2, kHead1},
      {kCorner1, kHead1, kHead0},
      // second ramp
      {kHead2, kEdge1c, kEdge2c},
      {kHead2, kEdge2c, kThird2},
      {kEdge1c, kEdge1b, kEdge2b},
      {kEdge1c, kEdge2b, kEdge2c},
      {kEdge1b, kEdge1a, kEdge2a},
      {kEdge1b, kEdge2a, kEdge2b},
      // second landing
      {kCorner2, kThird0, kThird1},
      {kCorner2, kThird1, kThird2},
      {kCorner2, kThird2, kEdge2c},
      {kCorner2, kEdge2c, kEdge2b},
      {kCorner2, kEdge2b, kEdge2a},
      // third ramp
      {kThird2, kThird1, kTop1},
      {kThird2, kTop1, kTop2},
      {kThird1, kThird0, kTop0},
      {kThird1, kTop0, kTop1},
      // steep slopes from the floor up to the first ramp, the second and the third
      {kFoot2, kHead2, kBend1},
      {kBend1, kHead2, kThird2},
      {kBend1, kThird2, kBend2},
      {kBend2, kThird2, kBend3},
      {kBend3, kThird2, kTop2},
      {kBend3, kTop2, kBend4},
      {kBend4, kTop2, kBend5},
      {kBend5, kTop2, kBend6},
      {kBend6, kTop2, kBend7},
      // floor
      {kFloorCorner, kFoot0, kFoot1},
      {kFloorCorner, kFoot1, kFoot2},
      {kFloorCorner, kFoot2, kBend2},
      {kFoot2, kBend1, kBend2},
      {kFloorCorner, kBend2, kBend3},
      {kFloorCorner, kBend3, kBend4},
      {kFloorCorner, kBend4, kBend5},
      {kFloorCorner, kBend5, kBend6},
      {kFloorCorner, kBend6, kBend7}};
  return kTriangles;
}

}  // namespace

Terrain ramps() {
  return make_terrain(mesh::joined(vertices(), triangles()), "three ramps in turn along the walls, and steep short cuts");
}

}  // namespace foothold::terrain
