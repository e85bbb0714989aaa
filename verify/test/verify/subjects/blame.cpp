#include "verify/subjects/blame.h"

#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/tetrahedron.h"
#include "verify/shrink/shrink.h"
#include "verify/subjects/blame_stages.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <string>

// Kernels in double, each with one formula that no arithmetic repairs.
namespace tetracone::verify {
namespace {

struct Wrong_volume : kernel::Double {};   // a determinant with a plus for a minus
struct Wrong_side : kernel::Double {};     // sides turned round, where a point is sought in a solid
struct Wrong_image : kernel::Double {};    // a matrix with its rows for its columns
struct Wrong_classes : kernel::Double {};  // a triangle is in a cone only as a whole

}  // namespace
}  // namespace tetracone::verify

namespace tetracone::kernel {

using verify::Wrong_classes;
using verify::Wrong_image;
using verify::Wrong_side;
using verify::Wrong_volume;

template <>
struct Kernel_traits<Wrong_volume> : Kernel_traits<Double> {};
template <>
struct Kernel_traits<Wrong_side> : Kernel_traits<Double> {};
template <>
struct Kernel_traits<Wrong_image> : Kernel_traits<Double> {};
template <>
struct Kernel_traits<Wrong_classes> : Kernel_traits<Double> {
  using Fixed = Wrong_classes;
};

template <>
Sign volume_sign<Wrong_volume>(const Double::Point_3& a, const Double::Point_3& b, const Double::Point_3& c,
                               const Double::Point_3& d)
{
  const auto p = b - a, q = c - a, r = d - a;
  return CGAL::sign((p.y() * q.z() + p.z() * q.y()) * r.x() + (p.z() * q.x() - p.x() * q.z()) * r.y() +
                    (p.x() * q.y() - p.y() * q.x()) * r.z());
}

template <>
Sign perturbed_side<Wrong_side>(const Double::Point_3& a, const Double::Point_3& b, const Double::Point_3& c,
                                const Double::Point_3& p)
{
  return volume_sign<Double>(b, a, c, p);
}

template <>
Double::Point_3 Frame<Wrong_image>::operator()(const Double::Point_3& p) const
{
  const auto& m = entries_;
  return {m[0] * p.x() + m[4] * p.y() + m[8] * p.z() + m[3], m[1] * p.x() + m[5] * p.y() + m[9] * p.z() + m[7],
          m[2] * p.x() + m[6] * p.y() + m[10] * p.z() + m[11]};
}

}  // namespace tetracone::kernel

namespace tetracone::tetratree {

template <>
Classified classify<verify::Wrong_classes>(const Cone_points<verify::Wrong_classes>& t,
                                           const kernel::Double::Point_3& a, const kernel::Double::Point_3& b,
                                           const kernel::Double::Point_3& c)
{
  for (const auto* p : {&a, &b, &c})
    if (!kernel::is_in_tetra_cone<verify::Wrong_classes>(*p, t.v0, t.v1, t.v2, t.v3)) return Classified::no;
  return Classified::vertex_in_cone;
}

}  // namespace tetracone::tetratree

BOOST_AUTO_TEST_SUITE(test_blame)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
namespace kernel = tetracone::kernel;
using tetracone::kernel::Question;

namespace {

/// The body with its images in K for vertices. Requires triangles: other faces need not stay planar.
template <class K>
Polyhedron rounded_body(Polyhedron body, const Pose& pose)
{
  const kernel::Frame<K> frame(pose);
  for (Vertex& v : body.vertices) {
    const auto image = frame(kernel::point<K>(v));
    v = {double(image.x()), double(image.y()), double(image.z())};
  }
  return body;
}

template <class K>
bool right_on_rounded_images(const Object_case& c, Question question, bool truth)
{
  return true_answer(object_case(rounded_body<K>(*c.a, c.pose_a), Pose(), rounded_body<K>(*c.b, c.pose_b), Pose()),
                     question) == truth;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_exact_subject_or_a_right_answer_has_no_stage)
{
  const Object_case apart = object_case(unit_cube(), Pose(), unit_cube(), translation(3, 0, 0));
  for (const char* name : {"adaptive", "rational", "epeck", "double", "float", "epick"})
    BOOST_TEST(!blame(*Subject::parse(name), apart, Question::solid, false).has_value(), name);
  // Even when the truth given is a lie, an exact subject is not blamed.
  BOOST_TEST(!blame(*Subject::parse("adaptive"), apart, Question::solid, true).has_value());
}

BOOST_AUTO_TEST_CASE(the_pose_is_to_blame_exactly_when_exact_signs_of_rounded_images_go_wrong)
{
  Random random(7);
  std::map<std::string, int> stages;
  const Polyhedron cube = triangulated(unit_cube()), box = triangulated(scenes::box({0, 0, 0}, {0.5, 0.25, 0.5}));
  for (int k = 0; k < 400; ++k) {
    const Pose rotation = random_rotation(random, 9);
    const std::array<Rational, 3> shifts[] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, Rational(1) / 3, Rational(1) / 7}};
    const auto& shift = shifts[k % 4];
    const Pose moved = composed(rotation, Pose({1, 0, 0, shift[0], 0, 1, 0, shift[1], 0, 0, 1, shift[2]}));
    const Object_case c = object_case(cube, rotation, k % 2 ? cube : box, moved);
    const Question question = k % 3 == 0 ? Question::solid : Question::surface;
    const bool truth = true_answer(c, question);
    for (const Method method : all_methods) {
      const auto judge = [&]<class K>(const char* name, K) {
        const Subject subject = *Subject::parse(name, method);
        const bool right = prepare(subject, *c.a, *c.b)->collide(c.pose_a, c.pose_b, question) == truth;
        const auto stage = blame(subject, c, question, truth);
        BOOST_TEST(stage.has_value() != right);
        if (!stage) return;
        ++stages[std::string(name) + " " + to_string(*stage)];
        BOOST_TEST((*stage == Stage::pose) != (right_on_rounded_images<K>(c, question, truth)));
        // Without a tree nothing but signs can go wrong; exact signs on rounded images can go wrong in nothing else.
        if (method == Method::brute)
          BOOST_TEST((*stage == Stage::pose || *stage == Stage::leaf_sign || *stage == Stage::containment));
        if (subject.kernel == Kernel_name::epick) BOOST_TEST((*stage == Stage::pose));
      };
      judge("double", kernel::Double());
      judge("epick", kernel::Epick());
      judge("float", kernel::Float());
    }
  }
  for (const auto& [name, count] : stages) BOOST_TEST_MESSAGE(name << ": " << count);
  BOOST_TEST(stages["double pose"] > 0);
  BOOST_TEST(stages["epick pose"] > 0);
  BOOST_TEST(stages["float pose"] > 0);
}

BOOST_AUTO_TEST_CASE(the_pose_is_to_blame_where_it_takes_a_coordinate_beyond_the_largest_number)
{
  // 1e39 is a double and no float: to float these meet in no point, or in any.
  const Object_case together = object_case(unit_cube(), translation(1e39, 0, 0), unit_cube(), translation(1e39, 0, 0));
  const Object_case apart = object_case(unit_cube(), translation(1e39, 0, 0), unit_cube(), translation(3e39, 0, 0));
  int blamed = 0;
  for (const Object_case* c : {&together, &apart}) {
    const bool truth = true_answer(*c, Question::solid);
    BOOST_TEST(truth == (c == &together));
    const auto stage = blame(*Subject::parse("float"), *c, Question::solid, truth);
    if (stage) BOOST_TEST((*stage == Stage::pose));
    blamed += stage.has_value();
  }
  BOOST_TEST(blamed > 0);
}

BOOST_AUTO_TEST_CASE(unmoved_bodies_leave_only_the_signs_to_blame)
{
  // A vertex of B is a point of a face of A, rounded; the rest of B is beyond the face.
  Random random(11);
  int wrong = 0, wrong_epick = 0;
  for (int k = 0; k < 300; ++k) {
    const Vertex p = real_vertex(random, 1), q = real_vertex(random, 1), r = real_vertex(random, 1),
                 top = real_vertex(random, 1);
    const double s = real(random, 0.1, 0.4), t = real(random, 0.1, 0.4);
    Vertex on, far, far_1, far_2;
    for (int i = 0; i < 3; ++i) {
      on[i] = p[i] + s * (q[i] - p[i]) + t * (r[i] - p[i]);
      far[i] = on[i] + 2 * (on[i] - top[i]);
      far_1[i] = far[i] + (q[i] - p[i]) / 8;
      far_2[i] = far[i] + (r[i] - p[i]) / 8;
    }
    const Object_case c = object_case(tetrahedron(p, q, r, top), Pose(), tetrahedron(on, far, far_1, far_2), Pose());
    const bool truth = true_answer(c, Question::surface);
    const auto stage = blame(*Subject::parse("double", Method::brute), c, Question::surface, truth);
    if (stage) BOOST_TEST((*stage == Stage::leaf_sign));
    wrong += stage.has_value();
    wrong_epick += blame(*Subject::parse("epick", Method::brute), c, Question::surface, truth).has_value();
  }
  BOOST_TEST(wrong > 0);
  BOOST_TEST(wrong_epick == 0);
}

BOOST_AUTO_TEST_CASE(a_sphere_in_double_that_rejects_touching_cubes_is_to_blame)
{
  // Two cubes of half width 1 that touch in a vertex: sqrt(0.75) rounded, twice, squared, is below 3. Unrotated: images
  // are exact.
  const Object_case c = object_case(unit_cube(), Pose(), unit_cube(), translation(1, 1, 1));
  const auto stage = blame(*Subject::parse("double", Method::paper), c, Question::solid, true);
  BOOST_TEST_REQUIRE(stage.has_value());
  BOOST_TEST((*stage == Stage::bounding_sphere));
  BOOST_TEST(!blame(*Subject::parse("double", Method::brute), c, Question::solid, true).has_value());
}

BOOST_AUTO_TEST_CASE(a_box_of_the_exact_place_that_leaves_a_rounded_image_out_is_to_blame)
{
  // Floats of that size are as far apart as an edge is long: faces whose images meet need not be those that meet.
  Random random(17);
  std::map<Stage, int> stages;
  for (int k = 0; k < 4000; ++k) {
    const double far = std::ldexp(1.0, integer(random, 18, 24));
    const auto place = [&] {
      return translation(far + real(random, -0.5, 0.5), far + real(random, -0.5, 0.5), far + real(random, -0.5, 0.5));
    };
    const Object_case c = object_case(unit_cube(), place(), unit_cube(), place());
    const bool truth = true_answer(c, Question::surface);
    if (const auto stage = blame(*Subject::parse("float"), c, Question::surface, truth)) ++stages[*stage];
  }
  BOOST_TEST(stages[Stage::bounding_box] > 0);
}

/// Stages that blame(case, truth) blames for wrong answers to the question, over bodies that meet and that do not.
template <class Blame>
std::map<Stage, int> stages_of(Question question, const Blame& blame)
{
  Random random(19);
  std::map<Stage, int> stages;
  const std::vector<Named> bodies = closed_bodies();
  for (int k = 0; k < 300; ++k) {
    const Polyhedron &a = bodies[k % bodies.size()].body, &b = bodies[k / bodies.size() % bodies.size()].body;
    const auto shift = [&] { return integer(random, -12, 12) / 8.0; };
    const double s = k % 2 == 0 ? 1 : 0.125, x = shift(), y = shift(), z = shift();
    // A quarter turn: every image is a double, and exact.
    const Object_case c = object_case(a, Pose(), b, Pose(std::array<double, 12>{0, -s, 0, x, s, 0, 0, y, 0, 0, s, z}));
    if (const auto stage = blame(c, true_answer(c, question))) ++stages[*stage];
  }
  return stages;
}

BOOST_AUTO_TEST_CASE(a_wrong_formula_is_blamed_where_it_stands)
{
  const auto only = [](const std::map<Stage, int>& stages, Stage stage) {
    for (const auto& [blamed, count] : stages) BOOST_TEST((blamed == stage), to_string(blamed) << ": " << count);
    BOOST_TEST(!stages.empty(), to_string(stage));
  };
  using namespace tetracone::verify::detail;
  const auto surface = Question::surface, solid = Question::solid;
  only(stages_of(surface,
                 [&](const Object_case& c, bool truth) { return blame_in_fast_tree<Wrong_volume>(c, surface, truth); }),
       Stage::leaf_sign);
  only(stages_of(solid,
                 [&](const Object_case& c, bool truth) { return blame_in_fast_tree<Wrong_side>(c, solid, truth); }),
       Stage::containment);
  const auto in_tetra_tree = [&]<class K>(Method method, K) {
    return stages_of(surface, [&](const Object_case& c, bool truth) {
      return blame_in_tetra_tree<K>(tetracone::config_of(method), c, surface, truth);
    });
  };
  only(in_tetra_tree(Method::brute, Wrong_image()), Stage::pose);
  // The volumes of a node bound what has been classified in it, and can be wrong with it.
  const std::map<Stage, int> of_classes = in_tetra_tree(Method::paper, Wrong_classes());
  BOOST_TEST(of_classes.contains(Stage::classification));
  for (const auto& [blamed, count] : of_classes)
    BOOST_TEST((blamed >= Stage::classification && blamed <= Stage::regular_hull), to_string(blamed));
  for (const Method method : all_methods)
    BOOST_TEST(stages_of(solid, [&](const Object_case& c, bool truth) {
                 return blame(*Subject::parse("double", method), c, solid, truth);
               }).empty());
}

BOOST_AUTO_TEST_CASE(an_absolute_tolerance_is_to_blame_where_it_closes_a_gap)
{
  const Object_case c = object_case(unit_cube(), Pose(), moved(unit_cube(), 0x1p-20, {0.5, 0.5, 1 + 0x1p-12}), Pose());
  const auto stage = blame(*Subject::parse("double-eps=1e-3", Method::brute), c, Question::surface, false);
  BOOST_TEST_REQUIRE(stage.has_value());
  BOOST_TEST((*stage == Stage::leaf_sign));
}

BOOST_AUTO_TEST_SUITE_END()
