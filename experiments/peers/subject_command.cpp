#include "experiments/peers/subject_command.h"

#include "experiments/peers/command_process.h"
#include "experiments/peers/subject_lines.h"
#include "verify/cases/shape_generators.h"

#include <algorithm>
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

/// A subject's program at work.
class Running_command : public verify::Running_subject {
 public:
  Running_command(std::string command, std::chrono::milliseconds limit) : command_(std::move(command)), limit_(limit) {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    spent_.reset();
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
      process_.reset();
      // A program that does not start is not waited for as long each time.
      if (is_new) start_ = std::min(start_, std::max<Clock::duration>(start_ / 4, std::chrono::seconds(1)));
      return Outcome::failed;
    }
    if (is_new) start_ = std::min<Clock::duration>(start_, 2 * (Clock::now() - start) + std::chrono::seconds(1));
    return *outcome;
  }

  /// Only what the program itself tells: our clock would add the pipe and the reading of lines.
  std::optional<verify::Spent> spent() const override { return spent_; }
  verify::Failure failure() const override { return failure_; }

 private:
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
      failure_.how = status ? end_in_words(*status) : "silent";
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
    const auto line = process_->line(deadline);
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
  Clock::duration start_ = longest_start;
  std::unique_ptr<Command_process> process_;
  std::vector<std::pair<Body, std::uint64_t>> announced_;  // what the process has
  std::uint64_t models_ = 0, asks_ = 0;
  std::optional<verify::Spent> spent_;
  verify::Failure failure_;
};

}  // namespace

verify::Object_subject subject_command(const std::string& name, const std::string& command,
                                       std::chrono::milliseconds limit)
{
  return {name,
          false,
          "somebody else's program",
          std::nullopt,
          [=] { return std::make_unique<Running_command>(command, limit); },
          command};
}

void require_command(const std::string& command, std::chrono::milliseconds limit)
{
  Command_process process(in_shell(command));
  const auto deadline = Clock::now() + longest_start + limit;
  const auto cube = verify::unit_cube();
  const std::string lines =
      subject_lines::model(0, cube) + subject_lines::ask(0, 0, 0, {}, {}, kernel::Question::surface);
  if (process.send(lines, deadline) && process.line(deadline)) return;
  const int status = process.end(Clock::now() + std::chrono::milliseconds(200)).value_or(0);
  if (status == 126 || status == 127)
    throw std::runtime_error("'" + command + "' ended with status " + std::to_string(status) +
                             "; expected a program that the shell can run");
}

}  // namespace tetracone::experiments
