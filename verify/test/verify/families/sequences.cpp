#include "verify/families/sequences.h"

#include "verify/subjects/subject.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <set>

BOOST_AUTO_TEST_SUITE(test_sequences)

using namespace tetracone;
using namespace tetracone::verify;
using kernel::Question;

namespace {

std::vector<bool> truth(const Sequence& sequence, Question question)
{
  const Brute_body a(*sequence.frames[0].a), b(*sequence.frames[0].b);
  std::vector<bool> answers;
  for (const Object_case& frame : sequence.frames)
    answers.push_back(collide(a, frame.pose_a, b, frame.pose_b, question));
  return answers;
}

int changes(const std::vector<bool>& answers)
{
  int count = 0;
  for (std::size_t k = 1; k < answers.size(); ++k) count += answers[k] != answers[k - 1];
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_change_exactly_as_claimed_in_every_frame)
{
  int kept = 0, met = 0;
  for (const Sequence& sequence : sequences(1, 9)) {
    const auto surface = truth(sequence, Question::surface), solid = truth(sequence, Question::solid);
    BOOST_TEST_CONTEXT(sequence.name)
    {
      BOOST_TEST(sequence.frames.size() == 9);
      if (sequence.changes) BOOST_TEST(changes(surface) == *sequence.changes);
      for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
        const Object_case& frame = sequence.frames[k];
        BOOST_TEST(frame.a == sequence.frames[0].a);
        BOOST_TEST(frame.b == sequence.frames[0].b);
        if (frame.surface) BOOST_TEST(*frame.surface == surface[k], "frame " << k);
        if (frame.solid) BOOST_TEST(*frame.solid == solid[k], "frame " << k);
      }
    }
    kept += sequence.changes == 0;
    met += sequence.changes == 1;
  }
  BOOST_TEST(kept > 20);
  BOOST_TEST(met > 5);
}

BOOST_AUTO_TEST_CASE(names_are_unique_and_frames_differ)
{
  std::set<std::string> names;
  for (const Sequence& sequence : sequences(1, 5)) {
    BOOST_TEST(names.insert(sequence.name).second, sequence.name);
    for (std::size_t k = 1; k < sequence.frames.size(); ++k)
      BOOST_TEST(!(sequence.frames[k].pose_b == sequence.frames[k - 1].pose_b), sequence.name);
  }
}

BOOST_AUTO_TEST_CASE(the_same_seed_makes_the_same_frames)
{
  const auto first = sequences(3, 4), second = sequences(3, 4);
  BOOST_TEST(first.size() == second.size());
  for (std::size_t s = 0; s < first.size(); ++s)
    for (std::size_t k = 0; k < 4; ++k) {
      BOOST_TEST((first[s].frames[k].pose_a == second[s].frames[k].pose_a));
      BOOST_TEST((first[s].frames[k].pose_b == second[s].frames[k].pose_b));
    }
}

// The purpose of sequences: where contact is kept exactly, rounding lets the answer flicker.
BOOST_AUTO_TEST_CASE(doubles_flicker_where_the_answer_is_constant)
{
  int flips = 0;
  for (const Sequence& sequence : sequences(1, 9)) {
    if (sequence.changes != 0) continue;
    const auto pair = prepare(*Subject::parse("double", Method::brute), *sequence.frames[0].a, *sequence.frames[0].b);
    std::vector<bool> answers;
    for (const Object_case& frame : sequence.frames)
      answers.push_back(pair->collide(frame.pose_a, frame.pose_b, Question::surface));
    if (changes(answers) > 0) BOOST_TEST_MESSAGE(sequence.name << ": " << changes(answers));
    flips += changes(answers);
  }
  BOOST_TEST_MESSAGE("double brute: " << flips << " changes where there are none");
  BOOST_TEST(flips > 0);
}

BOOST_AUTO_TEST_SUITE_END()
