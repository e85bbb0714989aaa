#include "experiments/viewer/overlap_parts.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/contacts_data.h"
#include "tetracone/tetratree/query/bvh8_contacts.h"
#include "tetracone/tetratree/relation/solid_pair.h"
#include "tetracone/tetratree/relation/solid_sides.h"

#include <cstddef>
#include <span>
#include <utility>

namespace tetracone::experiments {
namespace {

/// The body with each triangle as a face of its own.
detail::Shared_body triangles_of(const Body& body)
{
  const detail::Body_data& data = detail::data_of(body).by_triangles();
  return {&data, [body](const detail::Body_data*) {}};  // the body keeps the data
}

tetratree::Placed_solid solid(const detail::Body_data& body)
{
  return tetratree::Placed_solid(body.polyhedron, body.solid_sides(), body.point_locator());
}

}  // namespace

struct Overlap_parts::Data {
  Data(const detail::Shared_body& a, const detail::Shared_body& b)
      : body_a(a),
        body_b(b),
        contacts(a->bvh8(), a->bvh8().model(), a->polyhedron, b->bvh8(), b->bvh8().model(), b->polyhedron),
        pair(solid(*a), solid(*b))
  {}

  detail::Shared_body body_a, body_b;
  tetratree::Bvh8_contacts<> contacts;
  tetratree::Solid_pair pair;
};

Overlap_parts::Overlap_parts(const Body& a, const Body& b)
    : data_(std::make_unique<Data>(triangles_of(a), triangles_of(b)))
{}

Overlap_parts::~Overlap_parts() = default;

std::vector<Overlap_parts::Corners> Overlap_parts::at(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  const detail::Contacts_data shared{data_->contacts.contacts(pose_a, pose_b), data_->body_a, data_->body_b, pose_a,
                                     pose_b};
  std::vector<tetratree::Solid_piece> pieces;
  for (std::size_t k = 0; k < shared.found.pieces.size(); ++k) {
    const tetratree::Found_piece& piece = shared.found.pieces[k];
    pieces.push_back({{piece.face_a, piece.face_b}, piece.kind, detail::rational_loops(shared, k), piece.by_signs});
  }
  data_->pair.place(pose_a, pose_b, std::move(pieces));
  std::vector<Corners> parts;
  data_->pair.for_border_parts([&](std::span<const kernel::Rational_point> corners) {
    Corners& part = parts.emplace_back();
    for (const auto& [x, y, z] : corners)
      part.push_back({kernel::nearest_double(x), kernel::nearest_double(y), kernel::nearest_double(z)});
  });
  return parts;
}

}  // namespace tetracone::experiments
