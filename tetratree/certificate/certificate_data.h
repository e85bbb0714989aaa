#ifndef TETRACONE_TETRATREE_CERTIFICATE_CERTIFICATE_DATA_H
#define TETRACONE_TETRATREE_CERTIFICATE_CERTIFICATE_DATA_H

#include "tetracone/tetratree/certificate/lower_bound.h"
#include "tetracone/tetratree/certificate/placed_pair.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/certificate.h"
#include "tetracone/tetratree/penetration/near_origin.h"

#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone {

/// The bodies of a certificate, and its answers so far.
struct Certificate::Data {
  /// A body, as the certificate names it.
  struct Part {
    std::shared_ptr<const detail::Body_data> body;
    std::optional<Certified_file> file;           ///< nothing where the body itself is written
    std::vector<Index> source_face;               ///< for each face of the body, the face of the file
    std::optional<tetratree::Group_tree> groups;  ///< made when a proof first needs it

    explicit Part(std::shared_ptr<const detail::Body_data> b)
        : body(std::move(b)), source_face(body->polyhedron.face_count())
    {
      std::iota(source_face.begin(), source_face.end(), Index(0));
    }

    const covering::Polyhedron& polyhedron() const { return body->polyhedron; }

    /// Returns the groups, made now if need be.
    tetratree::Group_tree& tree()
    {
      if (!groups) groups.emplace(body->bvh8(), source_face);
      return *groups;
    }
  };

  std::vector<Part> parts;           ///< one body or two
  std::vector<std::string> answers;  ///< each as JSON that lacks its closing brace
  std::vector<std::size_t> rows;     ///< of each answer: the number of questions asked before it
  std::size_t without_proof = 0;     ///< number of answers that were left out

  /// Returns the number of a text. Throws Error for a text that is none.
  static kernel::Rational parsed(const std::string& text) { return kernel::required_number(text, "certificate: "); }

  /// Returns the trees of both bodies. Throws Error for a certificate of one body.
  std::array<tetratree::Group_tree*, 2> groups()
  {
    if (parts.size() != 2) tetratree::fail_proof("a question about two bodies; expected a certificate for two");
    return {&parts[0].tree(), &parts[1].tree()};
  }

  /// Returns both bodies by their triangles. Throws as `groups`.
  tetratree::Two_bodies triangles()
  {
    const auto [a, b] = groups();
    return {tetratree::Numbered_triangles(*parts[0].body, *a), tetratree::Numbered_triangles(*parts[1].body, *b)};
  }

  /// Returns both bodies at their poses, relative to an origin near them if they are far from 0. There the search in
  /// doubles finds more. Throws as `groups`, and where floating point is not sound.
  tetratree::Placed_pair placed(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    kernel::require_sound_floating_point();
    const auto trees = groups();
    const auto near = tetratree::near_origin(pose_a, trees[0]->tree().scale(), pose_b);
    if (near.exponent != 0) return {trees, {pose_a, pose_b}};
    return {trees, near.pose, near.origin};
  }

  /// Returns the only body. Throws Error for a certificate of two bodies, and where floating point is not sound.
  Part& only()
  {
    kernel::require_sound_floating_point();
    if (parts.size() != 1) tetratree::fail_proof("a question about one body; expected a certificate for one");
    return parts[0];
  }

  /// Returns the beginning of an answer's text: what was asked.
  static std::string begin(std::string_view ask) { return "{\"ask\":" + tetratree::json_text(ask); }

  /// Returns the text of an answer about two bodies up to the answer's value.
  static std::string begin(std::string_view ask, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                           std::optional<Question> question = {})
  {
    std::string text = begin(ask);
    if (question) {
      tetratree::add_key(text, "question");
      text += tetratree::json_text(kernel::to_string(*question));
    }
    tetratree::add_pose(text, "pose_a", pose_a);
    tetratree::add_pose(text, "pose_b", pose_b);
    tetratree::add_key(text, "answer");
    return text;
  }

  /// Adds an answer, to whose text write(text) appends the rest. True when write() does, which says that the answer is
  /// proved. Else, or where it throws No_proof, the answer is counted and left out.
  template <class Write>
  bool add(std::string text, const Write& write)
  {
    try {
      if (write(text)) {
        rows.push_back(answers.size() + without_proof);
        answers.push_back(std::move(text));
        return true;
      }
    } catch (const tetratree::No_proof&) {
      // It is left out as others are that lack a proof.
    }
    ++without_proof;
    return false;
  }

  /// Adds an answer, as `add` does. `leaves` is the pair of leaves at which the query found that the surfaces meet, if
  /// known. Throws Error for a wrong answer.
  bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, Relation answer,
               const std::optional<tetratree::Box_ids>& leaves);

  /// Appends the nearest points and their faces, or a proof that one solid holds a shell of the other. Throws Error
  /// where neither is found.
  void together(std::string& text, const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Nearest& nearest);
  /// Appends a proof that the distance is above the root of `square`; with `or_equal`, that it is not below. Throws
  /// Error where there is none.
  void at_least_apart(std::string& text, const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                      const kernel::Rational& square, bool or_equal, const Nearest& nearest);
  /// Returns a face of the file that has the vertex, edge or face which holds a nearest point. Throws Error for an edge
  /// or a vertex of no face.
  Index face_of(std::size_t body, const Holder& holder) const;

  /// True when both bodies have the same faces, by the places of their corners.
  bool have_same_faces(const tetratree::Placed_pair& pair) const;

  /// Returns a body as JSON: its file or its faces, its cuts, and the groups that proofs have opened.
  std::string text_of(const Part& part) const;
};

}  // namespace tetracone

#endif
