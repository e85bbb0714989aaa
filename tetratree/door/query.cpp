#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/door/solver.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cstddef>
#include <future>
#include <string>

namespace tetracone {
namespace {

/// Makes the roots of both fast trees, at once in two threads where the bodies are large enough.
void make_roots(const detail::Body_data& a, const detail::Body_data& b)
{
  constexpr std::size_t worth_a_thread = 100'000;  // faces: some tens of milliseconds
  if (a.made_bvh8() || b.made_bvh8() ||
      kernel::minimum(a.polyhedron.face_count(), b.polyhedron.face_count()) < worth_a_thread)
    return;
  auto of_b = std::async(std::launch::async, [&] { b.bvh8(); });
  a.bvh8();
  of_b.get();
}

}  // namespace

Query::Query(const Body& a, const Body& b, Question question, const Query_options& options)
{
  if (question == Question::solid) {
    detail::require_solid(*a.data_, "query: body a", "Question::solid");
    detail::require_solid(*b.data_, "query: body b", "Question::solid");
  }
  if (options.method == Method::tree) make_roots(*a.data_, *b.data_);
  data_ = std::make_unique<detail::Query_data>(detail::Query_data{
      question, detail::make_solver(a.data_, b.data_, options), a.data_, b.data_, options, nullptr, nullptr, nullptr});
}

Query::~Query() = default;
Query::Query(Query&&) noexcept = default;
Query& Query::operator=(Query&&) noexcept = default;

detail::Query_data& Query::data() const
{
  if (!data_) [[unlikely]]
    throw Error("query: moved from; expected one that still has its bodies");
  return *data_;
}

Answer Query::collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  detail::Query_data& d = data();
  return Answer(d.solver->relation(pose_a, pose_b, d.question, nullptr));
}

Answer Query::collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, tetratree::Pair_memory& memory)
{
  detail::Query_data& d = data();
  return Answer(d.solver->relation(pose_a, pose_b, d.question, &memory));
}

std::vector<Answer> Query::collide(std::span<const Pose> poses_a, std::span<const Pose> poses_b)
{
  data();  // throws where this was moved from, though there may be no pose
  const std::size_t n = poses_a.size() == 1 ? poses_b.size() : poses_a.size();
  if ((poses_a.size() != n && poses_a.size() != 1) || (poses_b.size() != n && poses_b.size() != 1))
    throw Error("query: " + std::to_string(poses_a.size()) + " poses of a and " + std::to_string(poses_b.size()) +
                " of b; expected as many, or one of either");
  std::vector<Answer> answers;
  answers.reserve(n);
  for (std::size_t k = 0; k < n; ++k)
    answers.push_back(collide(poses_a[poses_a.size() == 1 ? 0 : k], poses_b[poses_b.size() == 1 ? 0 : k]));
  return answers;
}

std::vector<Feature_pair> Query::features(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return data().solver->features(pose_a, pose_b);
}

Contacts Query::contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  detail::Query_data& d = data();
  return Contacts(std::make_shared<const detail::Contacts_data>(
      detail::Contacts_data{d.solver->contacts(pose_a, pose_b), d.a, d.b, pose_a, pose_b}));
}

double Query::certified_gap() const { return data().solver->certified_gap(); }

Query_statistics Query::statistics() const
{
  Query_statistics all = data().solver->statistics();
  if (data().distance) all += data().distance->statistics();
  if (data().motion) all += data().motion->motion.counts();
  if (data().relation) all += data().relation->statistics();
  return all;
}
void Query::clear_statistics()
{
  data().solver->clear_statistics();
  if (data().distance) data().distance->clear_statistics();
  if (data().motion) data().motion->motion.clear_counts();
  if (data().relation) data().relation->clear_statistics();
}
std::size_t Query::bytes() const { return data().solver->bytes(); }
std::size_t Query::node_count() const { return data().solver->node_count(); }

}  // namespace tetracone
