#include "verify/subjects/object_subject.h"

#include "verify/families/families.h"
#include "verify/integer_truth/integer_features.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/cgal_contacts.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(test_object_subject)

// Planted by hand, and wrong in a campaign of 4 cases a family: a pair of elements that met in the last pose taken for
// one that meets in this (64 of 196 answers), a last pose apart taken for this one apart (50), whole faces bounded by
// their first four corners (1). And in 24 cases of "many-faces": a tree that leaves out a part of each lowest node (2).

using namespace tetracone;
using namespace tetracone::verify;
using kernel::Question;

namespace {

Object_subject named(const std::string& name)
{
  const auto all = object_subjects();
  const auto found = std::ranges::find(all, name, &Object_subject::name);
  BOOST_REQUIRE(found != all.end());
  return *found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_are_unique)
{
  std::set<std::string> names;
  for (const Object_subject& subject : object_subjects()) BOOST_TEST(names.insert(subject.name).second, subject.name);
}

BOOST_AUTO_TEST_CASE(trees_that_remember_or_have_whole_faces_are_right_on_all_families)
{
  for (const char* name : {"adaptive tree remembering", "adaptive tree whole-faces"}) {
    const Object_subject subject = named(name);
    BOOST_TEST(subject.is_exact);
    const auto ask = subject.make();
    for (const Family& family : families())
      for (std::uint64_t k = 0; k < 4; ++k) {
        const Object_case c = family.object_case(9, k);
        for (const Question question : {Question::surface, Question::solid})
          BOOST_TEST(((*ask)(c, question) == Outcome::yes) == integer_truth::collide(c, question),
                     name << ", " << family.name << ' ' << k);
      }
  }
}

BOOST_AUTO_TEST_CASE(large_bodies_are_asked_of_fast_trees_alone)
{
  const Family& family = *find_family("many-faces");
  const Object_case c = family.object_case(1, 1);
  BOOST_TEST(std::max(c.a->face_count(), c.b->face_count()) > 2 * most_faces);
  const bool truth = integer_truth::collide(c, Question::surface);
  for (const Object_subject& subject : object_subjects()) {
    const Outcome outcome = (*subject.make())(c, Question::surface);
    BOOST_TEST((outcome != Outcome::not_asked) == (subject.own->method == Method::tree), subject.name);
    if (subject.is_exact && outcome != Outcome::not_asked) BOOST_TEST((outcome == Outcome::yes) == truth, subject.name);
    BOOST_TEST((subject.make()->features(c).outcome == Outcome::not_asked), subject.name);
  }
}

BOOST_AUTO_TEST_CASE(every_kernel_lists_features_and_exact_ones_list_them_right)
{
  std::set<Kernel_name> kernels;
  for (const Object_subject& subject : feature_subjects()) {
    kernels.insert(subject.own->kernel);
    if (!subject.is_exact) continue;
    const auto ask = subject.make();
    for (const char* family : {"face-on-face", "vertex-on-edge", "nested-touching"})
      for (std::uint64_t k = 0; k < 3; ++k) {
        const Object_case c = find_family(family)->object_case(9, k);
        const Listed listed = ask->features(c);
        BOOST_TEST((listed.outcome == Outcome::yes));
        BOOST_TEST((listed.pairs == integer_truth::features(c)), subject.name << ", " << family << ' ' << k);
      }
  }
  BOOST_TEST(kernels.size() == 7u);
}

BOOST_AUTO_TEST_CASE(exact_kernels_list_contacts_right)
{
  std::size_t pieces = 0;
  for (const Object_subject& subject : contact_subjects()) {
    BOOST_TEST(subject.is_exact, subject.name);
    const auto ask = subject.make();
    for (const char* family : {"face-on-face", "vertex-on-edge", "edge-along-edge", "stacked", "swept-contact"})
      for (std::uint64_t k = 0; k < 3; ++k) {
        const Object_case c = find_family(family)->object_case(9, k);
        const Listed_contacts listed = ask->contacts(c);
        BOOST_TEST((listed.outcome == Outcome::yes));
        BOOST_TEST((listed.forms == contacts(c)), subject.name << ", " << family << ' ' << k);
        pieces += listed.forms.size();
      }
  }
  BOOST_TEST(pieces > 100u);
}

BOOST_AUTO_TEST_SUITE_END()
