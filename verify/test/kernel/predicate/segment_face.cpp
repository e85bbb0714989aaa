#include "tetracone/kernel/predicate/segment_face.h"

#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/plane_basis.h"
#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/segment_truth.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_segment_face)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Kernels = std::tuple<Float, Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;
using Corners = std::array<Vertex, 3>;

/// A face of several loops; any corner of it is the origin of its covering.
template <class K>
class Face {
 public:
  explicit Face(const Loops& loops, std::size_t origin = 0)
  {
    std::vector<Vertex> corners;
    for (const auto& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        from_.push_back(point<K>(loop[k]));
        to_.push_back(point<K>(loop[(k + 1) % loop.size()]));
        corners.push_back(loop[k]);
      }
    origin_ = origin % from_.size();
    basis_ = tetracone::kernel::plane_basis(corners.size(), [&](std::size_t k) -> const Vertex& { return corners[k]; });
  }

  std::size_t edge_count() const { return from_.size(); }
  const Point<K>& from(std::size_t k) const { return from_[k]; }
  const Point<K>& to(std::size_t k) const { return to_[k]; }
  const Point<K>& origin() const { return from_[origin_]; }
  bool is_degenerate() const { return !basis_; }
  const Point<K>& plane_basis(int k) const { return from_[(*basis_)[std::size_t(k)]]; }

 private:
  std::vector<Point<K>> from_, to_;
  std::size_t origin_;
  std::optional<std::array<std::size_t, 3>> basis_;
};

template <class K>
Contact face_contact(const Vertex& p, const Vertex& q, const Loops& loops, std::size_t origin = 0)
{
  return segment_face<K>(point<K>(p), point<K>(q), Face<K>(loops, origin));
}

template <class K>
Contact triangle_contact(const Vertex& p, const Vertex& q, const Corners& t)
{
  return segment_triangle<K>(point<K>(p), point<K>(q), point<K>(t[0]), point<K>(t[1]), point<K>(t[2]));
}

/// A face and a segment of small integers. Ends are corners now and then, or in the face's plane.
struct Sample {
  Vertex p, q;
  Loops loops;
  bool is_in_plane;

  explicit Sample(Random& random) : loops(random_loops(random, 2))
  {
    const int height = integer(random, 0, 1);
    const auto end = [&]() -> Vertex {
      const auto& loop = loops[std::size_t(integer(random, 0, int(loops.size()) - 1))];
      if (integer(random, 0, 3) == 0) return loop[std::size_t(integer(random, 0, int(loop.size()) - 1))];
      Vertex v = grid_vertex(random, 3);
      v[2] = integer(random, -height, height);
      return v;
    };
    p = end();
    q = integer(random, 0, 9) == 0 ? p : end();
    is_in_plane = p[2] == 0 && q[2] == 0;
    // By small integers into any plane, which changes no contact.
    const Pose pose = random_affine(random, 1);
    const auto place = [&pose](Vertex& v) {
      const Vertex at = v;
      for (int i = 0; i < 3; ++i) v[i] = pose[4 * i] * at[0] + pose[4 * i + 1] * at[1] + pose[4 * i + 2] * at[2];
    };
    place(p);
    place(q);
    for (auto& loop : loops)
      for (Vertex& v : loop) place(v);
  }

  /// Where edges cross in one point, a segment of their plane through it overlaps by contract.
  bool agrees(Contact found, Contact truth) const
  {
    return found == truth || (is_in_plane && found == Contact::coplanar_overlap && truth == Contact::edge_edge);
  }
};

KERNEL_TEST_CASE(random_triangles_meet_segments_as_integers_say_in_any_order, K, Kernels)
{
  Random random(2);
  int wrong = 0;
  std::map<Contact, int> seen;
  for (int n = 0; n < 4'000; ++n) {
    // In space, or nearly all on few lines and planes.
    const int radius = 1 + n % 2;
    const auto any = [&] { return grid_vertex(random, radius); };
    const Vertex p = any(), q = n % 20 == 0 ? p : any();
    Corners t = {any(), any(), any()};
    if (n % 3 == 0)
      for (Vertex& v : t) v[2] = 0;
    const Contact truth = true_contact(p, q, {{t[0], t[1], t[2]}});
    ++seen[truth];
    std::sort(t.begin(), t.end());
    do {
      wrong += triangle_contact<K>(p, q, t) != truth || triangle_contact<K>(q, p, t) != truth;
      wrong += segment_face<K>(point<K>(p), point<K>(q), Triangle<K>{point<K>(t[0]), point<K>(t[1]), point<K>(t[2])}) !=
               truth;
    } while (std::next_permutation(t.begin(), t.end()));
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(seen.size() == 7u);
  for (const auto& [kind, count] : seen) BOOST_TEST(count > 2, to_string(kind));
}

KERNEL_TEST_CASE(random_faces_meet_segments_as_integers_say_whatever_their_order_and_origin, K, Kernels)
{
  Random random(4);
  int wrong = 0, crossings = 0, flat = 0;
  std::map<Contact, int> seen;
  for (int n = 0; n < 6'000; ++n) {
    Sample sample(random);
    auto& [p, q, loops, is_in_plane] = sample;
    const Contact truth = true_contact(p, q, loops);
    ++seen[truth];
    const auto ask = [&](std::size_t origin) {
      const Contact found = face_contact<K>(p, q, loops, origin);
      wrong += !sample.agrees(found, truth);
      crossings += found != truth;
    };
    flat += Face<K>(loops).is_degenerate();
    for (std::size_t origin = 0; origin < 4; ++origin) ask(origin);
    std::swap(p, q);
    ask(0);
    for (auto& loop : loops)
      std::rotate(loop.begin(), loop.begin() + integer(random, 0, int(loop.size()) - 1), loop.end());
    std::reverse(loops.begin(), loops.end());
    ask(0);
    for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
    ask(0);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(flat > 200);
  BOOST_TEST(crossings > 0);
  BOOST_TEST(crossings < 2'000);
  BOOST_TEST(seen.size() == 7u);
}

BOOST_AUTO_TEST_CASE(where_edges_cross_in_one_point_a_coplanar_segment_through_it_overlaps)
{
  // A bow-tie, and the segment that touches it in its knot only: the one kind that is not told. Across the plane it is.
  const Loops bow_tie = {{{-2, -1, 0}, {2, 1, 0}, {2, -1, 0}, {-2, 1, 0}}};
  const auto contact = [&](const Vertex& p, const Vertex& q) { return face_contact<Rational_kernel>(p, q, bow_tie); };
  BOOST_TEST((contact({0, -1, 0}, {0, 1, 0}) == Contact::coplanar_overlap));
  BOOST_TEST((true_contact({0, -1, 0}, {0, 1, 0}, bow_tie) == Contact::edge_edge));
  BOOST_TEST((contact({0, 0, 0}, {0, 1, 0}) == Contact::vertex_edge));
  BOOST_TEST((contact({0, 0, -1}, {0, 0, 1}) == Contact::edge_edge));
}

BOOST_AUTO_TEST_SUITE_END()
