#include "verify/subjects/subject.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_subject)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
using tetracone::kernel::Question;
using tetracone::tetratree::Query_statistics;

namespace {

const std::vector<std::string> kernels = {"adaptive", "double", "float",   "double-eps=1e-13", "double-eps=rel:1e-15",
                                          "epick",    "epeck",  "rational"};
const std::vector<Method> methods = {Method::tree, Method::paper, Method::brute};

std::vector<Subject> all_subjects()
{
  std::vector<Subject> subjects;
  for (const std::string& kernel : kernels)
    for (const Method method : methods) subjects.push_back(Subject::parse(kernel, method).value());
  return subjects;
}

bool is_truth(const Subject& subject)
{
  return subject.kernel == Kernel_name::rational && subject.method == Method::brute;
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_are_read_back)
{
  for (const std::string& kernel : kernels)
    for (const Method method : methods) {
      const auto subject = Subject::parse(kernel, method);
      BOOST_TEST_REQUIRE(subject.has_value(), kernel);
      BOOST_TEST(subject->kernel_name() == kernel);
      BOOST_TEST(subject->name() == kernel + " " + std::string(to_string(method)));
      BOOST_TEST((subject->method == method));
      const auto again = Subject::parse(subject->kernel_name(), subject->method).value();
      BOOST_TEST((again.kernel == subject->kernel));
      BOOST_TEST(again.tolerance.absolute == subject->tolerance.absolute);
      BOOST_TEST(again.tolerance.relative == subject->tolerance.relative);
    }
  BOOST_TEST(Subject::parse("adaptive")->name() == "adaptive tree");
  BOOST_TEST(Subject().name() == "adaptive tree");
}

BOOST_AUTO_TEST_CASE(methods_are_read_back)
{
  for (const Method method : methods) BOOST_TEST((parse_method(to_string(method)) == method));
  for (const char* bad : {"", "Tree", "trees", "tree ", "brute,tree"}) BOOST_TEST(!parse_method(bad).has_value(), bad);
}

BOOST_AUTO_TEST_CASE(tolerances_are_read_as_doubles)
{
  BOOST_TEST(Subject::parse("double-eps=1e-12")->tolerance.absolute == 1e-12);
  BOOST_TEST(Subject::parse("double-eps=1e-12")->tolerance.relative == 0);
  BOOST_TEST(Subject::parse("double-eps=rel:0.125")->tolerance.relative == 0.125);
  BOOST_TEST(Subject::parse("double-eps=rel:0.125")->tolerance.absolute == 0);
  BOOST_TEST(Subject::parse("double-eps=0")->tolerance.absolute == 0);
  BOOST_TEST(Subject::parse("double-eps=0")->kernel_name() == "double-eps=0");
  BOOST_TEST(Subject::parse("double-eps=5e-324")->tolerance.absolute == std::numeric_limits<double>::denorm_min());
  BOOST_TEST(Subject::parse("double-eps=0.1000000000000000055511151231257827")->kernel_name() == "double-eps=0.1");
}

BOOST_AUTO_TEST_CASE(bad_words_are_no_kernels)
{
  for (const char* bad : {"",
                          " ",
                          "Adaptive",
                          "adaptive ",
                          " adaptive",
                          "adaptiv",
                          "doubles",
                          "double-eps",
                          "double-eps=",
                          "double-eps=-1",
                          "double-eps=-0",
                          "double-eps=-1e-400",
                          "double-eps=nan",
                          "double-eps=-nan",
                          "double-eps=inf",
                          "double-eps=infinity",
                          "double-eps=1e400",
                          "double-eps=1e-12x",
                          "double-eps= 1",
                          "double-eps=1 ",
                          "double-eps=1,5",
                          "double-eps=0x1p-3",
                          "double-eps=1/2",
                          "double-eps=rel",
                          "double-eps=rel:",
                          "double-eps=rel:-1",
                          "double-eps=rel:nan",
                          "double-eps=rel:rel:1",
                          "double-eps=abs:1",
                          "double-eps:1",
                          "double=1",
                          "epick=1",
                          "rational\n"})
    BOOST_TEST(!Subject::parse(bad).has_value(), "'" << bad << "' was read");
}

BOOST_AUTO_TEST_CASE(three_kernels_are_exact)
{
  for (const std::string& kernel : kernels)
    BOOST_TEST(Subject::parse(kernel)->is_exact() ==
               (kernel == "adaptive" || kernel == "epeck" || kernel == "rational"));
}

BOOST_AUTO_TEST_CASE(a_tolerance_is_its_own_subjects_and_nobody_elses)
{
  const auto plain = prepare(*Subject::parse("double-eps=0"), scenes::unit_cube(), scenes::unit_cube());
  const auto coarse = prepare(*Subject::parse("double-eps=0.25"), scenes::unit_cube(), scenes::unit_cube());
  const auto in_double = prepare(*Subject::parse("double"), scenes::unit_cube(), scenes::unit_cube());
  Random random(24);
  int differ = 0;
  for (int round = 0; round < 20; ++round) {
    const Pose a = rounded(random_rotation(random)),
               b = translation(real(random, -1.5, 1.5), real(random, -1.5, 1.5), real(random, -1.5, 1.5));
    const bool expected = in_double->collide(a, b, Question::solid);
    differ += coarse->features(a, b) != in_double->features(a, b);
    BOOST_TEST(plain->collide(a, b, Question::solid) == expected);
    differ += coarse->collide(a, b, Question::solid) != expected;
    BOOST_TEST((plain->features(a, b) == in_double->features(a, b)));
  }
  BOOST_TEST(differ > 0);
}

BOOST_AUTO_TEST_CASE(work_is_counted_since_it_was_last_asked_for)
{
  for (const Subject& subject : all_subjects()) {
    BOOST_TEST_INFO_SCOPE(subject.name());
    const auto pair = prepare(subject, star_prism(), cube(1));
    BOOST_TEST(pair->take_counts().queries == 0u);
    const Pose turn = Pose::from_quaternion(3, 1, -2, 1);
    pair->collide(turn, Pose(), Question::solid);
    pair->collide(Pose(), translation(1, 1, 0), Question::surface);
    pair->features(turn, Pose());
    const Query_statistics counts = pair->take_counts(), after = pair->take_counts();
    BOOST_TEST(after.queries == 0u);
    BOOST_TEST(after.primitive_tests() == 0u);
    if (is_truth(subject)) {
      BOOST_TEST(counts.queries == 0u);
      BOOST_TEST(pair->bytes() == 0u);
      BOOST_TEST(pair->node_count() == 0u);
      continue;
    }
    BOOST_TEST(counts.queries == 3u);
    BOOST_TEST(counts.primitive_tests() > 0u);
    BOOST_TEST((counts.exact_fallbacks > 0) == (subject.kernel == Kernel_name::adaptive));
    BOOST_TEST(pair->bytes() > 0u);
    BOOST_TEST(pair->node_count() >= 2u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
