#include "tetracone/tetratree/door/certificate.h"

#include "tetracone/covering/model.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/ray_face.h"
#include "tetracone/tetratree/certificate/cover.h"
#include "tetracone/tetratree/certificate/motion_cover.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/memory/pair_memory.h"
#include "tetracone/tetratree/query/exact_vertices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

namespace tetracone {
namespace {

using kernel::Exact_number;
using kernel::Exact_vector;
using kernel::Rational;
using kernel::Rational_point;
using tetratree::Box_id;
using tetratree::Covered_body;
using tetratree::Probe;
using tetratree::Probe_cover;

/// Appends "key":, behind a comma unless it is the first key of its object.
void add_key(std::string& text, std::string_view key)
{
  if (text.back() != '{') text += ',';
  text += '"';
  text += key;
  text += "\":";
}

/// Appends a list of what text_of(x) returns for each element.
template <class Range, class Text_of>
void add_list(std::string& text, const Range& range, const Text_of& text_of)
{
  char before = '[';
  for (const auto& x : range) {
    text += std::exchange(before, ',');
    text += text_of(x);
  }
  text += before == '[' ? "[]" : "]";
}

std::string json_text(std::string_view text)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20)
      quoted += std::string("\\u00") + digits[code / 16] + digits[code % 16];
    else
      quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return quoted + "\"";
}

template <class Numbers>
std::string strings_of(const Numbers& numbers)
{
  std::string text;
  add_list(text, numbers, [](const Rational& x) { return json_text(kernel::to_string(x)); });
  return text;
}

Rational_point rational(const Exact_vector& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

/// Returns the point in the coordinates of the bodies, of which those of `point` are `weight` times as large.
Rational_point rational(const kernel::Exact_point& point, const Exact_number& weight)
{
  const Rational by = Rational(point.weight) * Rational(weight);
  Rational_point x = rational(point.at);
  for (Rational& c : x) c /= by;
  return x;
}

/// Returns the largest absolute value of a coordinate.
Rational longest_part(const Rational_point& v)
{
  Rational longest = 0;
  for (const Rational& x : v) longest = abs(x) > longest ? Rational(abs(x)) : longest;
  return longest;
}

/// Returns the direction in integers without a common factor.
Rational_point in_lowest_terms(Rational_point m)
{
  mpz_class common = 1, factor = 0;
  for (const Rational& x : m) common = lcm(common, x.get_den());
  for (Rational& x : m) {
    x *= common;
    factor = gcd(factor, x.get_num());
  }
  for (Rational& x : m) x /= factor;
  return m;
}

mpz_class common_denominator(const Rational_point& x)
{
  return lcm(lcm(x[0].get_den(), x[1].get_den()), x[2].get_den());
}

/// Returns the number. Requires an integer, or a binary fraction.
Exact_number exact(const Rational& x)
{
  Exact_number value = 0;
  const std::string digits = mpz_class(abs(x.get_num())).get_str(16);
  for (const char digit : digits)
    value = value * Exact_number(16) + Exact_number(digit <= '9' ? digit - '0' : digit - 'a' + 10);
  Rational unit(1, x.get_den());
  // The factors 2^-1000 and less are doubles.
  for (; unit < Rational(0x1p-1000); unit *= Rational(0x1p1000)) value = value * Exact_number(0x1p-1000);
  value = value * Exact_number(unit.get_d());
  return sgn(x) < 0 ? Exact_number(-value) : value;
}

void add_pose(std::string& text, std::string_view key, const kernel::Pose& pose)
{
  std::array<int, 12> places;
  std::iota(places.begin(), places.end(), 0);
  add_key(text, key);
  add_list(text, places, [&](int k) { return json_text(kernel::exact_text(pose.exact(k))); });
}

void add_cover(std::string& text, const tetratree::Cover& cover)
{
  add_key(text, "directions");
  add_list(text, cover.directions, [](const Exact_vector& m) { return strings_of(in_lowest_terms(rational(m))); });
  add_key(text, "cover");
  text += cover.nodes;
  for (const auto& [groups, box] : cover.opened) groups->open(box);
}

void add_witness(std::string& text, const std::array<Rational_point, 2>& points, const std::array<Index, 2>& faces)
{
  add_key(text, "witness");
  text += '{';
  add_key(text, "points");
  add_list(text, points, [](const Rational_point& x) { return strings_of(x); });
  add_key(text, "faces");
  add_list(text, faces, [](Index f) { return std::to_string(f); });
  text += '}';
}

/// Returns directions that may part bodies which touch in two faces: normals of either, and of edges of both.
std::vector<Exact_vector> parting_directions(const std::array<kernel::Exact_face, 2>& face)
{
  std::vector<Exact_vector> found;
  for (const kernel::Exact_face& f : face)
    if (f.plane) found.push_back(kernel::detail::normal_of(*f.plane));
  for (const auto& [p, q] : face[0].edges)
    for (const auto& [r, s] : face[1].edges)
      found.push_back(kernel::cross(kernel::difference(q, p), kernel::difference(s, r)));
  for (std::size_t k = 0, count = found.size(); k < count; ++k)
    found.push_back(kernel::detail::scaled(found[k], Exact_number(-1)));
  return found;
}

[[noreturn]] void fail(const std::string& what) { throw Error("certificate: " + what); }

}  // namespace

/// Two placed bodies on one scale.
struct Placed_pair {
  std::array<Covered_body, 2> body;
  Exact_number weight = 1, rounding = 1;  // of all coordinates; beyond it, of the rounded ones
};

struct Certificate::Data {
  struct Part {
    detail::Shared_body body;
    std::optional<Certified_file> file;
    std::vector<Index> source_face;
    std::optional<tetratree::Group_tree> groups;

    explicit Part(detail::Shared_body b) : body(std::move(b)), source_face(body->polyhedron.face_count())
    {
      std::iota(source_face.begin(), source_face.end(), Index(0));
    }

    const covering::Polyhedron& polyhedron() const { return body->polyhedron; }

    tetratree::Group_tree& tree()
    {
      if (!groups) groups.emplace(body->bvh8(), source_face);
      return *groups;
    }
  };

  using Poses = std::array<kernel::Pose, 2>;

  std::vector<Part> parts;
  std::vector<std::string> answers;
  std::size_t without_proof = 0;
  std::uint32_t state_of_random = 1;

  /// Returns an integer of so many bits about 0.
  double random(int bits)
  {
    state_of_random = state_of_random * 1664525u + 1013904223u;  // Numerical Recipes' generator
    return double(state_of_random >> (32 - bits)) - std::ldexp(0.5, bits);
  }

  Part& only()
  {
    if (parts.size() != 1) fail("a question about one body; expected a certificate for one");
    return parts[0];
  }

  /// Returns the body, with its coordinates multiplied by `weight`.
  Covered_body placed(std::size_t k, const kernel::Pose& pose, const kernel::Pose& other, const Exact_number& weight)
  {
    const auto& vertices = parts[k].polyhedron().vertices;
    tetratree::Exact_vertices images(vertices);
    images.place(pose, other);
    Covered_body body{&parts[k].tree(), {}};
    body.points.exact.reserve(vertices.size());
    for (Index v = 0; v < vertices.size(); ++v) body.points.exact.push_back(kernel::detail::scaled(images(v), weight));
    return body;
  }

  Placed_pair placed(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    kernel::require_sound_floating_point();
    if (parts.size() != 2) fail("a question about two bodies; expected a certificate for two");
    Placed_pair pair{{placed(0, pose_a, pose_b, 1), placed(1, pose_b, pose_a, 1)}};
    pair.weight = pose_a.weight() * pose_b.weight();
    pair.rounding = kernel::round_together(pair.body[0].points, pair.body[1].points);
    return pair;
  }

  Index file_face(std::size_t body, Index f) const { return parts[body].source_face[f]; }

  [[noreturn]] void refuse_whole(std::size_t body, Index face) const
  {
    fail("face " + std::to_string(file_face(body, face)) +
         " has no triangles; expected a face whose loops don't cross");
  }

  /// Covers the pair, or finds a common point: then `text` has a witness, and `met` is that point.
  bool cover(std::string& text, Placed_pair& pair, const kernel::Gap_rule& rule,
             const std::optional<Exact_vector>& preferred = {}, tetratree::Common_point* met = nullptr)
  {
    tetratree::Pair_cover cover(pair.body[0], pair.body[1], rule);
    if (preferred) cover.prefer(*preferred);
    try {
      if (cover()) {
        add_cover(text, cover.cover());
        return true;
      }
    } catch (const tetratree::Face_without_triangles& found) {
      refuse_whole(std::size_t(found.body), found.face);
    }
    if (!cover.common()) fail("two faces are nearer than the answer");
    add_common(text, pair, *cover.common());
    if (met) *met = *cover.common();
    return false;
  }

  void add_common(std::string& text, Placed_pair& pair, const tetratree::Common_point& common) const
  {
    const Rational_point x = rational(common.point, pair.weight);
    add_witness(text, {x, x}, {face_of(pair, common, 0), face_of(pair, common, 1)});
  }

  /// Returns the face of the file of which the piece of body k is a part.
  Index face_of(Placed_pair& pair, const tetratree::Common_point& common, std::size_t k) const
  {
    return file_face(k, pair.body[k].groups->piece_of(common.piece[k]).face);
  }

  /// Finds the winding number of a point in a body by a ray that meets no edge. Appends the ray, the number and the
  /// cover. Nothing where no ray of some is such, as from a point of the surface.
  std::optional<int> winding(std::string& text, Covered_body& body, const Exact_vector& x)
  {
    // The first ray leads away from the body's middle, which few faces of it meet if the point is outside.
    Exact_vector sum = {0, 0, 0};
    const auto& corners = body.groups->group({}).corners;
    for (const std::uint32_t v : corners) sum = kernel::detail::sum(sum, body.points.exact[v]);
    const Exact_number count(static_cast<double>(corners.size()));
    Exact_vector way = kernel::difference(kernel::detail::scaled(x, count), sum);
    constexpr int most_rays = 60;
    for (int k = 0; k < most_rays; ++k) {
      kernel::Hull_points rounded, none;
      rounded.exact = {way};
      kernel::round_together(rounded, none);
      // Few bits first, since short numbers are cheap to check.
      const int bits = 6 + k / 4;
      Exact_vector direction = {1, 1, 1};
      if (k == 0 && rounded.rounded[0] != kernel::Rounded_vector{})
        direction = kernel::rounded_to_bits(rounded.rounded[0], bits);
      else if (k > 0)
        for (Exact_number& c : direction) c = Exact_number(random(bits));
      if (direction == Exact_vector{0, 0, 0}) continue;
      Probe_cover cover(body, Probe{x, {}, direction});
      int winding = 0;
      const bool is_generic = cover([&](Box_id, const kernel::Exact_face& face, bool) {
        const auto count = kernel::generic_crossing(face, x, direction, cover.face());
        if (!count) return Probe_cover::Met::stops;
        winding += *count;
        cover.search().append("\"crossed\"");
        return Probe_cover::Met::is_covered;
      });
      if (!is_generic) continue;
      add_key(text, "ray");
      text += strings_of(in_lowest_terms(rational(direction)));
      add_key(text, "winding");
      text += std::to_string(winding);
      add_cover(text, cover.cover());
      return winding;
    }
    return std::nullopt;
  }

  using Winding_row = std::pair<std::string, int>;

  /// Returns the winding number of a point in body `holder` as a row, and the number; nothing as `winding`. `of` has
  /// the point's key and value.
  std::optional<Winding_row> winding_row(Placed_pair& pair, int holder, const std::string& of, const Exact_vector& x)
  {
    std::string row = "{";
    add_key(row, "in");
    row += holder == 0 ? "\"a\"," : "\"b\",";
    row += of;
    const auto number = winding(row, pair.body[holder], x);
    if (!number) return std::nullopt;
    return Winding_row{row + '}', *number};
  }

  /// Returns that of a vertex of body k in the other one. Requires one that is not on its surface.
  Winding_row winding_of_vertex(Placed_pair& pair, int k, Index v)
  {
    auto row = winding_row(pair, 1 - k, "\"vertex\":" + std::to_string(v), pair.body[k].points.exact[v]);
    if (!row) fail("no ray from a vertex goes through faces alone");
    return *std::move(row);
  }

  /// Appends the winding number of a vertex of each shell of both bodies. True where those of A are all inside of B, or
  /// all outside, as `a_is_inside` says, and those of B in A.
  bool all_windings(std::string& text, Placed_pair& pair, bool a_is_inside = false, bool b_is_inside = false)
  {
    std::vector<std::string> rows;
    bool found = true;
    for (int k = 0; k < 2; ++k)
      for (const Index v : parts[k].tree().tree().model().covering().shell_vertices()) {
        auto [row, number] = winding_of_vertex(pair, k, v);
        found = found && (number != 0) == (k == 0 ? a_is_inside : b_is_inside);
        rows.push_back(std::move(row));
      }
    add_key(text, "windings");
    add_list(text, rows, [](const std::string& row) { return row; });
    return found;
  }

  /// Appends the winding number of a vertex of body k that is inside of the other one. False where no shell is.
  bool one_winding(std::string& text, Placed_pair& pair, int k)
  {
    for (const Index v : parts[k].tree().tree().model().covering().shell_vertices()) {
      const auto [row, number] = winding_of_vertex(pair, k, v);
      if (number == 0) continue;
      add_key(text, "windings");
      text += '[' + row + ']';
      return true;
    }
    return false;
  }

  /// Returns the point that two leaves share, if there is one.
  std::optional<tetratree::Common_point> common_of(Placed_pair& pair, const tetratree::Box_ids& leaves)
  {
    const kernel::Exact_distance found =
        kernel::distance_of_faces(pair.body[0].face(leaves[0]), pair.body[1].face(leaves[1]));
    if (!found.is_zero()) return {};
    return tetratree::Common_point{{leaves[0], leaves[1]}, found.on_a};
  }

  std::string begin(std::string_view ask) const { return "{\"ask\":" + json_text(ask); }

  std::string begin(std::string_view ask, const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question)
  {
    std::string text = begin(ask);
    add_key(text, "question");
    text += json_text(kernel::to_string(question));
    add_pose(text, "pose_a", pose_a);
    add_pose(text, "pose_b", pose_b);
    return text;
  }

  void keep(std::string answer) { answers.push_back(std::move(answer) + "}"); }

  /// Counts an answer that has no proof.
  bool leave_out()
  {
    ++without_proof;
    return false;
  }

  /// Returns a face of the file that has the part which holds a nearest point.
  Index face_of(std::size_t body, const Holder& holder) const
  {
    const covering::Polyhedron& polyhedron = parts[body].polyhedron();
    if (holder.kind == Holder::Kind::face) return file_face(body, holder.number[0]);
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
        const auto loop = polyhedron.loop(f, l);
        for (std::size_t k = 0; k < loop.size(); ++k)
          if (loop[k] == holder.number[0] &&
              (holder.kind == Holder::Kind::vertex || loop[k + 1 == loop.size() ? 0 : k + 1] == holder.number[1]))
            return file_face(body, f);
      }
    fail("no face has the nearest point");
  }

  /// Proves that the nearest points are where they are, or that one solid holds a part of the other.
  void together(std::string& text, const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Nearest& nearest)
  {
    if (nearest.holder[0].kind != Holder::Kind::interior && nearest.holder[1].kind != Holder::Kind::interior) {
      std::array<Rational_point, 2> points;
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t c = 0; c < 3; ++c) points[k][c] = Rational(nearest.point[k][c]);
      add_witness(text, points, {face_of(0, nearest.holder[0]), face_of(1, nearest.holder[1])});
      return;
    }
    Placed_pair pair = placed(pose_a, pose_b);
    if (!one_winding(text, pair, 0) && !one_winding(text, pair, 1)) fail("no shell is inside of the other solid");
  }

  /// Proves that the bodies are farther apart than the root of `square`, or as far.
  void apart(std::string& text, const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
             const Rational& square, bool or_equal, const Nearest& nearest)
  {
    Placed_pair pair = placed(pose_a, pose_b);
    Rational_point way;
    for (std::size_t c = 0; c < 3; ++c) way[c] = Rational(nearest.point[1][c]) - Rational(nearest.point[0][c]);
    way = in_lowest_terms(way);
    const double limit = std::sqrt(square.get_d());
    kernel::Gap_rule rule{exact(square.get_num()) * pair.weight * pair.weight, exact(square.get_den()), or_equal, 0};
    if (std::isfinite(limit))
      rule.rounded = Exact_number(Exact_number(limit) * pair.weight * pair.rounding).to_double();
    if (!cover(text, pair, rule, Exact_vector{exact(way[0]), exact(way[1]), exact(way[2])}))
      fail("the bodies share a point");
    if (question == Question::solid && !all_windings(text, pair)) fail("one solid holds a part of the other");
  }

  /// Whether a point is inside of A, and of B.
  using Sides = std::array<bool, 2>;

  /// Appends a point for each of the sides, if random points about a place have them. Surfaces that cross there have
  /// all in any ball about it.
  bool sides(std::string& text, Placed_pair& pair, const kernel::Exact_point& place, std::vector<Sides> wanted)
  {
    kernel::Rounded_vector middle;
    double size = 0;
    for (int c = 0; c < 3; ++c) middle[c] = place.at[c].to_double() / place.weight.to_double();
    for (const Covered_body& body : pair.body)
      for (const Exact_vector& v : body.points.exact)
        for (int c = 0; c < 3; ++c) size = kernel::maximum(size, std::abs(v[c].to_double() - middle[c]));
    if (!std::isfinite(size)) return false;
    std::vector<std::string> rows;
    for (int n = 0; n < most_points && !wanted.empty(); ++n) {
      Exact_vector x;
      for (int c = 0; c < 3; ++c)
        x[c] = Exact_number(middle[c] + std::ldexp(size, 2 - n / points_of_a_size) * random(20) * 0x1p-20);
      Rational_point exact_x = rational(x);
      for (Rational& c : exact_x) c /= Rational(pair.weight);
      const std::string of = "\"point\":" + strings_of(exact_x);
      const auto in_a = winding_row(pair, 0, of, x), in_b = winding_row(pair, 1, of, x);
      if (!in_a || !in_b || std::erase(wanted, Sides{in_a->second != 0, in_b->second != 0}) == 0) continue;
      rows.push_back(in_a->first);
      rows.push_back(in_b->first);
    }
    add_key(text, "windings");
    add_list(text, rows, [](const std::string& row) { return row; });
    return wanted.empty();
  }

  /// Both bodies on lines between poses, with each time that was asked for.
  struct Moving_pair {
    Data* data;
    Poses from, to;
    std::map<double, Placed_pair> placed = {};

    Placed_pair& at(double time)
    {
      const auto found = placed.find(time);
      if (found != placed.end()) return found->second;
      const auto pose = [&](std::size_t k) { return kernel::Body_motion::linear(from[k], to[k]).at(Rational(time)); };
      return placed.emplace(time, data->placed(pose(0), pose(1))).first->second;
    }

    tetratree::Motion_cover::Bodies_at bodies()
    {
      return [this](double time) -> std::array<Covered_body, 2>& { return at(time).body; };
    }
  };

  /// Appends a cover over all times but the last, at which the surfaces may touch, and the windings at the first.
  /// `inside` is the body whose shells are inside of the other one; -1 where all are outside. True where it holds.
  bool leads_free(std::string& text, Moving_pair moving, int inside)
  {
    constexpr double shortest = 0x1p-8;  // of intervals: a way that needs shorter ones is given up
    tetratree::Motion_cover cover(moving.bodies(), 1, true, shortest);
    if (!cover()) return false;
    add_cover(text, cover.cover());
    return all_windings(text, moving.at(0), inside == 0, inside == 1);
  }

  /// A body and a pose near its own.
  using Start = std::pair<std::size_t, kernel::Pose>;

  /// Returns a point near the mean of the corners of placed body k, and a length like that of the body.
  static std::pair<Rational_point, double> middle_of(Placed_pair& pair, std::size_t k)
  {
    const auto& corners = pair.body[k].groups->group({}).corners;
    const double weight = Rational(pair.weight).get_d();
    kernel::Rounded_vector middle{};
    double size = 0;
    const auto at = [&](std::uint32_t v, std::size_t c) {
      return pair.body[k].points.exact[v][c].to_double() / weight;
    };
    for (const std::uint32_t v : corners)
      for (std::size_t c = 0; c < 3; ++c) middle[c] += at(v, c) / double(corners.size());
    for (const std::uint32_t v : corners)
      for (std::size_t c = 0; c < 3; ++c) size = kernel::maximum(size, std::abs(at(v, c) - middle[c]));
    if (!std::isfinite(size)) return {};
    return {{Rational(middle[0]), Rational(middle[1]), Rational(middle[2])}, size};
  }

  /// Returns the pieces that share a point.
  static std::array<kernel::Exact_face, 2> faces_of(Placed_pair& pair, const tetratree::Common_point& met)
  {
    return {pair.body[0].face(met.piece[0]), pair.body[1].face(met.piece[1])};
  }

  /// True when m is a direction along which hull a ends where hull b begins, or before.
  static bool leads_between(const Exact_vector& m, const kernel::Hull& a, const kernel::Hull& b)
  {
    return m != Exact_vector{0, 0, 0} && !(tetratree::extent_of(a, m, 1) > tetratree::extent_of(b, m, -1));
  }

  /// Returns where bodies may come from: smaller ones, or larger ones about another that they hold, and ones aside.
  std::vector<Start> starts(const Poses& poses, Placed_pair& pair, int inside, const tetratree::Common_point& met)
  {
    std::vector<Start> starts;
    const auto add = [&](std::size_t k, const Rational& factor, const Rational_point& shift) {
      std::array<Rational, 12> entries;
      for (std::size_t e = 0; e < 12; ++e) {
        entries[e] = factor * poses[k].exact(int(e));
        if (e % 4 == 3) entries[e] += shift[e / 4];
        if (!std::isfinite(kernel::nearest_double(entries[e]))) return;
      }
      starts.emplace_back(k, kernel::Pose(entries));
    };
    double size = HUGE_VAL;
    for (const double share : {0.5, 0x1p-4})
      for (std::size_t k = 0; k < 2; ++k) {
        const auto [middle, length] = middle_of(pair, k);
        size = kernel::minimum(size, length);
        const Rational factor = inside == int(1 - k) ? 1 + share : 1 - share;
        add(k, factor, {(1 - factor) * middle[0], (1 - factor) * middle[1], (1 - factor) * middle[2]});
      }
    for (const Exact_vector& m : parting_directions(faces_of(pair, met))) {
      if (!leads_between(m, pair.body[0].hull(met.piece[0]), pair.body[1].hull(met.piece[1]))) continue;
      Rational_point aside = in_lowest_terms(rational(m));
      const Rational longest = longest_part(aside);
      for (Rational& x : aside) x *= -Rational(size / 16) / longest;
      add(0, 1, aside);
    }
    return starts;
  }

  /// Appends a way of one body to its pose, before the end of which the surfaces share no point. False where none of
  /// the few that are tried is such. `inside` is as for `leads_free`. `met` is a point that the bodies share at their
  /// poses.
  bool way(std::string& text, const Poses& poses, Placed_pair& pair, int inside, const tetratree::Common_point& met)
  {
    for (const auto& [mover, from] : starts(poses, pair, inside, met)) {
      Poses start = poses;
      start[mover] = from;
      std::string row = text + "{\"of\":\"" + (mover == 0 ? 'a' : 'b') + '"';
      add_pose(row, "pose", from);
      if (!leads_free(row, {this, start, poses}, inside)) continue;
      text = row + '}';
      return true;
    }
    return false;
  }

  /// Appends why the interiors share no point: a plane between the bodies, or a way of one without contact.
  bool parted(std::string& text, const Poses& poses, Placed_pair& pair, const tetratree::Common_point& met)
  {
    for (const Exact_vector& m : parting_directions(faces_of(pair, met))) {
      if (!leads_between(m, pair.body[0].hull({}), pair.body[1].hull({}))) continue;
      add_key(text, "plane");
      text += strings_of(in_lowest_terms(rational(m)));
      return true;
    }
    add_key(text, "way");
    return way(text, poses, pair, -1, met);
  }

  /// Appends a point that is inside of body `holder`, or outside. A segment from it follows, which meets the surface at
  /// its end x at the earliest. The segment leads against `along` where that is given. False where none of some is
  /// such.
  bool approach(std::string& text, const Poses& poses, std::size_t holder, const Rational_point& x, bool is_inside,
                const std::optional<Rational_point>& along = {})
  {
    Placed_pair pair = placed(poses[0], poses[1]);
    const double size = middle_of(pair, holder).second, length = along ? longest_part(*along).get_d() : 1;
    const mpz_class common = along ? lcm(common_denominator(x), common_denominator(*along)) : common_denominator(x);
    pair.body[holder] = placed(holder, poses[holder], poses[1 - holder], exact(Rational(common)));
    const auto weighted = [by = Rational(Rational(common) * Rational(pair.weight))](const Rational_point& p) {
      return Exact_vector{exact(p[0] * by), exact(p[1] * by), exact(p[2] * by)};
    };
    for (int n = 0; n < most_points; ++n) {
      Rational_point y = x;
      const double far = std::ldexp(size, 1 - n / points_of_a_size);
      if (along && n % points_of_a_size > 0) continue;
      for (std::size_t c = 0; c < 3; ++c)
        y[c] += along ? Rational(Rational(std::exp2(std::rint(std::log2(far / length)))) * (*along)[c])
                      : Rational(far * random(10) * 0x1p-10);
      if (y == x) continue;
      const auto row = winding_row(pair, int(holder), "\"point\":" + strings_of(y), weighted(y));
      if (!row || (row->second != 0) != is_inside) continue;
      Probe_cover cover(pair.body[holder], Probe{weighted(y), weighted(x), {}});
      const bool is_free = cover([&](Box_id, const kernel::Exact_face& f, bool) {
        const auto m = kernel::direction_of_first_touch(f, weighted(y), weighted(x));
        if (!m) return Probe_cover::Met::stops;
        cover.search().append(cover.search().add(*m));
        return Probe_cover::Met::is_covered;
      });
      if (!is_free) continue;
      text += "{\"winding\":" + row->first;
      add_cover(text, cover.cover());
      text += '}';
      return true;
    }
    return false;
  }

  /// Appends why a point of the inner body is not in the interior of the other one.
  bool border(std::string& text, const Poses& poses, Placed_pair& pair, int inner, const tetratree::Common_point& met)
  {
    const Rational_point x = rational(met.point, pair.weight);
    add_key(text, "border");
    text += "{\"face\":" + std::to_string(face_of(pair, met, std::size_t(inner)));
    add_key(text, "point");
    text += strings_of(x);
    add_key(text, "outside");
    if (!approach(text, poses, std::size_t(1 - inner), x, false)) return false;
    text += '}';
    return true;
  }

  /// Appends why the interiors share a point just before A, moved along a direction, comes to its pose.
  bool just_before(std::string& text, const Poses& poses, const Rational_point& along)
  {
    Placed_pair pair = placed(poses[0], poses[1]);
    std::string unused = "{";
    tetratree::Common_point met;
    if (cover(unused, pair, {}, {}, &met)) return false;
    const std::array<Rational_point, 2> ahead = {along, {-along[0], -along[1], -along[2]}};
    for (const Rational_point& x : points_near(pair, met))
      for (const std::size_t k : {1, 0}) {  // the body of the segment along the direction
        std::string both = text + (text.back() == '[' ? "{" : ",{");
        add_key(both, "point");
        both += strings_of(x);
        add_key(both, k == 0 ? "in_a" : "in_b");
        if (!approach(both, poses, k, x, true, ahead[k])) continue;
        add_key(both, k == 0 ? "in_b" : "in_a");
        if (!approach(both, poses, 1 - k, x, true)) continue;
        text = both + '}';
        return true;
      }
    return false;
  }

  /// Returns a common point, and points from it towards the middles of both pieces. Where faces touch in an area, the
  /// point may be on its border, and the others are within.
  static std::vector<Rational_point> points_near(Placed_pair& pair, const tetratree::Common_point& met)
  {
    const Rational_point x = rational(met.point, pair.weight);
    std::array<Rational_point, 3> way{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& corners = pair.body[k].groups->group(met.piece[k]).corners;
      const Rational share(1, std::uint32_t(corners.size()));
      for (const std::uint32_t v : corners) {
        const Rational_point at = rational(pair.body[k].points.exact[v]);
        for (std::size_t c = 0; c < 3; ++c) way[k][c] += share * (at[c] / Rational(pair.weight) - x[c]);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) way[2][c] = (way[0][c] + way[1][c]) / 2;
    std::vector<Rational_point> points = {x};
    for (const Rational& part : {Rational(1, 2), Rational(1, 16), Rational(1, 256)})
      for (const Rational_point& w : way)
        points.push_back({x[0] + part * w[0], x[1] + part * w[1], x[2] + part * w[2]});
    return points;
  }

  /// True when both bodies have the same faces, by the places of their corners.
  bool have_same_faces(Placed_pair& pair) const
  {
    using Face = std::vector<std::vector<Exact_vector>>;
    std::array<std::vector<Face>, 2> faces;
    for (std::size_t k = 0; k < 2; ++k) {
      const covering::Polyhedron& polyhedron = parts[k].polyhedron();
      for (Index f = 0; f < polyhedron.face_count(); ++f) {
        Face face(polyhedron.loop_count(f));
        for (std::size_t l = 0; l < face.size(); ++l) {
          for (const Index v : polyhedron.loop(f, l)) face[l].push_back(pair.body[k].points.exact[v]);
          std::rotate(face[l].begin(), std::ranges::min_element(face[l]), face[l].end());
        }
        std::ranges::sort(face);
        faces[k].push_back(std::move(face));
      }
      std::ranges::sort(faces[k]);
    }
    return faces[0] == faces[1];
  }

  /// Random points that a search tries, and how many of them are as near to a place.
  static constexpr int most_points = 192, points_of_a_size = 8;

  /// Adds an answer. `leaves` are those at which the query found that the surfaces meet, if it says so.
  void collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, Relation answer,
               const std::optional<tetratree::Box_ids>& leaves);

  /// Appends why the interiors share no point at these poses. `met` is a common point, if the surfaces share one.
  bool interiors_apart(std::string& text, const Poses& poses, tetratree::Common_point& met);

  std::string text() const;
  std::string text_of(const Part& part) const;
};

Certificate::Certificate(const Body& body) : data_(std::make_unique<Data>()) { data_->parts.emplace_back(body.data_); }
Certificate::Certificate(const Body& a, const Body& b) : data_(std::make_unique<Data>())
{
  data_->parts.emplace_back(a.data_);
  data_->parts.emplace_back(b.data_);
}
Certificate::Certificate(const Query& query) : data_(std::make_unique<Data>())
{
  data_->parts.emplace_back(query.data().a);
  data_->parts.emplace_back(query.data().b);
}
Certificate::~Certificate() = default;
Certificate::Certificate(Certificate&&) noexcept = default;
Certificate& Certificate::operator=(Certificate&&) noexcept = default;

void Certificate::name_file(std::size_t body, Certified_file file)
{
  data_->parts[body].source_face = file.source_face;
  data_->parts[body].file = std::move(file);
}

Answer Certificate::collide(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  tetratree::Pair_memory memory;
  const Answer answer = query.collide(pose_a, pose_b, memory);
  data_->collide(pose_a, pose_b, query.data().question, answer.relation(), memory.witness);
  return answer;
}

Nearest Certificate::distance(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  Nearest nearest = query.nearest(pose_a, pose_b);
  distance(pose_a, pose_b, query.data().question, nearest);
  return nearest;
}

bool Certificate::within(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit)
{
  const bool answer = query.within(pose_a, pose_b, limit);
  within(pose_a, pose_b, query.data().question, limit, answer, query.nearest(pose_a, pose_b));
  return answer;
}

Solid_contact Certificate::relation(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  const Solid_contact contact = query.solid_relation(pose_a, pose_b);
  relation(pose_a, pose_b, contact.relation);
  return contact;
}

Exits Certificate::exits(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                         const std::array<std::string, 3>& direction)
{
  Exits answer = query.exits(pose_a, pose_b, direction);
  exits(pose_a, pose_b, direction, answer);
  return answer;
}

Depth Certificate::depth(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                         const Depth_options& options)
{
  Depth answer = query.depth(pose_a, pose_b, options);
  depth(pose_a, pose_b, answer);
  return answer;
}

std::size_t Certificate::without_proof() const { return data_->without_proof; }

void Certificate::collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, Relation answer)
{
  data_->collide(pose_a, pose_b, question, answer, {});
}

void Certificate::Data::collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                                Relation answer, const std::optional<tetratree::Box_ids>& leaves)
{
  std::string text = begin("collide", pose_a, pose_b, question);
  add_key(text, "answer");
  text += json_text(kernel::to_string(answer));
  Placed_pair pair = placed(pose_a, pose_b);
  if (answer == Relation::surfaces && leaves) {
    const auto met = common_of(pair, *leaves);
    if (met) {
      add_common(text, pair, *met);
      keep(std::move(text));
      return;
    }
  }
  const bool shares_none = cover(text, pair, {});
  if (shares_none != (answer != Relation::surfaces)) fail("the answer is not proved: surfaces");
  if (shares_none && question == Question::solid &&
      !(answer == Relation::apart ? all_windings(text, pair)
                                  : one_winding(text, pair, answer == Relation::a_in_b ? 0 : 1)))
    fail("the answer is not proved: shells");
  keep(std::move(text));
}

void Certificate::distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                           const Nearest& nearest)
{
  std::string text = data_->begin("distance", pose_a, pose_b, question);
  add_key(text, "answer");
  text += json_text(nearest.squared);
  data_->together(text, pose_a, pose_b, nearest);
  if (const Rational square(nearest.squared); square != 0)
    data_->apart(text, pose_a, pose_b, question, square, true, nearest);
  data_->keep(std::move(text));
}

void Certificate::within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                         const std::string& limit, bool answer, const Nearest& nearest)
{
  std::string text = data_->begin("within", pose_a, pose_b, question);
  add_key(text, "limit");
  text += json_text(limit);
  add_key(text, "answer");
  text += answer ? '1' : '0';
  const Rational exact_limit = kernel::parse_number(limit).value();
  if (answer)
    data_->together(text, pose_a, pose_b, nearest);
  else if (sgn(exact_limit) >= 0)
    data_->apart(text, pose_a, pose_b, question, exact_limit * exact_limit, false, nearest);
  data_->keep(std::move(text));
}

void Certificate::inside(const std::array<std::string, 3>& point, Location answer)
{
  kernel::require_sound_floating_point();
  std::string text = data_->begin("inside");
  add_key(text, "point");
  add_list(text, point, [](const std::string& x) { return json_text(x); });
  add_key(text, "answer");
  text += std::to_string(int(answer));
  Rational_point x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = kernel::parse_number(point[k]).value();
  data_->only();
  const Exact_number weight = exact(Rational(common_denominator(x)));
  Covered_body body = data_->placed(0, kernel::Pose(), kernel::Pose(), weight);
  const Exact_vector at = {exact(x[0] * Rational(weight)), exact(x[1] * Rational(weight)),
                           exact(x[2] * Rational(weight))};
  if (answer == Location::on_surface) {
    Probe_cover cover(body, Probe{at, {}, {}});
    std::optional<Index> found;
    cover([&](Box_id piece, const kernel::Exact_face&, bool is_apart) {
      if (is_apart) {
        cover.search().append("0");
        return Probe_cover::Met::is_covered;
      }
      found = body.groups->piece_of(piece).face;
      return Probe_cover::Met::stops;
    });
    if (!found) fail("no face holds the point");
    add_key(text, "face");
    text += std::to_string(data_->file_face(0, *found));
  } else {
    const auto number = data_->winding(text, body, at);
    if (!number || (*number != 0) != (answer == Location::inside)) fail("the answer is not proved: the winding number");
  }
  data_->keep(std::move(text));
}

bool Certificate::relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Solid_relation answer)
{
  std::string text = data_->begin("relation");
  add_pose(text, "pose_a", pose_a);
  add_pose(text, "pose_b", pose_b);
  add_key(text, "answer");
  text += json_text(kernel::to_string(answer));
  const Data::Poses poses = {pose_a, pose_b};
  Placed_pair pair = data_->placed(pose_a, pose_b);
  std::string witness = text;
  tetratree::Common_point met;
  const bool shares_none = data_->cover(witness, pair, {}, {}, &met);
  const bool is_without =
      answer == Solid_relation::disjoint || answer == Solid_relation::inside || answer == Solid_relation::contains;
  if (shares_none != is_without) fail("the answer is not proved: surfaces");
  if (is_without) {
    if (!data_->all_windings(witness, pair, answer == Solid_relation::inside, answer == Solid_relation::contains))
      fail("the answer is not proved: shells");
    data_->keep(std::move(witness));
    return true;
  }
  const auto is_proved = [&] {
    switch (answer) {
      case Solid_relation::meet:
        text = witness;
        return data_->parted(text, poses, pair, met) &&
               data_->sides(text, pair, met.point, {{true, false}, {false, true}});
      case Solid_relation::overlap:
        return data_->sides(text, pair, met.point, {{true, true}, {true, false}, {false, true}});
      case Solid_relation::equal:
        if (data_->have_same_faces(pair)) return true;
        add_key(text, "ways");
        text += '[';
        if (!data_->way(text, poses, pair, 0, met)) return false;
        text += ',';
        if (!data_->way(text, poses, pair, 1, met)) return false;
        text += ']';
        return true;
      default: {
        const int inner = answer == Solid_relation::covered_by ? 0 : 1;
        add_key(text, "way");
        return data_->way(text, poses, pair, inner, met) && data_->border(text, poses, pair, inner, met) &&
               data_->sides(text, pair, met.point, {{inner == 1, inner == 0}});
      }
    }
  };
  if (!is_proved()) return data_->leave_out();
  data_->keep(std::move(text));
  return true;
}

namespace {

/// Returns the pose, moved by a vector.
kernel::Pose moved(const kernel::Pose& pose, const Rational_point& by)
{
  std::array<Rational, 12> entries;
  for (std::size_t k = 0; k < 12; ++k) entries[k] = pose.exact(int(k)) + (k % 4 == 3 ? by[k / 4] : Rational(0));
  return kernel::Pose(entries);
}

}  // namespace

bool Certificate::Data::interiors_apart(std::string& text, const Poses& poses, tetratree::Common_point& met)
{
  Placed_pair pair = placed(poses[0], poses[1]);
  std::string unused = "{";
  if (!cover(unused, pair, {}, {}, &met)) return parted(text, poses, pair, met);
  // Without a common point, the way of a body that stays is free.
  add_key(text, "way");
  text += "{\"of\":\"a\"";
  add_pose(text, "pose", poses[0]);
  if (!leads_free(text, {this, poses, poses}, -1)) return false;
  text += '}';
  return true;
}

bool Certificate::exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                        const std::array<std::string, 3>& direction, const Exits& answer)
{
  std::string text = data_->begin("exit");
  add_pose(text, "pose_a", pose_a);
  add_pose(text, "pose_b", pose_b);
  add_key(text, "direction");
  add_list(text, direction, [](const std::string& x) { return json_text(x); });
  add_key(text, "answer");
  const std::array<Rational, 2> exit = {Rational(answer.exact_first), Rational(answer.exact_last)};
  text += strings_of(exit);
  Rational_point along;
  for (std::size_t k = 0; k < 3; ++k) along[k] = kernel::parse_number(direction[k]).value();
  const auto shifted = [&](const Rational& s) {
    return Data::Poses{moved(pose_a, {s * along[0], s * along[1], s * along[2]}), pose_b};
  };
  tetratree::Common_point met;
  if (!data_->interiors_apart(text, shifted(exit[0]), met)) return data_->leave_out();

  // Beyond `until`, a plane across the direction is between the bodies.
  const Data::Poses last = shifted(exit[1]);
  Placed_pair pair = data_->placed(last[0], last[1]);
  const Rational_point m = in_lowest_terms(along);
  const Exact_vector across = {exact(m[0]), exact(m[1]), exact(m[2])};
  const Exact_number between =
      kernel::extent(pair.body[1].hull({}), across, 1) - kernel::extent(pair.body[0].hull({}), across, -1);
  Rational until = Rational(between) / Rational(pair.weight) / kernel::dot(m, along);
  if (until <= 0) until = 1;
  add_key(text, "gone");
  text += "{\"until\":" + json_text(kernel::to_string(until));
  if (!data_->leads_free(text, {data_.get(), shifted(exit[1] + until), last}, -1)) return data_->leave_out();
  text += "}";
  add_key(text, "before");
  text += '[';
  if (exit[0] > 0)
    for (const Rational& s : exit)
      if (!data_->just_before(text, shifted(s), along)) return data_->leave_out();
  text += ']';
  data_->keep(std::move(text));
  return true;
}

bool Certificate::depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth& answer)
{
  std::string text = data_->begin("depth");
  add_pose(text, "pose_a", pose_a);
  add_pose(text, "pose_b", pose_b);
  add_key(text, "answer");
  text += json_text(answer.exact_square);
  Rational_point v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = Rational(answer.exact_vector[k]);
  add_key(text, "vector");
  text += strings_of(v);
  tetratree::Common_point met;
  if (!data_->interiors_apart(text, {moved(pose_a, v), pose_b}, met)) return data_->leave_out();
  data_->keep(std::move(text));
  return true;
}

bool Certificate::first_contact(const Motion& a, const Motion& b, Question question,
                                const std::optional<First_contact>& answer)
{
  kernel::require_sound_floating_point();
  const auto &ends_a = a.exact().ends(), &ends_b = b.exact().ends();
  if (!ends_a || !ends_b) return data_->leave_out();
  std::string text = data_->begin("motion");
  add_key(text, "question");
  text += json_text(kernel::to_string(question));
  for (const auto& [body, ends] : {std::pair("a", &*ends_a), {"b", &*ends_b}})
    for (int k = 0; k < 2; ++k) add_pose(text, std::string(k == 0 ? "from_" : "to_") + body, (*ends)[k]);
  add_key(text, "answer");
  if (answer)
    add_list(text, std::array{answer->lo, answer->hi}, [](double t) { return json_text(kernel::shortest(t)); });
  else
    text += "null";
  Data::Moving_pair moving{data_.get(), {(*ends_a)[0], (*ends_b)[0]}, {(*ends_a)[1], (*ends_b)[1]}};
  if (answer) {
    std::string witness = "{";
    const bool shares_none = data_->cover(witness, moving.at(answer->hi), {});
    if (!shares_none) {
      // The witness is the only key; its time stands first in it.
      const std::string key = "\"witness\":{";
      text += ",\"witness\":{\"time\":" + json_text(kernel::to_string(Rational(answer->hi))) + "," +
              witness.substr(1 + key.size());
    } else if (answer->hi != 0 ||
               !(data_->one_winding(text, moving.at(0), 0) || data_->one_winding(text, moving.at(0), 1))) {
      return data_->leave_out();
    }
    if (answer->hi == 0) {
      data_->keep(std::move(text));
      return true;
    }
  }
  const double end = answer ? answer->lo : 1;
  tetratree::Motion_cover cover(moving.bodies(), end, answer && answer->lo == answer->hi);
  if (!cover()) return data_->leave_out();
  add_cover(text, cover.cover());
  if (question == Question::solid && !data_->all_windings(text, moving.at(0))) fail("the answer is not proved: shells");
  data_->keep(std::move(text));
  return true;
}

namespace {

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
  if (!t) fail("the ray does not meet the face");
  return *t;
}

}  // namespace

void Certificate::first_hit(const Ray& ray, const std::optional<Ray_hit>& answer, double end)
{
  kernel::require_sound_floating_point();
  std::string text = data_->begin("ray");
  for (const auto& [key, numbers] : {std::pair("origin", ray.origin), {"direction", ray.direction}}) {
    add_key(text, key);
    add_list(text, numbers, [](double x) { return json_text(kernel::shortest(x)); });
  }
  if (std::isfinite(end)) {
    add_key(text, "end");
    text += json_text(kernel::shortest(end));
  }
  add_key(text, "answer");
  Data::Part& part = data_->only();
  kernel::Rational_ray exact_ray;
  for (std::size_t k = 0; k < 3; ++k) {
    exact_ray.origin[k] = ray.origin[k];
    exact_ray.direction[k] = ray.direction[k];
  }
  std::optional<Rational> t;
  Index face = 0;
  if (answer) {
    t = first_time(part.polyhedron(), answer->face, exact_ray);
    face = data_->file_face(0, answer->face);
    text += "{\"face\":" + std::to_string(face) + ",\"t\":" + json_text(kernel::to_string(*t)) + "}";
  } else {
    text += "null";
    if (end < 0) return data_->keep(std::move(text));
    if (std::isfinite(end)) t = end;
  }
  Rational_point last = exact_ray.origin;
  if (t)
    for (std::size_t k = 0; k < 3; ++k) last[k] += *t * exact_ray.direction[k];
  const Rational weight(common_denominator(last));
  Covered_body body = data_->placed(0, kernel::Pose(), kernel::Pose(), exact(weight));
  Probe probe;
  const auto weighted = [&](const Rational_point& x) {
    return Exact_vector{exact(x[0] * weight), exact(x[1] * weight), exact(x[2] * weight)};
  };
  probe.start = weighted(exact_ray.origin);
  if (!t)
    probe.direction = of_length_near_1(ray.direction);
  else if (*t != 0)
    probe.end = weighted(last);
  Probe_cover cover(body, probe);
  std::optional<Index> met;
  const bool is_covered = cover([&](Box_id piece, const kernel::Exact_face& f, bool) {
    met = body.groups->piece_of(piece).face;
    const bool may_touch = answer && body.groups->group(piece).least_face >= face;
    if (may_touch && !probe.end) {
      cover.search().append("\"touched\"");
      return Probe_cover::Met::is_covered;
    }
    const auto m = may_touch ? kernel::direction_of_first_touch(f, probe.start, *probe.end) : std::nullopt;
    if (!m) return Probe_cover::Met::stops;
    cover.search().append(cover.search().add(*m));
    return Probe_cover::Met::is_covered;
  });
  if (!is_covered) data_->refuse_whole(0, *met);
  add_cover(text, cover.cover());
  data_->keep(std::move(text));
}

std::string Certificate::Data::text_of(const Part& part) const
{
  std::string text = "{";
  const covering::Polyhedron& polyhedron = part.polyhedron();
  if (part.file) {
    add_key(text, "file");
    text += json_text(part.file->name);
    add_key(text, "sha256");
    text += json_text(part.file->sha256);
  } else {
    add_key(text, "vertices");
    add_list(text, polyhedron.vertices, [](const covering::Vertex& v) {
      std::string row;
      add_list(row, v, [](double x) { return json_text(kernel::shortest(x)); });
      return row;
    });
    std::vector<Index> faces(polyhedron.face_count());
    std::iota(faces.begin(), faces.end(), Index(0));
    add_key(text, "faces");
    add_list(text, faces, [&](Index f) {
      std::string row = "[";
      for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
        if (l > 0) row += ',';
        add_list(row, polyhedron.loop(f, l), [](Index v) { return std::to_string(v); });
      }
      return row + "]";
    });
  }
  if (!part.groups) return text + "}";
  const tetratree::Group_tree& groups = *part.groups;
  // A face of the file is not cut where it is one piece.
  std::vector<std::string> cut;
  for (std::size_t first = 0, next = 0; first < groups.piece_count(); first = next) {
    const Index face = part.source_face[groups.piece(first).face];
    while (next < groups.piece_count() && part.source_face[groups.piece(next).face] == face) ++next;
    const tetratree::Element& only = groups.piece(first);
    if (next == first + 1 && (only.is_whole_face() || polyhedron.is_triangle(only.face))) continue;
    for (std::size_t n = first; n < next; ++n) {
      const tetratree::Element& e = groups.piece(n);
      std::vector<Index> row = {face};
      groups.tree().for_vertices(e, [&](Index v) { row.push_back(v); });
      std::string numbers;
      add_list(numbers, row, [](Index v) { return std::to_string(v); });
      cut.push_back(std::move(numbers));
    }
  }
  if (!cut.empty()) {
    add_key(text, "cut");
    add_list(text, cut, [](const std::string& row) { return row; });
  }
  if (groups.is_opened()) {
    add_key(text, "groups");
    groups.write(text);
  }
  return text + "}";
}

std::string Certificate::text() const
{
  std::string text = "{\"certificate\":\"tetracone 1\",\n\"bodies\":";
  add_list(text, data_->parts, [&](const Data::Part& part) { return data_->text_of(part); });
  text += ",\n\"answers\":[\n";
  for (std::size_t k = 0; k < data_->answers.size(); ++k) text += (k == 0 ? "" : ",\n") + data_->answers[k];
  return text + "\n]}\n";
}

}  // namespace tetracone
