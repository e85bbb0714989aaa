#include "experiments/peers/subject_command.h"

#include "tetracone/kernel/number/number.h"
#include "verify/cases/shape_generators.h"
#include "verify/truth/moving_bodies_truth.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace tetracone::experiments {
namespace {

using subject_lines::Kind;
using subject_lines::Reply;
using verify::Object_case;
using verify::Outcome;
using Clock = std::chrono::steady_clock;
using Body = std::shared_ptr<const covering::Polyhedron>;

/// The answers and time-outs of a subject in all threads, by size class.
class Pace {
 public:
  void add(std::size_t faces, bool timed_out) { ++(timed_out ? time_outs_ : answers_)[size_class(faces)]; }

  bool is_too_slow(std::size_t faces) const
  {
    constexpr int enough = 3;
    for (std::size_t k = 0; k <= size_class(faces); ++k)
      if (time_outs_[k] >= enough && time_outs_[k] > answers_[k]) return true;
    return false;
  }

 private:
  static std::size_t size_class(std::size_t faces) { return std::size_t(std::bit_width(faces)); }

  std::array<std::atomic<int>, 65> time_outs_{}, answers_{};
};

/// A subject's program at work. It answers any kind of question about bodies.
class Program {
 public:
  Program(std::string command, std::chrono::milliseconds limit, std::optional<subject_lines::Hello> hello,
          std::shared_ptr<Pace> pace)
      : command_(std::move(command)), limit_(limit), hello_(std::move(hello)), pace_(std::move(pace))
  {}

  bool takes(Kind kind) const { return hello_ ? hello_->takes(kind) : kind == Kind::collide; }

  /// True when the hello takes the question in these poses.
  bool takes(Kind kind, kernel::Question question, std::initializer_list<const kernel::Pose*> poses) const
  {
    if (!takes(kind)) return false;
    return !hello_ || (hello_->takes(kind, question) &&
                       std::ranges::all_of(poses, [this](const kernel::Pose* pose) { return hello_->takes(*pose); }));
  }

  /// Asks a question that is taken, unless the hello does not take the bodies. `line(ask, numbers)` writes it, with the
  /// bodies' numbers. The reply has an outcome.
  template <class Line>
  Reply ask(Kind kind, const std::vector<Body>& bodies, const Line& line)
  {
    begin();
    std::size_t faces = 0;
    for (const Body& body : bodies) faces += body->face_count();
    why_not_ = !takes(bodies) ? "not taken" : pace_->is_too_slow(faces) ? "too slow" : "declined";
    if (why_not_ != "declined") return {Outcome::not_asked, "", {}};
    const auto start = Clock::now();
    const bool is_new = !process_;
    if (is_new) {
      process_ = std::make_unique<Command_process>(in_shell(command_));
      announced_.clear();
    }
    const auto deadline = start + limit_ + (is_new ? start_ : Clock::duration::zero());
    Reply reply = answer(kind, bodies, line, deadline);
    if (!reply.outcome) {
      tell_failure(reply.wrong);
      if (failure_.how == silent) pace_->add(faces, true);
      process_.reset();
      // A program that does not start is not waited for as long each time.
      if (is_new) start_ = std::min(start_, std::max<Clock::duration>(start_ / 4, std::chrono::seconds(1)));
      reply.outcome = Outcome::failed;
      return reply;
    }
    pace_->add(faces, false);
    if (is_new) start_ = std::min<Clock::duration>(start_, 2 * (Clock::now() - start) + std::chrono::seconds(1));
    if (reply.ns) spent_ = verify::Spent{{}, *reply.ns};
    return reply;
  }

  /// Declines for the program what its hello does not take.
  Reply not_taken()
  {
    begin();
    why_not_ = "not taken";
    return {Outcome::not_asked, "", {}};
  }

  // These are about the last question.
  const std::optional<verify::Spent>& spent() const { return spent_; }
  const verify::Failure& failure() const { return failure_; }
  const std::string& why_not_asked() const { return why_not_; }
  std::uint64_t skipped_lines() const { return skipped_; }

 private:
  static constexpr const char* silent = "silent";

  void begin()
  {
    spent_.reset();
    skipped_ = 0;
  }

  /// True when the hello takes the bodies; the last two decisions are kept.
  bool takes(const std::vector<Body>& bodies)
  {
    if (!hello_) return true;
    std::erase_if(taken_, [&](const auto& known) { return std::ranges::find(bodies, known.first) == bodies.end(); });
    return std::ranges::all_of(bodies, [this](const Body& body) {
      for (const auto& [known, is_taken] : taken_)
        if (known == body) return is_taken;
      return taken_.emplace_back(body, hello_->takes(*body)).second;
    });
  }

  /// The process is about to go.
  void tell_failure(const std::string& wrong_line)
  {
    // One that has closed its output ends at once or hangs.
    const auto status = process_->end(Clock::now() + std::chrono::seconds(1));
    failure_.said = process_->last_error();
    if (!wrong_line.empty()) {
      failure_.how = "wrong line";
      failure_.said = wrong_line + (failure_.said.empty() ? "" : "; " + failure_.said);
    } else {
      failure_.how = status ? end_in_words(*status) : silent;
    }
  }

  /// No outcome for a failure; `wrong` says what is wrong where a line came.
  template <class Line>
  Reply answer(Kind kind, const std::vector<Body>& bodies, const Line& line, Clock::time_point deadline)
  {
    std::string lines;
    std::erase_if(announced_, [&](const auto& known) {
      if (std::ranges::find(bodies, known.first) != bodies.end()) return false;
      lines += subject_lines::forget(known.second);
      return true;
    });
    std::vector<std::uint64_t> numbers;
    for (const Body& body : bodies) numbers.push_back(number_of(body, lines));
    lines += line(++asks_, numbers);
    if (!process_->send(lines, deadline)) return {};
    auto told = subject_lines::next_object(*process_, deadline, skipped_);
    if (told && subject_lines::read_hello(*told)) told = subject_lines::next_object(*process_, deadline, skipped_);
    return told ? subject_lines::read(*told, asks_, kind) : Reply{};
  }

  /// The body's number; a line for it where the program does not have it.
  std::uint64_t number_of(const Body& body, std::string& lines)
  {
    for (const auto& [known, number] : announced_)
      if (known == body) return number;
    lines += subject_lines::model(++models_, *body);
    announced_.emplace_back(body, models_);
    return models_;
  }

  std::string command_;
  std::chrono::milliseconds limit_;
  std::optional<subject_lines::Hello> hello_;
  std::shared_ptr<Pace> pace_;
  Clock::duration start_ = longest_start;
  std::unique_ptr<Command_process> process_;
  std::vector<std::pair<Body, std::uint64_t>> announced_;  // what the process has
  std::uint64_t models_ = 0, asks_ = 0;
  std::vector<std::pair<Body, bool>> taken_;
  std::optional<verify::Spent> spent_;
  verify::Failure failure_;
  std::string why_not_;
  std::uint64_t skipped_ = 0;
};

/// Asked about two bodies.
class Running_command : public verify::Running_subject {
 public:
  explicit Running_command(Program program) : program_(std::move(program)) {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    if (program_.takes(Kind::relation)) return by_relation(c, question);
    return *ask(Kind::collide, c, question, [&](std::uint64_t ask, const auto& numbers) {
              return subject_lines::ask(ask, numbers[0], numbers[1], c.pose_a, c.pose_b, question);
            }).outcome;
  }

  verify::Told<verify::Distance_answer> distance(const Object_case& c, kernel::Question question) override
  {
    verify::Distance_answer answer;
    answer.alone = std::numeric_limits<double>::quiet_NaN();
    answer.is_alone = true;
    if (!program_.takes(Kind::distance) && program_.takes(Kind::within, question, {&c.pose_a, &c.pose_b}))
      return {Outcome::yes, answer};
    const Reply reply = ask(Kind::distance, c, question, [&](std::uint64_t ask, const auto& numbers) {
      return subject_lines::distance(ask, numbers[0], numbers[1], c.pose_a, c.pose_b, question);
    });
    if (reply.outcome == Outcome::yes) answer.alone = reply.value;
    return {*reply.outcome, answer, program_.spent()};
  }

  Outcome within(const Object_case& c, kernel::Question question, const std::string& limit) override
  {
    const auto number = kernel::parse_number(limit);
    const double nearest = number ? kernel::nearest_double(*number) : 0;
    const bool is_double = number && kernel::Rational(nearest) == *number;
    return *ask(Kind::within, c, question, [&](std::uint64_t ask, const auto& numbers) {
              return subject_lines::within(ask, numbers[0], numbers[1], c.pose_a, c.pose_b, question,
                                           is_double ? kernel::shortest(nearest) : limit);
            }).outcome;
  }

  /// Only what the program itself tells: our clock would add the pipe and the reading of lines.
  std::optional<verify::Spent> spent() const override { return program_.spent(); }
  verify::Failure failure() const override { return program_.failure(); }
  std::string why_not_asked() const override { return program_.why_not_asked(); }
  std::uint64_t skipped_lines() const override { return program_.skipped_lines(); }

 private:
  Outcome by_relation(const Object_case& c, kernel::Question question)
  {
    const Reply reply = ask(Kind::relation, c, question, [&](std::uint64_t ask, const auto& numbers) {
      return subject_lines::relation(ask, numbers[0], numbers[1], c.pose_a, c.pose_b);
    });
    if (reply.outcome != Outcome::yes) return *reply.outcome;
    const bool yes = question == kernel::Question::surface ? reply.value == 1 : reply.value != 0;
    return yes ? Outcome::yes : Outcome::no;
  }

  template <class Line>
  Reply ask(Kind kind, const Object_case& c, kernel::Question question, const Line& line)
  {
    if (!program_.takes(kind, question, {&c.pose_a, &c.pose_b})) return program_.not_taken();
    return program_.ask(kind, {c.a, c.b}, line);
  }

  Program program_;
};

/// Asked about a body by `answer(program, case)`.
template <class Answer, verify::Told<Answer> (*answer)(Program& program, const verify::Probe_case& c)>
class Running_command_probes : public verify::Running<verify::Probe_case, Answer> {
 public:
  explicit Running_command_probes(Program program) : program_(std::move(program)) {}

  verify::Told<Answer> operator()(const verify::Probe_case& c) override { return answer(program_, c); }

 private:
  Program program_;
};

verify::Told<int> place_of(Program& program, const verify::Probe_case& c)
{
  const Reply reply = program.ask(Kind::inside, {c.body}, [&](std::uint64_t ask, const auto& numbers) {
    return subject_lines::inside(ask, numbers[0], c.from);
  });
  return {*reply.outcome, int(reply.value), program.spent()};
}

verify::Told<verify::Ray_answer> first_hit_of(Program& program, const verify::Probe_case& c)
{
  const Reply reply = program.ask(Kind::ray, {c.body}, [&](std::uint64_t ask, const auto& numbers) {
    return subject_lines::ray(ask, numbers[0], c.from, c.direction);
  });
  verify::Ray_answer answer;
  answer.is_first_t = true;
  if (reply.outcome == Outcome::yes) answer.first = verify::Ray_hit{0, reply.value};
  // That a ray meets nothing is an answer, too.
  return {reply.outcome == Outcome::no ? Outcome::yes : *reply.outcome, answer, program.spent()};
}

/// Asked when two bodies first meet in a linear motion. A rigid motion that does not turn is linear.
class Running_command_motion : public verify::Running_motion {
 public:
  explicit Running_command_motion(Program program) : program_(std::move(program)) {}

  verify::Told_contact operator()(const verify::Moving_bodies& c, kernel::Question question) override
  {
    if (c.is_rigid() && (turns(c.motion_a) || turns(c.motion_b))) return {Outcome::not_asked};
    verify::Moving_bodies back = c;
    std::swap(back.motion_a[0], back.motion_a[1]);
    std::swap(back.motion_b[0], back.motion_b[1]);
    const Object_case start = verify::at_start(c), end = verify::at_start(back);
    if (!program_.takes(Kind::first_contact, question, {&start.pose_a, &start.pose_b, &end.pose_a, &end.pose_b}))
      return {Outcome::not_asked};
    const Reply reply =
        program_.ask(Kind::first_contact, {start.a, start.b}, [&](std::uint64_t ask, const auto& numbers) {
          return subject_lines::first_contact(ask, numbers[0], numbers[1], {start.pose_a, end.pose_a},
                                              {start.pose_b, end.pose_b}, question);
        });
    return {*reply.outcome, {reply.value, reply.value}, program_.spent()};
  }

 private:
  static bool turns(const verify::Motion_ends& ends)
  {
    return !std::equal(ends[0].begin(), ends[0].begin() + 4, ends[1].begin());
  }

  Program program_;
};

/// Asked whether two triangles share a point.
class Running_command_triangles : public verify::Running_predicates {
 public:
  Running_command_triangles(const std::string& name, Program program)
      : Running_predicates(name), program_(std::move(program))
  {}

  verify::Told<int> operator()(const verify::Predicate_case& c, verify::Predicate predicate) override
  {
    if (predicate != verify::Predicate::triangle_triangle) return {};
    const Reply reply = program_.ask(Kind::triangles, {},
                                     [&](std::uint64_t ask, const auto&) { return subject_lines::triangles(ask, c); });
    if (reply.outcome != Outcome::yes && reply.outcome != Outcome::no) return {*reply.outcome};
    return {Outcome::yes, reply.outcome == Outcome::yes, program_.spent()};
  }

  verify::Failure failure() const override { return program_.failure(); }
  std::uint64_t skipped_lines() const override { return program_.skipped_lines(); }

 private:
  Program program_;
};

/// The program of a subject; its pace is shared by all threads.
std::function<Program()> program_of(const verify::Object_subject& subject, std::chrono::milliseconds limit)
{
  const auto pace = std::make_shared<Pace>();
  return [command = subject.command, limit, hello = subject_lines::read_hello(subject.hello), pace] {
    return Program(command, limit, hello, pace);
  };
}

/// True where the hello of the subject's program names the kind.
bool tells(const verify::Object_subject& subject, Kind kind)
{
  const auto hello = subject_lines::read_hello(subject.hello);
  return hello && hello->takes(kind);
}

/// The program as a subject of one kind of question, where its hello names it.
template <class Running, class Subject>
std::optional<Subject> of_kind(Kind kind, const verify::Object_subject& subject, std::chrono::milliseconds limit)
{
  if (!tells(subject, kind)) return std::nullopt;
  return Subject{subject.name, false, subject.note,
                 [make = program_of(subject, limit)] { return std::make_unique<Running>(make()); }};
}

}  // namespace

verify::Object_subject subject_command(const std::string& name, const std::string& command,
                                       std::chrono::milliseconds limit,
                                       const std::optional<subject_lines::Hello>& hello)
{
  verify::Object_subject subject{name,
                                 false,
                                 "somebody else's program",
                                 std::nullopt,
                                 {},
                                 command,
                                 hello ? hello->text : "",
                                 "",
                                 verify::Knows::both,
                                 hello ? hello->in_floats : verify::In_floats::nothing};
  subject.make = [make = program_of(subject, limit)] { return std::make_unique<Running_command>(make()); };
  return subject;
}

bool tells_distances(const verify::Object_subject& subject)
{
  return tells(subject, Kind::distance) || tells(subject, Kind::within);
}

std::optional<verify::Point_subject> point_command(const verify::Object_subject& subject,
                                                   std::chrono::milliseconds limit)
{
  return of_kind<Running_command_probes<int, place_of>, verify::Point_subject>(Kind::inside, subject, limit);
}

std::optional<verify::Ray_subject> ray_command(const verify::Object_subject& subject, std::chrono::milliseconds limit)
{
  return of_kind<Running_command_probes<verify::Ray_answer, first_hit_of>, verify::Ray_subject>(Kind::ray, subject,
                                                                                                limit);
}

std::optional<verify::Moving_bodies_subject> motion_command(const verify::Object_subject& subject,
                                                            std::chrono::milliseconds limit)
{
  return of_kind<Running_command_motion, verify::Moving_bodies_subject>(Kind::first_contact, subject, limit);
}

std::optional<verify::Predicate_subject> triangle_command(const verify::Object_subject& subject,
                                                          std::chrono::milliseconds limit)
{
  if (!tells(subject, Kind::triangles)) return std::nullopt;
  return verify::Predicate_subject{subject.name, false, subject.note, nullptr,
                                   [name = subject.name, make = program_of(subject, limit)] {
                                     return std::make_unique<Running_command_triangles>(name, make());
                                   }};
}

std::optional<subject_lines::Hello> require_command(const std::string& command, std::chrono::milliseconds limit)
{
  Command_process process(in_shell(command));
  const auto deadline = Clock::now() + longest_start + limit;
  const auto cube = verify::unit_cube();
  const std::string lines =
      subject_lines::model(0, cube) + subject_lines::ask(0, 0, 0, {}, {}, kernel::Question::surface);
  std::uint64_t skipped = 0;
  if (process.send(lines, deadline))
    if (const auto line = subject_lines::next_object(process, deadline, skipped))
      return subject_lines::read_hello(*line);
  const int status = process.end(Clock::now() + std::chrono::milliseconds(200)).value_or(0);
  if (status == 126 || status == 127)
    throw std::runtime_error("'" + command + "' ended with status " + std::to_string(status) +
                             "; expected a program that the shell can run");
  return std::nullopt;
}

}  // namespace tetracone::experiments
