#include "experiments/peers/check_subject.h"

#include "experiments/peers/subject_lines.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/shape_generators.h"

#include <cmath>
#include <memory>
#include <utility>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;
using verify::Outcome;
using Clock = std::chrono::steady_clock;

/// An error of the program, and the expected behaviour.
struct Wrong {
  std::string what;
};

const Pose near = Pose::translation(0.25, 0.25, 0.25), far = Pose::translation(9, 9, 9);

std::string said(Outcome outcome) { return outcome == Outcome::yes ? "1" : "0"; }

/// A talk with a program: started by the first line, within the time that is left.
class Talk {
 public:
  Talk(std::string command, std::chrono::milliseconds limit, Clock::time_point last, Question usual)
      : command_(std::move(command)), limit_(limit), last_(last), usual_(usual)
  {}

  /// The question that talks ask where either would do.
  Question usual() const { return usual_; }

  /// Sends lines that want no answer.
  void tell(const std::string& lines)
  {
    if (!process_) {
      process_ = std::make_unique<Command_process>(in_shell(command_), Command_process::Errors::shown);
      starting_ = true;
    }
    if (!process_->send(lines, deadline())) complain("it does not read its input");
  }
  void tell(std::uint64_t number, const covering::Polyhedron& body) { tell(subject_lines::model(number, body)); }

  /// Reads the answer to an ask; with `truth`, one of a question that nobody gets wrong but by a wrong reading.
  Outcome hear(std::uint64_t ask, std::optional<Outcome> truth = {})
  {
    return judged(subject_lines::read(next_line(), ask), truth);
  }

  Outcome ask(std::uint64_t a, std::uint64_t b, const Pose& pose_a, const Pose& pose_b, std::optional<Outcome> truth,
              Question question)
  {
    tell(subject_lines::ask(++asks_, a, b, pose_a, pose_b, question));
    const Outcome outcome = hear(asks_, truth);
    if (process_->rest().starts_with('{'))
      throw Wrong{"there is output behind the answer; expected one line a question"};
    return outcome;
  }
  Outcome ask(std::uint64_t a, std::uint64_t b, const Pose& pose_a, const Pose& pose_b,
              std::optional<Outcome> truth = {})
  {
    return ask(a, b, pose_a, pose_b, truth, usual_);
  }

  /// Asks a question of another kind, where the hello names it. `line` is the ask with the number that it is given.
  /// `value` is the number that the answer carries. Nobody gets it wrong by more than a hundredth.
  template <class Line>
  void ask_kind(subject_lines::Kind kind, const Line& line, Outcome truth, double value = 0)
  {
    if (!hello_ || !hello_->takes(kind)) return;
    tell(line(++asks_));
    const subject_lines::Reply reply = subject_lines::read(next_line(), asks_, kind);
    const Outcome outcome = judged(reply, truth);
    if (outcome == Outcome::yes && !(std::abs(reply.value - value) <= 0.01))
      throw Wrong{"the answer to '" + std::string(to_string(kind)) + "' is " + kernel::shortest(reply.value) +
                  "; expected " + kernel::shortest(value)};
  }

  /// Asks two placements of the bodies 0 and 1 in one line, if the program takes batches.
  void ask_batch(const Pose& yes, const Pose& no)
  {
    if (!hello_ || !hello_->takes_batches) return;
    const std::uint64_t first = asks_ + 1;
    asks_ += 2;
    tell(subject_lines::batch(
        {subject_lines::ask(first, 0, 1, {}, yes, usual_), subject_lines::ask(first + 1, 0, 1, {}, no, usual_)}));
    const auto replies = subject_lines::read_batch(next_line(), first, 2);
    judged(replies.front(), Outcome::yes);
    judged(replies.back(), Outcome::no);
  }

  void end()
  {
    process_->close_input();
    const auto status = process_->end(deadline());
    process_.reset();
    if (!status) throw Wrong{"it goes on; expected it to end when its input does"};
    if (*status != 0) throw Wrong{"it ends with status " + std::to_string(*status) + "; expected 0"};
  }

  int answers() const { return answers_; }
  int declined() const { return declined_; }
  std::uint64_t skipped() const { return skipped_; }
  const std::optional<subject_lines::Hello>& hello() const { return hello_; }

 private:
  /// The next line that is for us, behind the hello.
  std::string next_line()
  {
    for (;;) {
      auto line = subject_lines::next_object(*process_, deadline(), skipped_);
      if (!line) complain("no line");
      auto hello = subject_lines::read_hello(*line);
      if (!hello) return *line;
      if (const std::string flaw = subject_lines::flaw_of(*hello); !flaw.empty()) throw Wrong{flaw};
      hello_ = std::move(hello);
    }
  }

  Outcome judged(const subject_lines::Reply& reply, const std::optional<Outcome>& truth)
  {
    const auto& outcome = reply.outcome;
    if (!outcome) throw Wrong{reply.wrong};
    starting_ = false;
    ++answers_;
    if (*outcome == Outcome::not_asked)
      ++declined_;
    else if (truth && *outcome != *truth)
      throw Wrong{"the answer is " + said(*outcome) + "; expected " + said(*truth) + " or null"};
    return *outcome;
  }

  Clock::time_point deadline() const
  {
    return std::min(last_, Clock::now() + limit_ + (starting_ ? 2 * limit_ : limit_ * 0));
  }

  /// Why there is no line: an end, an answer that is held back, or silence.
  [[noreturn]] void complain(const std::string& what)
  {
    using std::chrono::milliseconds;
    const auto status = process_->end(Clock::now() + milliseconds(200));
    if (status) throw Wrong{what + ", and it ends with status " + std::to_string(*status) + "; expected an answer"};
    process_->close_input();
    if (process_->line(Clock::now() + milliseconds(2000)))
      throw Wrong{what + " before its input ends; expected standard output to be flushed after each answer"};
    throw Wrong{what + " within the limit; expected an answer"};
  }

  std::string command_;
  std::chrono::milliseconds limit_;
  Clock::time_point last_;
  Question usual_;
  std::unique_ptr<Command_process> process_;
  std::optional<subject_lines::Hello> hello_;
  std::uint64_t skipped_ = 0;
  bool starting_ = false;
  std::uint64_t asks_ = 1000;
  int answers_ = 0, declined_ = 0;
};

/// A convex body with faces of six corners; its centre is the origin.
covering::Polyhedron hexagonal_prism()
{
  covering::Polyhedron prism;
  for (const double z : {-1, 1})
    for (const auto& [x, y] : {std::pair(2, 0), {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}})
      prism.vertices.push_back({double(x), double(y), z});
  prism.add_face({{5, 4, 3, 2, 1, 0}});
  prism.add_face({{6, 7, 8, 9, 10, 11}});
  for (covering::Index k = 0; k < 6; ++k) prism.add_face({{k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k}});
  return prism;
}

void two_cubes(Talk& talk)
{
  talk.tell(0, verify::unit_cube());
  talk.tell(1, verify::unit_cube());
}

/// The talks, in turn; each begins with a new program.
struct Talk_kind {
  const char* name;
  void (*hold)(Talk&);
};
const std::vector<Talk_kind> kinds = {
    {"a first question is answered",
     [](Talk& talk) {
       two_cubes(talk);
       talk.ask(0, 1, {}, near);
     }},
    {"clear overlap and clear separation, both questions",
     [](Talk& talk) {
       two_cubes(talk);
       for (const Question question : {Question::surface, Question::solid}) {
         talk.ask(0, 1, {}, near, Outcome::yes, question);
         talk.ask(0, 1, {}, far, Outcome::no, question);
         talk.ask(0, 1, far, far, Outcome::yes, question);
       }
     }},
    {"poses are row-major, and both are used",
     [](Talk& talk) {
       // A quarter turn about z takes B's y in [5, 6] to x; the turn back takes it elsewhere.
       const Pose turned(std::array<double, 12>{0, -1, 0, 6.25, 1, 0, 0, 0.25, 0, 0, 1, 0.25});
       talk.tell(0, verify::unit_cube());
       talk.tell(1, verify::box({0, 5, 0}, {1, 6, 1}));
       talk.ask(0, 1, {}, turned, Outcome::yes);
       talk.ask(1, 0, turned, {}, Outcome::yes);
       talk.ask(1, 0, {}, turned, Outcome::no);
     }},
    {"fractions in poses",
     [](Talk& talk) {
       const kernel::Rational third(1, 3);
       two_cubes(talk);
       talk.ask(0, 1, Pose::from_quaternion(2, 0, 0, 1), Pose::from_quaternion(2, 0, 0, 1, {third, third, third}),
                Outcome::yes);
       talk.ask(0, 1, {}, Pose::from_quaternion(1, 2, 3, 4, {100 * third, 0, 0}), Outcome::no);
     }},
    {"faces of many corners and with holes",
     [](Talk& talk) {
       const covering::Polyhedron tunnel = verify::prism_with_tunnel();
       double left = tunnel.vertices[0][0];
       for (const auto& v : tunnel.vertices) left = std::min(left, v[0]);
       talk.tell(0, tunnel);
       talk.tell(1, verify::box({left - 1, -50, -50}, {left + 0.01, 50, 50}));
       talk.ask(0, 1, {}, {}, Outcome::yes);
       talk.ask(0, 1, {}, Pose::translation(-9, 0, 0), Outcome::no);
       talk.tell(2, hexagonal_prism());  // for those that take convex bodies alone
       talk.ask(2, 2, {}, Pose::translation(0.125, 0, 0), Outcome::yes);
       talk.ask(2, 2, {}, far, Outcome::no);
     }},
    {"one body as both",
     [](Talk& talk) {
       talk.tell(4, verify::unit_cube());
       talk.ask(4, 4, {}, near, Outcome::yes);
       talk.ask(4, 4, far, near, Outcome::no);
     }},
    {"bodies announced in any order, questions answered in theirs",
     [](Talk& talk) {
       talk.tell(12, verify::unit_cube());
       talk.tell(3, verify::box({20, 20, 20}, {21, 21, 21}));
       using subject_lines::ask;
       talk.tell(ask(100, 12, 3, {}, {}, talk.usual()) + ask(5, 3, 3, {}, near, talk.usual()) +
                 ask(101, 12, 12, near, {}, talk.usual()));
       talk.hear(100, Outcome::no);
       talk.hear(5, Outcome::yes);
       talk.hear(101, Outcome::yes);
     }},
    {"a body forgotten, and its number used again",
     [](Talk& talk) {
       two_cubes(talk);
       talk.ask(0, 1, {}, near, Outcome::yes);
       talk.tell(subject_lines::forget(0));
       talk.tell(0, verify::box({20, 20, 20}, {21, 21, 21}));
       talk.ask(0, 1, {}, near, Outcome::no);
       talk.ask(0, 1, {}, Pose::translation(20.5, 20.5, 20.5), Outcome::yes);
     }},
    {"a body of 20,000 faces",
     [](Talk& talk) {
       talk.tell(0, verify::torus_knot(20000));
       talk.tell(1, verify::unit_cube());
       talk.ask(0, 1, {}, Pose::translation(99, 99, 99), Outcome::no);
     }},
    {"numbers from the smallest double to large ones",
     [](Talk& talk) {
       talk.tell(0, verify::box({-0.0, 0, 0}, {5e-324, 1e-7, 1e100}));
       talk.tell(1, verify::box({1e22, -2.2250738585072014e-308, 0}, {1.7e300, 1, 1}));
       talk.ask(0, 1, {}, {});
     }},
    {"keys in another order, and keys that it does not know",
     [](Talk& talk) {
       const std::string cube = subject_lines::model(0, verify::unit_cube());
       talk.tell("{\"later\": {\"forget\": 0}, " + cube.substr(1));
       talk.tell("{\"question\": \"" + std::string(kernel::to_string(talk.usual())) +
                 "\", \"pose_b\": [1,0,0,9,0,1,0,9,0,0,1,9], \"note\": [null, \"x\"], \"b\": 0, "
                 "\"pose_a\": [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0], \"a\": 0, \"ask\": 7}\n");
       talk.hear(7, Outcome::no);
     }},
    {"several questions in a line, where its hello says so",
     [](Talk& talk) {
       two_cubes(talk);
       talk.ask(0, 1, {}, near, Outcome::yes);
       talk.ask_batch(near, far);
     }},
    {"other kinds of question, where its hello names them",
     [](Talk& talk) {
       using namespace subject_lines;
       two_cubes(talk);
       talk.ask(0, 1, {}, near, Outcome::yes);
       const Pose beside = Pose::translation(3, 0.25, 0.25), beyond = Pose::translation(-1, 0.25, 0.25);
       const Question of = talk.usual();
       talk.tell(2, verify::box({-9, -9, -9}, {19, 19, 19}));
       const auto related = [](std::uint64_t a, std::uint64_t b, const Pose& pose) {
         return [=](std::uint64_t ask) { return relation(ask, a, b, {}, pose); };
       };
       talk.ask_kind(Kind::relation, related(0, 1, beside), Outcome::yes, 0);
       talk.ask_kind(Kind::relation, related(0, 1, near), Outcome::yes, 1);
       talk.ask_kind(Kind::relation, related(0, 2, {}), Outcome::yes, 2);
       talk.ask_kind(Kind::relation, related(2, 0, {}), Outcome::yes, 3);
       const auto at = [](const kernel::Vertex& point) {
         return [=](std::uint64_t ask) { return inside(ask, 0, point); };
       };
       talk.ask_kind(Kind::inside, at({0.5, 0.25, 0.25}), Outcome::yes, 1);
       talk.ask_kind(Kind::inside, at({3, 0.25, 0.25}), Outcome::yes, -1);
       const auto towards = [](double x) {
         return [=](std::uint64_t ask) { return ray(ask, 0, {-1, 0.25, 0.375}, {x, 0, 0}); };
       };
       talk.ask_kind(Kind::ray, towards(2), Outcome::yes, 0.5);
       talk.ask_kind(Kind::ray, towards(-2), Outcome::no);
       talk.ask_kind(
           Kind::distance, [&](std::uint64_t ask) { return distance(ask, 0, 1, {}, beside, of); }, Outcome::yes, 2);
       const auto limit = [&](const char* text) {
         return [=](std::uint64_t ask) { return within(ask, 0, 1, {}, beside, of, text); };
       };
       talk.ask_kind(Kind::within, limit("2.5"), Outcome::yes);
       talk.ask_kind(Kind::within, limit("4/3"), Outcome::no);
       const auto moves = [&](const Pose& from, const Pose& to) {
         return [=](std::uint64_t ask) { return first_contact(ask, 0, 1, {Pose(), Pose()}, {from, to}, of); };
       };
       talk.ask_kind(Kind::first_contact, moves(beside, beyond), Outcome::yes, 0.5);
       talk.ask_kind(Kind::first_contact, moves(beside, Pose::translation(9, 0, 0)), Outcome::no);
       const auto pair = [](const kernel::Rational& height) {
         const verify::Predicate_case c = {
             {kernel::Vertex{9, 9, 9}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {1, 1, 0}, {2, 1, 2}, {1, 2, 3}, {},
             Pose::from_quaternion(1, 0, 0, 0, {0, 0, height}),          {}};
         return [=](std::uint64_t ask) { return triangles(ask, c); };
       };
       talk.ask_kind(Kind::triangles, pair(kernel::Rational(-1, 3)), Outcome::yes);
       talk.ask_kind(Kind::triangles, pair(kernel::Rational(1, 3)), Outcome::no);
     }},
    {"the end of its input is its end",
     [](Talk& talk) {
       two_cubes(talk);
       talk.ask(0, 1, {}, near);
       talk.end();
     }},
};

/// Says which questions about which bodies and poses the program answers, by asking it.
void tell_what_it_takes(Talk& talk, std::ostream& out)
{
  talk.tell(0, verify::unit_cube());
  talk.tell(1, verify::prism_with_tunnel());
  const Pose sheared(std::array<double, 12>{1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  for (const Question question : {Question::surface, Question::solid}) {
    const auto takes = [&](std::uint64_t body, const Pose& pose) {
      return talk.ask(body, body, {}, pose, {}, question) != Outcome::not_asked;
    };
    std::string kinds;
    for (const auto& [kind, is_taken] :
         {std::pair("convex bodies", takes(0, near)), std::pair("other bodies", takes(1, near)),
          std::pair("sheared poses", takes(0, sheared) || takes(1, sheared)),
          std::pair("fractions", takes(0, Pose::from_quaternion(1, 2, 3, 4)))})
      if (is_taken) kinds += (kinds.empty() ? "" : ", ") + std::string(kind);
    out << "takes  " << kernel::to_string(question) << ": " << (kinds.empty() ? "nothing" : kinds) << '\n';
  }
  for (const subject_lines::Kind kind : subject_lines::all_kinds)
    if (kind != subject_lines::Kind::collide && talk.hello() && talk.hello()->takes(kind))
      out << "takes  " << to_string(kind) << '\n';
  if (talk.hello()) out << "says   " << talk.hello()->text << '\n';
}

/// Returns the question of surfaces, or that of solids to a program that declines surfaces or does not answer.
Question usual_question(Talk talk)
{
  try {
    two_cubes(talk);
    return talk.ask(0, 1, {}, near) == Outcome::not_asked ? Question::solid : Question::surface;
  } catch (const Wrong&) {
    return Question::surface;  // the talks say what is wrong
  }
}

}  // namespace

bool check_subject(const std::string& command, std::chrono::milliseconds limit, std::ostream& out)
{
  const auto last = Clock::now() + std::chrono::seconds(55);
  int answers = 0, declined = 0, wrong = 0;
  std::uint64_t skipped = 0;
  const Question usual = usual_question(Talk(command, limit, last, Question::surface));
  for (const Talk_kind& kind : kinds) {
    Talk talk(command, limit, last, usual);
    try {
      if (Clock::now() >= last) throw Wrong{"the minute is over; expected quicker answers before"};
      kind.hold(talk);
      out << "ok     " << kind.name << '\n';
    } catch (const Wrong& found) {
      ++wrong;
      out << "WRONG  " << kind.name << ": " << found.what << '\n';
    }
    out.flush();
    answers += talk.answers();
    declined += talk.declined();
    skipped += talk.skipped();
    if (answers == 0) break;  // nor would it be another time
  }
  if (wrong == 0) {
    try {
      Talk talk(command, limit, last, usual);
      tell_what_it_takes(talk, out);
    } catch (const Wrong& found) {
      ++wrong;
      out << "WRONG  what it takes: " << found.what << '\n';
    }
  }
  if (skipped > 0) out << "skipped " << skipped << " lines that do not begin with {\n";
  out << (wrong == 0 ? "follows the protocol" : "does not follow the protocol") << "; declined " << declined << " of "
      << answers << " questions\n";
  return wrong == 0;
}

}  // namespace tetracone::experiments
