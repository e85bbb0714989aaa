// Certificates of points and of rays, about one body.

#include "tetracone/covering/model.h"
#include "tetracone/kernel/predicate/ray_face.h"
#include "tetracone/tetratree/certificate/certificate_data.h"
#include "tetracone/tetratree/certificate/windings.h"

#include <cmath>

namespace tetracone {
namespace {

using kernel::Exact_number;
using kernel::Exact_vector;
using kernel::Rational;
using kernel::Rational_point;
using tetratree::add_cover;
using tetratree::add_key;
using tetratree::add_list;
using tetratree::Box_id;
using tetratree::Covered_body;
using tetratree::fail_proof;
using tetratree::json_text;
using tetratree::Probe;
using tetratree::Probe_cover;

/// Returns the direction, multiplied by a power of 2: the search for a cover rounds it.
Exact_vector of_length_near_1(const std::array<double, 3>& direction)
{
  double largest = 0;
  for (const double x : direction) largest = kernel::maximum(largest, std::abs(x));
  const int power = std::ilogb(largest);
  Exact_vector scaled;
  for (std::size_t k = 0; k < 3; ++k)
    scaled[k] = power < 0 ? Exact_number(std::ldexp(direction[k], -power))
                          : Exact_number(Exact_number(direction[k]) * Exact_number(std::ldexp(1.0, -power)));
  return scaled;
}

/// Returns where the ray meets the face first, exactly.
Rational first_time(const covering::Polyhedron& polyhedron, Index f, const kernel::Rational_ray& ray)
{
  covering::Polyhedron alone;
  std::vector<std::vector<Index>> loops;
  for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
    loops.emplace_back();
    for (const Index v : polyhedron.loop(f, l)) {
      loops.back().push_back(Index(alone.vertices.size()));
      alone.vertices.push_back(polyhedron.vertices[v]);
    }
  }
  alone.add_face(loops);
  const covering::Model<kernel::Rational_kernel> model(alone);
  const auto t = kernel::ray_face(ray, covering::Model_face<kernel::Rational_kernel>(model, 0));
  if (!t) fail_proof("the ray does not meet the face");
  return *t;
}

}  // namespace

bool Certificate::inside(const std::array<std::string, 3>& point, Location answer)
{
  Data::Part& part = data_->only();
  return data_->add(Data::begin("inside"), [&](std::string& text) {
    add_key(text, "point");
    add_list(text, point, [](const std::string& x) { return json_text(x); });
    add_key(text, "answer");
    text += std::to_string(int(answer));
    Rational_point x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = Data::parsed(point[k]);
    const Rational weight(tetratree::common_denominator(x));
    Covered_body body = tetratree::placed(part.tree(), kernel::Pose(), kernel::Pose(), tetratree::exact(weight));
    const Exact_vector at = tetratree::exact(x, weight);
    if (answer == Location::on_surface) {
      Probe_cover cover(body, Probe{at, {}, {}});
      std::optional<Index> found;
      cover([&](Box_id piece, const kernel::Exact_face&, bool is_apart) {
        if (is_apart) {
          cover.search().append("0");
          return Probe_cover::Met::is_covered;
        }
        found = body.groups->source_face(piece);
        return Probe_cover::Met::stops;
      });
      if (!found) fail_proof("no face holds the point");
      add_key(text, "face");
      text += std::to_string(*found);
    } else {
      tetratree::Random_integers random;
      const auto number = add_winding(text, body, at, random);
      if (!number || (*number != 0) != (answer == Location::inside))
        fail_proof("the answer is not proved: the winding number");
    }
    return true;
  });
}

bool Certificate::first_hit(const Ray& ray, const std::optional<Ray_hit>& answer, double end)
{
  Data::Part& part = data_->only();
  return data_->add(Data::begin("ray"), [&](std::string& text) {
    for (const auto& [key, numbers] : {std::pair("origin", ray.origin), {"direction", ray.direction}}) {
      add_key(text, key);
      add_list(text, numbers, [](double x) { return json_text(kernel::shortest(x)); });
    }
    if (std::isfinite(end)) {
      add_key(text, "end");
      text += json_text(kernel::shortest(end));
    }
    add_key(text, "answer");
    kernel::Rational_ray exact_ray;
    for (std::size_t k = 0; k < 3; ++k) {
      exact_ray.origin[k] = ray.origin[k];
      exact_ray.direction[k] = ray.direction[k];
    }
    std::optional<Rational> t;
    Index face = 0;
    if (answer) {
      t = first_time(part.polyhedron(), answer->face, exact_ray);
      face = part.source_face[answer->face];
      text += "{\"face\":" + std::to_string(face) + ",\"t\":" + json_text(kernel::to_string(*t)) + "}";
    } else {
      text += "null";
      if (end < 0) return true;
      if (std::isfinite(end)) t = end;
    }
    Rational_point last = exact_ray.origin;
    if (t)
      for (std::size_t k = 0; k < 3; ++k) last[k] += *t * exact_ray.direction[k];
    const Rational weight(tetratree::common_denominator(last));
    Covered_body body = tetratree::placed(part.tree(), kernel::Pose(), kernel::Pose(), tetratree::exact(weight));
    Probe probe;
    probe.start = tetratree::exact(exact_ray.origin, weight);
    if (!t)
      probe.direction = of_length_near_1(ray.direction);
    else if (*t != 0)
      probe.end = tetratree::exact(last, weight);
    Probe_cover cover(body, probe);
    const bool is_covered = cover([&](Box_id piece, const kernel::Exact_face& f, bool is_apart) {
      const bool may_touch = answer && body.groups->group(piece).least_face >= face;
      if (may_touch && !probe.end) {
        cover.search().append("\"touched\"");
        return Probe_cover::Met::is_covered;
      }
      if (!may_touch && !is_apart) fail_proof("the answer is not proved: the ray meets another face first");
      const auto m = may_touch ? kernel::direction_of_first_touch(f, probe.start, *probe.end) : std::nullopt;
      if (!m) return Probe_cover::Met::stops;
      cover.search().append(cover.search().add(*m));
      return Probe_cover::Met::is_covered;
    });
    if (is_covered) add_cover(text, cover.cover());
    return is_covered;
  });
}

}  // namespace tetracone
