#include "experiments/peers/peer_worker.h"

#include "experiments/peers/peer.h"
#include "experiments/peers/peer_wire.h"

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

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

void answer(wire::Answer a)
{
  ssize_t put;
  do {
    put = ::write(STDIN_FILENO, &a, 1);  // a socket: both ways
  } while (put < 0 && errno == EINTR);
  if (put != 1) throw Closed();
}

/// What one peer makes of the models last sent; built at the first question, so that building is within its time limit.
class Bench {
 public:
  explicit Bench(const Peer& peer) : peer_(peer) {}

  void take(covering::Polyhedron a, covering::Polyhedron b)
  {
    a_ = std::move(a);
    b_ = std::move(b);
    built_ = false;
  }

  wire::Answer ask(const wire::Asked& asked)
  {
    try {
      if (!built_) build();
      if (!pair_) return wire::Answer::not_taken;
      const bool yes = pair_->collide(kernel::Pose(asked.pose_a), kernel::Pose(asked.pose_b), asked.question);
      return yes ? wire::Answer::yes : wire::Answer::no;
    } catch (const std::exception&) {
      built_ = false;
      return wire::Answer::failed;
    }
  }

 private:
  void build()
  {
    pair_.reset();
    const auto a = peer_mesh(a_), b = peer_mesh(b_);
    if (a && b) pair_ = peer_.prepare(*a, *b);
    built_ = true;
  }

  const Peer& peer_;
  covering::Polyhedron a_, b_;
  std::unique_ptr<Prepared_pair> pair_;
  bool built_ = false;
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
  if (name == "crash") return Peer{name, "", false, Misbehaving<crash>::prepare};
  if (name == "hang") return Peer{name, "", false, Misbehaving<hang>::prepare};
  return std::nullopt;
}

/// Dies with its parent even while a peer hangs: when the socket's other end goes. (A signal at the parent's death, by
/// prctl, comes at the death of the thread that started us, and a campaign's threads come and go.)
void die_with_parent()
{
  std::thread([] {
    pollfd socket = {STDIN_FILENO, 0, 0};  // a hang-up is told unasked
    while (::poll(&socket, 1, -1) <= 0) {
    }
    ::_exit(0);
  }).detach();
}

/// Dies with its parent, not by a closed socket nor by the Ctrl-C that its parent handles; leaves no core, and takes no
/// machine down.
void behave_as_child()
{
  die_with_parent();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGINT, SIG_IGN);
  const rlimit no_core = {0, 0}, memory = {rlim_t{4} << 30, rlim_t{4} << 30};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::setrlimit(RLIMIT_AS, &memory);
}

void serve(const Peer& peer)
{
  behave_as_child();
  Bench bench(peer);
  Input input;
  const auto read = [&input](void* to, std::size_t bytes) { input(to, bytes); };
  try {
    answer(wire::Answer::ready);
    for (;;) {
      if (wire::take<wire::Message>(read) == wire::Message::models) {
        auto a = wire::take_polyhedron(read), b = wire::take_polyhedron(read);
        bench.take(std::move(a), std::move(b));
      } else {
        answer(bench.ask(wire::take<wire::Asked>(read)));
      }
    }
  } catch (const Closed&) {
  }
}

}  // namespace

void add_peer_worker_command(CLI::App& app)
{
  CLI::App* const command = app.add_subcommand("peer-worker", "Answers for a peer; started by the program itself");
  command->group("");
  const auto name = std::make_shared<std::string>();
  command->add_option("NAME", *name)->required();
  command->callback([name] {
    const auto peer = find_peer(*name);
    if (!peer) throw CLI::ValidationError("NAME", "no such peer in this build: " + *name);
    serve(*peer);
  });
}

}  // namespace tetracone::experiments
