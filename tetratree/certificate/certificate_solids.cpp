// Certificates of relations, exits and depths. Those that have no proof are left out.

#include "tetracone/tetratree/certificate/approach.h"
#include "tetracone/tetratree/certificate/certificate_data.h"
#include "tetracone/tetratree/certificate/lower_bound.h"
#include "tetracone/tetratree/certificate/sides.h"

#include <algorithm>

namespace tetracone {

using kernel::Rational;
using kernel::Rational_point;
using tetratree::add_key;
using tetratree::Placed_pair;

bool Certificate::Data::have_same_faces(const Placed_pair& pair) const
{
  using Face = std::vector<std::vector<kernel::Exact_vector>>;
  std::array<std::vector<Face>, 2> faces;
  for (std::size_t k = 0; k < 2; ++k) {
    const covering::Polyhedron& polyhedron = parts[k].polyhedron();
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      Face face(polyhedron.loop_count(f));
      for (std::size_t l = 0; l < face.size(); ++l) {
        for (const Index v : polyhedron.loop(f, l)) face[l].push_back(pair.body[k].points.exact(v));
        std::rotate(face[l].begin(), std::ranges::min_element(face[l]), face[l].end());
      }
      std::ranges::sort(face);
      faces[k].push_back(std::move(face));
    }
    std::ranges::sort(faces[k]);
  }
  return faces[0] == faces[1];
}

bool Certificate::relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Solid_relation answer)
{
  using enum Solid_relation;
  return data_->add(Data::begin("relation", pose_a, pose_b), [&](std::string& text) {
    text += tetratree::json_text(kernel::to_string(answer));
    Placed_pair pair = data_->placed(pose_a, pose_b);
    std::string surfaces = text;
    const auto met = cover_or_meet(surfaces, pair);
    const bool is_without = answer == disjoint || answer == inside || answer == contains;
    if (!met != is_without) {
      // Membranes within a solid may touch the other surface, and solids of several parts overlap without contact.
      if (answer == inside || answer == contains || answer == overlap) return false;
      tetratree::fail_proof("the answer is not proved: surfaces");
    }
    if (is_without || answer == meet) text = surfaces;
    switch (answer) {
      case disjoint:
      case inside:
      case contains:
        if (!add_all_windings(text, pair, answer == inside, answer == contains))
          tetratree::fail_proof("the answer is not proved: shells");
        return true;
      case meet: return add_parted(text, pair, met) && add_sides(text, pair, *met, {{true, false}, {false, true}});
      case overlap: return add_sides(text, pair, *met, {{true, true}, {true, false}, {false, true}});
      case equal:
        if (data_->have_same_faces(pair)) return true;
        add_key(text, "ways");
        text += '[';
        if (!add_way(text, pair, 0, *met)) return false;
        text += ',';
        if (!add_way(text, pair, 1, *met)) return false;
        text += ']';
        return true;
      default: {
        const int inner = answer == covered_by ? 0 : 1;
        add_key(text, "way");
        return add_way(text, pair, inner, *met) && add_border(text, pair, inner, *met) &&
               add_sides(text, pair, *met, {{inner == 1, inner == 0}});
      }
    }
  });
}

namespace {

/// Appends a proof that the interiors share no point. False where none is found.
bool add_interiors_apart(std::string& text, Placed_pair& pair)
{
  std::string unused = "{";
  return add_parted(text, pair, cover_or_meet(unused, pair));
}

}  // namespace

bool Certificate::exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                        const std::array<std::string, 3>& direction, const Exits& answer)
{
  const std::array<Rational, 2> exit = {Rational(answer.exact_first), Rational(answer.exact_last)};
  return data_->add(Data::begin("exit", pose_a, pose_b), [&](std::string& text) {
    text += tetratree::strings_of(exit);
    add_key(text, "direction");
    tetratree::add_list(text, direction, [](const std::string& x) { return tetratree::json_text(x); });
    Rational_point along;
    for (std::size_t k = 0; k < 3; ++k) along[k] = Data::parsed(direction[k]);
    Placed_pair start = data_->placed(pose_a, pose_b);
    const auto shifted = [&](const Rational& s) { return tetratree::moved(start.pose, kernel::scaled(along, s)); };
    Placed_pair first = start.at(shifted(exit[0]));
    if (!add_interiors_apart(text, first)) return false;
    if (exit[0] == 0) return true;

    const tetratree::Two_bodies bodies = data_->triangles();
    tetratree::Points_of_both points_of_both(bodies);
    if (!points_of_both(text, start)) return false;
    // Beyond `until`, a plane across the direction is between the bodies.
    const Placed_pair last = first.at(shifted(exit[1]));
    const kernel::Exact_vector across = tetratree::exact(tetratree::in_lowest_terms(along), 1);
    const kernel::Exact_number between = tetratree::extent_of(last.body[1].hull({}), across, 1) -
                                         tetratree::extent_of(last.body[0].hull({}), across, -1);
    Rational until = Rational(between) / Rational(last.weight) / kernel::dot(tetratree::in_lowest_terms(along), along);
    if (until <= 0) until = 1;
    add_key(text, "gone");
    text += "{\"until\":" + tetratree::json_text(kernel::to_string(until));
    if (!leads_free(text, shifted(exit[1] + until), last, -1)) return false;
    text += "}";
    add_key(text, "before");
    std::array<std::string, 2> before;
    for (const std::size_t k : {0, 1}) {
      std::string& row = before[k];
      if (k == 1 && exit[0] == exit[1])
        row = before[0];
      else if (!add_just_before(row, k == 0 ? first : last, along, crossings_before(start, bodies, along, exit[k])))
        return false;
    }
    tetratree::add_list(text, before, [](const std::string& row) { return row; });
    add_stretches(text, start, bodies, points_of_both, along, exit[0]);
    return true;
  });
}

bool Certificate::depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth& answer)
{
  return data_->add(Data::begin("depth", pose_a, pose_b), [&](std::string& text) {
    text += tetratree::json_text(answer.exact_square);
    Rational_point v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = Rational(answer.exact_vector[k]);
    add_key(text, "vector");
    text += tetratree::strings_of(v);
    Placed_pair pair = data_->placed(pose_a, pose_b);
    Placed_pair apart = pair.at(tetratree::moved(pair.pose, v));
    if (!add_interiors_apart(text, apart)) return false;
    if (answer.high > 0) {
      const tetratree::Two_bodies bodies = data_->triangles();
      tetratree::Lower_bound bound(pair, bodies);
      bound(text, v, answer.is_exact ? 0 : 1 - answer.low / answer.high);
    }
    return true;
  });
}

}  // namespace tetracone
