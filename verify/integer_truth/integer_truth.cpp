#include "verify/integer_truth/integer_truth.h"

#include "verify/integer_truth/integer_contact.h"
#include "verify/integer_truth/integer_pair.h"

#include <optional>
#include <vector>

namespace tetracone::verify::integer_truth {
namespace {

/// The closed segment ab and the face, whose normal is given where it has one, share a point.
bool meets_face(const Integer_vector& a, const Integer_vector& b, const Integer_body& body, Index f,
                const std::optional<Integer_vector>& n)
{
  if (n) {
    const Integer height_a = dot(*n, difference(a, body.corner(f))), height_b = dot(*n, difference(b, body.corner(f)));
    if (sgn(height_a) * sgn(height_b) > 0) return false;
    if (sgn(height_a) != 0 || sgn(height_b) != 0) {
      // The crossing is a and b weighted by each other's height.
      const Integer of_a = abs(height_b), of_b = abs(height_a);
      Integer_vector x;
      for (int i = 0; i < 3; ++i) x[i] = of_a * a[i] + of_b * b[i];
      return is_on_face(body, f, *n, x, of_a + of_b);
    }
    if (is_on_face(body, f, *n, a, 1)) return true;
  }
  // One plane, and a segment that would have to come in through a loop; or a face that is its loops only.
  return meets_loops(a, b, body, f);
}

/// Some edge of the one meets some face of the other. When this holds neither way, the surfaces share no point. Had two
/// faces one in common, what they share would be closed and bounded. So it would end on a loop of one of them, at a
/// point of the other.
bool edges_meet_faces(const Integer_body& with_edges, const std::vector<Rank_box>& edge_boxes,
                      const Integer_body& with_faces, const std::vector<Rank_box>& face_boxes)
{
  Index last = with_faces.face_count();
  std::optional<Integer_vector> normal;
  for (const auto& [f, e] : meeting_boxes(face_boxes, edge_boxes)) {
    if (f != last) normal = with_faces.normal(f);
    last = f;
    const auto& [from, to] = with_edges.edges()[e];
    if (meets_face(with_edges.point(from), with_edges.point(to), with_faces, f, normal)) return true;
  }
  return false;
}

}  // namespace

bool collide(const Object_case& c, kernel::Question question)
{
  const auto [denominator, a, b] = integer_pair(c);
  const auto [of_a, of_b] = element_boxes(a, b);
  if (edges_meet_faces(a, of_a.edges, b, of_b.faces) || edges_meet_faces(b, of_b.edges, a, of_a.faces)) return true;
  return question == kernel::Question::solid &&
         (contains(a, of_a.faces, b, of_b.vertices) || contains(b, of_b.faces, a, of_a.vertices));
}

}  // namespace tetracone::verify::integer_truth
