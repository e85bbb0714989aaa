#ifndef TETRACONE_TETRATREE_DOOR_CERTIFICATE_H
#define TETRACONE_TETRATREE_DOOR_CERTIFICATE_H

#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone {

/// The model file of a body in a certificate.
struct Certified_file {
  std::string name;                ///< without folders
  std::string sha256;              ///< of its bytes, 64 hexadecimal digits
  std::vector<Index> source_face;  ///< for each face of the body, the face of the file that it is a part of, ascending
};

/// Collects proofs of answers about one body, or two. A program without our code, experiments/certificates/check.py,
/// proves the answers from the text. Each proof is found anew, exactly, by a search over the trees of the bodies: it
/// costs more than the answer, which stays as fast as it is.
///
/// An answer that the search cannot prove throws Error, and so does a body with a face that has no triangles where its
/// proof needs some.
class Certificate {
 public:
  /// For answers about one body. The bodies are written into the certificate, unless `name_file` names their files.
  explicit Certificate(const Body& body);
  /// For answers about two bodies.
  Certificate(const Body& a, const Body& b);
  ~Certificate();
  /// Moves; the certificate that is moved from may only be destroyed.
  Certificate(Certificate&&) noexcept;
  /// Moves; the certificate that is moved from may only be destroyed.
  Certificate& operator=(Certificate&&) noexcept;

  /// Names the file of body 0 or 1, instead of writing the body. Requires that it holds the body's vertices, and that
  /// no answer has been added.
  void name_file(std::size_t body, Certified_file file);

  /// Adds what `Query::collide` answers.
  void collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, Relation answer);
  /// Adds what `Query::nearest` answers.
  void distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, const Nearest& nearest);
  /// Adds what `Query::within` answers for this limit. `nearest` is the answer of `Query::nearest`.
  void within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, const std::string& limit,
              bool answer, const Nearest& nearest);
  /// Adds the relation that `Query::solid_relation` answers; the dimension has no proof. True
  /// where it is proved: disjoint, inside and contains always, overlap and meet where the search finds a proof. Else
  /// nothing is added.
  bool relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Solid_relation answer);
  /// Adds what `Query::first_contact` answers. True where it is proved. Else nothing is added: the motion is rigid, or
  /// the bodies only graze.
  bool first_contact(const Motion& a, const Motion& b, Question question, const std::optional<First_contact>& answer);
  /// Adds where a point of decimals or fractions is, as `Body::inside_text` answers.
  void inside(const std::array<std::string, 3>& point, Location answer);
  /// Adds what `Body::first_hit` answers.
  void first_hit(const Ray& ray, const std::optional<Ray_hit>& answer,
                 double end = std::numeric_limits<double>::infinity());

  /// Returns the certificate of all answers so far, as JSON.
  std::string text() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace tetracone

#endif
