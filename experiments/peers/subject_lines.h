#ifndef TETRACONE_EXPERIMENTS_PEERS_SUBJECT_LINES_H
#define TETRACONE_EXPERIMENTS_PEERS_SUBJECT_LINES_H

#include "experiments/peers/command_process.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/subjects/object_subject.h"

#include <cstdint>

/// The lines of the subject protocol, experiments/subjects/README.md: one JSON object each. Numbers are shortest
/// decimals of doubles; other rationals are strings "n/d".
namespace tetracone::experiments::subject_lines {

/// What a subject can be asked.
/// - Of two bodies: whether they collide, their relation, whether they are within a distance, the distance, and their
///   first contact in a linear motion.
/// - Of one body: where a point is, and where a ray first meets its surface.
/// - Of two triangles, which are no bodies: whether they share a point.
enum class Kind { collide, relation, within, distance, inside, ray, first_contact, triangles };
inline constexpr std::array all_kinds = {Kind::collide, Kind::relation, Kind::within,        Kind::distance,
                                         Kind::inside,  Kind::ray,      Kind::first_contact, Kind::triangles};

/// Returns the name that hellos and lines have for it. They name `collide` by its question instead: surface or solid.
const char* to_string(Kind kind);

/// What a subject says of itself before it answers. An entry that it leaves out excludes nothing.
struct Hello {
  std::string text;                    ///< the line, as JSON without blanks
  std::string bodies = "any";          ///< "convex", "manifold", "closed" or "any"
  std::vector<std::string> questions;  ///< "surface", "solid", and kinds by their names; none: surface and solid
  bool is_rigid = false;               ///< it takes rigid poses alone
  bool takes_batches = false;
  verify::In_floats in_floats = verify::In_floats::nothing;

  /// Kinds other than `collide` are taken where they are named, for surfaces and solids both where neither is named.
  /// A relation answers both questions of `collide`.
  bool takes(Kind kind) const;
  bool takes(Kind kind, kernel::Question of) const;
  bool takes(const kernel::Pose& pose) const;

  /// Convexity is decided exactly, for bodies of at most 1000 faces; larger ones are not taken for convex.
  bool takes(const covering::Polyhedron& body) const;
};

/// Returns the contents of a hello; nothing for another line.
std::optional<Hello> read_hello(const std::string& line);

/// Returns what is wrong with the values of a hello, and what was expected; empty where nothing is.
std::string flaw_of(const Hello& hello);

/// Returns the next line that begins with `{`; nothing when the child ends or the deadline passes first. The others,
/// which libraries print, are counted in `skipped`.
std::optional<std::string> next_object(Command_process& process, Command_process::Deadline deadline,
                                       std::uint64_t& skipped);

/// Returns the quaternion (w, x, y, z) and the translation of a pose whose matrix is a rotation to 1e-12, each rounded
/// to double. Returns nothing for another pose.
std::optional<std::array<double, 7>> rigid_motion(const kernel::Pose& pose);

/// Returns a line to the subject, including its end. A body that cannot be triangulated has no triangles.
std::string model(std::uint64_t number, const covering::Polyhedron& body);
std::string forget(std::uint64_t number);
std::string ask(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                const kernel::Pose& pose_b, kernel::Question question);

/// An ask for the relation of two solids.
std::string relation(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                     const kernel::Pose& pose_b);

/// An ask for the distance, and whether it is at most `limit`, a double or a fraction "n/d".
std::string distance(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                     const kernel::Pose& pose_b, kernel::Question of);
std::string within(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                   const kernel::Pose& pose_b, kernel::Question of, const std::string& limit);

/// An ask for the first contact of bodies that move from their first poses at t = 0 to the others at t = 1.
std::string first_contact(std::uint64_t ask, std::uint64_t a, std::uint64_t b,
                          const std::array<kernel::Pose, 2>& motion_a, const std::array<kernel::Pose, 2>& motion_b,
                          kernel::Question of);

/// Asks about a body in its own coordinates.
std::string inside(std::uint64_t ask, std::uint64_t a, const kernel::Vertex& point);
std::string ray(std::uint64_t ask, std::uint64_t a, const kernel::Vertex& origin, const kernel::Vertex& direction);

/// An ask for the triangles v1 v2 v3 and p q r, placed exactly.
std::string triangles(std::uint64_t ask, const verify::Predicate_case& c);

/// Returns one line of several asks, each a line of `ask`.
std::string batch(const std::vector<std::string>& asks);

/// The contents of a line from the subject.
struct Reply {
  /// Yes, no, or not_asked where it declines; nothing for a wrong line. An answer that is a number is yes.
  std::optional<verify::Outcome> outcome;
  std::string wrong;                ///< what is wrong with the line, and what was expected
  std::optional<std::uint64_t> ns;  ///< the time that it says it took; nothing for what is no number from 0 to 1e18
  double value = 0;  ///< the distance, the place of a point (-1, 0, 1), the `t` of a yes, or a relation: 0 apart, 1
                     ///< surfaces, 2 a_in_b, 3 b_in_a
};

/// Reads the line that answers the question with the number `ask`.
Reply read(const std::string& line, std::uint64_t ask, Kind kind = Kind::collide);

/// Reads the line that answers a batch of the asks from `first` on; one reply each. A wrong line is one wrong reply.
std::vector<Reply> read_batch(const std::string& line, std::uint64_t first, std::size_t count);

}  // namespace tetracone::experiments::subject_lines

#endif
