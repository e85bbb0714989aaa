// A subject in C++: all pairs of triangles by separating axes, in double. Surfaces; what it does not know is declined.
//   g++ -O2 -std=c++20 -isystem /usr/include/eigen3 plain_sat.cpp -o plain_sat
#include <Eigen/Geometry>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
using Eigen::Matrix3d, Eigen::Vector3d, nlohmann::json;

double number(const json& n)  // a fraction "n/d" is rounded
{
  if (n.is_number()) return n;
  const std::string text = n;
  return double(std::strtold(text.c_str(), nullptr) / std::strtold(&text[text.find('/') + 1], nullptr));
}

std::vector<Matrix3d> placed(const json& model, const json& pose)  // fans of triangles; none where a face has a hole
{
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> m;
  for (int k = 0; k < 12; ++k) m(k / 4, k % 4) = number(pose[k]);
  const auto point = [&](const json& v) { return Vector3d(m * Eigen::Vector4d(v[0], v[1], v[2], 1)); };
  std::vector<Matrix3d> all;
  for (const json& v = model["vertices"]; const json& face : model["faces"]) {
    if (face.size() > 1) return {};
    for (std::size_t k = 2; k < face[0].size(); ++k)
      all.emplace_back() << point(v[int(face[0][0])]), point(v[int(face[0][k - 1])]), point(v[int(face[0][k])]);
  }
  return all;
}

bool meet(const Matrix3d& s, const Matrix3d& t)
{
  const auto apart = [&](const Vector3d& axis) {
    const Eigen::RowVector3d x = axis.transpose() * s, y = axis.transpose() * t;
    return x.maxCoeff() < y.minCoeff() || y.maxCoeff() < x.minCoeff();
  };
  const auto edge = [](const Matrix3d& x, int k) { return Vector3d(x.col((k + 1) % 3) - x.col(k)); };
  const Vector3d n = edge(s, 0).cross(edge(s, 1)), m = edge(t, 0).cross(edge(t, 1));
  bool found = apart(n) || apart(m);
  for (int i = 0; i < 9; ++i)
    found = found || apart(Vector3d::Unit(i % 3)) || apart(n.cross(edge(s, i % 3))) || apart(m.cross(edge(t, i % 3))) ||
            apart(edge(s, i / 3).cross(edge(t, i % 3)));
  return !found;
}

int main()
{
  std::map<int, json> bodies;
  for (std::string line; std::getline(std::cin, line);) {
    const json m = json::parse(line);
    if (m.contains("model")) bodies[m["model"]] = m;
    if (m.contains("forget")) bodies.erase(int(m["forget"]));
    if (!m.contains("ask")) continue;
    const auto a = placed(bodies[m["a"]], m["pose_a"]), b = placed(bodies[m["b"]], m["pose_b"]);
    const bool taken = m["question"] == "surface" && !a.empty() && !b.empty();
    json answer = taken ? json(0) : json();  // null: declined
    for (std::size_t k = 0; answer == 0 && k < a.size() * b.size(); ++k)
      answer = int(meet(a[k / b.size()], b[k % b.size()]));
    std::cout << json{{"ask", m["ask"]}, {"answer", answer}} << std::endl;
  }
}
