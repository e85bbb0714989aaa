// A subject around a library: Embree 3 or 4, edges as rays against triangles, in float. Surfaces; the rest is declined.
//   g++ -O2 -std=c++20 embree_rays.cpp -o embree_rays -lembree3   # or 4
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
using nlohmann::json;
using Points = std::vector<std::array<float, 4>>;  // three a triangle; Embree wants room behind each
const RTCDevice device = rtcNewDevice("threads=1");
const RTCScene scene = rtcNewScene(device);  // of one mesh
const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);

Points placed(const json& model, const json& pose)  // fans; declined: fractions, holes, what is too far for Embree
{
  Points all;
  if (pose.dump().find('/') != std::string::npos) return {};  // a fraction
  for (const std::vector<float> m = pose; const json& face : model["faces"])
    for (std::size_t k = 2; k < face[0].size(); ++k)
      for (const json& corner : {face[0][0], face[0][k - 1], face[0][k]}) {
        all.push_back({m[3], m[7], m[11]});
        for (int i = 0; i < 9; ++i) all.back()[i / 3] += m[i + i / 3] * float(model["vertices"][int(corner)][i % 3]);
        if (face.size() > 1 || !std::ranges::all_of(all.back(), [](float x) { return std::abs(x) < 1e18f; })) return {};
      }
  return all;
}

bool hits(const Points& a, const Points& b)  // an edge of a, a triangle of b
{
  rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, b.data(), 0, 16, b.size());
  void* corners = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, b.size() / 3);
  for (unsigned k = 0; k < b.size(); ++k) static_cast<unsigned*>(corners)[k] = k;
  rtcCommitGeometry(mesh);
  rtcCommitScene(scene);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto &p = a[k], &q = a[k % 3 == 2 ? k - 2 : k + 1];  // a ray from p, at 0, to q, at 1
    RTCRay ray = {p[0], p[1], p[2], 0, q[0] - p[0], q[1] - p[1], q[2] - p[2], 0, 1, ~0u, 0, 0};
#if RTC_VERSION_MAJOR < 4
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#else
    rtcOccluded1(scene, &ray);
#endif
    if (ray.tfar < 0) return true;
  }
  return false;
}

int main()
{
  rtcAttachGeometry(scene, mesh);
  json bodies;
  for (std::string line; std::getline(std::cin, line);) {
    const json m = json::parse(line);
    if (m.contains("model")) bodies[m["model"].dump()] = m;
    if (m.contains("forget")) bodies.erase(m["forget"].dump());
    if (!m.contains("ask")) continue;
    const Points a = placed(bodies[m["a"].dump()], m["pose_a"]), b = placed(bodies[m["b"].dump()], m["pose_b"]);
    json answer;  // null: declined
    if (m["question"] == "surface" && !a.empty() && !b.empty()) answer = int(hits(a, b) || hits(b, a));
    std::cout << json{{"ask", m["ask"]}, {"answer", answer}} << std::endl;
  }
}
