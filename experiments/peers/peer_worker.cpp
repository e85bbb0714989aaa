#include "experiments/peers/peer_worker.h"

#include "experiments/peers/fcl.h"
#include "experiments/peers/peer_wire.h"
#include "verify/subjects/spent.h"

#include <CLI/CLI.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace tetracone::experiments {
namespace {

/// The other end is gone: nobody waits for an answer.
struct Closed {};

/// Standard input, a few questions at a read.
class Input {
 public:
  void operator()(void* to, std::size_t bytes)
  {
    auto* out = static_cast<char*>(to);
    while (bytes > 0) {
      if (next_ == end_) fill();
      const std::size_t part = std::min(bytes, end_ - next_);
      std::memcpy(out, buffer_.data() + next_, part);
      next_ += part;
      out += part;
      bytes -= part;
    }
  }

 private:
  void fill()
  {
    ssize_t got;
    do {
      got = ::read(STDIN_FILENO, buffer_.data(), buffer_.size());
    } while (got < 0 && errno == EINTR);
    if (got <= 0) throw Closed();
    next_ = 0;
    end_ = static_cast<std::size_t>(got);
  }

  std::array<char, 1 << 16> buffer_;
  std::size_t next_ = 0, end_ = 0;
};

/// The pipe to the program: our standard output, before it was closed to whatever libraries print.
int answers = -1;

template <class T>
void answer(const T& value)
{
  const char* next = reinterpret_cast<const char*>(&value);
  for (std::size_t left = sizeof value; left > 0;) {
    const ssize_t put = ::write(answers, next, left);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) throw Closed();
    next += put;
    left -= static_cast<std::size_t>(put);
  }
}

/// A peer's prepared form of the models last sent. It is built at the first question, so that building is within its
/// time limit.
template <class Ready>
class Bench {
 public:
  using Make = Ready (*)(const Peer_mesh& a, const Peer_mesh& b);
  explicit Bench(Make make) : make_(make) {}

  void take(covering::Polyhedron a, covering::Polyhedron b)
  {
    a_ = std::move(a);
    b_ = std::move(b);
    built_ = false;
  }

  /// Sends the answer, and how long it took.
  template <class Says>
  void tell(const Says& says)
  {
    const wire::Answer told = ask(says);
    answer(told);
    if (told != wire::Answer::yes && told != wire::Answer::no) return;
    answer(double(making_));
    answer(double(asking_));
  }

 private:
  template <class Says>
  wire::Answer ask(const Says& says)
  {
    try {
      making_ = 0;
      if (!built_) making_ = verify::timed([this] { return build(); }).second;
      if (!ready_) return wire::Answer::not_taken;
      const auto [yes, asking] = verify::timed([&] { return says(ready_); });
      asking_ = asking;
      return yes ? wire::Answer::yes : wire::Answer::no;
    } catch (const std::exception&) {
      built_ = false;
      return wire::Answer::failed;
    }
  }

  bool build()
  {
    ready_ = nullptr;
    const auto a = peer_mesh(a_), b = peer_mesh(b_);
    if (a && b) ready_ = make_(*a, *b);
    return built_ = true;
  }

  Make make_;
  covering::Polyhedron a_, b_;
  Ready ready_;  // false where the peer does not take such meshes
  bool built_ = false;
  std::uint64_t making_ = 0, asking_ = 0;  // nanoseconds of the last answer
};

template <void (*misbehave)()>
struct Misbehaving : Prepared_pair {
  bool collide(const kernel::Pose&, const kernel::Pose&, kernel::Question question) override
  {
    if (question == kernel::Question::surface) misbehave();
    return false;
  }
  static std::unique_ptr<Prepared_pair> prepare(const Peer_mesh&, const Peer_mesh&)
  {
    return std::make_unique<Misbehaving>();
  }
};

void crash() { std::abort(); }
void hang()
{
  for (;;) ::pause();
}

std::optional<Peer> find_peer(const std::string& name)
{
  for (const Peer& peer : peers())
    if (peer.name == name) return peer;
  if (name == "crash") return Peer{name, "", verify::Knows::both, Misbehaving<crash>::prepare};
  if (name == "hang") return Peer{name, "", verify::Knows::both, Misbehaving<hang>::prepare};
  return std::nullopt;
}

/// Prints nothing but answers, does not die by a closed pipe, and takes no machine down. What started it kills it.
void behave_as_child()
{
  answers = ::dup(STDOUT_FILENO);
  ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), STDOUT_FILENO);
  std::signal(SIGPIPE, SIG_IGN);
  const rlimit memory = {rlim_t{4} << 30, rlim_t{4} << 30};
  ::setrlimit(RLIMIT_AS, &memory);
}

/// Answers until the other end closes: take(read) takes what follows a message that announces no models.
template <class Ready, class Take>
void serve(typename Bench<Ready>::Make make, const Take& take)
{
  behave_as_child();
  Bench<Ready> bench(make);
  Input input;
  const auto read = [&input](void* to, std::size_t bytes) { input(to, bytes); };
  try {
    answer(wire::Answer::ready);
    for (;;) {
      if (wire::take<wire::Message>(read) == wire::Message::models) {
        auto a = wire::take_polyhedron(read), b = wire::take_polyhedron(read);
        bench.take(std::move(a), std::move(b));
      } else {
        take(bench, read);
      }
    }
  } catch (const Closed&) {
  }
}

void serve(const Peer& peer)
{
  serve<std::unique_ptr<Prepared_pair>>(peer.prepare, [](auto& bench, const auto& read) {
    const auto asked = wire::take<wire::Asked>(read);
    bench.tell([&](const auto& pair) {
      return pair->collide(kernel::Pose(asked.pose_a), kernel::Pose(asked.pose_b), asked.question);
    });
  });
}

void serve(const Named_motion_peer& peer)
{
  serve<Motion_peer>(peer.make, [](auto& bench, const auto& read) {
    const auto asked = wire::take<wire::Asked_motion>(read);
    std::optional<double> time;
    bench.tell([&](const Motion_peer& first_contact) {
      time = first_contact(kernel::Pose(asked.from), kernel::Pose(asked.to));
      return time.has_value();
    });
    if (time) answer(*time);
  });
}

}  // namespace

void add_peer_worker_command(CLI::App& app)
{
  CLI::App* const command = app.add_subcommand("peer-worker", "Answers for a peer; started by the program itself");
  command->group("");
  const auto name = std::make_shared<std::string>();
  command->add_option("NAME", *name)->required();
  command->callback([name] {
    for (const Named_motion_peer& peer : motion_peers())
      if (*name == peer.name) return serve(peer);
    const auto peer = find_peer(*name);
    if (!peer) throw CLI::ValidationError("NAME", "no such peer in this build: " + *name);
    serve(*peer);
  });
}

}  // namespace tetracone::experiments
