// Certificates of collisions and distances, and the text of all answers. Declarations have the contracts:
// tetratree/door/certificate.h, and certificate_data.h for what only this room uses.

#include "tetracone/tetratree/door/certificate.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/certificate/certificate_data.h"
#include "tetracone/tetratree/certificate/windings.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/memory/pair_memory.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetracone {

using kernel::Exact_number;
using kernel::Rational;
using kernel::Rational_point;
using tetratree::add_key;
using tetratree::add_list;
using tetratree::exact;
using tetratree::fail_proof;
using tetratree::json_text;
using tetratree::Placed_pair;

Certificate::Certificate(const Body& body) : data_(std::make_unique<Data>()) { data_->parts.emplace_back(body.data_); }
Certificate::Certificate(const Body& a, const Body& b) : data_(std::make_unique<Data>())
{
  data_->parts.emplace_back(a.data_);
  data_->parts.emplace_back(b.data_);
}
Certificate::Certificate(const Query& query) : data_(std::make_unique<Data>())
{
  data_->parts.emplace_back(query.data().a);
  data_->parts.emplace_back(query.data().b);
}
Certificate::~Certificate() = default;
Certificate::Certificate(Certificate&&) noexcept = default;
Certificate& Certificate::operator=(Certificate&&) noexcept = default;

void Certificate::name_file(std::size_t body, Certified_file file)
{
  if (body >= data_->parts.size())
    throw Error("certificate: body " + std::to_string(body) + "; expected one below " +
                std::to_string(data_->parts.size()));
  data_->parts[body].source_face = file.source_face;
  data_->parts[body].file = std::move(file);
}

Answer Certificate::collide(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  tetratree::Pair_memory memory;
  const Answer answer = query.collide(pose_a, pose_b, memory);
  data_->collide(pose_a, pose_b, query.data().question, answer.relation(), memory.witness);
  return answer;
}

Nearest Certificate::distance(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  Nearest nearest = query.nearest(pose_a, pose_b);
  distance(pose_a, pose_b, query.data().question, nearest);
  return nearest;
}

bool Certificate::within(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit)
{
  const bool answer = query.within(pose_a, pose_b, limit);
  within(pose_a, pose_b, query.data().question, limit, answer, query.nearest(pose_a, pose_b));
  return answer;
}

Solid_contact Certificate::relation(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  const Solid_contact contact = query.solid_relation(pose_a, pose_b);
  relation(pose_a, pose_b, contact.relation);
  return contact;
}

Exits Certificate::exits(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                         const std::array<std::string, 3>& direction)
{
  Exits answer = query.exits(pose_a, pose_b, direction);
  exits(pose_a, pose_b, direction, answer);
  return answer;
}

Depth Certificate::depth(Query& query, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                         const Depth_options& options)
{
  Depth answer = query.depth(pose_a, pose_b, options);
  depth(pose_a, pose_b, answer);
  return answer;
}

std::size_t Certificate::without_proof() const { return data_->without_proof; }

bool Certificate::collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question, Relation answer)
{
  return data_->collide(pose_a, pose_b, question, answer, {});
}

bool Certificate::Data::collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                                Relation answer, const std::optional<tetratree::Box_ids>& leaves)
{
  return add(begin("collide", pose_a, pose_b, question), [&](std::string& text) {
    text += json_text(kernel::to_string(answer));
    Placed_pair pair = placed(pose_a, pose_b);
    if (answer == Relation::surfaces && leaves)
      if (const auto met = pair.common(*leaves)) {
        add_common(text, pair, *met);
        return true;
      }
    const bool shares_none = !cover_or_meet(text, pair);
    if (shares_none != (answer != Relation::surfaces)) fail_proof("the answer is not proved: surfaces");
    if (shares_none && question == Question::solid &&
        !(answer == Relation::apart ? add_all_windings(text, pair)
                                    : add_one_winding(text, pair, answer == Relation::a_in_b ? 0 : 1)))
      fail_proof("the answer is not proved: shells");
    return true;
  });
}

Index Certificate::Data::face_of(std::size_t body, const Holder& holder) const
{
  const covering::Polyhedron& polyhedron = parts[body].polyhedron();
  if (holder.kind == Holder::Kind::face) return parts[body].source_face[holder.number[0]];
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
      const auto loop = polyhedron.loop(f, l);
      for (std::size_t k = 0; k < loop.size(); ++k)
        if (loop[k] == holder.number[0] &&
            (holder.kind == Holder::Kind::vertex || loop[k + 1 == loop.size() ? 0 : k + 1] == holder.number[1]))
          return parts[body].source_face[f];
    }
  fail_proof("no face has the nearest point");
}

void Certificate::Data::together(std::string& text, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                                 const Nearest& nearest)
{
  if (nearest.holder[0].kind != Holder::Kind::interior && nearest.holder[1].kind != Holder::Kind::interior) {
    std::array<Rational_point, 2> points;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t c = 0; c < 3; ++c) points[k][c] = Rational(nearest.point[k][c]);
    tetratree::add_witness(text, points, {face_of(0, nearest.holder[0]), face_of(1, nearest.holder[1])});
    return;
  }
  Placed_pair pair = placed(pose_a, pose_b);
  if (!add_one_winding(text, pair, 0) && !add_one_winding(text, pair, 1))
    fail_proof("no shell is inside of the other solid");
}

void Certificate::Data::at_least_apart(std::string& text, const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                                       Question question, const Rational& square, bool or_equal, const Nearest& nearest)
{
  Placed_pair pair = placed(pose_a, pose_b);
  Rational_point way;
  for (std::size_t c = 0; c < 3; ++c) way[c] = Rational(nearest.point[1][c]) - Rational(nearest.point[0][c]);
  way = tetratree::in_lowest_terms(way);
  const double limit = std::sqrt(square.get_d());
  kernel::Gap_rule rule{exact(square.get_num()) * pair.weight * pair.weight, exact(square.get_den()), or_equal, 0};
  if (std::isfinite(limit)) rule.rounded = Exact_number(Exact_number(limit) * pair.weight * pair.rounding).to_double();
  if (cover_or_meet(text, pair, rule, exact(way, 1))) fail_proof("the bodies share a point");
  if (question == Question::solid && !add_all_windings(text, pair)) fail_proof("one solid holds a part of the other");
}

bool Certificate::distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                           const Nearest& nearest)
{
  return data_->add(Data::begin("distance", pose_a, pose_b, question), [&](std::string& text) {
    text += json_text(nearest.squared);
    data_->together(text, pose_a, pose_b, nearest);
    if (const Rational square(nearest.squared); square != 0)
      data_->at_least_apart(text, pose_a, pose_b, question, square, true, nearest);
    return true;
  });
}

bool Certificate::within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                         const std::string& limit, bool answer, const Nearest& nearest)
{
  return data_->add(Data::begin("within", pose_a, pose_b, question), [&](std::string& text) {
    text += answer ? '1' : '0';
    add_key(text, "limit");
    text += json_text(limit);
    const Rational exact_limit = Data::parsed(limit);
    if (answer)
      data_->together(text, pose_a, pose_b, nearest);
    else if (sgn(exact_limit) >= 0)
      data_->at_least_apart(text, pose_a, pose_b, question, exact_limit * exact_limit, false, nearest);
    return true;
  });
}

std::string Certificate::Data::text_of(const Part& part) const
{
  std::string text = "{";
  const covering::Polyhedron& polyhedron = part.polyhedron();
  if (part.file) {
    add_key(text, "file");
    text += json_text(part.file->name);
    add_key(text, "sha256");
    text += json_text(part.file->sha256);
  } else {
    add_key(text, "vertices");
    add_list(text, polyhedron.vertices, [](const covering::Vertex& v) {
      std::string row;
      add_list(row, v, [](double x) { return json_text(kernel::shortest(x)); });
      return row;
    });
    std::vector<Index> faces(polyhedron.face_count());
    std::iota(faces.begin(), faces.end(), Index(0));
    add_key(text, "faces");
    add_list(text, faces, [&](Index f) {
      std::string row = "[";
      for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
        if (l > 0) row += ',';
        add_list(row, polyhedron.loop(f, l), [](Index v) { return std::to_string(v); });
      }
      return row + "]";
    });
  }
  if (!part.groups) return text + "}";
  const tetratree::Group_tree& groups = *part.groups;
  // A face of the file is not cut where it is one piece.
  std::vector<std::string> cut;
  for (std::size_t first = 0, next = 0; first < groups.piece_count(); first = next) {
    const Index face = part.source_face[groups.piece(first).face];
    while (next < groups.piece_count() && part.source_face[groups.piece(next).face] == face) ++next;
    const tetratree::Element& only = groups.piece(first);
    if (next == first + 1 && (only.is_whole_face() || polyhedron.is_triangle(only.face))) continue;
    for (std::size_t n = first; n < next; ++n) {
      const tetratree::Element& e = groups.piece(n);
      std::vector<Index> row = {face};
      groups.tree().for_vertices(e, [&](Index v) { row.push_back(v); });
      std::string numbers;
      add_list(numbers, row, [](Index v) { return std::to_string(v); });
      cut.push_back(std::move(numbers));
    }
  }
  if (!cut.empty()) {
    add_key(text, "cut");
    add_list(text, cut, [](const std::string& row) { return row; });
  }
  if (groups.is_opened()) {
    add_key(text, "groups");
    groups.write(text);
  }
  return text + "}";
}

std::string Certificate::text() const
{
  std::string text = "{\"certificate\":\"tetracone 1\",\n\"bodies\":";
  for (Data::Part& part : data_->parts)  // what is cut must be told, though no cover names its pieces
    if (std::ranges::adjacent_find(part.source_face) != part.source_face.end()) part.tree();
  add_list(text, data_->parts, [&](const Data::Part& part) { return data_->text_of(part); });
  text += ",\n\"answers\":[\n";
  for (std::size_t k = 0; k < data_->answers.size(); ++k) {
    text += (k == 0 ? "" : ",\n") + data_->answers[k];
    if (data_->without_proof > 0) text += ",\"row\":" + std::to_string(data_->rows[k]);
    text += '}';
  }
  text += "\n]";
  if (data_->without_proof > 0) text += ",\"asked\":" + std::to_string(data_->answers.size() + data_->without_proof);
  return text + "}\n";
}

}  // namespace tetracone
