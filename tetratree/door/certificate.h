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
/// proves the answers from the text. Each proof is found exactly, by a search over the trees of the bodies. It costs
/// more than the answer, which stays as fast as it is.
///
///     Query query(a, b);
///     Certificate certificate(query);
///     const Answer answer = certificate.collide(query, pose_a, pose_b);
///     std::ofstream("proof.json") << certificate.text();
///
/// An answer is left out and counted (`without_proof`) where its proof needs triangles that a face lacks, since its
/// loops cross. So are relations, exits, depths and first contacts for which the search finds no proof. A wrong
/// collision, distance, point or ray throws Error, and so does a relation that surfaces or shells contradict. Other
/// wrong answers find no proof. An answer about another number of bodies than the certificate has throws Error, too.
class Certificate {
 public:
  /// For answers about one body. The bodies are written into the certificate, unless `name_file` names their files.
  explicit Certificate(const Body& body);
  /// For answers about two bodies.
  Certificate(const Body& a, const Body& b);
  /// For answers of a query, and of others about the same two bodies. Throws Error for a query that has been moved
  /// from.
  explicit Certificate(const Query& query);
  ~Certificate();
  /// Moves; the certificate that is moved from may only be destroyed.
  Certificate(Certificate&&) noexcept;
  /// Moves; the certificate that is moved from may only be destroyed.
  Certificate& operator=(Certificate&&) noexcept;

  /// Names the file of body 0 or 1, instead of writing the body. Requires a file that holds the body's vertices, and
  /// that no answer has been added. Throws Error for a body that the certificate has not.
  void name_file(std::size_t body, Certified_file file);

  /// Asks the query, and adds its answer. Where surfaces meet, the proof is the pair of faces at which the query ended.
  /// Requires a query about the certificate's bodies. Throws as `Query::collide`.
  Answer collide(Query& query, const Pose& a, const Pose& b) { return collide(query, a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Answer collide(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b);
  /// Asks the query for the nearest points, and adds the distance. Requires and throws as above.
  Nearest distance(Query& query, const Pose& a, const Pose& b) { return distance(query, a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Nearest distance(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b);
  /// Asks the query whether the distance is at most `limit`, and adds the answer. Requires and throws as above.
  bool within(Query& query, const Pose& a, const Pose& b, const std::string& limit)
  {
    return within(query, a.exact(), b.exact(), limit);
  }
  /// Same, for poses of the templates. Requires det M != 0.
  bool within(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit);
  /// Asks the query for the relation of the solids, and adds it where it is proved. Requires and throws as above.
  Solid_contact relation(Query& query, const Pose& a, const Pose& b) { return relation(query, a.exact(), b.exact()); }
  /// Same, for poses of the templates. Requires det M != 0.
  Solid_contact relation(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b);
  /// Asks the query for the exits, and adds them where they are proved. Requires and throws as above.
  Exits exits(Query& query, const Pose& a, const Pose& b, const std::array<std::string, 3>& direction)
  {
    return exits(query, a.exact(), b.exact(), direction);
  }
  /// Same, for poses of the templates. Requires det M != 0.
  Exits exits(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
              const std::array<std::string, 3>& direction);
  /// Asks the query for the depth, and adds its bounds where they are proved. Requires and throws as above.
  Depth depth(Query& query, const Pose& a, const Pose& b, const Depth_options& options = {})
  {
    return depth(query, a.exact(), b.exact(), options);
  }
  /// Same, for poses of the templates. Requires det M != 0.
  Depth depth(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth_options& options = {});

  /// Returns how many answers had no proof and were left out.
  std::size_t without_proof() const;

  /// Adds an answer of `Query::collide`. Like all that follow, it returns true where the answer is proved; else the
  /// answer is left out. This and the next few are for poses of the templates (`Pose::exact`).
  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, Relation answer);
  /// Adds the distance by an answer of `Query::nearest`.
  bool distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, const Nearest& nearest);
  /// Adds an answer of `Query::within` for this limit. `nearest` is the answer of `Query::nearest`.
  bool within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, const std::string& limit,
              bool answer, const Nearest& nearest);
  /// Adds the relation of an answer of `Query::solid_relation`; the dimension has no proof. `inside` and `contains` are
  /// proved where the surfaces share no point, the others but `disjoint` where a search finds a proof. An overlap needs
  /// surfaces that share a point. Solids that touch and do not overlap are proved where a plane is between them. They
  /// are also proved where a body that shrinks, grows or moves aside a little has no contact left.
  /// Equal solids are proved where they have the same faces, too.
  bool relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Solid_relation answer);
  /// Adds an answer of `Query::exits`, as fractions. That no move before the first exit parts the solids is added where
  /// it is proved.
  bool exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::array<std::string, 3>& direction,
             const Exits& answer);
  /// Adds the translation of `Query::depth`, an upper bound, where it is proved as `meet` is in `relation`. A lower
  /// bound is added where a search of boxes proves one. It is near that of the answer, and exact where the search
  /// closes all boxes.
  bool depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth& answer);
  /// Adds an answer of `Query::first_contact`. Bodies that graze have no proof.
  bool first_contact(const Motion& a, const Motion& b, Question question, const std::optional<First_contact>& answer);
  /// Adds an answer of `Body::inside_text`: where a point of decimals or fractions is.
  bool inside(const std::array<std::string, 3>& point, Location answer);
  /// Adds an answer of `Body::first_hit` for a ray up to `end`.
  bool first_hit(const Ray& ray, const std::optional<Ray_hit>& answer,
                 double end = std::numeric_limits<double>::infinity());

  /// Returns the certificate of all answers so far, as JSON.
  std::string text() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace tetracone

#endif
