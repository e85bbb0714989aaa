// The recipes of CONTRIBUTING.md, compiled and asked: what they show is here.

#include "tetracone/tetratree/solver/contact_solver.inl"
#include "tetracone/tetratree/solver/solvers.inl"
#include "verify/cases/shape_generators.h"
#include "verify/test/experiments/recipes/box_subject.h"
#include "verify/test/experiments/recipes/halvings.h"
#include "verify/test/experiments/recipes/long_double.h"
#include "verify/test/experiments/recipes/mirror_image.h"
#include "verify/test/support/temporary_file.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

// The expansion that CMake makes from a row of kernel_list.h.
TETRACONE_INSTANTIATE_SOLVERS(, , Long_double, )
template std::unique_ptr<tetracone::detail::Contact_solver>
tetracone::detail::bvh8_contact_solver<tetracone::kernel::Long_double>(const Shared_body&, const Shared_body&,
                                                                       const Query_options&);

BOOST_AUTO_TEST_SUITE(test_recipes)

namespace verify = tetracone::verify;
using tetracone::kernel::Pose;
using tetracone::kernel::Question;

BOOST_AUTO_TEST_CASE(a_kernel_answers)
{
  using K = tetracone::kernel::Long_double;
  const auto cube = verify::unit_cube();
  const tetracone::tetratree::Bvh8 tree(cube);
  const tetracone::covering::Model<K> model(cube);
  tetracone::tetratree::Bvh8_collision<K> query(tree, model, tree, model);
  for (const double x : {0.5, 1.0, std::nextafter(1.0, 2.0)})
    BOOST_TEST(query(Pose(), Pose::translation(x, 0, 0)) == (x <= 1), x);
}

BOOST_AUTO_TEST_CASE(a_family_makes_legal_cases_of_both_answers)
{
  verify::Random random(1);
  int meet = 0;
  constexpr int cases = 40;
  for (int k = 0; k < cases; ++k) {
    const verify::Object_case c = verify::object_family::mirror_image(random, k % 8);
    BOOST_TEST(c.pose_b.determinant_sign() != CGAL::ZERO);
    meet += verify::collide(verify::Brute_body(*c.a), c.pose_a, verify::Brute_body(*c.b), c.pose_b, Question::surface);
    verify::predicate_family::mirror_image(random, k % 8);
  }
  BOOST_TEST(meet > cases / 5);
  BOOST_TEST(meet < cases);
}

BOOST_AUTO_TEST_CASE(a_subject_is_asked)
{
  verify::Random random(1);
  const auto boxes = verify::box_subject().make();
  for (int k = 0; k < 20; ++k) {
    const verify::Object_case c = verify::object_family::mirror_image(random, k % 8);
    if (verify::collide(verify::Brute_body(*c.a), c.pose_a, verify::Brute_body(*c.b), c.pose_b, Question::surface))
      BOOST_TEST(((*boxes)(c, Question::surface) == verify::Outcome::yes));
  }
}

BOOST_AUTO_TEST_CASE(an_experiment_writes_its_rows)
{
  const verify::Temporary_folder folder("halvings");
  tetracone::experiments::Experiment_options options;
  options.out = folder.path();
  tetracone::experiments::run_halvings(options);
  std::ifstream in(folder.path() / "halvings.csv");
  const std::string rows(std::istreambuf_iterator<char>(in), {});
  // 1 + 2^-53 is 1 in doubles, and 1 + 2^-24 in floats.
  for (const std::string row : {"adaptive tree,53,", "double tree,53,", "float tree,24,"})
    BOOST_TEST(rows.find(row) != std::string::npos, rows);
}

BOOST_AUTO_TEST_SUITE_END()
