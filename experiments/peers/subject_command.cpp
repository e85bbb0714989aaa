#include "experiments/peers/subject_command.h"

#include "experiments/peers/command_process.h"
#include "verify/cases/shape_generators.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tetracone::experiments {
namespace {

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

/// A subject's program at work.
class Running_command : public verify::Running_subject {
 public:
  Running_command(std::string command, std::chrono::milliseconds limit, std::optional<subject_lines::Hello> hello,
                  std::shared_ptr<Pace> pace)
      : command_(std::move(command)), limit_(limit), hello_(std::move(hello)), pace_(std::move(pace))
  {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    spent_.reset();
    skipped_ = 0;
    const std::size_t faces = c.a->face_count() + c.b->face_count();
    why_not_ = !takes(c, question) ? "not taken" : pace_->is_too_slow(faces) ? "too slow" : "declined";
    if (why_not_ != "declined") return Outcome::not_asked;
    const auto start = Clock::now();
    const bool is_new = !process_;
    if (is_new) {
      process_ = std::make_unique<Command_process>(in_shell(command_));
      announced_.clear();
    }
    const auto deadline = start + limit_ + (is_new ? start_ : Clock::duration::zero());
    std::string wrong_line;
    const auto outcome = ask(c, question, deadline, wrong_line);
    if (!outcome) {
      tell_failure(wrong_line);
      if (failure_.how == silent) pace_->add(faces, true);
      process_.reset();
      // A program that does not start is not waited for as long each time.
      if (is_new) start_ = std::min(start_, std::max<Clock::duration>(start_ / 4, std::chrono::seconds(1)));
      return Outcome::failed;
    }
    pace_->add(faces, false);
    if (is_new) start_ = std::min<Clock::duration>(start_, 2 * (Clock::now() - start) + std::chrono::seconds(1));
    return *outcome;
  }

  /// Only what the program itself tells: our clock would add the pipe and the reading of lines.
  std::optional<verify::Spent> spent() const override { return spent_; }
  verify::Failure failure() const override { return failure_; }
  std::string why_not_asked() const override { return why_not_; }
  std::uint64_t skipped_lines() const override { return skipped_; }

 private:
  static constexpr const char* silent = "silent";

  /// True when the hello takes the case; of bodies the last two decisions are kept.
  bool takes(const Object_case& c, kernel::Question question)
  {
    if (!hello_) return true;
    if (!hello_->takes(question) || !hello_->takes(c.pose_a) || !hello_->takes(c.pose_b)) return false;
    std::erase_if(taken_, [&](const auto& known) { return known.first != c.a && known.first != c.b; });
    return std::ranges::all_of(std::array{c.a, c.b}, [this](const Body& body) {
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

  /// Nothing for a failure; `wrong_line` says what is wrong where a line came.
  std::optional<Outcome> ask(const Object_case& c, kernel::Question question, Clock::time_point deadline,
                             std::string& wrong_line)
  {
    std::string lines;
    std::erase_if(announced_, [&](const auto& known) {
      if (known.first == c.a || known.first == c.b) return false;
      lines += subject_lines::forget(known.second);
      return true;
    });
    const std::uint64_t a = number_of(c.a, lines), b = number_of(c.b, lines);
    lines += subject_lines::ask(++asks_, a, b, c.pose_a, c.pose_b, question);
    if (!process_->send(lines, deadline)) return std::nullopt;
    auto line = subject_lines::next_object(*process_, deadline, skipped_);
    if (line && subject_lines::read_hello(*line)) line = subject_lines::next_object(*process_, deadline, skipped_);
    if (!line) return std::nullopt;
    subject_lines::Reply reply = subject_lines::read(*line, asks_);
    if (reply.ns) spent_ = verify::Spent{{}, *reply.ns};
    wrong_line = std::move(reply.wrong);
    return reply.outcome;
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

}  // namespace

verify::Object_subject subject_command(const std::string& name, const std::string& command,
                                       std::chrono::milliseconds limit,
                                       const std::optional<subject_lines::Hello>& hello)
{
  const auto pace = std::make_shared<Pace>();
  return {name,
          false,
          "somebody else's program",
          std::nullopt,
          [=] { return std::make_unique<Running_command>(command, limit, hello, pace); },
          command,
          hello ? hello->text : ""};
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
