#include "experiments/peers/check_subject.h"

#include "experiments/peers/command_process.h"
#include "experiments/peers/subject_lines.h"
#include "verify/cases/shape_generators.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

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
  Talk(std::string command, std::chrono::milliseconds limit, Clock::time_point last)
      : command_(std::move(command)), limit_(limit), last_(last)
  {}

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
  void hear(std::uint64_t ask, std::optional<Outcome> truth = {})
  {
    const auto line = process_->line(deadline());
    if (!line) complain("no line");
    const subject_lines::Reply reply = subject_lines::read(*line, ask);
    const auto& outcome = reply.outcome;
    if (!outcome) throw Wrong{reply.wrong};
    starting_ = false;
    ++answers_;
    if (*outcome == Outcome::not_asked)
      ++declined_;
    else if (truth && *outcome != *truth)
      throw Wrong{"the answer is " + said(*outcome) + "; expected " + said(*truth) + " or null"};
  }

  void ask(std::uint64_t a, std::uint64_t b, const Pose& pose_a, const Pose& pose_b, std::optional<Outcome> truth = {},
           Question question = Question::surface)
  {
    tell(subject_lines::ask(++asks_, a, b, pose_a, pose_b, question));
    hear(asks_, truth);
    if (!process_->rest().empty()) throw Wrong{"there is output behind the answer; expected one line a question"};
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

 private:
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
  std::unique_ptr<Command_process> process_;
  bool starting_ = false;
  std::uint64_t asks_ = 1000;
  int answers_ = 0, declined_ = 0;
};

void two_cubes(Talk& talk)
{
  talk.tell(0, verify::unit_cube());
  talk.tell(1, verify::unit_cube());
}

/// The talks, in turn; each begins with a new program.
struct Kind {
  const char* name;
  void (*hold)(Talk&);
};
const std::vector<Kind> kinds = {
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
       talk.tell(ask(100, 12, 3, {}, {}, Question::surface) + ask(5, 3, 3, {}, near, Question::surface) +
                 ask(101, 12, 12, near, {}, Question::surface));
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
       talk.ask(0, 1, {}, far, Outcome::no);
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
       talk.tell(
           "{\"question\": \"surface\", \"pose_b\": [1,0,0,9,0,1,0,9,0,0,1,9], \"note\": [null, \"x\"], \"b\": 0, "
           "\"pose_a\": [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0], \"a\": 0, \"ask\": 7}\n");
       talk.hear(7, Outcome::no);
     }},
    {"the end of its input is its end",
     [](Talk& talk) {
       two_cubes(talk);
       talk.ask(0, 1, {}, near);
       talk.end();
     }},
};

}  // namespace

bool check_subject(const std::string& command, std::chrono::milliseconds limit, std::ostream& out)
{
  const auto last = Clock::now() + std::chrono::seconds(55);
  int answers = 0, declined = 0, wrong = 0;
  for (const Kind& kind : kinds) {
    Talk talk(command, limit, last);
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
    if (answers == 0) break;  // nor would it be another time
  }
  out << (wrong == 0 ? "follows the protocol" : "does not follow the protocol") << "; declined " << declined << " of "
      << answers << " questions\n";
  return wrong == 0;
}

}  // namespace tetracone::experiments
