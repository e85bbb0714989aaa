#include "experiments/cli/contact_rows.h"

#include "experiments/cli/answer_rows.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/error.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;

/// Requires a finite number: no model can say another.
double finite(double x)
{
  if (!std::isfinite(x))
    throw Error("curves: a coordinate is beyond the largest double; expected --contacts without --curves");
  return x;
}

Json coordinate(double x) { return json_number(x); }
Json coordinate(const std::string& x) { return x; }
std::string coordinate_text(double x) { return kernel::shortest(x); }
std::string coordinate_text(const std::string& x) { return x; }

/// A piece, with its loops in doubles or in fractions.
template <class Loops>
Json piece_json(const Contact_piece& piece, const Loops& loops)
{
  Json all = Json::array();
  for (const auto& loop : loops) {
    Json points = Json::array();
    for (const auto& x : loop) points.push_back({coordinate(x[0]), coordinate(x[1]), coordinate(x[2])});
    all.push_back(std::move(points));
  }
  return {{"face_a", piece.face_a},        {"face_b", piece.face_b},        {"kind", to_string(piece.kind)},
          {"in_a", to_string(piece.in_a)}, {"in_b", to_string(piece.in_b)}, {"loops", std::move(all)}};
}

/// The doubles below and above the unit normals of the faces of piece k.
Json normals_json(const Contacts& contacts, std::size_t k)
{
  Json both = Json::array();
  for (const Enclosure& normal : contact_normals(contacts, k)) both.push_back({normal.lower, normal.upper});
  return both;
}

std::string normals_text(const Contacts& contacts, std::size_t k, const std::string& separator)
{
  std::string text;
  for (const Enclosure& normal : contact_normals(contacts, k))
    for (const double x : normal.lower) text += separator + kernel::shortest(x);
  return text;
}

/// A line without its end.
template <class Loops>
std::string piece_line(std::size_t pose, const Contact_piece& piece, const Loops& loops, const std::string& separator)
{
  std::string line = std::to_string(pose) + separator + std::to_string(piece.face_a) + separator +
                     std::to_string(piece.face_b) + separator + std::string(to_string(piece.kind));
  const bool is_polygon = piece.kind == Piece::polygon;
  for (const auto* x : {&loops[0].front(), &loops[0].back()})
    for (const auto& number : *x)
      if (!is_polygon)
        line += separator + coordinate_text(number);
      else if (separator == ",")
        line += separator;
  return line;
}

template <class What>
auto with_loops(const Contacts& contacts, std::size_t k, bool exact, const What& what)
{
  return exact ? what(contacts.exact_loops(k)) : what(contacts.nearest_loops(k));
}

/// Whether a face of the file became several.
bool is_split(const Model_file& model)
{
  return std::ranges::adjacent_find(model.source_face) != model.source_face.end();
}

using Exact_loops = std::vector<std::vector<kernel::Rational_point>>;

/// Returns the loops of a piece. The points of a piece that is no polygon are sorted, so that equal pieces have equal
/// loops.
Exact_loops loops_of(const Contacts& contacts, std::size_t k)
{
  Exact_loops loops;
  for (const auto& loop : contacts.exact_loops(k)) {
    loops.emplace_back();
    for (const auto& [x, y, z] : loop)
      loops.back().push_back({*kernel::parse_number(x), *kernel::parse_number(y), *kernel::parse_number(z)});
    if (contacts[k].kind != Piece::polygon) std::ranges::sort(loops.back());
  }
  return loops;
}

/// True when the segment from p to q holds the point.
bool is_held(const kernel::Rational_point& x, const kernel::Rational_point& p, const kernel::Rational_point& q)
{
  const auto along = kernel::difference(q, p), way = kernel::difference(x, p);
  for (const kernel::Rational& component : kernel::cross(along, way))
    if (sgn(component) != 0) return false;
  return sgn(kernel::dot(along, way)) >= 0 && sgn(kernel::dot(along, kernel::difference(x, q))) <= 0;
}

/// True when one edge of the other piece holds all points of a piece.
bool is_held(const Exact_loops& piece, const Exact_loops& other)
{
  for (const auto& loop : other)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto &p = loop[k], &q = loop[(k + 1) % loop.size()];
      if (p != q && std::ranges::all_of(piece[0], [&](const auto& x) { return is_held(x, p, q); })) return true;
    }
  return false;
}

/// Returns the pieces that other pieces of the same faces of the files hold, or equal one before. Only triangles of one
/// face have such pieces: what they share is on their sides.
std::set<std::size_t> held_pieces(const Contacts& contacts, const Model_file& a, const Model_file& b)
{
  std::map<std::pair<covering::Index, covering::Index>, std::vector<std::size_t>> pieces;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    pieces[{a.source_face[contacts[k].face_a], b.source_face[contacts[k].face_b]}].push_back(k);
  std::set<std::size_t> held;
  for (const auto& [faces, numbers] : pieces) {
    if (numbers.size() == 1) continue;
    std::map<std::size_t, Exact_loops> loops;
    for (const std::size_t k : numbers) loops[k] = loops_of(contacts, k);
    for (const std::size_t k : numbers)
      for (const std::size_t other : numbers) {
        const bool is_equal = loops[k] == loops[other];
        if (is_equal ? other < k : contacts[k].kind != Piece::polygon && is_held(loops[k], loops[other]))
          held.insert(k);
      }
  }
  return held;
}

/// The contact pieces of one pose, by the faces of the files. Pieces of a face that was split are listed once, unless
/// others of that face hold them.
std::vector<std::pair<std::size_t, Contact_piece>> pieces_of(const Contacts& contacts, const Model_file& a,
                                                             const Model_file& b)
{
  std::set<std::size_t> held;
  if (is_split(a) || is_split(b)) held = held_pieces(contacts, a, b);
  std::vector<std::pair<std::size_t, Contact_piece>> pieces;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    Contact_piece piece = contacts[k];
    piece.face_a = a.source_face[piece.face_a];
    piece.face_b = b.source_face[piece.face_b];
    if (!held.contains(k)) pieces.emplace_back(k, piece);
  }
  return pieces;
}

}  // namespace

std::string contact_rows(const std::vector<Contacts>& contacts, const Model_file& a, const Model_file& b,
                         const Contact_format& format)
{
  if (format.json) {
    Json poses = Json::array();
    for (std::size_t pose = 0; pose < contacts.size(); ++pose) {
      Json pieces = Json::array();
      for (const auto& [k, piece] : pieces_of(contacts[pose], a, b)) {
        pieces.push_back(with_loops(contacts[pose], k, format.exact,
                                    [&, &piece = piece](const auto& loops) { return piece_json(piece, loops); }));
        if (format.normals) pieces.back()["normals"] = normals_json(contacts[pose], k);
      }
      poses.push_back({{"pose", pose}, {"contacts", std::move(pieces)}});
    }
    return poses.dump(1) + "\n";
  }
  std::string text;
  if (format.csv)
    text = std::string("pose,face_a,face_b,kind,x0,y0,z0,x1,y1,z1") + (format.normals ? ",ax,ay,az,bx,by,bz\n" : "\n");
  const std::string separator = format.csv ? "," : " ";
  for (std::size_t pose = 0; pose < contacts.size(); ++pose)
    for (const auto& [k, piece] : pieces_of(contacts[pose], a, b)) {
      text += with_loops(contacts[pose], k, format.exact,
                         [&, &piece = piece](const auto& loops) { return piece_line(pose, piece, loops, separator); });
      if (format.normals) text += normals_text(contacts[pose], k, separator);
      text += '\n';
    }
  return text;
}

Pair_rows self_intersection_rows(const Contacts& contacts, const Model_file& model, bool json)
{
  struct Pieces {
    Piece kind = Piece::point;
    Json list = Json::array();
  };
  std::map<std::pair<covering::Index, covering::Index>, Pieces> pairs;
  for (const auto& [k, piece] : pieces_of(contacts, model, model)) {
    if (piece.face_a == piece.face_b) continue;
    Pieces& pieces = pairs[{piece.face_a, piece.face_b}];
    pieces.kind = std::max(pieces.kind, piece.kind);
    if (json) pieces.list.push_back(piece_json(piece, contacts.exact_loops(k)));
  }
  Pair_rows rows{"", pairs.size()};
  Json all = Json::array();
  for (auto& [faces, pieces] : pairs)
    if (json)
      all.push_back({{"faces", {faces.first, faces.second}},
                     {"kind", to_string(pieces.kind)},
                     {"shared", std::move(pieces.list)}});
    else
      rows.text += std::to_string(faces.first) + " " + std::to_string(faces.second) + " " +
                   std::string(to_string(pieces.kind)) + "\n";
  if (json) rows.text = all.dump(1) + "\n";
  return rows;
}

bool is_curve_file(const std::filesystem::path& file)
{
  return file.extension() == ".obj" || file.extension() == ".ply";
}

std::string curves_text(const std::vector<Contacts::Curve>& curves, const std::filesystem::path& file)
{
  const bool is_obj = file.extension() == ".obj";
  std::string points, lines;
  std::size_t point_count = 0, line_count = 0;
  for (const Contacts::Curve& curve : curves) {
    const std::size_t first = point_count;
    for (const auto& x : curve.points)
      points += (is_obj ? "v " : "") + coordinate_text(finite(x[0])) + " " + coordinate_text(finite(x[1])) + " " +
                coordinate_text(finite(x[2])) + "\n";
    point_count += curve.points.size();
    const std::size_t ends = curve.points.size() + (curve.closed ? 1 : 0);
    const auto number = [&](std::size_t k) { return first + k % curve.points.size(); };
    if (is_obj) {
      lines += "l";
      for (std::size_t k = 0; k < ends; ++k) lines += " " + std::to_string(1 + number(k));
      lines += "\n";
    } else {
      for (std::size_t k = 0; k + 1 < ends; ++k)
        lines += std::to_string(number(k)) + " " + std::to_string(number(k + 1)) + "\n";
      line_count += ends - 1;
    }
  }
  if (is_obj) return points + lines;
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(point_count) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement edge " + std::to_string(line_count) +
         "\nproperty int vertex1\nproperty int vertex2\nend_header\n" + points + lines;
}

}  // namespace tetracone::experiments
